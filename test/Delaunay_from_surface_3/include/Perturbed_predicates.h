// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_PERTURBED_PREDICATES_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_PERTURBED_PREDICATES_H

// CGAL's exact predicates, and its symbolic perturbation where these say "on the sphere": what the
// kernel's own must agree with. The perturbation depends on the points only, not on the order of
// insertion: that is why the compact kernel's result equals CGAL's on every input.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/enum.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Predicates on points given by their coordinates.
template <class GeomTraits>
class Perturbed_predicates
{
  // CGAL's perturbed predicates are protected members of the triangulation. They use nothing of it
  // but its traits.
  struct Exposed : Delaunay_triangulation_3<GeomTraits>
  {
    using Base = Delaunay_triangulation_3<GeomTraits>;
    explicit Exposed(const GeomTraits& gt)
      : Base(gt)
    {
    }
    using Base::coplanar_side_of_bounded_circle;
    using Base::side_of_oriented_sphere;
  };

public:
  explicit Perturbed_predicates(const GeomTraits& gt)
    : m_exposed(gt)
  {
  }

  Orientation orientation(const double* a, const double* b, const double* c, const double* d) const
  {
    return traits().orientation_3_object()(point(a), point(b), point(c), point(d));
  }

  // Is p inside the sphere of the positively oriented cell (a, b, c, d)?
  bool is_in_sphere(const double* a, const double* b, const double* c, const double* d,
                    const double* p) const
  {
    return m_exposed.side_of_oriented_sphere(point(a), point(b), point(c), point(d), point(p),
                                             true) == ON_POSITIVE_SIDE;
  }

  // Is p in conflict with the infinite cell (a, b, c, infinite): beyond the facet (a, b, c) of the
  // convex hull, or in its plane and inside its circle?
  bool is_beyond(const double* a, const double* b, const double* c, const double* p) const
  {
    const Orientation o = orientation(a, b, c, p);
    if (o != COPLANAR)
      return o == POSITIVE;
    return m_exposed.coplanar_side_of_bounded_circle(point(a), point(b), point(c), point(p),
                                                     true) == ON_BOUNDED_SIDE;
  }

  bool are_collinear(const double* a, const double* b, const double* c) const
  {
    return traits().coplanar_orientation_3_object()(point(a), point(b), point(c)) == COLLINEAR;
  }

private:
  using Point = typename GeomTraits::Point_3;

  static Point point(const double* p) { return Point(p[0], p[1], p[2]); }
  const GeomTraits& traits() const { return m_exposed.geom_traits(); }

  Exposed m_exposed;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_PERTURBED_PREDICATES_H
