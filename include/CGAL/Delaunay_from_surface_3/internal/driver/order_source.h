// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ORDER_SOURCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ORDER_SOURCE_H

// The order of insertion by a plan. If the plan is the core's own, only numbers go there; else it gets
// the caller's points and graph.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Order_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Order_of_core.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Has_budget.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/check_plan.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/lower_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// What a plan is asked about.
template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
struct Planned_points
{
  const std::vector<Point>& points;
  const GeomTraits& gt;
  const Graph& graph;
  VertexIndexMap index_map;
};

template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
Planned_points(const std::vector<Point>&, const GeomTraits&, const Graph&, VertexIndexMap)
    -> Planned_points<Point, GeomTraits, Graph, VertexIndexMap>;

// Can the core carry the plan out? Not one that a caller has derived from one of the core's.
template <class Plan, class = void>
struct Is_plan_of_core : std::false_type
{
};
template <class Plan>
struct Is_plan_of_core<Plan, std::void_t<typename Plan::Plan_of_core>>
  : std::is_same<Plan, typename Plan::Plan_of_core>
{
};

// The edges of the graph of a caller; none if they are too many.
template <class Points>
class Edges_of_graph
{
public:
  // Keeps a reference.
  explicit Edges_of_graph(const Points& points)
    : m_points(&points)
  {
  }

  Lists<std::uint32_t> operator()() const
  {
    constexpr std::size_t too_many = (std::numeric_limits<std::uint32_t>::max)();
    const std::size_t n = m_points->points.size(), m = std::size_t(num_edges(m_points->graph));
    if (m == 0 || (std::max)(n, m) >= too_many)
      return {};
    return lower_neighbors(m_points->graph, m_points->index_map, n);
  }

private:
  const Points* m_points;
};

template <class Plan, class Points>
std::unique_ptr<Order_source> order_source(const Plan& plan, const Points& points);

// By a caller's plan, and then by the one that it names for when its budget is exceeded. An order that
// no insertion could use is refused with a std::invalid_argument.
template <class Plan, class Points>
class Order_of_plan final : public Order_source
{
public:
  Order_of_plan(const Points& points, const Plan& plan)
    : m_points(points)
    , m_plan(plan)
  {
  }

  // The plan gets the points as the caller knows them.
  Insertion_order make(const Point_array& points, const Executor& executor) override
  {
    if (m_next)
      return m_next->make(points, executor);
    Insertion_order order =
        m_plan(m_points.points, m_points.gt, m_points.graph, m_points.index_map);
    check_plan(order, m_points.points.size());
    return order;
  }
  Insertion_budget budget() const override
  {
    if (m_next)
      return m_next->budget();
    if constexpr (Has_budget<Plan>::value)
      return Insertion_budget(Plan::cells_per_point);
    else
      return Insertion_budget();
  }
  bool go_on() override
  {
    if (m_next)
      return m_next->go_on();
    if constexpr (Has_budget<Plan>::value)
      m_next = order_source(m_plan.fallback_plan(), m_points);
    return m_next != nullptr;
  }

private:
  const Points& m_points;
  const Plan m_plan;
  std::unique_ptr<Order_source> m_next;
};

// Keeps a reference to the points.
template <class Plan, class Points>
std::unique_ptr<Order_source> order_source(const Plan& plan, const Points& points)
{
  if constexpr (Is_plan_of_core<Plan>::value)
    return std::make_unique<Order_of_core<Edges_of_graph<Points>>>(plan.order_request(),
                                                                   Edges_of_graph<Points>(points));
  else
    return std::make_unique<Order_of_plan<Plan, Points>>(points, plan);
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ORDER_SOURCE_H
