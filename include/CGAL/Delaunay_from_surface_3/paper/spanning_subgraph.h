// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/order/soup_edges.h>
#include <CGAL/Delaunay_from_surface_3/paper/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/shortest_edges_first.h>

#include <CGAL/iterator.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A graph on the indices of the points. Every edge is stored in both directions, so that
// adjacent_vertices() gives all neighbours.
using Index_graph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::size_t, std::size_t>;

// Runs the functor `subgraph` on `graph` and keeps the edges it writes as a graph on indices, in
// which vertex v has the number `numbers[index_map[v]]`. O(n + m).
template <class SurfaceSubgraph, class Graph, class VertexIndexMap>
Index_graph index_graph(const SurfaceSubgraph& subgraph, const Graph& graph,
                        VertexIndexMap index_map, const std::vector<std::size_t>& numbers)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(6 * numbers.size()); // a triangulated surface has three edges per vertex
  const auto keep = [&](const typename boost::graph_traits<Graph>::edge_descriptor& e) {
    const std::size_t s = numbers[std::size_t(get(index_map, source(e, graph)))];
    const std::size_t t = numbers[std::size_t(get(index_map, target(e, graph)))];
    edges.emplace_back(s, t);
    edges.emplace_back(t, s);
  };
  subgraph(graph, index_map, boost::make_function_output_iterator(keep));
  return Index_graph(boost::edges_are_unsorted_multi_pass, edges.begin(), edges.end(),
                     numbers.size());
}

// The neighbours of each of the n vertices of a graph that have smaller numbers. Its number of
// edges must have 32 bits.
template <class Graph, class VertexIndexMap>
Lists<std::uint32_t> lower_neighbors(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  using Index = std::uint32_t;
  std::vector<Large_vector<Numbered_edge>> numbered(1);
  numbered[0].reserve(std::size_t(num_edges(graph)));
  const auto range = edges(graph);
  for (auto e = range.first; e != range.second; ++e)
    numbered[0].emplace_back(Index(get(index_map, source(*e, graph))),
                             Index(get(index_map, target(*e, graph))));
  return lower_neighbors(numbered, n);
}

// The edges of a caller's graph.
template <class Graph, class VertexIndexMap>
class Edges_of_graph final : public Edge_source
{
public:
  // On n vertices. Keeps a reference.
  Edges_of_graph(const Graph& graph, VertexIndexMap index_map, std::size_t n)
    : m_graph(graph)
    , m_index_map(index_map)
    , m_number_of_vertices(n)
  {
  }

  Lists_view<std::uint32_t> edges() override
  {
    if constexpr (std::is_base_of<Lower_neighbor_graph, Graph>::value) {
      return m_graph.lists(); // which stay the caller's
    } else {
      constexpr std::size_t too_many = (std::numeric_limits<std::uint32_t>::max)();
      const std::size_t m = std::size_t(num_edges(m_graph));
      if (m_lower.first.empty() && m > 0 && (std::max)(m_number_of_vertices, m) < too_many)
        m_lower = lower_neighbors(m_graph, m_index_map, m_number_of_vertices);
      return m_lower;
    }
  }
  void give_up() override { m_lower = Lists<std::uint32_t>(); }

private:
  const Graph& m_graph;
  VertexIndexMap m_index_map;
  std::size_t m_number_of_vertices;
  Lists<std::uint32_t> m_lower; // none if there are no edges
};

// T, made by the functor of the traits. If the functor needs more than the graph has, such as
// faces, or refuses the surface by a Surface_input_error, a spanning forest is used, and the
// visitor is told why.
template <class SurfaceSubgraph, class Graph, class VertexIndexMap, class Visitor>
Index_graph spanning_subgraph(const SurfaceSubgraph& subgraph, const Graph& graph,
                              VertexIndexMap index_map, const std::vector<std::size_t>& numbers,
                              Visitor& visitor)
{
  if constexpr (std::is_invocable<const SurfaceSubgraph&, const Graph&, VertexIndexMap,
                                  Emptyset_iterator>::value) {
    try {
      return index_graph(subgraph, graph, index_map, numbers);
    } catch (const Surface_input_error& refusal) {
      visitor.subgraph_is_replaced(refusal.what());
    }
  } else {
    visitor.subgraph_is_replaced(
        "the subgraph needs a surface with faces, which a plain graph is not");
  }
  return index_graph(Spanning_forest(), graph, index_map, numbers);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H
