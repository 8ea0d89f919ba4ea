// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the order of the default costs, in counts: on every family of surfaces it destroys few more
// cells than plain CGAL's order does in the same kernel, and its starting places are not much worse
// than the nearest neighbour on the surface that is already inserted. Walks are short where cells are
// huge and thin, and where points fill a thin box. And what the budget allows.

#define BOOST_TEST_MODULE test_order_costs
#include <boost/test/included/unit_test.hpp>

#include "build_in_order.h"
#include "order_cases.h"

#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <CGAL/Delaunay_from_surface_3/core/order/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/door/soup_graph.h>
#include <CGAL/Delaunay_from_surface_3/paper/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/paper/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/paper/Neighbor_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Previous_hint_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Spatial_sort_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>
#include <CGAL/Delaunay_from_surface_3/surface/Full_graph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

namespace {

using DFS::internal::Index_graph;

// Of one point on average.
struct Cost
{
  double destroyed, tested_to_start;
};

// Each point from where the order says, or from the one before it.
Cost cost(const std::vector<Point>& points, const DFS::Insertion_order& order)
{
  const auto built = tests::build_in_order(points, order);
  const double n = double(points.size());
  return {double(built->counts.cells_destroyed) / n,
          double(built->counts.cells_tested_to_start) / n};
}

// The order, with each point from the nearest of its neighbours that comes before it.
DFS::Insertion_order from_nearest_neighbors(const std::vector<Point>& points,
                                            const Index_graph& graph, DFS::Insertion_order order)
{
  const std::vector<std::size_t> places = DFS::internal::inverse(order.order);
  std::vector<std::size_t>& start = order.starting_places;
  start.assign(points.size(), points.size());
  const auto offer = [&](std::size_t k, std::size_t place) {
    const Point& p = points[order.order[k]];
    if (place < k && (start[k] == points.size() ||
                      CGAL::has_larger_distance_to_point(p, points[order.order[start[k]]],
                                                         points[order.order[place]])))
      start[k] = place;
  };
  for (auto [e, end] = edges(graph); e != end; ++e) {
    const std::size_t s = places[source(*e, graph)], t = places[target(*e, graph)];
    offer(s, t);
    offer(t, s);
  }
  for (std::size_t k = 0; k < start.size(); ++k)
    if (start[k] == points.size())
      start[k] = k == 0 ? 0 : k - 1;
  return order;
}

template <class Plan>
DFS::Insertion_order plan_of(const std::vector<Point>& points, const Index_graph& graph)
{
  return Plan(1)(points, Kernel(), graph, get(boost::vertex_index, graph));
}

// Every edge once, from the smaller index to the larger.
Index_graph graph_of(const surfaces::Indexed_surface& surface)
{
  const auto soup = DFS::internal::soup_graph(surface.faces, surface.points.size()).graph;
  std::vector<std::pair<std::size_t, std::size_t>> ascending;
  for (auto [e, end] = edges(soup); e != end; ++e)
    ascending.emplace_back(target(*e, soup), source(*e, soup));
  return Index_graph(boost::edges_are_unsorted_multi_pass, ascending.begin(), ascending.end(),
                     surface.points.size());
}

void check(const std::vector<tests::Order_case>& cases)
{
  for (const tests::Order_case& a_case : cases)
    BOOST_TEST_CONTEXT(a_case.name)
    {
      const surfaces::Indexed_surface surface = a_case.make();
      const std::vector<Point>& points = surface.points;
      const Index_graph graph = graph_of(surface);
      const auto nets = plan_of<DFS::Surface_net_rounds>(points, graph);
      const Cost plain = cost(points, plan_of<DFS::Spatial_sort_order>(points, graph));
      const Cost planned = cost(points, nets);
      const Cost neighbor = cost(points, from_nearest_neighbors(points, graph, nets));
      BOOST_TEST_MESSAGE(a_case.name << ": cells destroyed per point: nets " << planned.destroyed
                                     << ", plain CGAL's order " << plain.destroyed
                                     << "; tested to start: planned " << planned.tested_to_start
                                     << ", at a neighbour " << neighbor.tested_to_start
                                     << ", plain CGAL's order " << plain.tested_to_start);
      BOOST_TEST(planned.destroyed <= 1.15 * plain.destroyed);
      if (a_case.is_quadratic)
        continue;
      BOOST_TEST(planned.tested_to_start <= 2 * neighbor.tested_to_start);
      // The budget leaves room for larger ones.
      const double allowed = 0.8 * double(DFS::Surface_net_rounds::cells_per_point);
      BOOST_TEST(planned.destroyed <= allowed);
      BOOST_TEST(planned.tested_to_start <= allowed / 4);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(cad_solids)
{
  check(tests::cad_order_cases());
}

BOOST_AUTO_TEST_CASE(structured_degenerate_and_misleading_surfaces)
{
  check(tests::other_order_cases());
}

// Cells tested to start, per point.
BOOST_AUTO_TEST_CASE(walks_on_a_smooth_torus)
{
  const surfaces::Indexed_surface surface = surfaces::winding_torus(46368);
  const Index_graph graph = graph_of(surface);
  const Cost nets = cost(surface.points, plan_of<DFS::Surface_net_rounds>(surface.points, graph));
  const Cost rounds = cost(surface.points, plan_of<DFS::Geometric_rounds>(surface.points, graph));
  BOOST_TEST_MESSAGE("tested to start: nets " << nets.tested_to_start << ", random rounds "
                                              << rounds.tested_to_start);
  BOOST_TEST(nets.tested_to_start < 6.);
  BOOST_TEST(rounds.tested_to_start < 6.);
}

BOOST_AUTO_TEST_CASE(walks_of_points_in_thin_boxes)
{
  for (const bool is_flat : {false, true})
    for (const double a : {1., 1e-2, 1e-3, 1e-4}) {
      surfaces::Random random(3);
      std::vector<Point> points;
      for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform(0, 1), y = random.uniform(0, is_flat ? 1 : a);
        points.emplace_back(x, y, random.uniform(0, a));
      }
      const Index_graph no_graph(points.size());
      const Cost rounds = cost(points, plan_of<DFS::Geometric_rounds>(points, no_graph));
      BOOST_TEST_MESSAGE((is_flat ? "slab 1 : 1 : " : "box 1 : a : a, a = ")
                         << a << ": tested to start " << rounds.tested_to_start);
      BOOST_TEST(rounds.tested_to_start < 4.);
    }
}

BOOST_AUTO_TEST_CASE(what_the_budget_allows)
{
  const DFS::internal::Insertion_budget budget(64), none(DFS::internal::Order_source::any_number);
  for (const auto& [inserted, cells] :
       {std::pair<std::size_t, std::size_t>(0, 64), {1000, 64}, {1000000, 64}, {4000000, 72}}) {
    DFS::Insertion_counts counts;
    counts.cells_destroyed = cells * (inserted + 1000);
    counts.cells_tested_to_start = 2 * counts.cells_destroyed;
    BOOST_TEST(!budget.is_exceeded(counts, inserted));
    ++counts.cells_destroyed;
    BOOST_TEST(budget.is_exceeded(counts, inserted));
    BOOST_TEST(!none.is_exceeded(counts, inserted));
    --counts.cells_destroyed;
    ++counts.cells_tested_to_start;
    BOOST_TEST(budget.is_exceeded(counts, inserted));
  }
}
