// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H

// A biased randomised insertion order (Amenta, Choi, Rote 2003): rounds that grow geometrically,
// each in a spatially coherent order.
//
// Cost: O(n log n) expected.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n, from the first that is at most first_round; nothing for
// n = 0.
inline std::vector<std::size_t> geometric_round_ends(std::size_t n, double ratio,
                                                     std::size_t first_round)
{
  std::vector<std::size_t> ends;
  for (std::size_t end = n; end > 0;) {
    ends.push_back(end);
    end = end <= first_round ? 0 : static_cast<std::size_t>(std::floor(double(end) * ratio));
  }
  std::reverse(ends.begin(), ends.end());
  return ends;
}

// A random order, in these rounds, each sorted by halves.
inline Insertion_order geometric_rounds(const Point_array& points, unsigned int seed, double ratio,
                                        std::size_t first_round)
{
  Insertion_order result;
  result.order.resize(points.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t(0));
  Split_mix(seed).shuffle(result.order.begin(), result.order.end());
  result.round_ends = geometric_round_ends(points.size(), ratio, first_round);
  Sort_by_halves sort;
  std::size_t first = 0;
  for (const std::size_t end : result.round_ends) {
    sort(points, result.order.data() + first, result.order.data() + end);
    first = end;
  }
  return result;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H
