// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The history DAG finds every point, from the root and from everything recorded on the way, and its
// events cover what they destroy. Traces with it give what CGAL's own insertion gives.

#define BOOST_TEST_MODULE test_history_dag
#include <boost/test/included/unit_test.hpp>

#include "check_equal.h"
#include "history_cases.h"
#include "named_surfaces.h"

#include <Delaunay_from_surface_3_meters/History_hints_3.h>
#include <Delaunay_from_surface_3_meters/orders.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_along_graph_3.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace tests::history;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Dag = meters::History_dag_3<Triangulation>;
using Traits =
    CGAL::Surface_insertion_policies_3<DFS::Bounded_degree_subgraph, meters::Random_log_star_rounds,
                                       meters::History_hints_3>;

namespace {

// The leaf is the place that CGAL finds, or, where the point lies on several cells or sees several
// facets of the convex hull, another one that is right.
void check_is_place(const Triangulation& tr, const Dag& dag, Dag::Node node, const Point& p)
{
  BOOST_TEST_REQUIRE(dag.is_leaf(node));
  const auto cell = dag.cell(node);
  BOOST_TEST_REQUIRE(tr.is_cell(cell));
  BOOST_TEST(dag.node(cell) == node);
  BOOST_TEST(dag.contains(node, p));

  Triangulation::Locate_type type;
  int li, lj;
  const auto place = tr.locate(p, type, li, lj);
  if (type == Triangulation::CELL)
    BOOST_TEST((cell == place));
  else if (type == Triangulation::OUTSIDE_CONVEX_HULL)
    BOOST_TEST(tr.is_infinite(cell));
  else if (type == Triangulation::VERTEX)
    BOOST_TEST(cell->has_vertex(place->vertex(li)));
  else if (type == Triangulation::EDGE)
    BOOST_TEST((cell->has_vertex(place->vertex(li)) && cell->has_vertex(place->vertex(lj))));
  else
    for (int k = 0; k < 4; ++k)
      BOOST_TEST((k == li || cell->has_vertex(place->vertex(k))));
}

// All of today's cells are leaves, and all leaves are today's cells.
void check_leaves(const Triangulation& tr, const Dag& dag)
{
  std::size_t leaves = 0, wrong = 0;
  for (Dag::Node n = 0; n < dag.number_of_nodes(); ++n)
    if (dag.is_leaf(n)) {
      ++leaves;
      const auto cell = dag.cell(n);
      wrong += !tr.tds().is_simplex(cell) || dag.node(cell) != n;
      for (int k = 0; k < 4; ++k)
        wrong += cell->vertex(k) != dag.vertices(n)[std::size_t(k)];
    }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(leaves == tr.number_of_cells());
}

// Counts what the observer is told, beside the DAG.
class Counting_dag : public Dag
{
public:
  using Dag::Dag;

  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last)
  {
    destroyed += std::size_t(std::distance(first, last));
    Dag::before_update(i, first, last);
  }

  std::size_t destroyed = 0;
};

// Six times the volume, exact for small integers; none for an infinite cell.
double six_volumes(const Triangulation& tr, const Dag& dag, Dag::Node n)
{
  const auto& v = dag.vertices(n);
  for (const auto& vertex : v)
    if (tr.is_infinite(vertex))
      return 0;
  return CGAL::determinant(v[1]->point() - v[0]->point(), v[2]->point() - v[0]->point(),
                           v[3]->point() - v[0]->point());
}

bool is_infinite(const Triangulation& tr, const Dag& dag, Dag::Node n)
{
  for (const auto& vertex : dag.vertices(n))
    if (tr.is_infinite(vertex))
      return true;
  return false;
}

struct Zone
{
  double volume = 0;
  bool is_finite = true;
};

} // namespace

BOOST_AUTO_TEST_CASE(descents_from_the_root_find_every_point)
{
  for (const Point_set& set : point_sets(600))
    BOOST_TEST_CONTEXT(set.name)
    {
      Triangulation tr;
      Dag dag(tr);
      insert_all(tr, set.points, dag, ignore);
      BOOST_TEST((tr == Triangulation(set.points.begin(), set.points.end())));
      std::size_t longest = 0;
      for (const Point& p : queries(set.points, 300)) {
        const Dag::Descent descent = dag.locate(p);
        check_is_place(tr, dag, descent.node, p);
        BOOST_TEST(descent.nodes_entered >= 1u);
        longest = (std::max)(longest, descent.nodes_entered);
      }
      BOOST_TEST(longest > 5u);
    }
}

