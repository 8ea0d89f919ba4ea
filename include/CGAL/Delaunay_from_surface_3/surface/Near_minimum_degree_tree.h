// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NEAR_MINIMUM_DEGREE_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NEAR_MINIMUM_DEGREE_TREE_H

// A spanning tree of nearly minimum degree as the T of Choi 2002, §3.2.

#include <CGAL/Delaunay_from_surface_3/surface/Face_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_near_minimum_degree_tree.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of `near_minimum_degree_spanning_tree()`: degree at most 3 on spheres and discs,
and elsewhere at most one more than that of any spanning tree.

\cgalModels{SurfaceSubgraph}
*/
class Near_minimum_degree_tree
{
public:
  /// writes edges of `graph` that are a spanning tree of every component. As
  /// `Bounded_degree_subgraph::operator()()`.
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator,
            class = typename boost::graph_traits<Graph>::halfedge_descriptor>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    std::vector<Minimum_degree_witness> witnesses;
    return internal::write_near_minimum_degree_tree(
        internal::Halfedge_graph_reader<Graph, VertexIndexMap>(graph, index_map), out, witnesses);
  }

  /// does the same for the graph that `insert_points_3()` makes of a polygon soup.
  template <class GraphOfFaces, class VertexIndexMap, class EdgeOutputIterator>
  auto operator()(const GraphOfFaces& graph, VertexIndexMap, EdgeOutputIterator out) const
      -> decltype(static_cast<void>(graph.faces_of_soup()), EdgeOutputIterator(out))
  {
    std::vector<Minimum_degree_witness> witnesses;
    return internal::write_near_minimum_degree_tree(
        internal::Face_reader<std::decay_t<decltype(graph.faces_of_soup())>>(
            graph.faces_of_soup(), graph.number_of_vertices()),
        out, witnesses);
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NEAR_MINIMUM_DEGREE_TREE_H
