// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_ORDER_SOURCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_ORDER_SOURCE_H

// The order of insertion by a plan. If the plan is the core's own, only numbers go there; else it
// gets the caller's points and graph.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/view_of_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/check_plan.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What a plan is given: points, traits, graph and index map.
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

// Whether a plan names a budget, and a plan to fall back to when it is exceeded.
template <class Plan>
using Budget = std::void_t<decltype(Plan::cells_per_point),
                           decltype(std::declval<const Plan&>().fallback_plan())>;

template <class Plan>
constexpr bool has_budget = is_detected<Budget, Plan>;

// Whether the core can carry the plan out: not one that a caller has derived from one of the
// core's.
template <class Plan>
using Plan_of_core = typename Plan::Plan_of_core;

template <class Plan>
constexpr bool is_plan_of_core = std::is_same<Plan, detected_or_t<void, Plan_of_core, Plan>>::value;

template <class Plan, class Points>
std::unique_ptr<Order_source> order_source(const Plan& plan, const Points& points,
                                           Edge_source& edges);

// The order of a caller's plan, and then that of its fallback plan, if the budget is exceeded. An
// order that no insertion could use is refused with a std::invalid_argument.
template <class Plan, class Points>
class Order_of_plan final : public Order_source
{
public:
  Order_of_plan(const Points& points, Edge_source& edges, const Plan& plan)
    : m_points(points)
    , m_edges(edges)
    , m_plan(plan)
  {
  }

  // The plan gets the points as the caller knows them.
  Order_view make(const Point_array& points, const Executor& executor) override
  {
    if (m_next)
      return m_next->make(points, executor);
    m_order = m_plan(m_points.points, m_points.gt, m_points.graph, m_points.index_map);
    check_plan(m_order, m_points.points.size());
    return view_of(m_order);
  }
  std::size_t cells_per_point() const override
  {
    if (m_next)
      return m_next->cells_per_point();
    if constexpr (has_budget<Plan>)
      return Plan::cells_per_point;
    else
      return any_number;
  }
  bool go_on() override
  {
    if (m_next)
      return m_next->go_on();
    m_order = Insertion_order(); // frees the memory before another is made
    if constexpr (has_budget<Plan>)
      m_next = order_source(m_plan.fallback_plan(), m_points, m_edges);
    return m_next != nullptr;
  }

private:
  const Points& m_points;
  Edge_source& m_edges;
  const Plan m_plan;
  Insertion_order m_order;
  std::unique_ptr<Order_source> m_next;
};

// Keeps a reference to the points.
template <class Plan, class Points>
std::unique_ptr<Order_source> order_source(const Plan& plan, const Points& points,
                                           Edge_source& edges)
{
  if constexpr (is_plan_of_core<Plan>)
    return order_of_core(plan.order_request(), edges);
  else
    return std::make_unique<Order_of_plan<Plan, Points>>(points, edges, plan);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_ORDER_SOURCE_H
