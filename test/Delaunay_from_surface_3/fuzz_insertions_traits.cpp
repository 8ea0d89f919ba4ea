// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The traits of the package, and mixtures that a user may make.

#include "check_insertion.h"
#include "insertion_ways.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Compact_delaunay_3.h>
#include <CGAL/Delaunay_from_surface_3/plan/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Hilbert_sorted_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Neighbor_started_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Spatial_sort_order.h>
#include <CGAL/Delaunay_from_surface_3/plan/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Full_graph.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Spanning_forest.h>
#include <CGAL/Delaunay_from_surface_3/trace/Neighbor_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Previous_hint_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Traced_hints_3.h>
#include <CGAL/History_tracing_traits_3.h>
#include <CGAL/Plain_insertion_traits_3.h>
#include <CGAL/Surface_insertion_policies_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

// Enough for 2^6 cells, so that wider ids take over on the way.
template <class Tr>
using With_8_bits = Compact_delaunay_with_ids_3<Tr, std::uint8_t>;
template <class Tr>
using With_64_bits = Compact_delaunay_with_ids_3<Tr, std::uint64_t>;

template <class Subgraph, class Plan, template <class, class> class Hints>
using Compact = Surface_insertion_policies_3<Subgraph, Plan, Hints, Compact_delaunay_3>;

using Random_compact = Compact<Full_graph, Random_plan, Planned_hints_3>;
using Geometric_compact = Compact<Full_graph, Geometric_rounds, Planned_hints_3>;
using Traced_compact = Compact<Spanning_forest, Log_star_rounds, Traced_hints_3>;
using Neighbor_compact = Compact<Full_graph, Spatial_sort_order, Neighbor_hints_3>;
using Started_compact = Compact<Full_graph, Neighbor_started_rounds<Random_plan>, Planned_hints_3>;
using Random_with_8_bits =
    Surface_insertion_policies_3<Full_graph, Random_plan, Previous_hint_3, With_8_bits>;
using Hilbert_with_64_bits =
    Surface_insertion_policies_3<Full_graph, Hilbert_sorted_rounds<Log_star_rounds>,
                                 Previous_hint_3, With_64_bits>;
using Nets_through_cgal =
    Surface_insertion_policies_3<Full_graph, Surface_net_rounds, Neighbor_hints_3>;

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
          {"random plan, compact", check_insertion<Tr, Random_compact, As_soup>},
          {"geometric rounds, compact", check_insertion<Tr, Geometric_compact, As_graph>},
          {"traces, compact", check_insertion<Tr, Traced_compact, As_soup>},
          {"neighbours, compact", check_insertion<Tr, Neighbor_compact, As_graph>},
          {"started random plan, compact", check_insertion<Tr, Started_compact, As_graph>},
          {"random plan, 8 bits", check_insertion<Tr, Random_with_8_bits, As_soup>},
          {"Hilbert rounds, 64 bits", check_insertion<Tr, Hilbert_with_64_bits, As_graph>},
          {"nets through CGAL", check_insertion<Tr, Nets_through_cgal, As_soup>}};
}

} // namespace fuzz
