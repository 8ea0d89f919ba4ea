// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H

#include <CGAL/Delaunay_from_surface_3/core/order/Order_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/order_of_points.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <cstdint>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The order that the core makes itself: by nets of the edges, within a budget; then by random rounds.
// edges() gives the edges as lower neighbours, each time that nets are made.
template <class Edges>
class Order_of_core final : public Order_source
{
public:
  Order_of_core(const Order_request& request, const Edges& edges)
    : m_request(request)
    , m_edges(edges)
  {
  }

  Insertion_order make(const Point_array& points, const Executor& executor) override
  {
    Lists<std::uint32_t> lower; // none are no edges
    if (m_request.kind == Order_request::NETS)
      lower = m_edges();
    return order_of_points(points, std::move(lower), m_request, executor);
  }
  Insertion_budget budget() const override
  {
    return m_request.kind == Order_request::NETS ? Insertion_budget(cells_per_point_of_nets)
                                                 : Insertion_budget();
  }
  bool go_on() override
  {
    return std::exchange(m_request.kind, Order_request::GEOMETRIC) == Order_request::NETS;
  }

private:
  Order_request m_request;
  const Edges m_edges;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H
