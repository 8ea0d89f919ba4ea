// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Euclidean minimum spanning trees against all pairs of points, ties included; whether a surface
// contains one against the trees themselves; and how much of a surface is Delaunay, where it is
// known.

#define BOOST_TEST_MODULE test_minimum_spanning_trees
#include <boost/test/included/unit_test.hpp>

#include "check_equal.h"
#include "history_cases.h"

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>

#include <Delaunay_from_surface_3_meters/delaunay_share.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_spanning_forest.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/contains_euclidean_minimum_spanning_tree.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>
#include <CGAL/euclidean_minimum_spanning_tree_3_arrays.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/regular_3_arrays.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace tests::history;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Triangulation::Vertex_handle;
using Pairs = std::vector<std::pair<Vertex, Vertex>>;

namespace {

template <class Tr>
std::vector<std::pair<typename Tr::Vertex_handle, typename Tr::Vertex_handle>> tree_of(const Tr& tr)
{
  std::vector<std::pair<typename Tr::Vertex_handle, typename Tr::Vertex_handle>> tree;
  CGAL::euclidean_minimum_spanning_tree_3(tr, std::back_inserter(tree));
  return tree;
}

std::vector<Point> distinct(std::vector<Point> points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Squared lengths of a minimum spanning tree of all pairs, by Prim's algorithm: exact for integers
// that are not large. Sorted.
std::vector<double> lengths_by_all_pairs(const std::vector<Point>& points)
{
  std::vector<double> distance(points.size(), 1e300), lengths;
  std::vector<bool> is_reached(points.size(), false);
  std::size_t last = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    is_reached[last] = true;
    std::size_t next = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_reached[i]) {
        distance[i] = (std::min)(distance[i], CGAL::squared_distance(points[i], points[last]));
        if (next == points.size() || distance[i] < distance[next])
          next = i;
      }
    lengths.push_back(distance[next]);
    last = next;
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

std::vector<double> lengths_of(const Pairs& tree)
{
  std::vector<double> lengths;
  for (const auto& e : tree)
    lengths.push_back(CGAL::squared_distance(e.first->point(), e.second->point()));
  return lengths;
}

// Spans all vertices without a cycle, and no degree is above 12.
void check_tree(const Triangulation& tr, const Pairs& tree)
{
  std::map<Vertex, std::size_t> number, degree;
  for (const Vertex v : tr.finite_vertex_handles())
    number.emplace(v, number.size());
  DFS::core::Disjoint_sets<std::size_t> sets(number.size());
  BOOST_TEST(tree.size() + 1 == (std::max)(number.size(), std::size_t(1)));
  for (const auto& e : tree) {
    BOOST_TEST((e.first->point() < e.second->point()));
    BOOST_TEST(sets.unite(number.at(e.first), number.at(e.second)));
    BOOST_TEST(++degree[e.first] <= 12u);
    BOOST_TEST(++degree[e.second] <= 12u);
  }
}

// Points in lexicographical order have the same tree as arrays.
void check_arrays(const std::vector<Point>& points, const Pairs& tree)
{
  const auto arrays = CGAL::delaunay_3_arrays(points);
  std::vector<std::array<std::int32_t, 2>> edges;
  CGAL::euclidean_minimum_spanning_tree_3(arrays, points, std::back_inserter(edges));
  BOOST_TEST_REQUIRE(edges.size() == tree.size());
  for (std::size_t k = 0; k < tree.size(); ++k)
    BOOST_TEST((points[std::size_t(edges[k][0])] == tree[k].first->point() &&
                points[std::size_t(edges[k][1])] == tree[k].second->point()));
}

// A mesh that is nothing but edges.
Mesh mesh_of(const std::vector<Point>& points, const std::vector<std::array<std::size_t, 2>>& edges)
{
  Mesh mesh;
  for (const Point& p : points)
    mesh.add_vertex(p);
  for (const auto& e : edges)
    mesh.add_edge(Mesh::Vertex_index(Mesh::size_type(e[0])),
                  Mesh::Vertex_index(Mesh::size_type(e[1])));
  return mesh;
}

// A point with all twelve at distance sqrt(2) in the face-centred cubic lattice.
std::vector<Point> kissing_points()
{
  std::vector<Point> points = {{0, 0, 0}};
  for (const int a : {-1, 1})
    for (const int b : {-1, 1}) {
      points.emplace_back(a, b, 0);
      points.emplace_back(a, 0, b);
      points.emplace_back(0, a, b);
    }
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(trees_are_those_of_all_pairs)
{
  std::vector<Point_set> sets = point_sets(400);
  sets.push_back({"kissing points", kissing_points()});
  sets.push_back({"few", random_points(20, 5, 9)});
  for (const Point_set& set : sets)
    BOOST_TEST_CONTEXT(set.name)
    {
      const Triangulation tr(set.points.begin(), set.points.end());
      const Pairs tree = tree_of(tr);
      check_tree(tr, tree);
      check_arrays(distinct(set.points), tree);
      const std::vector<double> lengths = lengths_of(tree);
      if (set.name != "surface") { // its coordinates are no integers
        BOOST_TEST(std::is_sorted(lengths.begin(), lengths.end()));
        BOOST_TEST((lengths == lengths_by_all_pairs(distinct(set.points))));
      }
      // The same points in another order have the same tree.
      std::vector<Point> reversed(set.points.rbegin(), set.points.rend());
      const Triangulation other(reversed.begin(), reversed.end());
      const Pairs other_tree = tree_of(other);
      BOOST_TEST_REQUIRE(other_tree.size() == tree.size());
      for (std::size_t k = 0; k < tree.size(); ++k)
        BOOST_TEST((tree[k].first->point() == other_tree[k].first->point() &&
                    tree[k].second->point() == other_tree[k].second->point()));
    }
}

namespace {

// By Kruskal's algorithm on all finite edges, in exact numbers.
template <class Tr>
std::vector<std::pair<typename Tr::Vertex_handle, typename Tr::Vertex_handle>>
tree_by_finite_edges(const Tr& tr)
{
  using FT = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  using Vertex = typename Tr::Vertex_handle;
  std::map<Vertex, std::size_t> number;
  for (const Vertex v : tr.finite_vertex_handles())
    number.emplace(v, number.size());
  std::vector<std::tuple<FT, typename Tr::Point, typename Tr::Point, Vertex, Vertex>> edges;
  for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e) {
    Vertex v = e->first->vertex(e->second), w = e->first->vertex(e->third);
    if (w->point() < v->point())
      std::swap(v, w);
    FT length = 0;
    for (int k = 0; k < 3; ++k)
      length += CGAL::square(FT(v->point()[k]) - FT(w->point()[k]));
    edges.emplace_back(length, v->point(), w->point(), v, w);
  }
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a), std::get<2>(a)) <
           std::tie(std::get<0>(b), std::get<1>(b), std::get<2>(b));
  });
  DFS::core::Disjoint_sets<std::size_t> sets(number.size());
  std::vector<std::pair<Vertex, Vertex>> tree;
  for (const auto& [length, p, q, v, w] : edges)
    if (sets.unite(number.at(v), number.at(w)))
      tree.emplace_back(v, w);
  return tree;
}

