// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What measures the theory, measured itself: crossings against all triangles one by one, shares
// where they are known, minimum spanning trees against all pairs of points, and the laboratory
// against plain CGAL.

#define BOOST_TEST_MODULE test_theory
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/restricted_delaunay.h>
#include <Delaunay_from_surface_3_theory/laboratory.h>
#include <Delaunay_from_surface_3_theory/trees.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

using surfaces::Indexed_surface;
using Kernel = Indexed_surface::Kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Vertices = std::vector<Triangulation::Vertex_handle>;

namespace {

std::vector<Point> random_points(std::size_t n, std::uint64_t seed)
{
  surfaces::Random random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(Point(CGAL::ORIGIN) + random.in_ball());
  return points;
}

Vertices insert(Triangulation& tr, const std::vector<Point>& points)
{
  Vertices vertices;
  for (const Point& p : points)
    vertices.push_back(tr.insert(p));
  return vertices;
}

// All triangles that the segment meets, except those that have an end of it for a vertex.
std::size_t crossings_one_by_one(const Triangulation& tr, const Point& p, const Point& q)
{
  std::size_t crossings = 0;
  for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f) {
    const Kernel::Triangle_3 t = tr.triangle(*f);
    bool has_end = false;
    for (int k = 0; k < 3; ++k)
      has_end = has_end || t[k] == p || t[k] == q;
    crossings += !has_end && CGAL::do_intersect(t, Kernel::Segment_3(p, q));
  }
  return crossings;
}

// Spans n vertices without a cycle.
bool is_tree(const theory::Edges& edges, std::size_t n)
{
  CGAL::Delaunay_from_surface_3::internal::Disjoint_sets<std::size_t> sets(n);
  return edges.size() + 1 == n && std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
           return sets.unite(e[0], e[1]);
         });
}

double share(const theory::Edges& edges, const theory::Edges& sorted)
{
  return theory::fraction(edges, [&](const auto& e) { return theory::contains(sorted, e); });
}

// Made once: Mesh_3 takes its time.
const Indexed_surface& small_sphere()
{
  static const Indexed_surface surface = surfaces::delaunay_sphere(1000);
  return surface;
}
const Indexed_surface& small_genus_3()
{
  static const Indexed_surface surface = surfaces::delaunay_genus_3(1500);
  return surface;
}

} // namespace

// Ends inside and outside the convex hull, at vertices and elsewhere.
BOOST_AUTO_TEST_CASE(crossings_are_those_counted_one_by_one)
{
  const std::vector<Point> points = random_points(300, 1);
  Triangulation tr;
  insert(tr, points);
  std::size_t wrong = 0, all = 0, outside = 0;
  std::vector<Point> ends = random_points(120, 2);
  for (std::size_t k = 0; k < 40; ++k)
    ends[k] = CGAL::ORIGIN + 1.5 * (ends[k] - CGAL::ORIGIN);
  ends.insert(ends.end(), points.begin(), points.begin() + 60);
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t expected = crossings_one_by_one(tr, ends[i], ends[j]);
      const std::size_t found = theory::number_of_crossings(
          tr, ends[i], ends[j], tr.locate(ends[i], Triangulation::Cell_handle()));
      wrong += found != expected;
      all += expected;
      outside += expected == 0;
    }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(all > 10000u);
  BOOST_TEST(outside > 50u);
}

