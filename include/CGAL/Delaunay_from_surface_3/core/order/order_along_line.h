// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_ALONG_LINE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_ALONG_LINE_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_ALONG_LINE_H
