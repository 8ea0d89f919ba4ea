// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/order_of_indices.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/permutation.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

using Phase = Surface_insertion_phase;

// Choi 2002, Fig. 1, for points that are numbered s_0, s_1, … in the order of insertion. Returns
// false if the visitor stopped it.
template <class Target, class Hints, class Visitor>
bool insert_in_rounds(const std::vector<std::size_t>& round_ends, Target& target, Hints& hints,
                      Visitor& visitor)
{
  std::size_t i = 0;
  for (std::size_t h = 0; h < round_ends.size(); ++h) {
    const std::size_t N_h = round_ends[h];
    visitor.round_begins(h, N_h - i);
    for (; i < N_h; ++i) {
      if (!visitor.go_further())
        return false;
      visitor.phase_begins(Phase::LOCATION);
      const typename Target::Location d_i = target.locate(i, hints.start(i)); // 2b
      visitor.phase_begins(Phase::UPDATE);
      target.insert(i, d_i, hints); // 2c
    }
    if (N_h < target.size()) {
      visitor.phase_begins(Phase::TRACE);
      visitor.trace_ends(hints.trace()); // 2a
    }
  }
  visitor.phase_begins(Phase::FINISH);
  target.finish();
  return true;
}

// The vertices of the points, and whether the visitor let the work come to its end.
template <class Vertex>
struct Inserted_points
{
  std::vector<Vertex> vertices;
  bool is_complete;
};

// numbers[i] is the place of points[i] in the order of insertion; `subgraph` joins these numbers.
// What is inserted one after the other then lies side by side; with the numbers of the mesh nearly
// every point and record would miss the cache. The vertices come back as `points` came.
template <class Target, class Hints, class Triangulation, class Graph, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_as_planned(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                  const Insertion_order& plan, const std::vector<std::size_t>& numbers,
                  const Graph& subgraph, Visitor& visitor)
{
  const auto s = permuted(points, plan.order);
  Target target(tr, s);
  Hints hints(target, subgraph, plan);
  const bool is_complete = insert_in_rounds(plan.round_ends, target, hints, visitor);
  return {permuted(target.take_vertices(), numbers), is_complete};
}

// Plan and subgraph from the surface, then the rounds; at last `write` is given the vertices of the
// points. An empty triangulation is built aside, as a copy that keeps its traits, its lock
// structure and what its infinite vertex holds: it changes when nothing can fail any more.
template <class Target, class Traits, class Triangulation, class Graph, class VertexIndexMap,
          class Visitor, class Write>
void insert_surface_into(Triangulation& tr,
                         const std::vector<typename Triangulation::Point>& points,
                         const Graph& graph, VertexIndexMap index_map, const Traits& traits,
                         unsigned int seed, Visitor& visitor, const Write& write)
{
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;

  visitor.phase_begins(Phase::PLAN);
  const Insertion_order plan =
      traits.insertion_plan_object(seed)(points, tr.geom_traits(), graph, index_map);
  const std::vector<std::size_t> numbers = inverse(plan.order);
  visitor.phase_begins(Phase::SUBGRAPH);
  Index_graph subgraph;
  if constexpr (Hints::uses_subgraph)
    subgraph =
        spanning_subgraph(traits.surface_subgraph_object(), graph, index_map, numbers, visitor);

  if (tr.number_of_vertices() > 0) {
    write(insert_as_planned<Target, Hints>(tr, points, plan, numbers, subgraph, visitor).vertices);
    visitor.phase_begins(Phase::DONE);
    return;
  }
  Triangulation aside(tr);
  const auto inserted =
      insert_as_planned<Target, Hints>(aside, points, plan, numbers, subgraph, visitor);
  if (inserted.is_complete)
    write(inserted.vertices);
  visitor.phase_begins(Phase::DONE);
  if (inserted.is_complete)
    tr.swap(aside);
}

// The target of the traits serves if it can; else CGAL's own insertion does.
template <class Traits, class Triangulation, class Graph, class VertexIndexMap, class Visitor,
          class Write>
void insert_surface(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                    const Graph& graph, VertexIndexMap index_map, const Traits& traits,
                    unsigned int seed, Visitor& visitor, const Write& write)
{
  using Target = typename Traits::template Insertion_target_3<Triangulation>;
  if constexpr (Target::serves_everything) {
    insert_surface_into<Target>(tr, points, graph, index_map, traits, seed, visitor, write);
  } else {
    const std::string obstacle = Target::obstacle(tr, points);
    if constexpr (Target::serves_geom_traits()) // otherwise it need not be compiled
      if (obstacle.empty())
        return insert_surface_into<Target>(tr, points, graph, index_map, traits, seed, visitor,
                                           write);
    visitor.target_is_replaced(obstacle);
    insert_surface_into<Triangulation_target_3<Triangulation>>(tr, points, graph, index_map, traits,
                                                               seed, visitor, write);
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H
