// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the order of the default costs, in counts: on every family of surfaces it destroys few more
// cells than plain CGAL's order does in the same kernel, and its starting places are not much worse
// than the nearest neighbour on the surface that is already inserted. Walks are short where cells are
// huge and thin, and where points fill a thin box. That of points alone destroys fewer cells than
// random rounds do. And what the budget allows.

#define BOOST_TEST_MODULE test_order_costs
#include <boost/test/included/unit_test.hpp>

#include "build_in_order.h"
#include "order_cases.h"

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

namespace {

using DFS::internal::Index_graph;

struct Order_watch : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t orders_replaced = 0;
  double destroyed = 0;

  void notice(CGAL::Surface_insertion_notice what, const std::string&)
  {
    orders_replaced += what == CGAL::Surface_insertion_notice::ORDER_IS_REPLACED;
  }
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints&)
  {
    destroyed = double(target.counts().cells_destroyed);
  }
};

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
  const auto lower = DFS::internal::soup_edges(surface.faces, surface.points.size()).lower;
  std::vector<std::pair<std::size_t, std::size_t>> ascending;
  for (std::size_t v = 0; v < lower.size(); ++v)
    for (const auto *u = lower.begin(v), *end = lower.end(v); u != end; ++u)
      ascending.emplace_back(*u, v);
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
      const auto spaced = plan_of<DFS::Spaced_rounds>(points, graph);
      const Cost plain = cost(points, plan_of<DFS::Spatial_sort_order>(points, graph));
      const Cost planned = cost(points, spaced);
      const Cost neighbor = cost(points, from_nearest_neighbors(points, graph, spaced));
      BOOST_TEST_MESSAGE(
          a_case.name << ": cells destroyed per point: spaced rounds " << planned.destroyed
                      << ", plain CGAL's order " << plain.destroyed << "; tested to start: planned "
                      << planned.tested_to_start << ", at a neighbour " << neighbor.tested_to_start
                      << ", plain CGAL's order " << plain.tested_to_start);
      BOOST_TEST(planned.destroyed <= 1.15 * plain.destroyed);
      if (a_case.is_quadratic)
        continue;
      BOOST_TEST(planned.tested_to_start <= 2 * neighbor.tested_to_start);
      // The budget leaves room for larger ones.
      const double allowed = 0.8 * double(DFS::Spaced_rounds::cells_per_point);
      BOOST_TEST(planned.destroyed <= allowed);
      BOOST_TEST(planned.tested_to_start <= allowed / 4);
    }
}

// `most`: so many cells destroyed, in shares of what random rounds destroy.
void check_spaced(const std::string& name, const std::vector<Point>& points, double most)
{
  const Index_graph no_graph(points.size());
  const Cost rounds = cost(points, plan_of<DFS::Geometric_rounds>(points, no_graph));
  const Cost spaced = cost(points, plan_of<DFS::Spaced_rounds>(points, no_graph));
  BOOST_TEST_MESSAGE(name << ": cells destroyed per point: spaced rounds " << spaced.destroyed
                          << ", random ones " << rounds.destroyed << "; tested to start "
                          << spaced.tested_to_start << ", " << rounds.tested_to_start);
  BOOST_TEST_CONTEXT(name)
  {
    BOOST_TEST(spaced.destroyed < most * rounds.destroyed);
    BOOST_TEST(spaced.tested_to_start < 4.);
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
  const Cost spaced = cost(surface.points, plan_of<DFS::Spaced_rounds>(surface.points, graph));
  BOOST_TEST_MESSAGE("tested to start: nets " << nets.tested_to_start << ", random rounds "
                                              << rounds.tested_to_start << ", spaced ones "
                                              << spaced.tested_to_start);
  BOOST_TEST(spaced.tested_to_start < 4.);
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
      const Cost spaced = cost(points, plan_of<DFS::Spaced_rounds>(points, no_graph));
      BOOST_TEST_MESSAGE((is_flat ? "slab 1 : 1 : " : "box 1 : a : a, a = ")
                         << a << ": tested to start: random rounds " << rounds.tested_to_start
                         << ", spaced ones " << spaced.tested_to_start);
      BOOST_TEST(rounds.tested_to_start < 4.);
      BOOST_TEST(spaced.tested_to_start < 3.);
      BOOST_TEST(spaced.destroyed < 18.);
    }
}

BOOST_AUTO_TEST_CASE(spaced_rounds_destroy_less_than_random_ones)
{
  surfaces::Random random(5);
  std::vector<Point> cube, cluster;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(0, 1), y = random.uniform(0, 1), z = random.uniform(0, 1);
    cube.emplace_back(x, y, z);
    // Plummer's sphere: dense in the middle.
    const double mass = random.uniform(1e-4, .999), up = random.uniform(-1, 1);
    const double turn = random.uniform(0, 6.28), r = 1 / std::sqrt(std::pow(mass, -2. / 3) - 1);
    const double across = r * std::sqrt(1 - up * up);
    cluster.emplace_back(across * std::cos(turn), across * std::sin(turn), r * up);
  }
  check_spaced("cube", cube, .9);
  check_spaced("cluster", cluster, .95);
  check_spaced("sphere with noise", surfaces::sphere(12000, 0.01, 13).points, .95);
  check_spaced("genus 3", surfaces::genus_surface(3, 12000, 0.05, 13).points, .95);
  check_spaced("winding torus", surfaces::winding_torus(46368).points, 1);
  check_spaced("tube", surfaces::round_tube(12000).points, .95);
  for (const surfaces::Cad_family& family : surfaces::cad_families())
    check_spaced(family.name, family.make(12000, 12, surfaces::Numbering::BY_PROFILE).points, .98);
}

