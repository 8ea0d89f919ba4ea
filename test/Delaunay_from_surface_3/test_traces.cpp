// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The route of a trace (Choi 2002, Fig. 1, line 2a): from which cell each point is located. A trace
// that located every point from anywhere would find the same, and cost more.

#define BOOST_TEST_MODULE test_traces
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Graph = DFS::internal::Index_graph;

namespace {

// Notes all locations in their order.
class Noting_target : public DFS::Triangulation_target_3<Triangulation>
{
  using Base = DFS::Triangulation_target_3<Triangulation>;

public:
  struct Note
  {
    std::size_t point;
    Cell start, found;
  };

  using Base::Base;

  Location locate(std::size_t i, Cell start) const
  {
    const Location location = Base::locate(i, start);
    notes.push_back({i, start, location.cell});
    return location;
  }

  mutable std::vector<Note> notes;
};

struct Case
{
  std::vector<Point> points;
  Graph graph;
  std::vector<std::size_t> component; // the smallest vertex in it
};

// A random forest of `pieces` trees on n points, and some edges more.
Case random_case(std::size_t n, std::size_t pieces, std::uint32_t seed)
{
  std::mt19937 random(seed);
  Case result;
  std::vector<std::pair<std::size_t, std::size_t>> darts;
  const auto join = [&](std::size_t i, std::size_t j) {
    darts.emplace_back(i, j);
    darts.emplace_back(j, i);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random() % 1000, y = random() % 1000, z = random() % 1000;
    result.points.emplace_back(x, y, z);
    result.component.push_back(i % pieces);
    if (i >= pieces) {
      join(i, i % pieces + pieces * (random() % (i / pieces)));
      if (random() % 4 == 0)
        join(i, i % pieces + pieces * (random() % (i / pieces)));
    }
  }
  result.graph = Graph(boost::edges_are_unsorted_multi_pass, darts.begin(), darts.end(), n);
  return result;
}

using Cells = std::map<std::size_t, Triangulation::Cell_handle>;

// The cells from which a trace of the points less than `end` may locate point i: those of points
// that are inserted, or have been found before, and that a path in T leads from to i past points
// that are neither and are not less than `end`.
std::set<Triangulation::Cell_handle> starts_of(std::size_t i, std::size_t end, const Case& c,
                                               const Noting_target& target, const Cells& found)
{
  std::set<Triangulation::Cell_handle> starts;
  std::set<std::size_t> seen = {i};
  std::vector<std::size_t> stack = {i};
  while (!stack.empty()) {
    const std::size_t j = stack.back();
    stack.pop_back();
    for (auto [u, last] = adjacent_vertices(j, c.graph); u != last; ++u) {
      const auto v = target.vertex(*u);
      if (v != Noting_target::Vertex())
        starts.insert(target.cell(v));
      else if (found.count(*u) != 0)
        starts.insert(found.at(*u));
      else if (*u >= end && seen.insert(*u).second)
        stack.push_back(*u);
    }
  }
  return starts;
}

} // namespace

// Every point less than `end` that is not inserted is located once: from the cell of the point in T
// that leads to it. Only in a component without any vertex the first is not.
BOOST_AUTO_TEST_CASE(each_point_is_located_from_a_neighbor)
{
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const std::size_t n = 300, pieces = 1 + seed % 7, inserted = 8 + seed * 2;
    const std::size_t end = seed % 2 == 0 ? n : inserted + 30;
    const Case c = random_case(n, pieces, seed);
    Triangulation tr;
    Noting_target target(tr, c.points);
    DFS::Previous_hint_3<Noting_target, Graph> nobody(target);
    // The last piece gets no vertex, if there are several.
    for (std::size_t k = 0, i = 0; k < inserted; ++i)
      if (pieces == 1 || i % pieces + 1 < pieces) {
        target.insert(i, target.locate(i, tr.infinite_cell()), nobody);
        ++k;
      }
    target.notes.clear();

    std::set<std::size_t> started;
    std::vector<std::size_t> recorded(n, 0);
    DFS::Trace_subgraph<Noting_target, Graph> trace(target, c.graph);
    const auto any = tr.infinite_cell();
    const std::size_t located = trace(
        [&](std::size_t i) {
          started.insert(i);
          return any;
        },
        [&](std::size_t i, const Noting_target::Location&) { ++recorded[i]; }, end);
    BOOST_TEST(located == target.notes.size());

    Cells found;
    for (const Noting_target::Note& note : target.notes) {
      const auto starts = starts_of(note.point, end, c, target, found);
      BOOST_TEST((starts.count(note.start) != 0) == (started.count(note.point) == 0));
      BOOST_TEST(found.emplace(note.point, note.found).second);
    }
    for (std::size_t i = 0; i < n; ++i) {
      BOOST_TEST(recorded[i] == (i < end && target.vertex(i) == Noting_target::Vertex() ? 1u : 0u));
      BOOST_TEST(found.count(i) == recorded[i]);
    }
    BOOST_TEST(started.size() == (pieces == 1 ? 0u : 1u));
  }
}

// Without edges each point is a component: it is located from where the one before it was found.
BOOST_AUTO_TEST_CASE(components_without_vertices_start_at_the_point_before)
{
  const std::size_t inserted = 50, end = 200;
  const Case c = random_case(300, 300, 1);
  Triangulation tr;
  Noting_target target(tr, c.points);
  DFS::Insertion_order plan;
  plan.round_ends = {inserted, end, c.points.size()};
  DFS::Traced_hints_3<Noting_target, Graph> hints(target, c.graph, plan);
  for (std::size_t i = 0; i < inserted; ++i)
    target.insert(i, target.locate(i, hints.start(i)), hints);
  target.notes.clear();
  BOOST_TEST(hints.trace() == end - inserted);
  BOOST_REQUIRE(target.notes.size() == end - inserted);
  BOOST_TEST((target.notes[0].start == target.cell(target.vertex(inserted - 1))));
  for (std::size_t k = 1; k < target.notes.size(); ++k)
    BOOST_TEST((target.notes[k].start == target.notes[k - 1].found));
}
