// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CERTIFY_EDGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CERTIFY_EDGES_H

// Certifies a spanning subgraph by means that share nothing with its construction: union-find and
// counting.

#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Counts the components of n vertices under edges that are added one by one.
class Component_count
{
public:
  explicit Component_count(std::size_t n)
    : m_sets(n)
    , m_count(n)
  {
  }

  void join(std::size_t v, std::size_t w) { m_count -= m_sets.unite(v, w); }

  std::size_t operator()() const { return m_count; }

private:
  Disjoint_sets<std::size_t> m_sets;
  std::size_t m_count;
};

// Holds the bounds of one component. Each is computed once: the last takes O(sqrt(g)) for genus g.
struct Degree_bounds
{
  explicit Degree_bounds(const Surface_component_topology& component)
    : subgraph(component.subgraph_degree_bound())
    , tree(component.tree_degree_bound())
    , near_minimum_tree(component.near_minimum_tree_degree_bound())
  {
  }

  std::size_t subgraph, tree, near_minimum_tree;
};

inline void certify_degrees(const std::vector<std::size_t>& degree,
                            const Surface_topology& topology, Spanning_subgraph_certificate& result)
{
  const std::vector<Degree_bounds> bounds(topology.components.begin(), topology.components.end());
  for (const Degree_bounds& of_component : bounds)
    result.largest_degree_bound = (std::max)(result.largest_degree_bound, of_component.subgraph);
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] >= result.number_of_vertices_of_degree.size())
      result.number_of_vertices_of_degree.resize(degree[v] + 1, 0);
    ++result.number_of_vertices_of_degree[degree[v]];
    if (degree[v] > result.maximum_degree) {
      result.maximum_degree = degree[v];
      result.vertex_of_maximum_degree = v;
    }
    const std::size_t c = topology.component_of_vertex[v];
    if (c == bounds.size())
      continue;
    if (degree[v] > bounds[c].subgraph)
      result.respects_degree_bounds = false;
    if (degree[v] > bounds[c].tree)
      result.respects_tree_degree_bounds = false;
    if (degree[v] > bounds[c].near_minimum_tree)
      result.respects_near_minimum_tree_degree_bounds = false;
  }
}

template <class Index>
bool is_edge(const Rotation_system<Index>& surface, std::size_t v, std::size_t w)
{
  const std::size_t n = surface.number_of_vertices();
  if (v >= n || w >= n)
    return false;
  if (surface.degree(Index(w)) < surface.degree(Index(v)))
    std::swap(v, w);
  const Star<Index> star = surface.star(Index(v));
  return std::find(star.begin(), star.end(), Index(w)) != star.end();
}

template <class Reader, class Index, class EdgeRange>
Spanning_subgraph_certificate certify_edges(const Reader& reader,
                                            const Rotation_system<Index>& surface,
                                            const EdgeRange& subgraph_edges)
{
  const Surface_topology topology = Find_topology<Index>(surface)();
  const std::size_t n = surface.number_of_vertices();
  Spanning_subgraph_certificate result;
  Component_count of_subgraph(n);
  std::vector<std::size_t> degree(n, 0);
  std::vector<std::pair<std::size_t, std::size_t>> sorted;
  for (const auto& e : subgraph_edges) {
    const auto [v, w] = reader.ends(e);
    if (!is_edge(surface, v, w))
      refuse(edge_name(v, w) + " is not in the surface");
    sorted.push_back(std::minmax(v, w));
    of_subgraph.join(v, w);
    ++degree[v];
    ++degree[w];
  }
  std::sort(sorted.begin(), sorted.end());
  result.number_of_edges = sorted.size();
  result.number_of_repeated_edges =
      std::size_t(std::distance(std::unique(sorted.begin(), sorted.end()), sorted.end()));
  result.number_of_graph_components =
      topology.components.size() + topology.number_of_isolated_vertices;
  result.number_of_subgraph_components = of_subgraph();
  result.number_of_independent_cycles = result.number_of_edges + of_subgraph() - n;
  certify_degrees(degree, topology, result);
  return result;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CERTIFY_EDGES_H