// Also when vertices were removed, so that those left are no longer one after the other in memory.
template <class Kernel>
void check_by_finite_edges(const std::vector<Point>& points, double scale)
{
  CGAL::Delaunay_triangulation_3<Kernel> tr;
  for (const Point& p : points)
    tr.insert(typename Kernel::Point_3(p.x() * scale, p.y() * scale, p.z() * scale));
  BOOST_TEST((tree_of(tr) == tree_by_finite_edges(tr)));
  for (int k = 0; k < 10 && tr.number_of_vertices() > 0; ++k)
    tr.remove(std::next(tr.finite_vertices_begin(), std::ptrdiff_t(tr.number_of_vertices() / 2)));
  tr.insert(typename Kernel::Point_3(scale / 4, scale / 8, 0));
  BOOST_TEST((tree_of(tr) == tree_by_finite_edges(tr)));
}

} // namespace

// There is one tree, for all kernels and at all scales.
BOOST_AUTO_TEST_CASE(trees_are_those_of_all_finite_edges)
{
  for (const std::vector<Point>& points :
       {grid(5), random_points(150, 6, 1), kissing_points(), random_points(200, 1 << 20, 2),
        random_points(12, 9, 3)}) {
    for (const double scale : {1., 1e-3, 1e-160, 1e-318, 1e160, 1e300})
      check_by_finite_edges<CGAL::Exact_predicates_inexact_constructions_kernel>(points, scale);
    check_by_finite_edges<CGAL::Exact_predicates_exact_constructions_kernel>(points, 1e-3);
    check_by_finite_edges<CGAL::Simple_cartesian<double>>(points, 1);
  }
}