// All triangles of a restricted Delaunay triangulation are Delaunay, and of the right surface.
BOOST_AUTO_TEST_CASE(restricted_delaunay_surfaces_are_delaunay)
{
  struct Case
  {
    Indexed_surface surface;
    std::ptrdiff_t euler_characteristic;
  };
  for (const Case& c : {Case{small_sphere(), 2}, Case{small_genus_3(), -4},
                        Case{surfaces::delaunay_round_genus_3(1500), -4}}) {
    Triangulation tr;
    const Vertices vertices = insert(tr, c.surface.points);
    const theory::Edges delaunay = theory::delaunay_edges(tr, vertices);
    const theory::Edges edges = theory::edges_of(c.surface);
    BOOST_TEST(surfaces::euler_characteristic(c.surface) == c.euler_characteristic);
    BOOST_TEST(surfaces::number_of_components(c.surface) == 1u);
    BOOST_TEST(share(edges, delaunay) == 1);
    BOOST_TEST(share(theory::bounded_degree_edges(c.surface), delaunay) == 1);
    BOOST_TEST(theory::delaunay_triangles(tr, vertices, c.surface.faces) == 1);
    const theory::Edges emst =
        theory::euclidean_minimum_spanning_tree(c.surface.points, delaunay, edges);
    BOOST_TEST(share(emst, edges) == 1);
    BOOST_TEST(is_tree(emst, vertices.size()));

    // The orientation is one: every edge is used once in each direction.
    theory::Edges darts;
    for (const auto& face : c.surface.faces)
      for (std::size_t k = 0; k < 3; ++k)
        darts.push_back({face[k], face[(k + 1) % 3]});
    std::sort(darts.begin(), darts.end());
    BOOST_TEST((std::adjacent_find(darts.begin(), darts.end()) == darts.end()));
  }
}

// A kite folded along its longer diagonal, under a fifth point: that diagonal is in no empty
// sphere.
BOOST_AUTO_TEST_CASE(shares_by_hand)
{
  const Indexed_surface kite = {{{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 5}},
                                {{0, 1, 2}, {1, 0, 3}}};
  Triangulation tr;
  const Vertices vertices = insert(tr, kite.points);
  const theory::Edges delaunay = theory::delaunay_edges(tr, vertices),
                      edges = theory::edges_of(kite);
  BOOST_TEST(delaunay.size() == 9u);
  BOOST_TEST(edges.size() == 5u);
  BOOST_TEST(share(edges, delaunay) == 0.8);
  BOOST_TEST(theory::delaunay_triangles(tr, vertices, kite.faces) == 0);
  const theory::Edges emst = theory::euclidean_minimum_spanning_tree(kite.points, delaunay, edges);
  BOOST_TEST(share(emst, edges) == 0.5); // 2-3 and an edge to 4 are not of the kite
}

BOOST_AUTO_TEST_CASE(minimum_spanning_trees_are_those_of_all_pairs)
{
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const std::vector<Point> points = random_points(200, seed);
    Triangulation tr;
    const theory::Edges delaunay = theory::delaunay_edges(tr, insert(tr, points));
    theory::Edges pairs;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        pairs.push_back({j, i});
    const auto tree = theory::euclidean_minimum_spanning_tree(points, delaunay, {});
    BOOST_TEST(is_tree(tree, points.size()));
    BOOST_TEST((tree == theory::euclidean_minimum_spanning_tree(points, pairs, {})));
    BOOST_TEST(share(tree, delaunay) == 1);
  }
}

// Trees that are to break the hypothesis span all the same, and break it more the more they are
// changed.
BOOST_AUTO_TEST_CASE(changed_trees_span)
{
  const Indexed_surface& surface = small_sphere();
  const std::size_t n = surface.points.size();
  Triangulation tr;
  const theory::Edges delaunay = theory::delaunay_edges(tr, insert(tr, surface.points));
  const theory::Edges edges = theory::edges_of(surface);
  const auto tree = theory::depth_first_tree(theory::bounded_degree_edges(surface), n);
  const theory::Edges random = theory::random_spanning_tree(edges, n, 1);
  BOOST_TEST(is_tree(random, n));
  BOOST_TEST(share(random, edges) == 1);
  double last = 1.5;
  for (const std::size_t k : {1, 2, 4, 8}) {
    const theory::Edges decimated = theory::decimated(tree, k);
    BOOST_TEST(is_tree(decimated, n));
    BOOST_TEST(share(decimated, delaunay) < last);
    last = share(decimated, delaunay);
    BOOST_TEST((k > 1 || last == 1));
  }
  last = 1.5;
  for (const double replaced : {0., 0.2, 1.}) {
    const theory::Edges changed = theory::with_random_edges(tree, replaced, 1);
    BOOST_TEST(is_tree(changed, n));
    BOOST_TEST(share(changed, delaunay) < last);
    last = share(changed, delaunay);
    BOOST_TEST((replaced > 0 || last == 1));
  }
  BOOST_TEST(last < 0.1);
}

