// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_FRACTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_FRACTIONS_H

// How far the assumptions of Choi 2002 hold: T and F in D(S), and §3.1: EMST(S) in F.

#include <Delaunay_from_surface_3_theory/trees.h>

#include <Delaunay_from_surface_3_meters/delaunay_share.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace theory {

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_FRACTIONS_H
