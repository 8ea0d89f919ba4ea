// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Certifies a spanning subgraph by means that share nothing with its construction: union-find and counting.
// This header and all it includes need Boost only.

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUBGRAPH_CERTIFY_EDGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUBGRAPH_CERTIFY_EDGES_H

#include <CGAL/Delaunay_from_surface_3/internal/subgraph/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/Surface_component_topology.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is what `certify_spanning_subgraph()` finds out about a set of edges.
*/
struct Spanning_subgraph_certificate
{
  std::size_t number_of_edges = 0;               ///< repeated ones included
  std::size_t number_of_repeated_edges = 0;      ///< edges that are there once before
  std::size_t number_of_graph_components = 0;    ///< isolated vertices included
  std::size_t number_of_subgraph_components = 0; ///< isolated vertices included
  std::size_t number_of_independent_cycles = 0; ///< edges − vertices + components of the subgraph
  std::size_t maximum_degree = 0;               ///< among all vertices
  std::size_t vertex_of_maximum_degree = 0;     ///< its index
  std::vector<std::size_t> number_of_vertices_of_degree; ///< a histogram of the degrees
  std::size_t largest_degree_bound = 0;    ///< the largest of the components' own bounds
  bool respects_degree_bounds = true;      ///< no degree exceeds the bound of its own component
  bool respects_tree_degree_bounds = true; ///< the same with the bounds for trees

  /// returns whether the vertices of every component of the surface are connected by the edges.
  bool is_spanning() const { return number_of_subgraph_components == number_of_graph_components; }

  /// returns whether the edges are a spanning tree of every component.
  bool is_spanning_forest() const { return is_spanning() && number_of_independent_cycles == 0; }

  /// returns whether all holds that `bounded_degree_spanning_subgraph()` promises.
  bool is_valid_subgraph() const
  {
    return is_spanning() && number_of_repeated_edges == 0 && respects_degree_bounds;
  }

  /// returns whether all holds that `bounded_degree_spanning_tree()` promises.
  bool is_valid_tree() const
  {
    return is_spanning_forest() && number_of_repeated_edges == 0 && respects_tree_degree_bounds;
  }
};

namespace internal {

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

inline void certify_degrees(const std::vector<std::size_t>& degree,
                            const Surface_topology& topology, Spanning_subgraph_certificate& result)
{
  for (const Surface_component_topology& component : topology.components)
    result.largest_degree_bound =
        (std::max)(result.largest_degree_bound, component.subgraph_degree_bound());
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] >= result.number_of_vertices_of_degree.size())
      result.number_of_vertices_of_degree.resize(degree[v] + 1, 0);
    ++result.number_of_vertices_of_degree[degree[v]];
    if (degree[v] > result.maximum_degree) {
      result.maximum_degree = degree[v];
      result.vertex_of_maximum_degree = v;
    }
    const std::size_t c = topology.component_of_vertex[v];
    if (c == topology.components.size())
      continue;
    if (degree[v] > topology.components[c].subgraph_degree_bound())
      result.respects_degree_bounds = false;
    if (degree[v] > topology.components[c].tree_degree_bound())
      result.respects_tree_degree_bounds = false;
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds out whether edges of a triangulated surface span it, with what degrees, and whether the degrees keep within the bounds that follow from the
surface's own Euler characteristic.

This form needs Boost only; include `CGAL/Delaunay_from_surface_3/internal/subgraph/Certify_edges.h`.

\param graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`
\param subgraph_edges a range of edge descriptors of `graph`
\param topology what `Delaunay_from_surface_3::surface_topology()` says of `graph`
\param vertex_index_map a bijection onto `0`, …, `num_vertices(graph) - 1`

Complexity: O(m log m) for m edges.
*/
template <class Graph, class EdgeRange, class VertexIndexMap>
Delaunay_from_surface_3::Spanning_subgraph_certificate
certify_spanning_subgraph(const Graph& graph, const EdgeRange& subgraph_edges,
                          const Delaunay_from_surface_3::Surface_topology& topology,
                          VertexIndexMap vertex_index_map)
{
  namespace internal = Delaunay_from_surface_3::internal;
  const std::size_t n = topology.component_of_vertex.size();
  Delaunay_from_surface_3::Spanning_subgraph_certificate result;
  const auto end_points = [&](const auto& e) {
    return std::pair<std::size_t, std::size_t>(
        std::minmax({std::size_t(get(vertex_index_map, source(e, graph))),
                     std::size_t(get(vertex_index_map, target(e, graph)))}));
  };

  internal::Component_count of_graph(n), of_subgraph(n);
  const auto all_edges = edges(graph);
  for (auto e = all_edges.first; e != all_edges.second; ++e)
    of_graph.join(end_points(*e).first, end_points(*e).second);

  std::vector<std::size_t> degree(n, 0);
  std::vector<std::pair<std::size_t, std::size_t>> sorted;
  for (const auto& e : subgraph_edges) {
    sorted.push_back(end_points(e));
    of_subgraph.join(sorted.back().first, sorted.back().second);
    ++degree[sorted.back().first];
    ++degree[sorted.back().second];
  }
  std::sort(sorted.begin(), sorted.end());
  result.number_of_edges = sorted.size();
  result.number_of_repeated_edges =
      std::size_t(std::distance(std::unique(sorted.begin(), sorted.end()), sorted.end()));
  result.number_of_graph_components = of_graph();
  result.number_of_subgraph_components = of_subgraph();
  result.number_of_independent_cycles = result.number_of_edges + of_subgraph() - n;
  internal::certify_degrees(degree, topology, result);
  return result;
}

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUBGRAPH_CERTIFY_EDGES_H
