// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>

#include <CGAL/iterator.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Represents a graph on the indices of the points. Every edge is stored in both directions, so that
// adjacent_vertices() returns all neighbours.
using Index_graph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::size_t, std::size_t>;

// Runs the functor `subgraph` on `graph` and keeps the edges it writes as a graph on indices, in
// which vertex v has the number `numbers[index_map[v]]`. Takes O(n + m).
template <class SurfaceSubgraph, class Graph, class VertexIndexMap>
Index_graph index_graph(const SurfaceSubgraph& subgraph, const Graph& graph,
                        VertexIndexMap index_map, const std::vector<std::size_t>& numbers)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(6 * numbers.size()); // a triangulated surface has three edges per vertex
  const auto keep = [&](const typename boost::graph_traits<Graph>::edge_descriptor& e) {
    const std::size_t s = numbers[index_of_end(index_map, source(e, graph), numbers.size())];
    const std::size_t t = numbers[index_of_end(index_map, target(e, graph), numbers.size())];
    edges.emplace_back(s, t);
    edges.emplace_back(t, s);
  };
  subgraph(graph, index_map, boost::make_function_output_iterator(keep));
  return Index_graph(boost::edges_are_unsorted_multi_pass, edges.begin(), edges.end(),
                     numbers.size());
}

// Makes T by the functor of the traits. If the functor needs more than the graph has, such as
// faces, or refuses the surface by a Surface_input_error, a spanning forest is used, and the
// visitor is told why.
template <class SurfaceSubgraph, class Graph, class VertexIndexMap, class Observer>
Index_graph spanning_subgraph(const SurfaceSubgraph& subgraph, const Graph& graph,
                              VertexIndexMap index_map, const std::vector<std::size_t>& numbers,
                              Observer& observer)
{
  if constexpr (std::is_invocable<const SurfaceSubgraph&, const Graph&, VertexIndexMap,
                                  Emptyset_iterator>::value) {
    try {
      return index_graph(subgraph, graph, index_map, numbers);
    } catch (const Surface_input_error& refusal) {
      observer.notice(Surface_insertion_notice::SUBGRAPH_IS_REPLACED, refusal.what());
    }
  } else {
    observer.notice(Surface_insertion_notice::SUBGRAPH_IS_REPLACED,
                    "the subgraph needs a surface with faces, which a plain graph is not");
  }
  return index_graph(Spanning_forest(), graph, index_map, numbers);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H
