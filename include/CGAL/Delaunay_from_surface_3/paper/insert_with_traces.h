// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_WITH_TRACES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_WITH_TRACES_H

// The paper's way: order and T from the surface, then Choi 2002, Fig. 1, on CGAL's own triangulation.

#include <CGAL/Delaunay_from_surface_3/paper/check_plan.h>
#include <CGAL/Delaunay_from_surface_3/paper/insert_through_cgal.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Traits, class Triangulation, class Input, class Watcher>
Inserted_points<typename Triangulation::Vertex_handle>
insert_with_traces(Triangulation& tr, const Input& input, const Traits& traits, unsigned int seed,
                   Watcher& watcher)
{
  using Phase = Surface_insertion_phase;
  using Target = Triangulation_target_3<Triangulation>;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;
  watcher.phase_begins(Phase::PLAN);
  const Insertion_order plan = traits.insertion_plan_object(seed)(input.points, tr.geom_traits(),
                                                                  input.graph, input.index_map);
  const std::vector<std::size_t> places = check_plan(plan, input.points.size());
  watcher.phase_begins(Phase::SUBGRAPH);
  Index_graph subgraph;
  if constexpr (Hints::uses_subgraph)
    subgraph = spanning_subgraph(traits.surface_subgraph_object(), input.graph, input.index_map,
                                 places, watcher);
  return insert_through_cgal<Traits::template Insertion_hints_3>(tr, input.points, plan, subgraph,
                                                                 watcher);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_WITH_TRACES_H