BOOST_AUTO_TEST_CASE(the_laboratory_builds_plain_triangulation_and_counts_all)
{
  const Indexed_surface surface = surfaces::delaunay_genus_3(3000);
  const theory::Edges edges = theory::edges_of(surface),
                      subgraph = theory::bounded_degree_edges(surface);
  const std::size_t n = surface.points.size();
  theory::Laboratory laboratory(surface.points, edges, subgraph, 1);
  const auto rounds = laboratory.run();
  const theory::Counted_triangulation plain(surface.points.begin(), surface.points.end());
  BOOST_TEST((laboratory.triangulation() == plain));

  const auto ends = CGAL::Delaunay_from_surface_3::Log_star_rounds::round_ends(n);
  BOOST_TEST_REQUIRE(rounds.size() == ends.size());
  std::size_t begin = 0;
  for (std::size_t h = 0; h < rounds.size(); ++h) {
    BOOST_TEST(rounds[h].end == ends[h]);
    for (const theory::Location_cost& cost : rounds[h].ways)
      BOOST_TEST(cost.points == ends[h] - begin);
    BOOST_TEST(rounds[h].trace.points == (h + 1 == rounds.size() ? 0 : n - ends[h]));
    begin = ends[h];
  }
  // The first round has no trace before it. Later the paper's way is much the shorter.
  const auto cells = [&](std::size_t h, theory::Way way) {
    return rounds[h].ways[way].cells_entered;
  };
  BOOST_TEST(cells(0, theory::HISTORY_FROM_TRACE) == cells(0, theory::HISTORY_FROM_ROOT));
  for (std::size_t h = 1; h < rounds.size(); ++h)
    BOOST_TEST(3 * cells(h, theory::HISTORY_FROM_TRACE) < cells(h, theory::HISTORY_FROM_ROOT));

  for (const theory::Round_cost& round : rounds)
    BOOST_TEST((round.trace.points == 0 || round.crossings > 0));

  // The vertices come in the order of the surface.
  const auto vertices = laboratory.take_vertices();
  for (std::size_t v = 0; v < n; ++v)
    BOOST_TEST(vertices[v]->point() == surface.points[v]);
}

namespace {

using Cells = std::vector<Triangulation::Cell_handle>;

// By point: the cells of the triangulation that are in conflict with it, sorted; none if it is a
// vertex.
std::vector<Cells> conflict_sets(const Triangulation& tr, const std::vector<Point>& points)
{
  std::vector<Cells> sets;
  for (const Point& p : points) {
    Triangulation::Locate_type type;
    int li, lj;
    const auto cell = tr.locate(p, type, li, lj);
    Cells cells;
    if (type != Triangulation::VERTEX)
      tr.find_conflicts(p, cell, CGAL::Emptyset_iterator(), std::back_inserter(cells));
    std::sort(cells.begin(), cells.end());
    sets.push_back(std::move(cells));
  }
  return sets;
}

// Of the cells that the segment from p to q goes through, those in neither set. A cell with an end
// for a vertex may only be touched.
std::size_t cells_in_neither(const Triangulation& tr, const Point& p, const Point& q,
                             const Cells& of_p, const Cells& of_q)
{
  std::size_t count = 0;
  auto cell = tr.segment_traverser_cells_begin(p, q, tr.locate(p));
  for (const auto end = tr.segment_traverser_cells_end(); cell != end; ++cell) {
    const Triangulation::Cell_handle c = cell.handle();
    bool has_end = false;
    for (int k = 0; k < 4; ++k)
      has_end = has_end || (!tr.is_infinite(c->vertex(k)) &&
                            (c->vertex(k)->point() == p || c->vertex(k)->point() == q));
    count += !has_end && !std::binary_search(of_p.begin(), of_p.end(), c) &&
             !std::binary_search(of_q.begin(), of_q.end(), c);
  }
  return count;
}

struct Edges_tried
{
  std::size_t edges = 0, crossings = 0, bound = 0; // of D(S)
  std::size_t others = 0, others_beyond = 0;       // of which the lemmas say nothing
};

// Lemma 1 for edges between points of S that are in D(S), and D(R) of so many of the points.
void try_edges(const std::vector<Point>& points, const theory::Edges& edges,
               const theory::Edges& delaunay, std::size_t size_of_part, Edges_tried& tried)
{
  const std::vector<std::size_t> order = surfaces::Random(1).permutation(points.size());
  Triangulation part; // D(R)
  for (std::size_t k = 0; k < size_of_part; ++k)
    part.insert(points[order[k]]);
  const std::vector<Cells> conflicts = conflict_sets(part, points);
  for (const theory::Edge& e : edges) {
    const Point &p = points[e[0]], &q = points[e[1]];
    const Cells &of_p = conflicts[e[0]], &of_q = conflicts[e[1]];
    const std::size_t missing = cells_in_neither(part, p, q, of_p, of_q);
    if (!theory::contains(delaunay, e)) {
      ++tried.others;
      tried.others_beyond += missing > 0;
      continue;
    }
    const std::size_t crossings = theory::number_of_crossings(part, p, q, part.locate(p));
    if (missing > 0 || crossings > of_p.size() + of_q.size())
      BOOST_ERROR(missing << " cells in conflict with neither end, " << crossings << " crossings, "
                          << of_p.size() + of_q.size() << " conflicts");
    ++tried.edges;
    tried.crossings += crossings;
    tried.bound += of_p.size() + of_q.size();
  }
}

} // namespace

