// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INDEX_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INDEX_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INDEX_GRAPH_H
