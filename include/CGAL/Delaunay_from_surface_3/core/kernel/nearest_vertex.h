// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_NEAREST_VERTEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_NEAREST_VERTEX_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The square of the distance, rounded.
inline double squared_distance(const double* p, const double* q)
{
  return row(p, q).w;
}

// Whether v is nearer to p than w, exactly. If both are equally near, the lexicographically smaller
// one is.
inline bool is_nearer_exactly(const double* p, const double* v, const double* w)
{
  const int c = compare_distance(p, v, w);
  return c != 0 ? c < 0 : std::lexicographical_compare(v, v + 3, w, w + 3);
}

// Of all vertices, the nearest to p, whose zone of conflict is dug. It is on the zone's boundary:
// the ball whose diameter leads from p to it is empty, so that it will be a neighbour of p. Those
// at the same distance are there too.
// Cost: O(facets); few distances are so close that they are compared exactly.
template <class Id>
Id nearest_vertex_of_zone(const Compact_complex<Id>& complex, const Conflict_zone<Id>& zone, Id p)
{
  // Sums of three squares of differences, in doubles: the errors of two of them, and what can be
  // lost where squares underflow.
  constexpr double relative = 2e-15, absolute = 1e-300;
  const double* const point = complex.vertex(p).coordinates;
  Id nearest = complex.infinite;
  double least = 0;
  for (std::size_t f = 0; f < zone.number_of_facets; ++f)
    for (const Id v : zone.facets[f].corners) {
      if (v == complex.infinite || v == nearest)
        continue;
      const double* const q = complex.vertex(v).coordinates;
      const double distance = squared_distance(q, point);
      const double bound = relative * (distance + least) + absolute;
      if (nearest == complex.infinite || distance < least - bound ||
          (distance <= least + bound &&
           is_nearer_exactly(complex.exact_coordinates(p), complex.exact_coordinates(v),
                             complex.exact_coordinates(nearest)))) {
        nearest = v;
        least = distance;
      }
    }
  return nearest;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_NEAREST_VERTEX_H
