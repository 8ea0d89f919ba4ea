// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_TEST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_TEST_H

// Whether a point is in conflict with a cell that may be gone: of the cell only the vertices are
// known. The answers are those of CGAL's find_conflicts(), perturbation included.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

enum class Conflict { NO, YES, AT_VERTEX };

template <class Triangulation>
class Conflict_test
{
  using Geom_traits = typename Triangulation::Geom_traits;
  using Point = typename Triangulation::Point;
  using Vertex = typename Triangulation::Vertex_handle;

  // Gives access to CGAL's perturbed predicates: protected members, which use nothing of the
  // triangulation but its traits.
  struct Exposed : Delaunay_triangulation_3<Geom_traits>
  {
    using Base = Delaunay_triangulation_3<Geom_traits>;
    using Base::Base;
    using Base::coplanar_side_of_bounded_circle;
    using Base::side_of_oriented_sphere;
  };

public:
  using Vertices = std::array<Vertex, 4>; // of a cell, in its orientation

  explicit Conflict_test(const Triangulation& tr)
    : m_tr(tr)
    , m_exposed(tr.geom_traits())
  {
  }

  Conflict operator()(const Vertices& v, const Point& p) const
  {
    for (std::size_t i = 0; i < 4; ++i)
      if (m_tr.is_infinite(v[i]))
        return with_infinite_cell(v, i, p);
    const Point &a = v[0]->point(), &b = v[1]->point(), &c = v[2]->point(), &d = v[3]->point();
    const Oriented_side side = traits().side_of_oriented_sphere_3_object()(a, b, c, d, p);
    if (side != ON_ORIENTED_BOUNDARY)
      return answer(side == ON_POSITIVE_SIDE);
    if (vertex_at(v, p) != Vertex())
      return Conflict::AT_VERTEX;
    return answer(m_exposed.side_of_oriented_sphere(a, b, c, d, p, true) == ON_POSITIVE_SIDE);
  }

  // The finite vertex at p; none if there is none.
  Vertex vertex_at(const Vertices& v, const Point& p) const
  {
    for (const Vertex u : v)
      if (!m_tr.is_infinite(u) && traits().compare_xyz_3_object()(u->point(), p) == EQUAL)
        return u;
    return Vertex();
  }

private:
  static Conflict answer(bool is_in_conflict)
  {
    return is_in_conflict ? Conflict::YES : Conflict::NO;
  }

  // Beyond the finite facet, or in its plane and inside its circle.
  Conflict with_infinite_cell(const Vertices& v, std::size_t infinite, const Point& p) const
  {
    std::array<const Point*, 4> q;
    for (std::size_t i = 0; i < 4; ++i)
      q[i] = i == infinite ? &p : &v[i]->point();
    const Orientation o = traits().orientation_3_object()(*q[0], *q[1], *q[2], *q[3]);
    if (o != COPLANAR)
      return answer(o == POSITIVE);
    if (vertex_at(v, p) != Vertex())
      return Conflict::AT_VERTEX;
    std::swap(q[infinite], q[3]);
    return answer(m_exposed.coplanar_side_of_bounded_circle(*q[0], *q[1], *q[2], p, true) ==
                  ON_BOUNDED_SIDE);
  }

  const Geom_traits& traits() const { return m_tr.geom_traits(); }

  const Triangulation& m_tr;
  Exposed m_exposed;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_TEST_H
