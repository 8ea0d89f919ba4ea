// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_STARTING_SIMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_STARTING_SIMPLEX_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Points none of which lies in the span of those before it: the first d + 1 of `points`, where d is
// the dimension of all; four are positively oriented.
struct Starting_simplex
{
  std::array<std::size_t, 4> points;
  int dimension; // -1: there are no points
};

// Whether four points lie in a plane across an axis, as most do that lie in one plane.
inline bool share_a_coordinate(const double* a, const double* b, const double* c, const double* d)
{
  for (int i = 0; i < 3; ++i)
    if (a[i] == b[i] && a[i] == c[i] && a[i] == d[i])
      return true;
  return false;
}

// The first such points among n; `point(i)` gives the coordinates of the i-th. Exact; O(n) at
// worst, a few tests as a rule.
template <class PointOf>
Starting_simplex starting_simplex(std::size_t n, const PointOf& point)
{
  std::size_t b = 1;
  while (b < n && std::equal(point(0), point(0) + 3, point(b)))
    ++b;
  std::size_t c = b + 1;
  while (c < n && are_collinear(point(0), point(b), point(c)))
    ++c;
  for (std::size_t d = c + 1; d < n; ++d) {
    if (share_a_coordinate(point(0), point(b), point(c), point(d)))
      continue;
    const int o = orientation(point(0), point(b), point(c), point(d));
    if (o != 0)
      return {o > 0 ? std::array<std::size_t, 4>{0, b, c, d}
                    : std::array<std::size_t, 4>{b, 0, c, d},
              3};
  }
  return {{0, b, c, 0}, n == 0 ? -1 : int(b < n) + int(c < n)};
}

// Starts a complex with such points, and notes them in vertex_of, by point. Returns one of these
// vertices; 0 if the points lie in one plane.
template <class Id>
Id start_complex(const Starting_simplex& simplex, Compact_complex<Id>& complex,
                 std::vector<Id>& vertex_of)
{
  if (simplex.dimension < 3)
    return 0;
  std::array<Id, 4> v;
  for (std::size_t k = 0; k < 4; ++k)
    v[k] = vertex_of[simplex.points[k]] = Compact_complex<Id>::vertex_of_point(simplex.points[k]);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(
      orientation(complex.exact_coordinates(v[0]), complex.exact_coordinates(v[1]),
                  complex.exact_coordinates(v[2]), complex.exact_coordinates(v[3])) > 0);
  complex.start(v);
  return v[0];
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_STARTING_SIMPLEX_H