// Every point is recorded whenever the number of points has doubled, and then found from each
// record.
BOOST_AUTO_TEST_CASE(descents_from_recorded_ancestors_find_every_point)
{
  for (const Point_set& set : point_sets(300))
    BOOST_TEST_CONTEXT(set.name)
    {
      const std::vector<Point> asked = queries(set.points, 60);
      std::map<std::size_t, std::vector<Dag::Node>> records;
      Triangulation tr;
      Dag dag(tr);
      insert_all(tr, set.points, dag, [&](std::size_t i) {
        if (!dag.is_empty() && ((i & (i + 1)) == 0))
          for (const Point& p : asked)
            records[i].push_back(dag.locate(p).node);
      });
      BOOST_TEST(records.size() >= 2u);
      for (const auto& [i, nodes] : records)
        for (std::size_t k = 0; k < asked.size(); ++k) {
          const Dag::Descent descent = dag.locate(asked[k], nodes[k]);
          check_is_place(tr, dag, descent.node, asked[k]);
          BOOST_TEST((descent.nodes_entered == 0) == dag.is_leaf(nodes[k]));
          BOOST_TEST(descent.nodes_entered < dag.locate(asked[k]).nodes_entered);
        }
    }
}

BOOST_AUTO_TEST_CASE(leaves_are_the_cells_and_counts_add_up)
{
  for (const Point_set& set : point_sets(300))
    BOOST_TEST_CONTEXT(set.name)
    {
      Triangulation tr;
      Counting_dag dag(tr);
      std::size_t events = 0, vertices = 0;
      insert_all(tr, set.points, dag, [&](std::size_t) {
        events += tr.dimension() == 3 && tr.number_of_vertices() > vertices;
        vertices = tr.number_of_vertices();
        BOOST_TEST(dag.is_empty() == (tr.dimension() < 3));
        BOOST_TEST(dag.number_of_events() == events);
        if (!dag.is_empty())
          BOOST_TEST(dag.number_of_nodes() == tr.number_of_cells() + dag.destroyed);
      });
      check_leaves(tr, dag);
      BOOST_TEST_REQUIRE(dag.star_begin(0) == 0u);
      for (std::size_t e = 0; e < dag.number_of_events(); ++e) {
        BOOST_TEST(dag.star_begin(e) < dag.star_end(e));
        if (e > 0)
          BOOST_TEST(dag.star_begin(e) == dag.star_end(e - 1));
      }
      BOOST_TEST(dag.star_end(dag.number_of_events() - 1) == dag.number_of_nodes());
    }
}

// A star has one new vertex in all its cells, and the volume of what it destroyed if that was
// finite; otherwise more, as the convex hull grows. And a destroyed cell's middle is in a cell of
// the star.
BOOST_AUTO_TEST_CASE(stars_cover_their_conflict_zones)
{
  for (const Point_set& set : point_sets(300))
    BOOST_TEST_CONTEXT(set.name)
    {
      Triangulation tr;
      Dag dag(tr);
      insert_all(tr, set.points, dag, ignore);
      std::vector<Zone> zones(dag.number_of_events());
      for (Dag::Node n = 0; n < dag.number_of_nodes(); ++n) {
        if (dag.is_leaf(n))
          continue;
        const std::size_t e = dag.destroying_event(n);
        BOOST_TEST_REQUIRE(e < dag.number_of_events());
        BOOST_TEST(dag.star_begin(e) > n);
        zones[e].volume += six_volumes(tr, dag, n);
        zones[e].is_finite = zones[e].is_finite && !is_infinite(tr, dag, n);
        if (is_infinite(tr, dag, n))
          continue;
        const auto& v = dag.vertices(n);
        const Point middle = CGAL::midpoint(CGAL::midpoint(v[0]->point(), v[1]->point()),
                                            CGAL::midpoint(v[2]->point(), v[3]->point()));
        std::size_t holders = 0;
        for (Dag::Node m = dag.star_begin(e); m != dag.star_end(e); ++m)
          holders += !is_infinite(tr, dag, m) && dag.contains(m, middle);
        BOOST_TEST(holders >= 1u);
      }
      std::size_t finite_zones = 0;
      for (std::size_t e = 1; e < zones.size(); ++e) {
        double star = 0;
        for (Dag::Node n = dag.star_begin(e); n != dag.star_end(e); ++n)
          star += six_volumes(tr, dag, n);
        finite_zones += zones[e].is_finite;
        if (set.name == "surface") // its coordinates are no integers
          BOOST_TEST(star >= zones[e].volume * (1 - 1e-9));
        else if (zones[e].is_finite)
          BOOST_TEST(star == zones[e].volume);
        else
          BOOST_TEST(star >= zones[e].volume);
      }
      BOOST_TEST_MESSAGE(set.name << ": " << finite_zones << " of " << zones.size()
                                  << " events left the convex hull alone");
    }
}