// Lengths that doubles cannot tell apart, and lengths beyond their squares.
BOOST_AUTO_TEST_CASE(lengths_are_compared_exactly)
{
  // From 0 to ±1 the way is 1; from 1 to a it is 1 - 2^-60, which rounds to 1.
  const double near = 2 - 1. / (1ll << 52);
  for (const double scale : {1., 1e-200, 1e200}) {
    const std::vector<Point> points = {
        {0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {scale, near * scale / 2, 0}};
    const Triangulation tr(points.begin(), points.end());
    const Pairs tree = tree_of(tr);
    BOOST_TEST_REQUIRE(tree.size() == 3u);
    // A square, all but: the shortest sides are the two that near has shortened.
    const std::set<Point> shortest = {tree[0].first->point(), tree[0].second->point()};
    BOOST_TEST((shortest == std::set<Point>{points[1], points[3]}));
    check_arrays(distinct(points), tree);
  }
  using Exact = CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_exact_constructions_kernel>;
  using FT = Exact::Geom_traits::FT;
  const FT tiny = FT(1.) / FT(1e18) / FT(1e18);
  Exact exact;
  for (const FT& x : {FT(0), FT(1), FT(2) - tiny})
    exact.insert(Exact::Point(x, 0, 0));
  exact.insert(Exact::Point(0, 5, 0));
  exact.insert(Exact::Point(0, 0, 5));
  const auto tree = tree_of(exact);
  BOOST_TEST_REQUIRE(tree.size() == 4u);
  BOOST_TEST((tree[0].first->point().x() == 1));
}

BOOST_AUTO_TEST_CASE(trees_in_lower_dimensions)
{
  Triangulation tr;
  BOOST_TEST(tree_of(tr).empty());
  tr.insert(Point(0, 0, 0));
  BOOST_TEST(tree_of(tr).empty());
  for (const int x : {5, 1, 9, 2})
    tr.insert(Point(x, 0, 0));
  BOOST_TEST(tr.dimension() == 1);
  check_tree(tr, tree_of(tr));
  BOOST_TEST((lengths_of(tree_of(tr)) == std::vector<double>{1, 1, 9, 16}));
  const auto check_as_arrays = [&tr] {
    const auto points = tr.points_begin();
    check_arrays(distinct({points, std::next(points, std::ptrdiff_t(tr.number_of_vertices()))}),
                 tree_of(tr));
  };
  check_as_arrays();
  tr.insert(Point(1, 3, 0));
  BOOST_TEST(tr.dimension() == 2);
  check_tree(tr, tree_of(tr));
  BOOST_TEST((lengths_of(tree_of(tr)) == std::vector<double>{1, 1, 9, 9, 16}));
  check_as_arrays();
}

// Points that are equal to others are in no edge.
BOOST_AUTO_TEST_CASE(trees_of_arrays_with_equal_points)
{
  std::vector<Point> points = {{0, 0, 0}, {0, 0, 0}};
  const auto tree = [&points] {
    std::vector<std::array<std::int32_t, 2>> edges;
    CGAL::euclidean_minimum_spanning_tree_3(CGAL::delaunay_3_arrays(points), points,
                                            std::back_inserter(edges));
    return edges;
  };
  BOOST_TEST(tree().empty());
  points.insert(points.end(), {{5, 0, 0}, {1, 0, 0}, {5, 0, 0}, {0, 2, 0}, {0, 0, 3}});
  BOOST_TEST((tree() == std::vector<std::array<std::int32_t, 2>>{{0, 3}, {0, 5}, {0, 6}, {2, 3}}));
  BOOST_CHECK_THROW(CGAL::euclidean_minimum_spanning_tree_3(
                        CGAL::delaunay_3_arrays(points), std::vector<Point>(3),
                        boost::make_function_output_iterator([](const auto&) {})),
                    CGAL::Surface_input_error);
}

// The edges of the others need not have a tree.
BOOST_AUTO_TEST_CASE(trees_of_arrays_with_hidden_points)
{
  const std::vector<std::array<double, 3>> points = {
      {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}};
  const std::vector<double> weights = {0, 0, 0, 0, -10};
  std::vector<std::array<std::int32_t, 2>> tree;
  const auto refused = [](const CGAL::Surface_input_error& error) {
    return std::string(error.what()) ==
           "vertex 4: its weight hides it, and a spanning tree needs all points";
  };
  BOOST_CHECK_EXCEPTION(
      CGAL::euclidean_minimum_spanning_tree_3(CGAL::regular_3_arrays(points, weights), points,
                                              std::back_inserter(tree)),
      CGAL::Surface_input_error, refused);
}

// Where all lengths differ there is one tree, and a graph contains it if and only if it has all its
// edges.
BOOST_AUTO_TEST_CASE(a_graph_contains_the_tree_if_it_has_its_edges)
{
  const std::vector<Point> points = distinct(random_points(60, 1 << 20, 3));
  const Triangulation tr(points.begin(), points.end());
  std::map<Point, std::size_t> number;
  for (std::size_t i = 0; i < points.size(); ++i)
    number[points[i]] = i;
  std::vector<std::array<std::size_t, 2>> tree, delaunay;
  for (const auto& e : tree_of(tr))
    tree.push_back({number.at(e.first->point()), number.at(e.second->point())});
  for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
    delaunay.push_back({number.at(e->first->vertex(e->second)->point()),
                        number.at(e->first->vertex(e->third)->point())});
  BOOST_TEST(CGAL::contains_euclidean_minimum_spanning_tree(mesh_of(points, tree), tr));
  BOOST_TEST(CGAL::contains_euclidean_minimum_spanning_tree(mesh_of(points, delaunay), tr));
  for (const auto& missing : tree) {
    auto others = delaunay;
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](const auto& e) {
                                  return std::minmax(e[0], e[1]) ==
                                         std::minmax(missing[0], missing[1]);
                                }),
                 others.end());
    BOOST_TEST(others.size() + 1 == delaunay.size());
    BOOST_TEST(!CGAL::contains_euclidean_minimum_spanning_tree(mesh_of(points, others), tr));
  }
}

