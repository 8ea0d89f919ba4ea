// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_TREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_TREES_H

// The subgraph T as a list of edges, and what can be done to it so that the theorems no longer hold. And
// how far the assumptions of Choi 2002 hold: T and F in D(S), and §3.1: EMST(S) in F.

#include <Delaunay_from_surface_3_meters/delaunay_share.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_spanning_forest.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/squared_distance_3.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace theory {

using surfaces::Indexed_surface;
using Edge = std::array<std::size_t, 2>; // the smaller number first
using Edges = std::vector<Edge>;
using Index_graph = CGAL::Delaunay_from_surface_3::internal::Index_graph;

inline Edge edge(std::size_t u, std::size_t v)
{
  return {(std::min)(u, v), (std::max)(u, v)};
}

// The edges of the surface F, each once, sorted.
inline Edges edges_of(const Indexed_surface& surface)
{
  Edges edges;
  for (const auto& face : surface.faces)
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back(edge(face[k], face[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// T as the paper has it: a spanning subgraph of bounded degree.
inline Edges bounded_degree_edges(const Indexed_surface& surface)
{
  using Mesh = CGAL::Surface_mesh<Indexed_surface::Point_3>;
  const Mesh mesh = surfaces::to_mesh<Mesh>(surface);
  Edges edges;
  CGAL::Delaunay_from_surface_3::Bounded_degree_subgraph()(
      mesh, get(boost::vertex_index, mesh),
      boost::make_function_output_iterator([&](Mesh::Edge_index e) {
        edges.push_back(edge(std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1))));
      }));
  return edges;
}

// The graph in which vertex v has the number numbers[v].
inline Index_graph graph_of(const Edges& edges, const std::vector<std::size_t>& numbers)
{
  std::vector<std::pair<std::size_t, std::size_t>> darts;
  for (const Edge& e : edges) {
    darts.emplace_back(numbers[e[0]], numbers[e[1]]);
    darts.emplace_back(numbers[e[1]], numbers[e[0]]);
  }
  return Index_graph(boost::edges_are_unsorted_multi_pass, darts.begin(), darts.end(),
                     numbers.size());
}

// The minimum spanning forest of F.
inline Edges minimum_spanning_forest(const Indexed_surface& surface)
{
  const Edges all = edges_of(surface);
  std::vector<std::size_t> numbers(surface.points.size());
  for (std::size_t v = 0; v < numbers.size(); ++v)
    numbers[v] = v;
  const Index_graph graph = graph_of(all, numbers);
  Edges forest;
  CGAL::Delaunay_from_surface_3::Minimum_spanning_forest<Indexed_surface::Point_3>(surface.points)(
      graph, get(boost::vertex_index, graph),
      boost::make_function_output_iterator(
          [&](const auto& e) { forest.push_back(edge(source(e, graph), target(e, graph))); }));
  return forest;
}

// A spanning tree of the graph with edges in random order: T is still a subset of F.
inline Edges random_spanning_tree(const Edges& graph, std::size_t n, std::uint64_t seed)
{
  CGAL::Delaunay_from_surface_3::internal::Disjoint_sets<std::size_t> trees(n);
  Edges tree;
  for (const std::size_t k : surfaces::Random(seed).permutation(graph.size()))
    if (trees.unite(graph[k][0], graph[k][1]))
      tree.push_back(graph[k]);
  return tree;
}

// A depth-first tree of a connected graph, rooted at vertex 0.
struct Rooted_tree
{
  std::vector<std::size_t> order;  // parents come first
  std::vector<std::size_t> parent; // of the root: the root
  std::vector<std::size_t> depth;
};

inline Rooted_tree depth_first_tree(const Edges& edges, std::size_t n)
{
  std::vector<std::size_t> numbers(n);
  for (std::size_t v = 0; v < n; ++v)
    numbers[v] = v;
  const Index_graph graph = graph_of(edges, numbers);
  Rooted_tree tree = {{}, std::vector<std::size_t>(n, n), std::vector<std::size_t>(n, 0)};
  std::vector<Edge> stack = {{0, 0}}; // a vertex and its parent
  while (!stack.empty()) {
    const auto [v, parent] = stack.back();
    stack.pop_back();
    if (tree.parent[v] != n)
      continue;
    tree.order.push_back(v);
    tree.parent[v] = parent;
    tree.depth[v] = v == parent ? 0 : tree.depth[parent] + 1;
    for (auto [u, end] = adjacent_vertices(v, graph); u != end; ++u)
      if (tree.parent[*u] == n)
        stack.push_back({*u, v});
  }
  return tree;
}

// T as if it had been made for a surface with a k-th of the points: of the vertices on a way
// through T every k-th is kept, and the others hang on the last one kept before them.
inline Edges decimated(const Rooted_tree& tree, std::size_t k)
{
  Edges edges;
  std::vector<std::size_t> kept(tree.parent.size(), 0); // the last one kept, perhaps v itself
  for (const std::size_t v : tree.order) {
    if (tree.depth[v] > 0)
      edges.push_back(edge(v, kept[tree.parent[v]]));
    kept[v] = tree.depth[v] % k == 0 ? v : kept[tree.parent[v]];
  }
  return edges;
}

// The tree with a share of its edges replaced by edges to any vertex that comes before.
inline Edges with_random_edges(const Rooted_tree& tree, double share, std::uint64_t seed)
{
  surfaces::Random random(seed);
  Edges edges;
  for (std::size_t k = 1; k < tree.order.size(); ++k) {
    const std::size_t v = tree.order[k];
    const bool is_replaced = random.uniform(0, 1) < share;
    edges.push_back(edge(v, is_replaced ? tree.order[random.below(k)] : tree.parent[v]));
  }
  return edges;
}

// The share of true answers; 1 if nothing is asked.
template <class Items, class Predicate>
double fraction(const Items& items, const Predicate& is_it)
{
  const auto number = std::count_if(items.begin(), items.end(), is_it);
  return items.empty() ? 1. : double(number) / double(items.size());
}

// The finite edges of a triangulation between its vertices, which are numbered by `vertices`,
// sorted. Of points that coincide the last stands for all.
template <class Triangulation>
Edges delaunay_edges(const Triangulation& tr,
                     const std::vector<typename Triangulation::Vertex_handle>& vertices)
{
  CGAL::Unique_hash_map<typename Triangulation::Vertex_handle, std::size_t> number;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    number[vertices[v]] = v;
  Edges edges;
  for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
    edges.push_back(edge(number[e->first->vertex(e->second)], number[e->first->vertex(e->third)]));
  std::sort(edges.begin(), edges.end());
  return edges;
}

inline bool contains(const Edges& sorted, const Edge& e)
{
  return std::binary_search(sorted.begin(), sorted.end(), e);
}

// The share of the triangles of a surface that are facets of the triangulation.
template <class Triangulation>
double delaunay_triangles(const Triangulation& tr,
                          const std::vector<typename Triangulation::Vertex_handle>& vertices,
                          const std::vector<Indexed_surface::Face>& faces)
{
  const auto share = meters::delaunay_share(tr, vertices, faces);
  return share.triangles == 0 ? 1. : double(share.delaunay_triangles) / double(share.triangles);
}

// The Euclidean minimum spanning tree, by Kruskal over the Delaunay edges (§3.1); sorted. Of edges
// of the same length those that are `preferred`, a sorted list, come first.
template <class Point>
Edges euclidean_minimum_spanning_tree(const std::vector<Point>& points, const Edges& delaunay,
                                      const Edges& preferred)
{
  std::vector<std::tuple<double, bool, Edge>> by_length;
  for (const Edge& e : delaunay)
    by_length.emplace_back(CGAL::to_double(CGAL::squared_distance(points[e[0]], points[e[1]])),
                           !contains(preferred, e), e);
  std::sort(by_length.begin(), by_length.end());
  CGAL::Delaunay_from_surface_3::internal::Disjoint_sets<std::size_t> trees(points.size());
  Edges tree;
  for (const auto& [length, is_other, e] : by_length)
    if (trees.unite(e[0], e[1]))
      tree.push_back(e);
  std::sort(tree.begin(), tree.end());
  return tree;
}

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_TREES_H