// Lemmas 1 and 2, edge by edge: a cell of D(R) that an edge vw of D(S) goes through is in conflict
// with v or with w. All edges of a surface are tried, and so those of any T; and edges that are not
// in D(S), for which this does not hold.
BOOST_AUTO_TEST_CASE(an_edge_goes_through_cells_in_conflict_with_its_ends)
{
  Edges_tried tried;
  for (const Indexed_surface& surface : {small_sphere(), small_genus_3()}) {
    Triangulation tr;
    const std::size_t n = surface.points.size();
    const theory::Edges delaunay = theory::delaunay_edges(tr, insert(tr, surface.points));
    theory::Edges edges = theory::edges_of(surface);
    const theory::Edges random =
        theory::with_random_edges(theory::depth_first_tree(edges, n), 0.5, 1);
    edges.insert(edges.end(), random.begin(), random.end());
    for (const std::size_t share : {30, 6, 2})
      try_edges(surface.points, edges, delaunay, n / share, tried);
  }
  BOOST_TEST_MESSAGE(tried.edges << " edges of D(S): " << tried.crossings << " crossings, bound "
                                 << tried.bound << "; " << tried.others << " others, of which "
                                 << tried.others_beyond << " break it");
  BOOST_TEST(tried.edges > 20000u);
  BOOST_TEST(tried.crossings > 5000u);
  BOOST_TEST(tried.others_beyond > 100u);
}

// The parts add up; and which cells are in conflict with a point does not depend on T.
BOOST_AUTO_TEST_CASE(total_work_is_that_of_its_parts)
{
  const Indexed_surface surface = small_sphere();
  const theory::Edges edges = theory::edges_of(surface);
  const theory::Edges tree = theory::random_spanning_tree(edges, surface.points.size(), 1);
  const theory::Json all = theory::Total_work(surface.points, edges, 1)();
  const theory::Json of_tree = theory::Total_work(surface.points, tree, 1)();
  for (const theory::Json& work : {all, of_tree}) {
    double calls = 0;
    for (const char* part : {"location", "traces", "records", "updates"})
      calls += work[part]["calls"].get<double>();
    BOOST_TEST(calls == work["calls"].get<double>(), boost::test_tools::tolerance(1e-4));
  }
  for (const auto& [part, counted] : {std::pair("location", "nodes"), std::pair("records", "nodes"),
                                      std::pair("updates", "cells_created")}) {
    BOOST_TEST(all[part][counted].get<double>() > 1.);
    BOOST_TEST(all[part][counted].get<double>() == of_tree[part][counted].get<double>());
  }
}
