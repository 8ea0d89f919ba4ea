// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Plans, subgraphs, hints and observers, one by one, with CGAL's expensive checks compiled in.

#define BOOST_TEST_MODULE test_policies
#include <Delaunay_from_surface_3_meters/orders.h>

#include <boost/test/included/unit_test.hpp>

#include "check_equal.h"
#include "checking_hints.h"
#include "points_and_graphs.h"

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_points_along_graph_3.h>
#include <CGAL/spatial_sort.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast_triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;
using tests::Graph;
using tests::graph_of;
using Indices = std::vector<std::size_t>;

namespace {

using tests::Indexed_surface;
using tests::Named_surface;

template <class Plan>
DFS::Insertion_order order_by(const Plan& plan, const std::vector<Point>& points)
{
  const Graph graph(points.size());
  return plan(points, Kernel(), graph, get(boost::vertex_index, graph));
}

// Round by round the indices inserted, sorted.
std::vector<Indices> sets_of_rounds(const DFS::Insertion_order& plan)
{
  std::vector<Indices> sets;
  std::size_t first = 0;
  for (const std::size_t end : plan.round_ends) {
    sets.emplace_back(plan.order.begin() + std::ptrdiff_t(first),
                      plan.order.begin() + std::ptrdiff_t(end));
    std::sort(sets.back().begin(), sets.back().end());
    first = end;
  }
  return sets;
}

void check_is_plan(const DFS::Insertion_order& plan, std::size_t n)
{
  Indices sorted = plan.order;
  std::sort(sorted.begin(), sorted.end());
  BOOST_TEST(sorted == CGAL::Delaunay_from_surface_3::internal::identity_order(n),
             boost::test_tools::per_element());
  BOOST_TEST(plan.round_ends.empty() == (n == 0));
  BOOST_TEST((n == 0 || plan.round_ends.back() == n));
  BOOST_TEST((n == 0 || plan.round_ends.front() > 0));
  BOOST_TEST((std::adjacent_find(plan.round_ends.begin(), plan.round_ends.end(),
                                 std::greater_equal<std::size_t>()) == plan.round_ends.end()));
}

template <class Plan>
void check_plan()
{
  BOOST_TEST_CONTEXT(boost::typeindex::type_id<Plan>().pretty_name())
  {
    for (const std::size_t n : {0, 1, 2, 3, 4, 15, 16, 17, 63, 64, 65, 513, 2000}) {
      std::vector<Point> points = surfaces::sphere(2000, 0.1).points;
      points.resize(n);
      const DFS::Insertion_order plan = order_by(Plan(1), points);
      check_is_plan(plan, n);
      BOOST_TEST(plan.order == order_by(Plan(1), points).order, boost::test_tools::per_element());
    }
  }
}

// Inserts the surface with the given hints, twice: into an empty triangulation and into one that
// holds half of the points.
template <class Tr, template <class, class> class Hints, class Subgraph = DFS::Spanning_forest,
          class Plan = DFS::Log_star_rounds>
void insert_twice(const Named_surface& named, unsigned int seed)
{
  using Traits = CGAL::Surface_insertion_policies_3<Subgraph, Plan, Hints>;
  BOOST_TEST_CONTEXT(named.name << ", seed " << seed)
  {
    const std::vector<Point>& points = named.surface.points;
    const Tr plain(points.begin(), points.end());
    Tr tr, half(points.begin(), points.begin() + std::ptrdiff_t(points.size() / 2));
    for (Tr* t : {&tr, &half}) {
      CGAL::insert_points_along_graph_3(*t, points, graph_of(named.surface), Traits(),
                                        CGAL::parameters::random_seed(seed));
      BOOST_TEST((*t == plain));
      BOOST_TEST(t->is_valid());
    }
  }
}

template <class Tr>
using Zone_hints = tests::Zone_checking_hints<DFS::Triangulation_target_3<Tr>,
                                              CGAL::Delaunay_from_surface_3::internal::Index_graph>;
template <class Tr>
using Traced_hints =
    tests::Checking_traced_hints<DFS::Triangulation_target_3<Tr>,
                                 CGAL::Delaunay_from_surface_3::internal::Index_graph>;

std::vector<Named_surface> small_surfaces()
{
  std::vector<Named_surface> all = tests::tiny_and_flat_surfaces();
  all.push_back({"terrain", surfaces::terrain(120)});
  all.push_back({"lattice", surfaces::lattice_surface(1, 100)});
  all.push_back({"three spheres", surfaces::copies(surfaces::sphere(40, 0.05), 3)});
  Indexed_surface torn = surfaces::sphere(80, 0.05);
  surfaces::duplicate_points(torn, 40, 1);
  all.push_back({"sphere with duplicates", torn});
  return all;
}

} // namespace

