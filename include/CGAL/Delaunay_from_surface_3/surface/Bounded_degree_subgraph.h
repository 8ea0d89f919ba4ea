// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_SUBGRAPH_H

// Offers the spanning subgraph T of bounded degree that Choi 2002, §3.2 asks for.

#include <CGAL/Delaunay_from_surface_3/surface/Face_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Reduce_degrees.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns the reader for a mesh, or for the graph that insert_points_3() makes of a soup.
template <class Graph, class VertexIndexMap,
          class = typename boost::graph_traits<Graph>::halfedge_descriptor>
Halfedge_graph_reader<Graph, VertexIndexMap> reader_of(const Graph& graph, VertexIndexMap index_map)
{
  return {graph, index_map};
}

template <class GraphOfFaces, class VertexIndexMap>
auto reader_of(const GraphOfFaces& graph, VertexIndexMap)
    -> Face_reader<std::decay_t<decltype(graph.faces_of_soup())>>
{
  return {graph.faces_of_soup(), graph.number_of_vertices()};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of `bounded_degree_spanning_subgraph()`, whose degree is at most 3 on spheres and
discs, and elsewhere satisfies a bound that depends on genus and boundary. Alternatively, it writes
the edges of one of the two trees, which have a smaller degree and take longer to find. To choose
one, derive a traits class from `Surface_insertion_policies_3` with its own
`surface_subgraph_object()`.

\cgalModels{SurfaceSubgraph}
*/
class Bounded_degree_subgraph
{
public:
  /// the subgraphs to choose from.
  enum Kind {
    SUBGRAPH,         ///< `bounded_degree_spanning_subgraph()`: linear time
    TREE,             ///< `bounded_degree_spanning_tree()`: nearly linear time
    NEAR_MINIMUM_TREE ///< `near_minimum_degree_spanning_tree()`
  };

  /// chooses the subgraph.
  explicit Bounded_degree_subgraph(Kind kind = SUBGRAPH)
    : m_kind(kind)
  {
  }

  /*!
  writes edges of `graph` that form a connected spanning subgraph of every component.

  \tparam Graph a model of `HalfedgeListGraph` and `FaceListGraph`, or the graph that
  `insert_points_3()` makes of a polygon soup. The cyclic order of the edges at each vertex is then
  derived from the faces, which may have any orientations.
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  \tparam EdgeOutputIterator accepts edge descriptors of `graph`

  \return the output iterator past the last edge written

  \throws Surface_input_error if `graph` is not a simple triangulated surface. The message names a
  vertex or an edge. Nothing has been written then.
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  auto operator()(const Graph& graph, VertexIndexMap index_map, EdgeOutputIterator out) const
      -> decltype(static_cast<void>(internal::reader_of(graph, index_map)), EdgeOutputIterator(out))
  {
    const auto reader = internal::reader_of(graph, index_map);
    if (m_kind == NEAR_MINIMUM_TREE) {
      std::vector<Minimum_degree_witness> not_asked_for;
      return internal::write_near_minimum_degree_tree(reader, out, not_asked_for);
    }
    using internal::Subgraph_kind;
    return internal::write_bounded_degree_subgraph(
        reader, m_kind == TREE ? Subgraph_kind::TREE : Subgraph_kind::SUBGRAPH, out);
  }

private:
  Kind m_kind;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_SUBGRAPH_H
