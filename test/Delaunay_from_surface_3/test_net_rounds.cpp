// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surface_net_rounds: the rounds are random nets, starting places come before what they serve, in
// an earlier round or just before, graphs on which nets do not shrink are ordered all the same, and
// no more cells are destroyed than with random rounds.

#define BOOST_TEST_MODULE test_net_rounds
#include <boost/test/included/unit_test.hpp>

#include "named_surfaces.h"
#include "points_and_graphs.h"

#include <Delaunay_from_surface_3_surfaces/adversarial.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using tests::Graph;
using tests::graph_of;
using tests::random_points;

namespace {

template <class Plan>
DFS::Insertion_order plan_of(const std::vector<Point>& points, const Graph& graph)
{
  return Plan(1)(points, Kernel(), graph, get(boost::vertex_index, graph));
}

// A permutation, strictly growing rounds, and starting places that come before.
DFS::Insertion_order checked_net_plan(const std::vector<Point>& points, const Graph& graph)
{
  const DFS::Insertion_order plan = plan_of<DFS::Surface_net_rounds>(points, graph);
  const std::size_t n = points.size();
  std::vector<std::size_t> sorted = plan.order;
  std::sort(sorted.begin(), sorted.end());
  BOOST_TEST_REQUIRE(sorted.size() == n);
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST_REQUIRE(sorted[i] == i);
  BOOST_TEST((std::is_sorted(plan.round_ends.begin(), plan.round_ends.end()) &&
              std::adjacent_find(plan.round_ends.begin(), plan.round_ends.end()) ==
                  plan.round_ends.end()));
  BOOST_TEST(plan.round_ends.back() == n);
  if (plan.starting_places.empty()) // those of Geometric_rounds
    return plan;
  BOOST_TEST_REQUIRE(plan.starting_places.size() == n);
  // Those of the coarsest level start at the place before, and so may those of a large cluster.
  std::size_t late = 0, begin_of_round = 0, round = 0;
  for (std::size_t k = 1; k < n; ++k) {
    if (k == plan.round_ends[round])
      begin_of_round = plan.round_ends[round++];
    late += plan.starting_places[k] >= begin_of_round && plan.starting_places[k] != k - 1;
  }
  BOOST_TEST(late == 0u);
  BOOST_TEST(plan.starting_places[0] == 0u);
  return plan;
}

std::size_t ends_of_random_rounds(std::size_t n)
{
  return DFS::Geometric_rounds().round_ends(n).size();
}

struct Destroyed
{
  double in_all = 0;
  std::string by_round;
};

// Cells destroyed per insertion.
Destroyed destroyed(const std::vector<Point>& all, const DFS::Insertion_order& plan)
{
  namespace internal = DFS::internal;
  const auto coordinates = internal::rounded_coordinates(all);
  internal::Observer nobody;
  internal::Order_view order = internal::view_of(plan);
  order.starting_places = nullptr;
  internal::Ordered_complex<internal::Compact_vertex> complex;
  complex.order = order;
  complex.start(internal::Point_array(coordinates.data(), all.size()), nullptr);
  internal::Insert_alone<internal::Compact_vertex> insert(complex, internal::Alone(), nobody);
  Destroyed result;
  std::size_t first = 0, before = 0;
  for (const std::size_t end : plan.round_ends) {
    insert(first, end);
    const std::size_t now = insert.counts().cells_destroyed;
    result.by_round +=
        " " +
        std::to_string(int(double(now - before) / double(end - first) * 10) / 10.).substr(0, 4);
    before = now;
    first = end;
  }
  result.in_all = double(before) / double(all.size());
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(finest_round_is_beside_a_maximal_independent_set)
{
  const surfaces::Indexed_surface surface = surfaces::genus_surface(2, 4000, 0.05);
  const Graph graph = graph_of(surface);
  const DFS::Insertion_order plan = checked_net_plan(surface.points, graph);
  BOOST_TEST(plan.round_ends.size() > 3u);
  std::vector<char> is_in_net(surface.points.size(), false);
  const std::size_t net_size = plan.round_ends[plan.round_ends.size() - 2];
  for (std::size_t k = 0; k < net_size; ++k)
    is_in_net[plan.order[k]] = true;
  std::vector<char> is_covered = is_in_net;
  std::size_t inner_edges = 0;
  for (auto [e, end] = edges(graph); e != end; ++e) {
    const std::size_t s = source(*e, graph), t = target(*e, graph);
    inner_edges += is_in_net[s] && is_in_net[t];
    is_covered[s] |= is_in_net[t];
    is_covered[t] |= is_in_net[s];
  }
  BOOST_TEST(inner_edges == 0u);
  BOOST_TEST(std::count(is_covered.begin(), is_covered.end(), true) ==
             std::ptrdiff_t(surface.points.size()));
  // A point of the last round starts at a neighbour in the net, the nearest of them up to rounding.
  std::size_t strangers = 0, far = 0;
  for (std::size_t k = net_size; k < plan.order.size(); ++k) {
    const std::size_t v = plan.order[k], start = plan.order[plan.starting_places[k]];
    strangers += !edge(v, start, graph).second;
    const double distance = CGAL::squared_distance(surface.points[v], surface.points[start]);
    for (auto [u, end] = adjacent_vertices(v, graph); u != end; ++u)
      far += is_in_net[*u] &&
             CGAL::squared_distance(surface.points[v], surface.points[*u]) < 0.999999 * distance;
  }
  BOOST_TEST(strangers == 0u);
  BOOST_TEST(far == 0u);
}

// Also where 32 random bits would make some numbers twice as likely as others, or are too few.
BOOST_AUTO_TEST_CASE(random_numbers_are_even)
{
  BOOST_TEST(DFS::internal::Split_mix(0)() == 0xe220a8397b1dcdafu); // the author's own
  const std::uint64_t large = std::uint64_t(1) << 32;
  for (const std::uint64_t n : {std::uint64_t(3), large / 4 * 3, large - 1, large, 3 * large}) {
    DFS::internal::Split_mix random(5);
    std::size_t in_third[3] = {}, of_rest[3] = {};
    for (int i = 0; i < 30000; ++i) {
      const std::uint64_t k = random.below(n);
      BOOST_TEST_REQUIRE(k < n);
      ++in_third[k / (n / 3 + (n % 3 != 0))];
      ++of_rest[k % 3];
    }
    for (int t = 0; t < 3; ++t) { // 6 standard deviations
      BOOST_TEST((9500 < in_third[t] && in_third[t] < 10500));
      BOOST_TEST((9500 < of_rest[t] && of_rest[t] < 10500));
    }
  }
  BOOST_TEST(DFS::internal::Split_mix(1).below(1) == 0u);
}

// The core's own call: what the plans return, without a type of CGAL's.
BOOST_AUTO_TEST_CASE(order_of_points_by_request)
{
  using namespace DFS::internal;
  const surfaces::Indexed_surface surface = surfaces::genus_surface(1, 4000, 0.05);
  const std::size_t n = surface.points.size();
  const auto coordinates = rounded_coordinates(surface.points);
  const auto order = [&](const auto& plan) {
    return order_of_points(Point_array(coordinates.data(), n), options_of(plan), Alone());
  };
  const auto planned = [&](const auto& plan) {
    return plan(surface.points, Kernel(), Graph(), get(boost::vertex_index, Graph()));
  };
  const DFS::Spaced_rounds spaced(3);
  BOOST_TEST((order(spaced).order == planned(spaced).order));
  BOOST_TEST((order(spaced).starting_places == planned(spaced).starting_places));
  const DFS::Geometric_rounds rounds(3, 0.5, 100);
  BOOST_TEST((order(rounds).order == planned(rounds).order));
  BOOST_TEST((order(rounds).round_ends == rounds.round_ends(n)));
  BOOST_TEST(order(rounds).starting_places.empty());
}

BOOST_AUTO_TEST_CASE(random_blocks_are_permutations)
{
  const auto order = [](std::size_t n, std::uint64_t seed) {
    std::vector<std::size_t> result;
    DFS::internal::for_each_in_random_blocks(n, seed, 1024,
                                             [&](std::size_t v) { result.push_back(v); });
    return result;
  };
  const std::size_t block = DFS::internal::largest_net_block;
  for (const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(2), std::size_t(3),
                              std::size_t(1000), block - 1, block, block + 1, 3 * block + 5}) {
    std::vector<std::size_t> sorted = order(n, 7);
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::size_t> all(n);
    std::iota(all.begin(), all.end(), std::size_t(0));
    BOOST_TEST((sorted == all));
    BOOST_TEST((order(n, 7) == order(n, 7)));
    if (n >= 1000)
      BOOST_TEST((order(n, 7) != order(n, 8)));
  }
  BOOST_TEST(order(3 * block, 7)[0] / block != order(3 * block, 7)[block] / block);
}

BOOST_AUTO_TEST_CASE(the_seed_alone_decides)
{
  const surfaces::Indexed_surface surface = surfaces::genus_surface(1, 4000, 0.05);
  const Graph graph = graph_of(surface);
  const auto order = [&](unsigned int seed) {
    return DFS::Surface_net_rounds(seed)(surface.points, Kernel(), graph,
                                         get(boost::vertex_index, graph))
        .order;
  };
  BOOST_TEST((order(1) == order(1)));
  BOOST_TEST((order(1) != order(2)));
}

// Wherever the hub stands in the numbering: it comes first, and its fan is in spatial order.
BOOST_AUTO_TEST_CASE(hubs_come_before_their_fans)
{
  for (const bool is_last : {false, true}) {
    surfaces::Indexed_surface star = surfaces::star(3000, 5);
    if (is_last) {
      std::swap(star.points.front(), star.points.back());
      for (surfaces::Indexed_surface::Face& face : star.faces)
        for (std::size_t& v : face)
          v = v == 0 ? 2999 : v == 2999 ? 0 : v;
    }
    const DFS::Insertion_order plan = checked_net_plan(star.points, graph_of(star));
    BOOST_TEST(plan.order.front() == (is_last ? 2999u : 0u));
    std::size_t from_previous = 0;
    for (std::size_t k = 2; k < 3000; ++k)
      from_previous += plan.starting_places[k] == k - 1;
    BOOST_TEST(from_previous > 2500u);
  }
}

// Beside a hub are points that are far from it, on a strip for example, and nearer to other net
// vertices: few may stay with it, also where there are many vertices (else 2 of 5 do).
BOOST_AUTO_TEST_CASE(hubs_do_not_keep_what_is_nearer_to_others)
{
  using DFS::internal::Numbered_edge;
  for (const std::uint32_t n :
       {8000u, 80000u}) { // vertices 1, 2, … along a line, every 4th beside 0
    DFS::internal::Large_vector<Numbered_edge> edges;
    for (std::uint32_t v = 2; v < n; ++v)
      edges.emplace_back(v - 1, v);
    for (std::uint32_t v = 4; v < n; v += 4)
      edges.emplace_back(0u, v);
    std::vector<double> coordinates(3 * n, 0.);
    for (std::uint32_t v = 0; v < n; ++v)
      coordinates[3 * v] = v;
    const DFS::internal::Point_array points(coordinates.data(), n);
    const auto lower = DFS::internal::lower_neighbors(edges, n);
    std::vector<std::uint32_t> names(n);
    std::iota(names.begin(), names.end(), 0u);
    const auto net = DFS::internal::net_of(lower, 1, points, names.data(), 1024);
    const auto stay = std::count(net.cluster_of.begin(), net.cluster_of.end(), net.cluster_of[0]);
    BOOST_TEST(stay > 1);
    BOOST_TEST(stay < n / 16);
  }
}

BOOST_AUTO_TEST_CASE(graphs_on_which_nets_do_not_shrink)
{
  const std::size_t n = 5000;
  const std::vector<Point> points = random_points(n);
  Graph star(n), random(n), loops(n);
  for (std::size_t i = 1; i < n; ++i)
    add_edge(0, i, star);
  CGAL::Random generator(5);
  for (std::size_t i = 0; i < 20 * n; ++i)
    add_edge(std::size_t(generator.get_int(0, int(n))), std::size_t(generator.get_int(0, int(n))),
             random);
  for (std::size_t i = 0; i < n; ++i)
    add_edge(i, i, loops);
  const std::size_t random_rounds = ends_of_random_rounds(n);
  const DFS::Insertion_order alone =
      DFS::Spaced_rounds(1)(points, Kernel(), Graph(n), get(boost::vertex_index, Graph(n)));
  BOOST_TEST((checked_net_plan(points, Graph(n)).order == alone.order));
  BOOST_TEST(checked_net_plan(points, loops).round_ends.size() == random_rounds);
  // entered at the centre or at a leaf
  BOOST_TEST(checked_net_plan(points, star).round_ends.size() <= random_rounds + 1);
  Graph star_from_leaf(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    add_edge(n - 1, i, star_from_leaf);
  BOOST_TEST(checked_net_plan(points, star_from_leaf).round_ends.size() <= random_rounds + 1);
  checked_net_plan(points, random);
}

// Then the surface says nothing, and random rounds are better.
BOOST_AUTO_TEST_CASE(graphs_whose_edges_join_points_that_are_not_near)
{
  for (const std::size_t n : {3000, 20000}) {
    const surfaces::Indexed_surface surface = surfaces::faces_at_random(n, 17);
    const DFS::Insertion_order plan =
        plan_of<DFS::Surface_net_rounds>(surface.points, graph_of(surface));
    const DFS::Insertion_order random =
        plan_of<DFS::Geometric_rounds>(surface.points, graph_of(surface));
    BOOST_TEST((plan.order == random.order));
    BOOST_TEST((plan.round_ends == random.round_ends));
    BOOST_TEST(plan.starting_places.empty());
  }
}

BOOST_AUTO_TEST_CASE(small_sets)
{
  for (const std::size_t n : {1, 2, 3, 4, 63, 64, 65, 66}) {
    Graph path(n);
    for (std::size_t i = 1; i < n; ++i)
      add_edge(i - 1, i, path);
    checked_net_plan(random_points(n), path);
  }
  BOOST_TEST(plan_of<DFS::Surface_net_rounds>({}, Graph(0)).order.empty());
  BOOST_TEST(plan_of<DFS::Surface_net_rounds>({}, Graph(0)).round_ends.empty());
}

// What assertions of the core ask.
BOOST_AUTO_TEST_CASE(invariants_of_orders_and_nets)
{
  namespace internal = DFS::internal;
  BOOST_TEST(internal::is_order({{2, 0, 1}, {1, 3}, {0, 0, 1}}, 3));
  BOOST_TEST(internal::is_order({{}, {}, {}}, 0));
  BOOST_TEST(!internal::is_order({{2, 0, 2}, {1, 3}, {}}, 3));
  BOOST_TEST(!internal::is_order({{2, 0, 3}, {1, 3}, {}}, 3));
  BOOST_TEST(!internal::is_order({{2, 0, 1}, {1, 2}, {}}, 3));
  BOOST_TEST(!internal::is_order({{2, 0, 1}, {1, 1, 3}, {}}, 3));
  BOOST_TEST(!internal::is_order({{2, 0, 1}, {1, 3}, {0, 0, 2}}, 3));
  BOOST_TEST(!internal::is_order({{2, 0, 1}, {1, 3}, {0, 0}}, 3));

  internal::Large_vector<internal::Numbered_edge> path; // 0 - 1 - 2 - 3
  for (const std::uint32_t v : {1u, 2u, 3u})
    path.emplace_back(v, v - 1);
  const auto lower = internal::lower_neighbors(path, 4);
  BOOST_TEST(internal::is_net(lower, {0, 0, 3, 3}));
  BOOST_TEST(internal::is_net(lower, {1, 1, 1, 3}));
  BOOST_TEST(!internal::is_net(lower, {0, 1, 1, 3})); // 0 and 1 are beside each other
  BOOST_TEST(!internal::is_net(lower, {0, 0, 0, 3})); // 2 is not beside 0
  BOOST_TEST(!internal::is_net(lower, {1, 1, 2, 2})); // 1 and 2
  BOOST_TEST(!internal::is_net(lower, {0, 0, 1, 3})); // 1 is no centre
}

BOOST_AUTO_TEST_CASE(no_more_cells_destroyed_than_twice_those_of_random_rounds)
{
  std::vector<tests::Named_surface> all = tests::ordinary_surfaces(8000);
  for (const tests::Named_surface& named : tests::degenerate_surfaces(8000))
    all.push_back(named);
  for (const tests::Named_surface& named : all) {
    BOOST_TEST_CONTEXT(named.name)
    {
      const std::vector<Point>& points = named.surface.points;
      const Graph graph = graph_of(named.surface);
      const Destroyed nets = destroyed(points, checked_net_plan(points, graph));
      const Destroyed random = destroyed(points, plan_of<DFS::Geometric_rounds>(points, graph));
      BOOST_TEST_MESSAGE(named.name << ": cells destroyed per insertion: nets " << nets.in_all
                                    << " (by round" << nets.by_round << "), random rounds "
                                    << random.in_all << " (" << random.by_round << ")");
      BOOST_TEST(nets.in_all <= 2 * random.in_all);
    }
  }
}
