// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_PERTURBED_PREDICATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_PERTURBED_PREDICATES_H

// The last stage of the predicates: the kernel's own exact ones, and CGAL's symbolic perturbation
// where these say "on the sphere". The perturbation depends on the points only, not on the order of
// insertion: that is why the compact kernel's result equals CGAL's on every input.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Predicates on points given by their indices.
template <class GeomTraits>
class Perturbed_predicates
{
  // CGAL's perturbed predicates are protected members of the triangulation. They use nothing of it
  // but its traits.
  template <class Gt>
  struct Exposed : Delaunay_triangulation_3<Gt>
  {
    using Base = Delaunay_triangulation_3<Gt>;
    explicit Exposed(const Gt& gt)
      : Base(gt)
    {
    }
    using Base::coplanar_side_of_bounded_circle;
    using Base::side_of_oriented_sphere;
  };

  // Traits for points that are known to be cospherical, or cocircular: what is left is the
  // perturbation.
  struct Cospherical_traits : GeomTraits
  {
    explicit Cospherical_traits(const GeomTraits& gt)
      : GeomTraits(gt)
    {
    }
    struct Side_of_oriented_sphere_3
    {
      template <class P>
      Oriented_side operator()(const P&, const P&, const P&, const P&, const P&) const
      {
        return ON_ORIENTED_BOUNDARY;
      }
    };
    struct Coplanar_side_of_bounded_circle_3
    {
      template <class P>
      Bounded_side operator()(const P&, const P&, const P&, const P&) const
      {
        return ON_BOUNDARY;
      }
    };
    Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const
    {
      return {};
    }
    Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
  };

public:
  using Point = typename GeomTraits::Point_3;

  // Keeps a reference to `points`.
  Perturbed_predicates(const GeomTraits& gt, const std::vector<Point>& points)
    : m_exposed(gt)
    , m_cospherical(Cospherical_traits(gt))
    , m_points(points)
  {
  }

  Orientation orientation(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const
  {
    return m_exposed.geom_traits().orientation_3_object()(m_points[a], m_points[b], m_points[c],
                                                          m_points[d]);
  }

  // Is p inside the sphere of the positively oriented cell (a, b, c, d)?
  bool is_in_sphere(std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t p) const
  {
    return m_exposed.side_of_oriented_sphere(m_points[a], m_points[b], m_points[c], m_points[d],
                                             m_points[p], true) == ON_POSITIVE_SIDE;
  }

  // The same for a point that is known to lie on the sphere.
  bool is_perturbed_into_sphere(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                                std::size_t p) const
  {
    return m_cospherical.side_of_oriented_sphere(m_points[a], m_points[b], m_points[c], m_points[d],
                                                 m_points[p], true) == ON_POSITIVE_SIDE;
  }

  // Is p in conflict with the infinite cell (a, b, c, infinite): beyond the facet (a, b, c) of the
  // convex hull, or in its plane and inside its circle?
  bool is_beyond(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const
  {
    const Orientation o = orientation(a, b, c, p);
    if (o != COPLANAR)
      return o == POSITIVE;
    return m_exposed.coplanar_side_of_bounded_circle(m_points[a], m_points[b], m_points[c],
                                                     m_points[p], true) == ON_BOUNDED_SIDE;
  }

  // The same for a point that is known to lie on the circle.
  bool is_perturbed_into_circle(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const
  {
    return m_cospherical.coplanar_side_of_bounded_circle(m_points[a], m_points[b], m_points[c],
                                                         m_points[p], true) == ON_BOUNDED_SIDE;
  }

  bool are_equal(std::size_t a, std::size_t b) const
  {
    return m_exposed.geom_traits().compare_xyz_3_object()(m_points[a], m_points[b]) == EQUAL;
  }

  bool are_collinear(std::size_t a, std::size_t b, std::size_t c) const
  {
    return m_exposed.geom_traits().coplanar_orientation_3_object()(m_points[a], m_points[b],
                                                                   m_points[c]) == COLLINEAR;
  }

private:
  Exposed<GeomTraits> m_exposed;
  Exposed<Cospherical_traits> m_cospherical;
  const std::vector<Point>& m_points;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_PERTURBED_PREDICATES_H