// Where distances do not tell, every second point is a centre.
BOOST_AUTO_TEST_CASE(spaced_rounds_of_points_whose_distances_do_not_tell)
{
  const double huge = 1e300, tiny = 1e-300;
  for (const double unit : {0., tiny, huge}) {
    std::vector<Point> points;
    for (int i = 0; i < 1000; ++i)
      points.emplace_back(unit * (i % 10), unit * (i / 10 % 10), unit * (i / 100));
    const auto order = plan_of<DFS::Spaced_rounds>(points, Index_graph(points.size()));
    BOOST_TEST(DFS::internal::is_order(order, points.size()));
    BOOST_TEST(order.round_ends == (std::vector<std::size_t>{63, 125, 250, 500, 1000}),
               boost::test_tools::per_element());
  }
}

// Many points are sorted in parts, where a sample tells enough: not of few different ones.
BOOST_AUTO_TEST_CASE(sorting_of_many_points_that_are_equal)
{
  for (const int different : {1, 2, 3, 70, 5000}) {
    std::vector<Point> points;
    for (int i = 0; i < 20000; ++i) {
      const int k = i % 3 == 0 ? 0 : i % different;
      points.emplace_back(k % 17, k / 17 % 17, k / 289);
    }
    const auto order = plan_of<DFS::Spaced_rounds>(points, Index_graph(points.size()));
    BOOST_TEST(DFS::internal::is_order(order, points.size()));
    const double tested = different < 4 ? 0 : cost(points, order).tested_to_start;
    BOOST_TEST_MESSAGE(different << " different points: tested to start " << tested);
    BOOST_TEST(tested < 4.);
  }
}

BOOST_AUTO_TEST_CASE(what_the_budget_allows)
{
  const DFS::internal::Insertion_budget budget(64), none(DFS::internal::Build_options::any_number),
      spread(64, true);
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
    // Where many cells stay, any order has to destroy many; not that of a surface, which may be misled.
    const std::size_t stay = 10 * counts.cells_destroyed;
    counts.cells_destroyed += stay;
    counts.cells_created = counts.cells_destroyed + stay;
    BOOST_TEST(!spread.is_exceeded(counts, inserted));
    BOOST_TEST(budget.is_exceeded(counts, inserted));
    counts.cells_tested_to_start += 2 * stay;
    BOOST_TEST(spread.is_exceeded(counts, inserted));
    --counts.cells_tested_to_start;
    BOOST_TEST(!spread.is_exceeded(counts, inserted));
    ++counts.cells_destroyed;
    BOOST_TEST(spread.is_exceeded(counts, inserted));
  }
}

// No order triangulates these by fewer cells; another one would destroy as many once more.
BOOST_AUTO_TEST_CASE(what_is_quadratic_by_nature_is_not_begun_anew)
{
  using Curve = std::array<double, 3> (*)(double, bool);
  const std::pair<const char*, Curve> curves[] = {
      {"moment curve",
       [](double t, bool) {
         return std::array<double, 3>{t, t * t, t * t * t};
       }},
      {"helix",
       [](double t, bool) {
         return std::array<double, 3>{std::cos(12 * t), std::sin(12 * t), 12 * t};
       }},
      {"spiral",
       [](double t, bool) {
         return std::array<double, 3>{t * std::cos(60 * t), t * std::sin(60 * t), 6 * t * t};
       }},
      {"two segments",
       [](double t, bool b) {
         return std::array<double, 3>{b ? t : 0, b ? 0 : t, double(b)};
       }},
      {"two parabolas",
       [](double t, bool b) {
         const double s = t - .5;
         return b ? std::array<double, 3>{s, s * s, 0} : std::array<double, 3>{0, 1 - s * s, s};
       }},
      {"linked circles",
       [](double t, bool b) {
         const double x = std::cos(6.28 * t), y = std::sin(6.28 * t);
         return b ? std::array<double, 3>{x, y, 0} : std::array<double, 3>{1 + x, 0, y};
       }},
      {"trefoil", [](double t, bool) {
         const double a = 6.28 * t;
         return std::array<double, 3>{std::sin(a) + 2 * std::sin(2 * a),
                                      std::cos(a) - 2 * std::cos(2 * a), -std::sin(3 * a)};
       }}};
  for (const auto& [name, curve] : curves) {
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < 1100; ++i)
      points.push_back(curve(i / 1100., i % 2 != 0));
    Order_watch watch;
    const auto arrays = CGAL::delaunay_3_arrays(points, CGAL::parameters::visitor(std::ref(watch)));
    BOOST_TEST(arrays.number_of_cells() > 100 * points.size(), name);
    BOOST_TEST(watch.orders_replaced == 0u, name);
    BOOST_TEST(watch.destroyed < 1.05 * double(arrays.number_of_cells()), name);
  }
}

// But no order is kept whose own fault it is: here two lines come first, and others destroy their cells.
BOOST_AUTO_TEST_CASE(an_order_that_destroys_what_need_not_be_there_is_replaced)
{
  surfaces::Random random(2);
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 1200; ++i) {
    const double t = i / 1200.;
    points.push_back(i % 2 != 0 ? std::array<double, 3>{t, .5, 0}
                                : std::array<double, 3>{.5, t, 1});
  }
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(0, 1), y = random.uniform(0, 1);
    points.push_back({x, y, random.uniform(0, 1)});
  }
  DFS::Insertion_order order;
  order.order.resize(points.size());
  std::iota(order.order.begin(), order.order.end(), std::size_t(0));
  order.round_ends = {points.size()};
  Order_watch watch;
  const auto arrays =
      CGAL::delaunay_3_arrays(points, order, CGAL::parameters::visitor(std::ref(watch)));
  BOOST_TEST(watch.orders_replaced == 1u);
  BOOST_TEST(watch.destroyed < 5 * double(arrays.number_of_cells()));
}
