// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What stands around the loop of Fig. 1: plans are checked, an order that is too dear is replaced,
// the end of the insertion is told; and points without a surface.

#define BOOST_TEST_MODULE test_driver
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

namespace {

std::vector<Point> random_points(std::size_t n, unsigned int seed = 1)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(random.get_double(-1, 1), random.get_double(-1, 1),
                        random.get_double(-1, 1));
  return points;
}

// Whatever a test wants.
struct Given_plan
{
  DFS::Insertion_order plan;

  template <class P, class Gt, class Graph, class Map>
  DFS::Insertion_order operator()(const std::vector<P>&, const Gt&, const Graph&, Map) const
  {
    return plan;
  }
};

struct Given_traits : CGAL::Surface_insertion_traits_3
{
  using Insertion_plan = Given_plan;
  Given_plan plan;
  Given_plan insertion_plan_object(unsigned int) const { return plan; }
};

// Inserts six points by the plan. Returns what the exception says; the triangulation must be
// unchanged.
std::string refusal(const DFS::Insertion_order& plan)
{
  const std::vector<Point> points = random_points(6);
  Given_traits traits;
  traits.plan.plan = plan;
  Triangulation tr;
  try {
    CGAL::insert_points_3(tr, points, std::vector<std::vector<int>>(), traits);
  } catch (const std::invalid_argument& e) {
    BOOST_TEST(tr.number_of_vertices() == 0u);
    return e.what();
  }
  BOOST_TEST((tr == Triangulation(points.begin(), points.end())));
  return "";
}

// A plan that is not the core's, with a budget that nothing keeps.
struct Starved_nets : DFS::Surface_net_rounds
{
  static constexpr std::size_t cells_per_point = 1;
  using DFS::Surface_net_rounds::Surface_net_rounds;
};

using Starved_traits =
    CGAL::Surface_insertion_policies_3<DFS::No_subgraph, Starved_nets, DFS::Planned_hints_3>;

struct Starved_rounds : DFS::Spaced_rounds
{
  static constexpr std::size_t cells_per_point = 1;
  using DFS::Spaced_rounds::Spaced_rounds;
};

struct Watch : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t orders_replaced = 0, ends = 0, rounds = 0, plans = 0;
  DFS::Insertion_counts counts;

  void notice(CGAL::Surface_insertion_notice what, const std::string&)
  {
    orders_replaced += what == CGAL::Surface_insertion_notice::ORDER_IS_REPLACED;
  }
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    plans += phase == CGAL::Surface_insertion_phase::PLAN;
    rounds += phase == CGAL::Surface_insertion_phase::ROUND;
  }
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints&)
  {
    ++ends;
    counts = target.counts();
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(plans_are_checked)
{
  BOOST_TEST(refusal({{5, 4, 3, 2, 1, 0}, {2, 6}, {}}) == "");
  BOOST_TEST(refusal({{5, 4, 3, 2, 1, 0}, {2, 6}, {0, 0, 1, 2, 3, 4}}) == "");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4}, {6}, {}}) ==
             "insertion plan: the order has 5 places for 6 points");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 6}, {6}, {}}) ==
             "insertion plan: at place 5 there is point 6, but there are 6 points");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 1}, {6}, {}}) ==
             "insertion plan: point 1 is at the places 1 and 5");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 5}, {5}, {}}) ==
             "insertion plan: the last round ends at 5, but there are 6 points");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 5}, {}, {}}) ==
             "insertion plan: the last round ends at 0, but there are 6 points");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 5}, {3, 3, 6}, {}}) ==
             "insertion plan: round 1 ends at 3, not after the round before it");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 5}, {6}, {0, 0, 0}}) ==
             "insertion plan: there are 3 starting places for 6 points");
  BOOST_TEST(refusal({{0, 1, 2, 3, 4, 5}, {6}, {0, 0, 2, 0, 0, 0}}) ==
             "insertion plan: the starting place of place 2 is 2, which is not before it");
}

BOOST_AUTO_TEST_CASE(an_order_over_its_budget_is_replaced)
{
  const auto surface = surfaces::sphere(5000, 0.05);
  const Triangulation expected(surface.points.begin(), surface.points.end());
  const std::ptrdiff_t n = std::ptrdiff_t(expected.number_of_vertices());

  Watch kept;
  Triangulation tr;
  CGAL::insert_points_3(tr, surface.points, surface.faces,
                        CGAL::parameters::visitor(std::ref(kept)));
  BOOST_TEST(kept.orders_replaced == 0u);
  BOOST_TEST(kept.ends == 1u);
  BOOST_TEST(kept.plans == 1u);
  BOOST_TEST(kept.counts.cells_created - kept.counts.cells_destroyed + 5 ==
             tr.tds().number_of_cells());

  Watch replaced;
  Triangulation again;
  BOOST_TEST(CGAL::insert_points_3(again, surface.points, surface.faces, Starved_traits(),
                                   CGAL::parameters::visitor(std::ref(replaced))) == n);
  BOOST_TEST((again == expected));
  BOOST_TEST(replaced.orders_replaced == 1u);
  BOOST_TEST(replaced.ends == 1u);
  BOOST_TEST(replaced.plans == 2u);

  // Points alone have a budget too.
  const CGAL::Surface_insertion_policies_3<DFS::No_subgraph, Starved_rounds, DFS::Planned_hints_3>
      starved_rounds;
  Watch exceeded;
  Triangulation of_points;
  CGAL::insert_points_3(of_points, surface.points, std::vector<std::array<int, 3>>(),
                        starved_rounds, CGAL::parameters::visitor(std::ref(exceeded)));
  BOOST_TEST((of_points == expected));
  BOOST_TEST(exceeded.orders_replaced == 1u);
  BOOST_TEST(exceeded.ends == 1u);

  // CGAL's own insertion is not counted, and goes on.
  Watch not_counted;
  again.insert(Point(7, 7, 7));
  CGAL::insert_points_3(again, surface.points, surface.faces, Starved_traits(),
                        CGAL::parameters::visitor(std::ref(not_counted)));
  BOOST_TEST(not_counted.orders_replaced == 0u);
  BOOST_TEST(not_counted.ends == 1u);
}

BOOST_AUTO_TEST_CASE(points_alone)
{
  std::vector<Point> points = random_points(2000);
  points.insert(points.end(), points.begin(), points.begin() + 50); // duplicates
  std::vector<std::pair<std::size_t, Triangulation::Vertex_handle>> pairs;
  Triangulation tr;
  BOOST_TEST(CGAL::insert_points_3(tr, points,
                                   CGAL::parameters::vertex_to_vertex_output_iterator(
                                       std::back_inserter(pairs))) == 2000);
  BOOST_TEST((tr == Triangulation(points.begin(), points.end())));
  BOOST_TEST(pairs.size() == points.size());
  for (const auto& [i, v] : pairs)
    BOOST_TEST(v->point() == points[i]);

  const std::vector<Point> more = random_points(100, 2);
  BOOST_TEST(CGAL::insert_points_3(tr, more) == 100);
  points.insert(points.end(), more.begin(), more.end());
  BOOST_TEST((tr == Triangulation(points.begin(), points.end())));

  Triangulation none;
  BOOST_TEST(CGAL::insert_points_3(none, std::vector<Point>()) == 0);
  Triangulation flat;
  BOOST_TEST(CGAL::insert_points_3(
                 flat, std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}) == 4);
  BOOST_TEST(flat.dimension() == 2);
  BOOST_CHECK_THROW(CGAL::insert_points_3(none, std::vector<Point>{{0, 0, 0}, {1, 0, 1 / 0.}}),
                    CGAL::Surface_input_error);
}
