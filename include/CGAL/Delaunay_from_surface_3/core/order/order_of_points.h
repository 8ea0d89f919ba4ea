// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_POINTS_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/order/is_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The order that is asked for. `lower`: of each point those of its neighbours that have smaller
// numbers, every edge once; or nothing, if there are no edges. Then, and where points or edges are
// too many for numbers of 32 bits, rounds are random.
inline Insertion_order order_of_points(const Point_array& points, Lists<std::uint32_t>&& lower,
                                       const Order_request& request, const Executor& executor)
{
  const std::size_t edges = lower.items.size();
  const bool has_nets =
      request.kind == Order_request::NETS && edges > 0 &&
      (std::max)(points.size(), edges) < (std::numeric_limits<std::uint32_t>::max)();
  Insertion_order order =
      has_nets ? surface_net_rounds(points, std::move(lower), request, executor)
               : geometric_rounds(points, request.seed, request.ratio, request.first_round);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(is_order(order, points.size()));
  return order;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_POINTS_H