// Any graph with points, not only one that is a mesh.
BOOST_AUTO_TEST_CASE(a_graph_of_boost_is_asked)
{
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  const std::vector<Point> points = distinct(random_points(40, 1 << 20, 5));
  const Triangulation tr(points.begin(), points.end());
  std::map<Point, std::size_t> number;
  for (std::size_t i = 0; i < points.size(); ++i)
    number[points[i]] = i;
  Graph graph(points.size());
  const auto contains = [&] {
    return CGAL::contains_euclidean_minimum_spanning_tree(
        graph, tr,
        CGAL::parameters::vertex_point_map(boost::make_function_property_map<std::size_t>(
            [&](std::size_t v) -> const Point& { return points[v]; })));
  };
  for (const auto& e : tree_of(tr)) {
    BOOST_TEST(!contains());
    add_edge(number.at(e.first->point()), number.at(e.second->point()), graph);
  }
  BOOST_TEST(contains());
}

// Equal points are one vertex of the triangulation, but two of the forest, which may need another
// edge to join them: F contains the tree of the points 0, 1 and 3, and its forest is no such tree.
BOOST_AUTO_TEST_CASE(the_forest_of_equal_points_is_another)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 0, 0}};
  const Triangulation tr(points.begin(), points.end());
  const Mesh mesh = mesh_of(points, {{0, 1}, {1, 2}, {2, 3}});
  BOOST_TEST(CGAL::contains_euclidean_minimum_spanning_tree(mesh, tr));
  std::vector<Mesh::Edge_index> forest;
  const DFS::Minimum_spanning_forest<Point> find_forest(points);
  find_forest(mesh, get(boost::vertex_index, mesh), std::back_inserter(forest));
  BOOST_TEST(forest.size() == 3u);
}

