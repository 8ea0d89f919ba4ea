// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_ORDERS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_ORDERS_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Log_star_rounds that are a type for each way to sort them, as Surface_insertion_policies_3 asks.
namespace meters {

template <CGAL::Delaunay_from_surface_3::Log_star_rounds::Sorted_rounds sorted>
struct Sorted_log_star_rounds : CGAL::Delaunay_from_surface_3::Log_star_rounds
{
  explicit Sorted_log_star_rounds(unsigned int seed = 0)
    : Log_star_rounds(seed, sorted)
  {
  }
};

using Random_log_star_rounds =
    Sorted_log_star_rounds<CGAL::Delaunay_from_surface_3::Log_star_rounds::NO_ROUND>;
using Hilbert_log_star_rounds =
    Sorted_log_star_rounds<CGAL::Delaunay_from_surface_3::Log_star_rounds::ALL_ROUNDS>;

// Beyond the paper: once the order is known, so is which surface neighbour of a point will have
// been inserted last when its turn comes. One pass over the edges of F finds it for all points.

// Takes the order of Plan and names for every point a starting place: the neighbour in the graph
// that was inserted last before it, or, if none was, the point inserted just before. In a coherent
// order that neighbour is near, and what is known of it is still in the cache. For Planned_hints_3.
// The cost of Plan, plus O(n + m) for n points and m edges.
//
// Plan: a model of InsertionPlan, constructible from a seed
template <class Plan>
class Neighbor_started_rounds
{
public:
  explicit Neighbor_started_rounds(unsigned int seed = 0)
    : m_plan(seed)
  {
  }

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  CGAL::Delaunay_from_surface_3::Insertion_order
  operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph& graph,
             VertexIndexMap index_map) const
  {
    using namespace CGAL::Delaunay_from_surface_3::internal;
    auto plan = m_plan(points, gt, graph, index_map);
    const std::vector<std::size_t> place = inverse(plan.order);

    // First 1 + the last place before k that holds a neighbour of order[k], or 0 if there is none.
    std::vector<std::size_t>& start = plan.starting_places;
    start.assign(points.size(), 0);
    for (auto [e, end] = edges(graph); e != end; ++e) {
      const std::size_t s = place[std::size_t(get(index_map, source(*e, graph)))];
      const std::size_t t = place[std::size_t(get(index_map, target(*e, graph)))];
      std::size_t& latest = start[(std::max)(s, t)];
      if (s != t)
        latest = (std::max)(latest, (std::min)(s, t) + 1);
    }
    for (std::size_t k = 1; k < start.size(); ++k)
      start[k] = (start[k] == 0 ? k : start[k]) - 1;
    return plan;
  }

private:
  Plan m_plan;
};

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_ORDERS_H
