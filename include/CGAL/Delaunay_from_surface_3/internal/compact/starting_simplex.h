// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STARTING_SIMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STARTING_SIMPLEX_H

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Four points that do not lie in one plane, positively oriented.
struct Starting_simplex
{
  std::array<std::size_t, 4> points;
  bool is_found;
};

// The first such points among n. Exact; O(n) at worst, a few tests as a rule.
template <class Predicates>
Starting_simplex starting_simplex(const Predicates& predicates, std::size_t n)
{
  std::size_t b = 1;
  while (b < n && predicates.are_equal(0, b))
    ++b;
  std::size_t c = b + 1;
  while (c < n && predicates.are_collinear(0, b, c))
    ++c;
  for (std::size_t d = c + 1; d < n; ++d) {
    const Orientation o = predicates.orientation(0, b, c, d);
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