// On a lattice any connected graph of unit edges contains one of the many trees; one edge of
// another length too many does not matter, one too few does.
BOOST_AUTO_TEST_CASE(ties_are_ties)
{
  const std::vector<Point> points = distinct(grid(4));
  const Triangulation tr(points.begin(), points.end());
  std::mt19937 random(1);
  for (int repetition = 0; repetition < 20; ++repetition) {
    std::vector<std::array<std::size_t, 2>> edges;
    DFS::core::Disjoint_sets<std::size_t> sets(points.size());
    std::size_t pieces = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double length = CGAL::squared_distance(points[i], points[j]);
        if (length == 1 ? random() % 100 < 40u + unsigned(repetition) * 3
                        : length == 2 && random() % 10 == 0) {
          edges.push_back({j, i});
          pieces -= length == 1 && sets.unite(i, j);
        }
      }
    BOOST_TEST(CGAL::contains_euclidean_minimum_spanning_tree(mesh_of(points, edges), tr) ==
               (pieces == 1));
  }
}

BOOST_AUTO_TEST_CASE(points_must_be_the_vertices)
{
  const std::vector<Point> points = distinct(random_points(30, 100, 3));
  const Triangulation tr(points.begin(), points.end());
  const auto contains = [&](const std::vector<Point>& others) {
    return CGAL::contains_euclidean_minimum_spanning_tree(mesh_of(others, {}), tr);
  };
  BOOST_TEST(!contains(points));
  std::vector<Point> others = points;
  others.push_back(points[3]); // a duplicate is no other vertex
  BOOST_TEST(!contains(others));
  others.back() = Point(0.5, 0, 0);
  BOOST_CHECK_THROW(contains(others), CGAL::Surface_input_error);
  others = points;
  others.pop_back();
  BOOST_CHECK_THROW(contains(others), CGAL::Surface_input_error);
  BOOST_TEST(CGAL::contains_euclidean_minimum_spanning_tree(Mesh(), Triangulation()));
}

namespace {

struct Forest_traits : CGAL::Tracing_traits_3
{
  using Surface_subgraph = DFS::Minimum_spanning_forest<Point>;
  explicit Forest_traits(const std::vector<Point>& all)
    : points(all)
  {
  }
  Surface_subgraph surface_subgraph_object() const { return Surface_subgraph(points); }
  const std::vector<Point>& points;
};

} // namespace

BOOST_AUTO_TEST_CASE(the_minimum_spanning_forest_is_traced)
{
  for (const tests::Named_surface& named : tests::ordinary_surfaces(2000)) {
    Triangulation tr;
    CGAL::insert_points_3(tr, named.surface.points, named.surface.faces,
                          Forest_traits(named.surface.points));
    BOOST_TEST((tr == Triangulation(named.surface.points.begin(), named.surface.points.end())));
    const Mesh mesh = surfaces::to_mesh<Mesh>(named.surface);
    std::vector<Mesh::Edge_index> forest;
    DFS::Minimum_spanning_forest<Point>(named.surface.points)(mesh, get(boost::vertex_index, mesh),
                                                              std::back_inserter(forest));
    DFS::core::Disjoint_sets<std::size_t> sets(mesh.number_of_vertices());
    std::size_t pieces = mesh.number_of_vertices();
    for (const auto e : forest)
      pieces -= sets.unite(std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1)));
    BOOST_TEST(pieces == surfaces::number_of_components(named.surface));
    BOOST_TEST(forest.size() == mesh.number_of_vertices() - pieces);
  }
}

// A kite folded along its longer diagonal, under a fifth point: that diagonal is in no empty
// sphere.
BOOST_AUTO_TEST_CASE(shares_by_hand)
{
  const surfaces::Indexed_surface kite = {{{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 5}},
                                          {{0, 1, 2}, {1, 0, 3}}};
  Triangulation tr;
  std::vector<Vertex> vertices;
  for (const Point& p : kite.points)
    vertices.push_back(tr.insert(p));
  const auto share = meters::delaunay_share(tr, vertices, kite.faces);
  BOOST_TEST(share.edges == 5u);
  BOOST_TEST(share.delaunay_edges == 4u);
  BOOST_TEST(share.triangles == 2u);
  BOOST_TEST(share.delaunay_triangles == 0u);
  BOOST_TEST(share.longest_other_edge == 4.);
  BOOST_TEST((std::set<Vertex>{share.ends_of_longest_other_edge.first,
                               share.ends_of_longest_other_edge.second} ==
              std::set<Vertex>{vertices[0], vertices[1]}));

  vertices[4] = Vertex();
  BOOST_CHECK_THROW(meters::delaunay_share(tr, vertices, kite.faces), CGAL::Surface_input_error);
  vertices.resize(3);
  BOOST_CHECK_THROW(meters::delaunay_share(tr, vertices, kite.faces), CGAL::Surface_input_error);
}

