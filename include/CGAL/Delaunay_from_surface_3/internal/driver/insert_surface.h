// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H

// What all public functions share, from the named parameters to the loop of Choi 2002, Fig. 1:
//   insert_surface        reads the parameters
//   insert_and_write      builds aside what is empty, and writes the pairs of points and vertices
//   insert_by_plan        makes the order and T, and begins anew in another order if that one is too dear
//   insert_into_target    chooses the target (insert_into_target.h)
//   insert_in_rounds      is the loop (insert_in_rounds.h)

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Visitor_in_mode_of_caller.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/check_plan.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_into_target.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/permutation.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/iterator.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Order, T, and the points in that order.
template <class Hints, class Traits, class Triangulation, class Plan, class Graph,
          class VertexIndexMap, class Visitor>
Planned_points<typename Triangulation::Point>
plan_insertion(const Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
               const Graph& graph, VertexIndexMap index_map, const Traits& traits,
               const Plan& make_plan, Visitor& visitor)
{
  using Phase = Surface_insertion_phase;
  Planned_points<typename Triangulation::Point> planned;
  visitor.phase_begins(Phase::PLAN);
  planned.plan = make_plan(points, tr.geom_traits(), graph, index_map);
  planned.places = check_plan(planned.plan, points.size());
  planned.points = permuted(points, planned.plan.order);
  if constexpr (Has_budget<Plan>::value)
    planned.budget = Insertion_budget(Plan::cells_per_point);
  visitor.phase_begins(Phase::SUBGRAPH);
  if constexpr (Hints::uses_subgraph)
    planned.subgraph = spanning_subgraph(traits.surface_subgraph_object(), graph, index_map,
                                         planned.places, visitor);
  return planned;
}

// Inserts by the plan; if that exceeds its budget, anew by the one that it names for this case. Returns
// the vertices by point.
template <class Traits, class Triangulation, class Plan, class Graph, class VertexIndexMap,
          class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_by_plan(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
               const Graph& graph, VertexIndexMap index_map, const Traits& traits,
               const Plan& make_plan, Visitor& visitor)
{
  using Target = typename Traits::template Insertion_target_3<Triangulation>;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;

  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  {
    const auto planned =
        plan_insertion<Hints>(tr, points, graph, index_map, traits, make_plan, visitor);
    inserted = insert_into_target<Target, Traits>(tr, planned, visitor);
    inserted.vertices = permuted(inserted.vertices, planned.places);
  }
  if constexpr (Has_budget<Plan>::value)
    if (inserted.outcome == Insertion_outcome::OVER_BUDGET) {
      visitor.order_is_replaced("its insertions destroy or enter too many cells");
      return insert_by_plan(tr, points, graph, index_map, traits, make_plan.fallback_plan(),
                            visitor);
    }
  return inserted;
}

// Inserts the points; at last `write` is given their vertices, by point. An empty triangulation is
// built aside, as a copy that keeps its traits, its lock structure and what its infinite vertex holds:
// it changes when nothing can fail any more.
template <class Traits, class Triangulation, class Graph, class VertexIndexMap, class Visitor,
          class Write>
void insert_and_write(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                      const Graph& graph, VertexIndexMap index_map, const Traits& traits,
                      unsigned int seed, Visitor& visitor, const Write& write)
{
  const Rounding_to_nearest rounding;
  Visitor_in_mode_of_caller<Visitor> observer(visitor, rounding);
  const auto insert_into = [&](Triangulation& into, bool writes_after_stop) {
    const auto inserted = insert_by_plan(into, points, graph, index_map, traits,
                                         traits.insertion_plan_object(seed), observer);
    const bool is_complete = inserted.outcome == Insertion_outcome::COMPLETE;
    if (is_complete || writes_after_stop)
      rounding.in_mode_of_caller([&] { write(inserted.vertices); });
    observer.phase_begins(Surface_insertion_phase::DONE);
    return is_complete;
  };
  if (tr.number_of_vertices() > 0) {
    insert_into(tr, true);
  } else {
    Triangulation aside(tr);
    if (insert_into(aside, false))
      tr.swap(aside);
  }
}

// A visitor in std::ref() serves as it is. Any other is copied, since its functions may change it;
// get_parameter_reference() gives a reference to what is gone by then.
template <class Visitor>
Visitor visitor_of(const Visitor& visitor)
{
  return visitor;
}

template <class Visitor>
Visitor& visitor_of(const std::reference_wrapper<Visitor>& visitor)
{
  return visitor;
}

// The parameters that all forms share: seed, visitor, and what is done with the vertices.
template <class Triangulation, class Graph, class VertexIndexMap, class Traits,
          class NamedParameters, class NameOf>
std::ptrdiff_t insert_surface(Triangulation& tr,
                              const std::vector<typename Triangulation::Point>& points,
                              const std::optional<std::string>& irregularity, const Graph& graph,
                              VertexIndexMap index_map, const Traits& traits,
                              const NamedParameters& np, const NameOf& name_of)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  auto&& visitor = visitor_of(choose_parameter<Default_surface_insertion_visitor_3>(
      get_parameter(np, internal_np::visitor)));
  const auto seed =
      static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0));
  auto out = choose_parameter(get_parameter(np, internal_np::vertex_to_vertex_output_iterator),
                              Emptyset_iterator());

  if (irregularity)
    visitor.surface_is_irregular(*irregularity);
  const auto before = static_cast<std::ptrdiff_t>(tr.number_of_vertices());
  insert_and_write(tr, points, graph, index_map, traits, seed, visitor, [&](const auto& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] != typename Triangulation::Vertex_handle())
        *out++ = std::make_pair(name_of(i), vertices[i]);
  });
  return static_cast<std::ptrdiff_t>(tr.number_of_vertices()) - before;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H
