// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_SUBGRAPH_H

// A spanning subgraph T of bounded degree, as Choi 2002, §3.2 asks for.

#include <CGAL/Delaunay_from_surface_3/surface/Face_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_bounded_degree_subgraph.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of `bounded_degree_spanning_subgraph()`: degree at most 3 on spheres and discs, and
a bound that depends on the genus and the boundary elsewhere.

Linear: \f$O(n + m)\f$ for n vertices and m edges.

\cgalModels{SurfaceSubgraph}
*/
class Bounded_degree_subgraph
{
public:
  /*!
  writes edges of `graph` that span every component and are connected there.

  \tparam Graph a model of `HalfedgeListGraph` and `FaceListGraph`
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  \tparam EdgeOutputIterator accepts edge descriptors of `graph`

  \throws Surface_input_error that names a vertex or an edge, if `graph` is not a simple
  triangulated surface. Nothing has been written then.
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator,
            class = typename boost::graph_traits<Graph>::halfedge_descriptor>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    return internal::write_bounded_degree_subgraph(
        internal::Halfedge_graph_reader<Graph, VertexIndexMap>(graph, index_map),
        internal::Subgraph_kind::SUBGRAPH, out);
  }

  /// does the same for the graph that `insert_points_3()` makes of a polygon soup: the
  /// cyclic order of the edges at each vertex is read from the faces, which may be oriented at
  /// random.
  template <class GraphOfFaces, class VertexIndexMap, class EdgeOutputIterator>
  auto operator()(const GraphOfFaces& graph, VertexIndexMap, EdgeOutputIterator out) const
      -> decltype(static_cast<void>(graph.faces_of_soup()), EdgeOutputIterator(out))
  {
    return internal::write_bounded_degree_subgraph(
        internal::Face_reader<std::decay_t<decltype(graph.faces_of_soup())>>(
            graph.faces_of_soup(), graph.number_of_vertices()),
        internal::Subgraph_kind::SUBGRAPH, out);
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of `bounded_degree_spanning_tree()`: as `Bounded_degree_subgraph`, without cycles.

Nearly linear: \f$O(n \alpha(n))\f$ for n vertices and edges.

\cgalModels{SurfaceSubgraph}
*/
class Bounded_degree_tree
{
public:
  /// writes edges of `graph` that are a spanning tree of every component. As
  /// `Bounded_degree_subgraph::operator()()`.
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator,
            class = typename boost::graph_traits<Graph>::halfedge_descriptor>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    return internal::write_bounded_degree_subgraph(
        internal::Halfedge_graph_reader<Graph, VertexIndexMap>(graph, index_map),
        internal::Subgraph_kind::TREE, out);
  }

  /// does the same for the graph that `insert_points_3()` makes of a polygon soup.
  template <class GraphOfFaces, class VertexIndexMap, class EdgeOutputIterator>
  auto operator()(const GraphOfFaces& graph, VertexIndexMap, EdgeOutputIterator out) const
      -> decltype(static_cast<void>(graph.faces_of_soup()), EdgeOutputIterator(out))
  {
    return internal::write_bounded_degree_subgraph(
        internal::Face_reader<std::decay_t<decltype(graph.faces_of_soup())>>(
            graph.faces_of_soup(), graph.number_of_vertices()),
        internal::Subgraph_kind::TREE, out);
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_SUBGRAPH_H
