// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STARTING_SIMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STARTING_SIMPLEX_H

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Four points that do not lie in one plane, positively oriented.
struct Starting_simplex
{
  std::array<std::size_t, 4> points;
  bool is_found;
};

// The first such points among n; `point(i)` gives the coordinates of the i-th. Exact; O(n) at worst, a
// few tests as a rule.
template <class Predicates, class PointOf>
Starting_simplex starting_simplex(const Predicates& predicates, std::size_t n, const PointOf& point)
{
  std::size_t b = 1;
  while (b < n && std::equal(point(0), point(0) + 3, point(b)))
    ++b;
  std::size_t c = b + 1;
  while (c < n && predicates.are_collinear(point(0), point(b), point(c)))
    ++c;
  for (std::size_t d = c + 1; d < n; ++d) {
    const Orientation o = predicates.orientation(point(0), point(b), point(c), point(d));
    if (o != COPLANAR)
      return {o == POSITIVE ? std::array<std::size_t, 4>{0, b, c, d}
                            : std::array<std::size_t, 4>{b, 0, c, d},
              true};
  }
  return {{}, false};
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STARTING_SIMPLEX_H
