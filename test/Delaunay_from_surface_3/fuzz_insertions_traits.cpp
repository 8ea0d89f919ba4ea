// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The traits of the package, and mixtures that a user may make.

#include "core_traits.h"
#include "check_insertion.h"
#include "insertion_ways.h"

#include <Delaunay_from_surface_3_meters/orders.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fuzz {
namespace {

using namespace CGAL;
using namespace CGAL::Delaunay_from_surface_3;

// Any order, any rounds, and any point before it for each point to start from.
struct Random_plan
{
  explicit Random_plan(unsigned int seed)
    : m_seed(seed)
  {
  }

  template <class Points, class Gt, class Graph, class Map>
  Insertion_order operator()(const Points& points, const Gt&, const Graph&, Map) const
  {
    Random r(m_seed);
    Insertion_order plan;
    plan.order = all_parts(points.size());
    r.shuffle(plan.order);
    const std::size_t mean = 1 + r.below(50);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i + 1 == points.size() || r.one_in(mean))
        plan.round_ends.push_back(i + 1);
      plan.starting_places.push_back(i == 0 ? 0 : r.below(i));
    }
    return plan;
  }

private:
  unsigned int m_seed;
};

template <class Plan, template <class, class> class Hints>
using Core = Surface_insertion_policies_3<Full_graph, Plan, Hints>;

using Random_core = Core<Random_plan, Planned_hints_3>;
using Nets_core = Core<Surface_net_rounds, Planned_hints_3>;
using Geometric_core = Core<Geometric_rounds, Planned_hints_3>;
using Started_core = Core<meters::Neighbor_started_rounds<Random_plan>, Planned_hints_3>;
using Spatial_core = Core<Spatial_sort_order, Previous_hint_3>;
using Hilbert_core = Core<Log_star_rounds, Previous_hint_3>;
using Nets_through_cgal =
    Surface_insertion_policies_3<Full_graph, Surface_net_rounds, Neighbor_hints_3>;
using Planned_through_cgal = tests::Round_the_core<Random_core>;
using Traced_random =
    Surface_insertion_policies_3<Spanning_forest, meters::Random_log_star_rounds, Traced_hints_3>;

using Tr = Delaunay_triangulation_3<Exact_predicates_inexact_constructions_kernel>;

} // namespace

std::vector<Insertion_way> ways_by_traits()
{
  return {{"default, soup", check_insertion<Tr, Surface_insertion_traits_3, As_soup>},
          {"default, points", check_insertion<Tr, Surface_insertion_traits_3, As_points>},
          {"default, graph", check_insertion<Tr, Surface_insertion_traits_3, As_graph>},
          {"default, mesh", check_insertion<Tr, Surface_insertion_traits_3, As_mesh>},
          {"tracing, mesh", check_insertion<Tr, Tracing_traits_3, As_mesh>},
          {"history, mesh", check_insertion<Tr, History_tracing_traits_3, As_mesh>},
          {"plain order, soup", check_insertion<Tr, Plain_insertion_traits_3, As_soup>},
          {"random plan, core", check_insertion<Tr, Random_core, As_soup>},
          {"nets, core", check_insertion<Tr, Nets_core, As_mesh>},
          {"geometric rounds, core", check_insertion<Tr, Geometric_core, As_graph>},
          {"started random plan, core", check_insertion<Tr, Started_core, As_graph>},
          {"spatial order, core", check_insertion<Tr, Spatial_core, As_soup>},
          {"random plan through CGAL", check_insertion<Tr, Planned_through_cgal, As_graph>},
          {"traces of a forest", check_insertion<Tr, Traced_random, As_soup>},
          {"Hilbert rounds, core", check_insertion<Tr, Hilbert_core, As_graph>},
          {"nets through CGAL", check_insertion<Tr, Nets_through_cgal, As_soup>}};
}

} // namespace fuzz