BOOST_AUTO_TEST_CASE(shares_of_surfaces)
{
  for (const auto& surfaces : {tests::tiny_and_flat_surfaces(), tests::ordinary_surfaces(2000),
                               tests::degenerate_surfaces(600)})
    for (const tests::Named_surface& named : surfaces)
      BOOST_TEST_CONTEXT(named.name)
      {
        Triangulation tr;
        std::vector<Vertex> vertices;
        for (const Point& p : named.surface.points)
          vertices.push_back(tr.insert(p));
        const auto share = meters::delaunay_share(tr, vertices, named.surface.faces);
        // One by one, by sets of points.
        std::set<std::set<Vertex>> edges, triangles;
        for (const auto& face : named.surface.faces) {
          const std::set<Vertex> corners = {vertices[face[0]], vertices[face[1]],
                                            vertices[face[2]]};
          if (corners.size() == 3)
            triangles.insert(corners);
          for (std::size_t k = 0; k < 3; ++k)
            if (vertices[face[k]] != vertices[face[(k + 1) % 3]])
              edges.insert({vertices[face[k]], vertices[face[(k + 1) % 3]]});
        }
        std::size_t delaunay_edges = 0, delaunay_triangles = 0;
        Triangulation::Cell_handle c;
        int i, j, k;
        for (const auto& e : edges)
          delaunay_edges += tr.dimension() > 0 && tr.is_edge(*e.begin(), *e.rbegin(), c, i, j);
        for (const auto& t : triangles)
          delaunay_triangles += tr.dimension() > 1 && tr.is_facet(*t.begin(), *std::next(t.begin()),
                                                                  *t.rbegin(), c, i, j, k);
        BOOST_TEST(share.edges == edges.size());
        BOOST_TEST(share.triangles == triangles.size());
        BOOST_TEST(share.delaunay_edges == delaunay_edges);
        BOOST_TEST(share.delaunay_triangles == delaunay_triangles);
        BOOST_TEST((share.longest_other_edge > 0) == (delaunay_edges < edges.size()));
        if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(named.surface.faces) ||
            named.surface.faces.empty())
          continue;
        const Mesh mesh = surfaces::to_mesh<Mesh>(named.surface);
        if (mesh.number_of_vertices() != vertices.size())
          continue;
        const auto of_mesh = meters::delaunay_share(
            tr, mesh,
            boost::make_function_property_map<Mesh::Vertex_index>(
                [&](Mesh::Vertex_index v) { return vertices[std::size_t(v)]; }));
        BOOST_TEST(of_mesh.edges == share.edges);
        BOOST_TEST(of_mesh.delaunay_edges == share.delaunay_edges);
        BOOST_TEST(of_mesh.triangles == share.triangles);
        BOOST_TEST(of_mesh.delaunay_triangles == share.delaunay_triangles);
        BOOST_TEST(of_mesh.longest_other_edge == share.longest_other_edge);
      }
}

// A wheel with many spokes takes no quadratic time.
BOOST_AUTO_TEST_CASE(share_of_a_star)
{
  const surfaces::Indexed_surface star = surfaces::star(20000, 1);
  Triangulation tr;
  std::vector<Vertex> vertices(star.points.size());
  CGAL::insert_points_3(
      tr, star.points, star.faces,
      CGAL::parameters::vertex_to_vertex_output_iterator(boost::make_function_output_iterator(
          [&](const auto& pair) { vertices[pair.first] = pair.second; })));
  BOOST_TEST(meters::delaunay_share(tr, vertices, star.faces).edges == 2 * star.points.size() - 3);
}
