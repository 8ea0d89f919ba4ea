// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_ORDERS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_ORDERS_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Tracing_traits_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meters {

// The paper's plan to the letter, as a type, and traits with its random order, as far as walks allow.
struct Random_log_star_rounds : CGAL::Delaunay_from_surface_3::Log_star_rounds
{
  explicit Random_log_star_rounds(unsigned int seed = 0)
    : Log_star_rounds(seed, NO_ROUND)
  {
  }
};

struct Random_tracing_traits : CGAL::Tracing_traits_3
{
  Random_tracing_traits()
    : Tracing_traits_3(Insertion_plan::FIRST_ROUND)
  {
  }
};

// No hint at all: the location starts where insert(p) starts, with Fast_location at the top.
template <class Target, class Subgraph>
struct No_hint_3 : CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>
{
  using CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>::Previous_hint_3;
  typename Target::Cell start(std::size_t) const { return {}; }
};

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
