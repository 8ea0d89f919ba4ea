// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_POINTS_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/order/is_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/order/surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The order requested. Rounds are random where there are too many points for numbers of 32 bits.
inline Insertion_order order_of_points(const Point_array& points, Edge_source& edges,
                                       const Order_request& request, const Executor& executor)
{
  const bool are_few = points.size() < (std::numeric_limits<std::uint32_t>::max)();
  Insertion_order order =
      request.kind == Order_request::NETS && are_few
          ? surface_net_rounds(points, edges, request, executor)
      : request.kind == Order_request::SPACED && are_few
          ? spaced_rounds(points, executor)
          : geometric_rounds(points, request.seed, request.ratio, request.first_round);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(is_order(order, points.size()));
  return order;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_POINTS_H