// The powers by hand, the rest with sixty decimal digits.
BOOST_AUTO_TEST_CASE(log_star_round_ends)
{
  const auto ends = [](std::size_t n) { return DFS::Log_star_rounds::round_ends(n); };
  BOOST_TEST(ends(0) == Indices(), boost::test_tools::per_element());
  BOOST_TEST(ends(1) == (Indices{1}), boost::test_tools::per_element());
  BOOST_TEST(ends(2) == (Indices{2}), boost::test_tools::per_element());
  BOOST_TEST(ends(3) == (Indices{2, 3}), boost::test_tools::per_element());
  BOOST_TEST(ends(4) == (Indices{2, 4}), boost::test_tools::per_element());
  BOOST_TEST(ends(8) == (Indices{3, 6, 8}), boost::test_tools::per_element());
  BOOST_TEST(ends(15) == (Indices{4, 8, 15}), boost::test_tools::per_element());
  BOOST_TEST(ends(16) == (Indices{4, 8, 16}), boost::test_tools::per_element());
  BOOST_TEST(ends(17) == (Indices{5, 9, 17}), boost::test_tools::per_element());
  BOOST_TEST(ends(255) == (Indices{32, 86, 161, 255}), boost::test_tools::per_element());
  BOOST_TEST(ends(256) == (Indices{32, 86, 162, 256}), boost::test_tools::per_element());
  BOOST_TEST(ends(65535) == (Indices{4096, 16384, 32768, 65535}), boost::test_tools::per_element());
  BOOST_TEST(ends(65536) == (Indices{4096, 16384, 32768, 65536}), boost::test_tools::per_element());
  BOOST_TEST(ends(65537) == (Indices{4097, 16385, 32769, 65537}), boost::test_tools::per_element());
  BOOST_TEST(ends(1000000) == (Indices{50172, 231644, 473929, 928282, 1000000}),
             boost::test_tools::per_element());
  BOOST_TEST(ends(1000000000) == (Indices{33447778, 204000622, 436042479, 835101376, 1000000000}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(geometric_round_ends)
{
  using DFS::Geometric_rounds;
  BOOST_TEST(Geometric_rounds().round_ends(0) == Indices(), boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds().round_ends(1) == (Indices{1}), boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds().round_ends(64) == (Indices{64}), boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds().round_ends(65) == (Indices{8, 65}),
             boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds().round_ends(1000) == (Indices{15, 125, 1000}),
             boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds(0, 0.5, 10).round_ends(100) == (Indices{6, 12, 25, 50, 100}),
             boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds(0, 0.25, 1).round_ends(7) == (Indices{1, 7}),
             boost::test_tools::per_element());
  BOOST_TEST(Geometric_rounds(0, 0.001, 1).round_ends(7) == (Indices{7}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(plans_are_permutations_with_increasing_rounds)
{
  check_plan<DFS::Log_star_rounds>();
  check_plan<meters::Random_log_star_rounds>();
  check_plan<DFS::Geometric_rounds>();
  check_plan<DFS::Spaced_rounds>();
  check_plan<DFS::Spatial_sort_order>();
  check_plan<meters::Neighbor_started_rounds<DFS::Geometric_rounds>>();
}

BOOST_AUTO_TEST_CASE(seeds_draw_the_order)
{
  const std::vector<Point> points = surfaces::sphere(500, 0.1).points;
  BOOST_TEST((order_by(DFS::Log_star_rounds(1), points).order !=
              order_by(DFS::Log_star_rounds(2), points).order));
  BOOST_TEST((order_by(meters::Random_log_star_rounds(1), points).order !=
              order_by(meters::Random_log_star_rounds(2), points).order));
  BOOST_TEST((order_by(DFS::Geometric_rounds(1), points).order !=
              order_by(DFS::Geometric_rounds(2), points).order));
  BOOST_TEST((order_by(DFS::Spaced_rounds(1), points).order ==
              order_by(DFS::Spaced_rounds(2), points).order));
  BOOST_TEST((order_by(DFS::Spatial_sort_order(1), points).order ==
              order_by(DFS::Spatial_sort_order(2), points).order));
}

// Sorted rounds hold the same points as those of the paper's random order. The first round alone
// may be sorted.
BOOST_AUTO_TEST_CASE(sorted_rounds_keep_the_sets)
{
  using DFS::Log_star_rounds;
  const std::vector<Point> points = surfaces::sphere(2000, 0.1).points;
  const auto random = order_by(Log_star_rounds(5, Log_star_rounds::NO_ROUND), points);
  const auto first = order_by(Log_star_rounds(5, Log_star_rounds::FIRST_ROUND), points);
  const auto sorted = order_by(Log_star_rounds(5), points);
  for (const auto* plan : {&first, &sorted}) {
    BOOST_TEST((sets_of_rounds(*plan) == sets_of_rounds(random)));
    BOOST_TEST(plan->round_ends == random.round_ends, boost::test_tools::per_element());
  }
  const auto begin = random.order.begin(), sorted_begin = sorted.order.begin();
  const auto N_1 = std::ptrdiff_t(random.round_ends[0]), N_2 = std::ptrdiff_t(random.round_ends[1]);
  BOOST_TEST(!std::equal(begin, begin + N_1, sorted_begin));
  BOOST_TEST(!std::equal(begin + N_1, begin + N_2, sorted_begin + N_1));
  BOOST_TEST(std::equal(sorted_begin, sorted_begin + N_1, first.order.begin()));
  BOOST_TEST(std::equal(begin + N_1, random.order.end(), first.order.begin() + N_1));
}

// The bounds of the history hold for the paper's own order, which other traits may ask for.
BOOST_AUTO_TEST_CASE(traits_choose_the_rounds_that_are_sorted)
{
  using DFS::Log_star_rounds;
  const std::vector<Point> points = surfaces::sphere(2000, 0.1).points;
  const auto order_of = [&](const auto& traits) {
    return order_by(traits.insertion_plan_object(5), points).order;
  };
  const auto order = [&](Log_star_rounds::Sorted_rounds sorted) {
    return order_by(Log_star_rounds(5, sorted), points).order;
  };
  BOOST_TEST((order_of(CGAL::History_tracing_traits_3()) == order(Log_star_rounds::NO_ROUND)));
  BOOST_TEST((order_of(CGAL::Tracing_traits_3()) == order(Log_star_rounds::ALL_ROUNDS)));
  BOOST_TEST((order_of(CGAL::Tracing_traits_3(Log_star_rounds::FIRST_ROUND)) ==
              order(Log_star_rounds::FIRST_ROUND)));
}

BOOST_AUTO_TEST_CASE(spatial_sort_order_is_that_of_spatial_sort)
{
  for (const std::size_t n : {5, 100, 5000}) {
    const std::vector<Point> points = surfaces::sphere(n, 0.1).points;
    std::vector<Point> sorted = points;
    CGAL::spatial_sort(sorted.begin(), sorted.end(), Kernel());
    const auto plan = order_by(DFS::Spatial_sort_order(), points);
    std::size_t different = 0;
    for (std::size_t i = 0; i < n; ++i)
      different += points[plan.order[i]] != sorted[i];
    BOOST_TEST(different == 0u);
    BOOST_TEST(plan.round_ends == (Indices{n}), boost::test_tools::per_element());
  }
}

// A path 0-1-2-3, a loop, and two points apart; the order is given.
BOOST_AUTO_TEST_CASE(starting_places_by_hand)
{
  struct Given_order
  {
    explicit Given_order(unsigned int) {}
    DFS::Insertion_order
    operator()(const std::vector<Point>&, const Kernel&, const Graph&,
               boost::property_map<Graph, boost::vertex_index_t>::const_type) const
    {
      return {{4, 1, 3, 2, 5, 0}, {2, 6}, {}};
    }
  };
  Graph graph(6);
  for (const std::size_t i : {0, 1, 2})
    add_edge(i, i + 1, graph);
  add_edge(3, 3, graph);
  const auto plan = meters::Neighbor_started_rounds<Given_order>()(
      std::vector<Point>(6), Kernel(), graph, get(boost::vertex_index, std::as_const(graph)));
  BOOST_TEST(plan.order == (Indices{4, 1, 3, 2, 5, 0}), boost::test_tools::per_element());
  BOOST_TEST(plan.round_ends == (Indices{2, 6}), boost::test_tools::per_element());
  // Point 0 after 1; 1 and 3 have no neighbour yet, nor has 5 ever; 2 after 3; 4 is the first.
  BOOST_TEST(plan.starting_places == (Indices{0, 0, 1, 2, 3, 1}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(planned_starts_are_the_neighbors_inserted_last)
{
  using CGAL::Delaunay_from_surface_3::internal::Index_graph;
  for (const Named_surface& named : small_surfaces())
    insert_twice<Triangulation, tests::Checking_planned_hints, DFS::Full_graph,
                 meters::Neighbor_started_rounds<DFS::Geometric_rounds>>(named, 1);
  using Hints =
      tests::Checking_planned_hints<DFS::Triangulation_target_3<Triangulation>, Index_graph>;
  BOOST_TEST(2 * Hints::number_of_neighbors > Hints::number_of_starts);
  BOOST_TEST(Hints::number_of_starts > 300u);
}

// Without starting places in the plan every point starts from the one before it.
BOOST_AUTO_TEST_CASE(hints_without_a_trace_lead_to_the_same_triangulation)
{
  for (const Named_surface& named : small_surfaces()) {
    insert_twice<Triangulation, DFS::Planned_hints_3>(named, 1);
    insert_twice<Triangulation, DFS::Neighbor_hints_3, DFS::Full_graph>(named, 1);
    insert_twice<Triangulation, DFS::Previous_hint_3>(named, 1);
  }
}

BOOST_AUTO_TEST_CASE(spanning_forest_spans_without_cycles)
{
  Indexed_surface three = surfaces::copies(surfaces::genus_surface(1, 400), 3);
  three.points.resize(three.points.size() + 2, Point(9, 9, 9)); // isolated
  Graph graph = graph_of(three);
  add_edge(0, 0, graph);                                 // a loop
  add_edge(three.faces[0][0], three.faces[0][1], graph); // a multiple edge
  const auto index_map = get(boost::vertex_index, graph);

  Graph forest(num_vertices(graph));
  std::vector<Graph::edge_descriptor> edges_of_forest, edges_of_graph;
  DFS::Spanning_forest()(graph, index_map, std::back_inserter(edges_of_forest));
  for (const auto& e : edges_of_forest)
    add_edge(source(e, graph), target(e, graph), forest);
  std::vector<int> component(num_vertices(graph));
  const auto components_of = [&](const Graph& g) {
    return connected_components(
        g, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, g)));
  };
  BOOST_TEST(components_of(graph) == 5);
  BOOST_TEST(components_of(forest) == 5);
  BOOST_TEST(num_edges(forest) == num_vertices(graph) - 5);

  DFS::Full_graph()(graph, index_map, std::back_inserter(edges_of_graph));
  BOOST_TEST(edges_of_graph.size() == num_edges(graph));
}

BOOST_AUTO_TEST_CASE(recorded_vertices_are_finite_alive_and_at_the_point)
{
  for (const Named_surface& named : small_surfaces())
    for (unsigned int seed = 0; seed < 3; ++seed)
      insert_twice<Triangulation, tests::Checking_traced_hints>(named, seed);
  BOOST_TEST(Traced_hints<Triangulation>::number_of_starts > 1000u);
  BOOST_TEST(Traced_hints<Triangulation>::number_of_traced_points > 1000u);
}

BOOST_AUTO_TEST_CASE(recorded_vertices_with_fast_location)
{
  for (const Named_surface& named : small_surfaces())
    insert_twice<Fast_triangulation, tests::Checking_traced_hints>(named, 1);
  BOOST_TEST(Traced_hints<Fast_triangulation>::number_of_traced_points > 1000u);
}

BOOST_AUTO_TEST_CASE(observers_see_exactly_the_destroyed_cells)
{
  for (const Named_surface& named : small_surfaces())
    insert_twice<Triangulation, tests::Zone_checking_hints>(named, 1);
  using Hints = Zone_hints<Triangulation>;
  BOOST_TEST(Hints::number_of_zones > 300u);
  BOOST_TEST(Hints::number_of_zones == Hints::number_of_updates_in_space);
  BOOST_TEST(Hints::number_of_zones < Hints::number_of_updates); // flat ones and duplicates
}

BOOST_AUTO_TEST_CASE(observers_see_no_zone_with_fast_location)
{
  for (const Named_surface& named : small_surfaces())
    insert_twice<Fast_triangulation, tests::Zone_checking_hints>(named, 1);
  using Hints = Zone_hints<Fast_triangulation>;
  BOOST_TEST(Hints::number_of_zones == 0u);
  BOOST_TEST(Hints::number_of_updates_in_space > 300u);
}
