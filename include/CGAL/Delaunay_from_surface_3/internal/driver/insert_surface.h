// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H

// What comes before the loop of Fig. 1 (insert_in_rounds.h) and after it: the order of the points, T,
// the choice of the target, and an empty triangulation that is built aside.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Visitor_in_mode_of_caller.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/check_plan.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_in_rounds.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/permutation.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The points in the order of insertion, the plan that says so, and T on their places. What is inserted
// one after the other lies side by side; with the numbers of the mesh nearly every point and record
// would miss the cache.
template <class Point>
struct Planned_points
{
  std::vector<Point> points;
  Insertion_order plan;
  Index_graph subgraph;
};

// The vertices of the points, none where the work stopped before; by place.
template <class Vertex_handle>
struct Inserted_points
{
  std::vector<Vertex_handle> vertices;
  bool is_complete;
};

template <class Target, class Traits, class Triangulation, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_into_target(Triangulation& tr, const Planned_points<typename Triangulation::Point>& planned,
                   Visitor& visitor);

// The target that begins anew where `Target` has too few ids; void if there is none.
template <class Target, class = void>
struct Wider_target_of
{
  using type = void;
};
template <class Target>
struct Wider_target_of<Target, std::void_t<typename Target::Wider_target>>
{
  using type = typename Target::Wider_target;
};

template <class Target, class Traits, class Triangulation, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_into_wider_target(Triangulation& tr,
                         const Planned_points<typename Triangulation::Point>& planned,
                         const Too_few_ids& shortage, Visitor& visitor)
{
  using Wider_target = typename Wider_target_of<Target>::type;
  if constexpr (std::is_void<Wider_target>::value) {
    throw shortage;
  } else {
    visitor.target_is_replaced(shortage.what());
    return insert_into_target<Wider_target, Traits>(tr, planned, visitor);
  }
}

template <class Traits, class Triangulation, class Target, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_planned(Target& target, const Planned_points<typename Triangulation::Point>& planned,
               Visitor& visitor)
{
  typename Traits::template Insertion_hints_3<Target, Index_graph> hints(target, planned.subgraph,
                                                                         planned.plan);
  const bool is_complete = insert_in_rounds(planned.plan.round_ends, target, hints, visitor);
  return {target.take_vertices(), is_complete};
}

// Inserts into `Target` if it can serve, else through CGAL's own insertion.
template <class Target, class Traits, class Triangulation, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_into_target(Triangulation& tr, const Planned_points<typename Triangulation::Point>& planned,
                   Visitor& visitor)
{
  if constexpr (Target::serves_everything) {
    Target target(tr, planned.points);
    return insert_planned<Traits, Triangulation>(target, planned, visitor);
  } else {
    std::string obstacle = "the coordinates are not doubles with filtered predicates";
    if constexpr (Target::serves_geom_traits()) { // else it need not compile
      try {
        Target target(tr, planned.points);
        if (target.obstacle().empty())
          return insert_planned<Traits, Triangulation>(target, planned, visitor);
        obstacle = target.obstacle();
      } catch (const Too_few_ids& shortage) {
        return insert_into_wider_target<Target, Traits>(tr, planned, shortage, visitor);
      }
    }
    visitor.target_is_replaced(obstacle);
    return insert_into_target<Triangulation_target_3<Triangulation>, Traits>(tr, planned, visitor);
  }
}

// Order, T, and the points in that order. Returns the place of each point as well.
template <class Target, class Traits, class Triangulation, class Graph, class VertexIndexMap,
          class Visitor>
std::pair<Planned_points<typename Triangulation::Point>, std::vector<std::size_t>>
plan_insertion(const Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
               const Graph& graph, VertexIndexMap index_map, const Traits& traits,
               unsigned int seed, Visitor& visitor)
{
  using Phase = Surface_insertion_phase;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;

  Planned_points<typename Triangulation::Point> planned;
  visitor.phase_begins(Phase::PLAN);
  planned.plan = traits.insertion_plan_object(seed)(points, tr.geom_traits(), graph, index_map);
  std::vector<std::size_t> places = check_plan(planned.plan, points.size());
  planned.points = permuted(points, planned.plan.order);
  visitor.phase_begins(Phase::SUBGRAPH);
  if constexpr (Hints::uses_subgraph)
    planned.subgraph =
        spanning_subgraph(traits.surface_subgraph_object(), graph, index_map, places, visitor);
  return {std::move(planned), std::move(places)};
}

// Inserts the points; at last `write` is given their vertices, by point. An empty triangulation is
// built aside, as a copy that keeps its traits, its lock structure and what its infinite vertex holds:
// it changes when nothing can fail any more.
template <class Traits, class Triangulation, class Graph, class VertexIndexMap, class Visitor,
          class Write>
void insert_surface(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                    const Graph& graph, VertexIndexMap index_map, const Traits& traits,
                    unsigned int seed, Visitor& visitor, const Write& write)
{
  using Target = typename Traits::template Insertion_target_3<Triangulation>;

  const Rounding_to_nearest rounding;
  Visitor_in_mode_of_caller<Visitor> observer(visitor, rounding);
  const auto plan = plan_insertion<Target>(tr, points, graph, index_map, traits, seed, observer);
  const auto& planned = plan.first; // names of their own: a lambda captures no structured binding
  const std::vector<std::size_t>& places = plan.second;
  const auto insert_and_write = [&](Triangulation& into, bool writes_after_stop) {
    const auto inserted = insert_into_target<Target, Traits>(into, planned, observer);
    if (inserted.is_complete || writes_after_stop)
      rounding.in_mode_of_caller([&] { write(permuted(inserted.vertices, places)); });
    observer.phase_begins(Surface_insertion_phase::DONE);
    return inserted.is_complete;
  };
  if (tr.number_of_vertices() > 0) {
    insert_and_write(tr, true);
  } else {
    Triangulation aside(tr);
    if (insert_and_write(aside, false))
      tr.swap(aside);
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H
