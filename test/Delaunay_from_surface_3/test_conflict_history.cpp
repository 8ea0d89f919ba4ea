// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The history of all conflicts gives all cells in conflict with a point and no others: compared
// with all cells one by one, from the root and from everything recorded on the way. With it the
// paper's algorithm gives what CGAL's own insertion gives.

#define BOOST_TEST_MODULE test_conflict_history
#include <boost/test/included/unit_test.hpp>

#include "check_equal.h"
#include "history_cases.h"
#include "named_surfaces.h"

#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace tests::history;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using History = DFS::Conflict_history_3<Triangulation>;
using Nodes = std::vector<History::Node>;

namespace {

bool is_vertex(const Triangulation& tr, const Point& p)
{
  Triangulation::Vertex_handle v;
  return tr.is_vertex(p, v);
}

// The cells of today in conflict with p by CGAL's own test, as sorted nodes.
Nodes conflicts_one_by_one(const Triangulation& tr, const History& history, const Point& p)
{
  Nodes nodes;
  for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    if (tr.side_of_sphere(c, p, true) == CGAL::ON_BOUNDED_SIDE)
      nodes.push_back(history.node(c));
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

Nodes sorted(Nodes nodes)
{
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

// What a search finds is the conflict set, each cell once, or the vertex at p.
void check_search(const Triangulation& tr, const History& history, const Point& p,
                  const History::Search& search, const Nodes& found)
{
  Triangulation::Vertex_handle v;
  BOOST_TEST(
      (tr.is_vertex(p, v) ? search.vertex == v : search.vertex == Triangulation::Vertex_handle()));
  if (search.vertex == Triangulation::Vertex_handle())
    BOOST_TEST((sorted(found) == conflicts_one_by_one(tr, history, p)));
}

std::size_t nodes_in_conflict(const History& history, const Point& p)
{
  std::size_t nodes = 0;
  for (History::Node n = 0; n < history.number_of_nodes(); ++n)
    nodes += history.is_in_conflict(n, p);
  return nodes;
}

} // namespace

// Each node in conflict is visited, and the tests made in vain are bounded by those visited.
BOOST_AUTO_TEST_CASE(searches_from_the_root_find_all_conflicts)
{
  for (const Point_set& set : point_sets(500))
    BOOST_TEST_CONTEXT(set.name)
    {
      Triangulation tr;
      History history(tr);
      insert_all(tr, set.points, history, ignore);
      BOOST_TEST((tr == Triangulation(set.points.begin(), set.points.end())));
      for (const Point& p : queries(set.points, 100)) {
        Nodes found;
        const History::Search search = history.find_conflicts(p, std::back_inserter(found));
        check_search(tr, history, p, search, found);
        if (search.vertex != Triangulation::Vertex_handle())
          continue;
        BOOST_TEST(search.nodes_visited == nodes_in_conflict(history, p));
        BOOST_TEST(search.nodes_tested <= 9 * search.nodes_visited + 5);
      }
    }
}

// The conflict sets of all points are recorded whenever the number of points has doubled; from each
// the later ones are found.
BOOST_AUTO_TEST_CASE(searches_from_recorded_sets_find_all_conflicts)
{
  struct Recorded
  {
    std::size_t number_of_nodes;
    std::vector<Nodes> conflicts;
  };
  for (const Point_set& set : point_sets(300))
    BOOST_TEST_CONTEXT(set.name)
    {
      const std::vector<Point> asked = queries(set.points, 60);
      std::vector<Recorded> records;
      Triangulation tr;
      History history(tr);
      insert_all(tr, set.points, history, [&](std::size_t i) {
        if (history.is_empty() || (i & (i + 1)) != 0)
          return;
        records.push_back({history.number_of_nodes(), {}});
        for (const Point& p : asked) {
          const bool is_there = is_vertex(tr, p);
          records.back().conflicts.push_back(is_there ? Nodes()
                                                      : conflicts_one_by_one(tr, history, p));
        }
      });
      BOOST_TEST(records.size() >= 2u);
      for (const Recorded& record : records)
        for (std::size_t k = 0; k < asked.size(); ++k) {
          const Nodes& from = record.conflicts[k];
          if (from.empty()) // a vertex by then
            continue;
          Nodes found, from_root;
          const History::Search search =
              history.find_conflicts(asked[k], from.begin(), from.end(), record.number_of_nodes,
                                     std::back_inserter(found));
          check_search(tr, history, asked[k], search, found);
          const History::Search whole =
              history.find_conflicts(asked[k], std::back_inserter(from_root));
          BOOST_TEST((search.vertex != Triangulation::Vertex_handle() ||
                      search.nodes_visited < whole.nodes_visited));
        }
    }
}

// The paper records the cell that contains the point: from that cell alone cells are lost.
BOOST_AUTO_TEST_CASE(one_recorded_cell_does_not_do)
{
  const std::vector<Point> points = random_points(600, 1 << 12, 1);
  const std::vector<Point> asked = random_points(200, 1 << 12, 2);
  std::vector<History::Node> containing;
  std::size_t number_of_nodes_then = 0, lost = 0, all = 0, points_without = 0;
  Triangulation tr;
  History history(tr);
  insert_all(tr, points, history, [&](std::size_t i) {
    if (i != 100)
      return;
    number_of_nodes_then = history.number_of_nodes();
    for (const Point& p : asked)
      containing.push_back(history.node(tr.locate(p)));
  });
  for (std::size_t k = 0; k < asked.size(); ++k) {
    Nodes found;
    history.find_conflicts(asked[k], containing.begin() + std::ptrdiff_t(k),
                           containing.begin() + std::ptrdiff_t(k) + 1, number_of_nodes_then,
                           std::back_inserter(found));
    const Nodes expected = conflicts_one_by_one(tr, history, asked[k]);
    all += expected.size();
    lost += expected.size() - found.size();
    points_without += found.empty() && !expected.empty() ? 1 : 0;
  }
  BOOST_TEST_MESSAGE(lost << " of " << all << " conflicts lost, all of them for " << points_without
                          << " of " << asked.size() << " points");
  BOOST_TEST(lost > 0u);
  BOOST_TEST(lost < all);
  BOOST_TEST(points_without > 0u);
}

BOOST_AUTO_TEST_CASE(leaves_are_the_cells)
{
  for (const Point_set& set : point_sets(300))
    BOOST_TEST_CONTEXT(set.name)
    {
      Triangulation tr;
      History history(tr);
      insert_all(tr, set.points, history,
                 [&](std::size_t) { BOOST_TEST(history.is_empty() == (tr.dimension() < 3)); });
      std::size_t leaves = 0, wrong = 0;
      for (History::Node n = 0; n < history.number_of_nodes(); ++n)
        if (history.is_leaf(n)) {
          ++leaves;
          const auto cell = history.cell(n);
          wrong += !tr.tds().is_simplex(cell) || history.node(cell) != n;
          for (int k = 0; k < 4; ++k)
            wrong += cell->vertex(k) != history.vertices(n)[std::size_t(k)];
        }
      BOOST_TEST(wrong == 0u);
      BOOST_TEST(leaves == tr.number_of_cells());
    }
}

BOOST_AUTO_TEST_CASE(history_begins_with_what_is_there)
{
  const std::vector<Point> points = random_points(400, 1000, 5);
  Triangulation tr(points.begin(), points.begin() + 200);
  History history(tr);
  BOOST_TEST(history.number_of_nodes() == tr.number_of_cells());
  insert_all(tr, {points.begin() + 200, points.end()}, history, ignore);
  for (const Point& p : queries(points, 50)) {
    Nodes found;
    const History::Search search = history.find_conflicts(p, std::back_inserter(found));
    check_search(tr, history, p, search, found);
  }
}

// Lemma 4: from the triangulation of k points to that of i the sum of 4 c_j / j is visited, c_j
// cells being in conflict with a point among j: for points well inside, where all these cells are
// finite.
BOOST_AUTO_TEST_CASE(searches_are_as_long_as_lemma_4_says)
{
  const std::size_t k = 1000, i = 8000;
  const std::vector<Point> points = random_points(i, 1 << 20, 6);
  std::vector<Point> asked;
  for (const Point& p : random_points(500, 1 << 19, 7))
    asked.push_back(p + Kernel::Vector_3(1 << 18, 1 << 18, 1 << 18));
  std::vector<Nodes> records;
  std::size_t number_of_nodes_then = 0;
  std::map<std::size_t, double> sizes; // c_j, at some j
  Triangulation tr;
  History history(tr);
  insert_all(tr, points, history, [&](std::size_t last) {
    const std::size_t j = last + 1;
    if (j < k || j % 1000 != 0)
      return;
    std::size_t sum = 0;
    for (const Point& p : asked) {
      Nodes found;
      history.find_conflicts(p, std::back_inserter(found));
      sum += found.size();
      if (j == k)
        records.push_back(found);
    }
    sizes[j] = double(sum) / double(asked.size());
    if (j == k)
      number_of_nodes_then = history.number_of_nodes();
  });
  double expected = 0, visited = 0;
  for (std::size_t j = k + 1; j <= i; ++j)
    expected += 4 * sizes[(j + 999) / 1000 * 1000] / double(j);
  for (std::size_t a = 0; a < asked.size(); ++a) {
    Nodes found;
    visited += double(history
                          .find_conflicts(asked[a], records[a].begin(), records[a].end(),
                                          number_of_nodes_then, std::back_inserter(found))
                          .nodes_visited);
  }
  visited /= double(asked.size());
  BOOST_TEST_MESSAGE("visited " << visited << ", expected " << expected);
  BOOST_TEST(visited == expected, boost::test_tools::tolerance(0.1));
}

// TracingDT with the paper's Q, on everything from a single point to degenerate surfaces; as meshes
// too, where T is of bounded degree and no forest.
BOOST_AUTO_TEST_CASE(the_papers_algorithm_gives_plain_triangulations)
{
  tests::history::check_plain_triangulations<CGAL::History_tracing_traits_3,
                                             DFS::Conflict_history_hints_3>(400, 2);
  for (const tests::Named_surface& named : tests::ordinary_surfaces(2000))
    for (unsigned int seed = 0; seed < 2; ++seed)
      tests::Plain_case<Triangulation>(named).check_as_mesh<CGAL::History_tracing_traits_3>(seed);
}

BOOST_AUTO_TEST_CASE(the_papers_algorithm_with_exact_constructions)
{
  for (const tests::Named_surface& named : tests::degenerate_surfaces(150))
    tests::Plain_case<CGAL::Delaunay_triangulation_3<Exact_kernel>>(named)
        .check<CGAL::History_tracing_traits_3>();
}

// Cells that were there before the history, or that became its root all at once when the first
// point left a plane, are not tested one by one for every point: up to the next trace none is.
BOOST_AUTO_TEST_CASE(large_roots_are_not_searched)
{
  using Graph = CGAL::Delaunay_from_surface_3::internal::Index_graph;
  using Hints = DFS::Conflict_history_hints_3<Target, Graph>;
  std::vector<Point> flat = random_points(600, 1 << 20, 13);
  for (std::size_t i = 0; i < flat.size(); ++i)
    flat[i] = Point(flat[i].x(), flat[i].y(), i == 300 ? 1 << 19 : 0);
  struct Case
  {
    std::vector<Point> before, points;
    std::size_t trace_after;
  };
  for (const Case& c :
       {Case{random_points(2000, 1 << 20, 11), random_points(400, 1 << 20, 12), 100},
        Case{{}, flat, 500}}) {
    Triangulation tr(c.before.begin(), c.before.end());
    Target target(tr, c.points);
    const Graph graph = tests::history::broken_path(c.points.size(), 100, 300);
    Hints hints(target, graph);
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      target.insert(i, target.locate(i, hints.start(i)), hints);
      if (i + 1 != c.trace_after)
        continue;
      BOOST_TEST(hints.history().root_size() > 500u);
      BOOST_TEST(hints.nodes_tested() == 0u);
      hints.trace();
      BOOST_TEST(hints.nodes_tested() == 0u);
    }
    BOOST_TEST(hints.nodes_tested() > 0u);
    std::vector<Point> all = c.before;
    all.insert(all.end(), c.points.begin(), c.points.end());
    BOOST_TEST((tr == Triangulation(all.begin(), all.end())));
  }
}

// After each trace the records are the conflict sets, with several components and duplicates; and
// every start is in conflict with its point.
BOOST_AUTO_TEST_CASE(records_are_conflict_sets)
{
  using Graph = CGAL::Delaunay_from_surface_3::internal::Index_graph;
  using Hints = DFS::Conflict_history_hints_3<Target, Graph>;
  std::vector<Point> points = random_points(400, 1000, 7);
  points[350] = points[20];
  points[351] = points[320];
  const Graph graph = tests::history::broken_path(points.size(), 100, 300);
  Triangulation tr;
  Target target(tr, points);
  Hints hints(target, graph);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto cell = hints.start(i);
    if (tr.dimension() == 3 && is_vertex(tr, points[i]))
      BOOST_TEST(cell->has_vertex(target.locate(i, cell).cell->vertex(target.locate(i, cell).li)));
    else if (tr.dimension() == 3)
      BOOST_TEST((tr.side_of_sphere(cell, points[i], true) == CGAL::ON_BOUNDED_SIDE));
    target.insert(i, target.locate(i, cell), hints);
    if (i % 60 != 59)
      continue;
    BOOST_TEST(hints.trace() == points.size() - i - 1);
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const bool is_there = is_vertex(tr, points[j]);
      BOOST_TEST((sorted(hints.recorded_conflicts(j)) ==
                  (is_there ? Nodes() : conflicts_one_by_one(tr, hints.history(), points[j]))));
    }
  }
  BOOST_TEST(hints.nodes_visited() > points.size());
  BOOST_TEST(hints.nodes_tested() > hints.nodes_visited());
}
