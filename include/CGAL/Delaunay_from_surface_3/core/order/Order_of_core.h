// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/order_of_points.h>
#include <CGAL/Delaunay_from_surface_3/core/order/view_of_order.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The order that the core makes itself: by nets of the edges or in spaced rounds, within a budget; then
// by random rounds.
class Order_of_core final : public Order_source
{
public:
  // Keeps a reference.
  Order_of_core(const Order_request& request, Edge_source& edges)
    : m_request(request)
    , m_edges(edges)
  {
  }

  Order_view make(const Point_array& points, const Executor& executor) override
  {
    if (m_request.kind == Order_request::NETS && m_edges.edges().number_of_items == 0)
      m_request.kind = Order_request::SPACED; // there are points alone
    m_order = order_of_points(points, m_edges, m_request, executor);
    return view_of(m_order);
  }
  std::size_t cells_per_point() const override
  {
    return m_request.kind != Order_request::GEOMETRIC ? cells_per_point_of_nets : any_number;
  }
  bool is_spread() const override { return m_request.kind == Order_request::SPACED; }
  bool go_on() override
  {
    m_order = Insertion_order(); // before there is another
    return std::exchange(m_request.kind, Order_request::GEOMETRIC) != Order_request::GEOMETRIC;
  }

private:
  Order_request m_request;
  Edge_source& m_edges;
  Insertion_order m_order;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H