BOOST_AUTO_TEST_CASE(history_begins_with_what_is_there)
{
  const std::vector<Point> points = random_points(400, 1000, 5);
  Triangulation tr(points.begin(), points.begin() + 200);
  Dag dag(tr);
  BOOST_TEST(dag.number_of_events() == 1u);
  BOOST_TEST(dag.number_of_nodes() == tr.number_of_cells());
  insert_all(tr, {points.begin() + 200, points.end()}, dag, ignore);
  check_leaves(tr, dag);
  for (const Point& p : queries(points, 100))
    check_is_place(tr, dag, dag.locate(p).node, p);
}

// Lemma 4 with its constant: from the triangulation of k points to that of i, 4 ln(i/k) nodes for
// points well inside; less for those that were in infinite cells for a while, which have three
// vertices only.
BOOST_AUTO_TEST_CASE(descents_are_as_long_as_lemma_4_says)
{
  const std::size_t k = 1000, i = 8000;
  std::vector<Point> points = random_points(i, 1 << 20, 6), asked;
  for (const Point& p : random_points(2000, 1 << 19, 7))
    asked.push_back(p + Kernel::Vector_3(1 << 18, 1 << 18, 1 << 18));
  std::vector<Dag::Node> records;
  Triangulation tr;
  Dag dag(tr);
  insert_all(tr, points, dag, [&](std::size_t last) {
    if (last + 1 == k)
      for (const Point& p : asked)
        records.push_back(dag.locate(p).node);
  });
  std::size_t from_root = 0, from_record = 0;
  for (std::size_t j = 0; j < asked.size(); ++j) {
    from_root += dag.locate(asked[j]).nodes_entered;
    from_record += dag.locate(asked[j], records[j]).nodes_entered;
  }
  const double n = double(asked.size());
  BOOST_TEST(double(from_record) / n == 4 * std::log(double(i) / double(k)),
             boost::test_tools::tolerance(0.1));
  BOOST_TEST(double(from_root) / n < 4 * std::log(double(i)));
  BOOST_TEST(double(from_root) / n > 3 * std::log(double(i) / 4));
}

// TracingDT with this history for Q, on everything from a single point to degenerate surfaces.
BOOST_AUTO_TEST_CASE(traces_and_this_history_give_plain_triangulations)
{
  tests::history::check_plain_triangulations<Traits, meters::History_hints_3>(600, 3);
}

BOOST_AUTO_TEST_CASE(with_exact_constructions)
{
  for (const tests::Named_surface& named : tests::degenerate_surfaces(200))
    tests::Plain_case<CGAL::Delaunay_triangulation_3<Exact_kernel>>(named).check<Traits>();
}

// Whenever a point is inserted its descent has found the cell that contains it, so that the walk
// after it has nothing to do; and what is recorded contains the point.
BOOST_AUTO_TEST_CASE(records_contain_their_points)
{
  using Graph = CGAL::Delaunay_from_surface_3::internal::Index_graph;
  using Hints = meters::History_hints_3<Target, Graph>;
  const std::vector<Point> points = random_points(500, 1000, 7);
  const Graph graph = tests::history::broken_path(points.size(), 100, 400);
  Triangulation tr;
  Target target(tr, points);
  Hints hints(target, graph);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto cell = hints.start(i);
    if (tr.dimension() == 3)
      BOOST_TEST(hints.history().contains(hints.history().node(cell), points[i]));
    target.insert(i, target.locate(i, cell), hints);
    if (i % 60 != 59)
      continue;
    BOOST_TEST(hints.trace() == points.size() - i - 1);
    for (std::size_t j = i + 1; j < points.size(); ++j)
      BOOST_TEST(hints.history().contains(hints.recorded_node(j), points[j]));
  }
  BOOST_TEST(hints.nodes_entered() > points.size());
}
