// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

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
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n; rounds are cut off until at most `first_round` points are left.
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

// The order of points that lie on one line, along it: on the axis along which the first two that
// differ are farthest from each other. In one round; O(n log n), O(n) if they come in that order.
inline Insertion_order order_along_line(const Point_array& points)
{
  const std::size_t n = points.size();
  std::size_t other = 1, axis = 0;
  while (other < n && std::equal(points[0], points[0] + 3, points[other]))
    ++other;
  for (std::size_t c = 1; other < n && c < 3; ++c)
    if (std::abs(points[other][c] - points[0][c]) > std::abs(points[other][axis] - points[0][axis]))
      axis = c;
  std::vector<std::pair<double, std::size_t>> places(n);
  for (std::size_t i = 0; i < n; ++i)
    places[i] = {points[i][axis], i};
  if (!std::is_sorted(places.begin(), places.end()))
    std::sort(places.begin(), places.end());
  Insertion_order plan;
  plan.order.reserve(n);
  for (const auto& place : places)
    plan.order.push_back(place.second);
  if (n > 0)
    plan.round_ends.push_back(n);
  return plan;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H
