// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ORDER_BY_CORE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ORDER_BY_CORE_H

// The core's orders for the points of any kernel: what the plans with a public face share.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Given_edges.h>
#include <CGAL/Delaunay_from_surface_3/core/order/view_of_order.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// x, y and z of one point after the other, as doubles near them.
template <class Point>
Large_vector<double> rounded_coordinates(const std::vector<Point>& points)
{
  Large_vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point& p : points) {
    coordinates.push_back(to_double(p.x()));
    coordinates.push_back(to_double(p.y()));
    coordinates.push_back(to_double(p.z()));
  }
  return coordinates;
}

template <class Point>
Insertion_order order_by_core(const std::vector<Point>& points, const Order_request& request,
                              Edge_source& edges, const Executor& executor = Alone())
{
  const auto coordinates = rounded_coordinates(points);
  const Point_array array(coordinates.data(), points.size());
  return copy_of(order_of_core(request, edges)->make(array, executor));
}

// Where there are no edges.
template <class Point>
Insertion_order order_by_core(const std::vector<Point>& points, const Order_request& request)
{
  Given_edges none;
  return order_by_core(points, request, none);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ORDER_BY_CORE_H
