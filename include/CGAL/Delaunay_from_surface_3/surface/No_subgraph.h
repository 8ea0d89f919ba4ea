// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H

// Offers subgraphs that need no faces. Full_graph takes T = F. Choi 2002, §3.1: "Some surface meshes
// already have bounded degree", such as isosurfaces. The degree of Spanning_forest has no bound, as
// Choi 2002, §3 asks for; so the trace is correct, but its cost is not proved.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes no edge. It is for hint policies that trace nothing, such as `Planned_hints_3` and
`Previous_hint_3`.

\cgalModels{SurfaceSubgraph}
*/
class No_subgraph
{
public:
  /// returns `out`.
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph&, VertexIndexMap, EdgeOutputIterator out) const
  {
    return out;
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes all edges: the surface is its own spanning subgraph. The degree is that of the surface.

<b>Complexity</b>: \f$O(m)\f$ for m edges.

\cgalModels{SurfaceSubgraph}
*/
class Full_graph
{
public:
  /*!
  writes all edges of `graph`.

  \tparam Graph a model of `boost::EdgeListGraph`
  \tparam VertexIndexMap is not used
  \tparam EdgeOutputIterator accepts edge descriptors of `Graph`

  \return the output iterator past the last edge written
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap, EdgeOutputIterator out) const
  {
    for (auto [e, end] = edges(graph); e != end; ++e)
      *out++ = *e;
    return out;
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning forest, one tree per connected component: every edge that joins two
components of the edges before it. It works for every graph; the degree is not bounded.

<b>Complexity</b>: \f$O(n + m \alpha(n))\f$ time for n vertices and m edges, and two integers of
memory per vertex.

\cgalModels{SurfaceSubgraph}
*/
class Spanning_forest
{
public:
  /*!
  writes edges of `graph` that span it without a cycle.

  \tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  \tparam EdgeOutputIterator accepts edge descriptors of `Graph`

  \param graph the surface
  \param index_map maps the vertices of `graph` to their indices
  \param out receives the edges

  \return the output iterator past the last edge written
  \throws Surface_input_error if an edge leads to a vertex that was removed
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    const std::size_t n = number_of_vertices(graph);
    internal::Disjoint_sets<std::size_t> trees(n);
    for (auto [e, end] = edges(graph); e != end; ++e)
      if (trees.unite(internal::index_of_end(index_map, source(*e, graph), n),
                      internal::index_of_end(index_map, target(*e, graph), n)))
        *out++ = *e;
    return out;
  }

private:
  // Counts the vertices: num_vertices() is only an upper bound where a mesh has removed elements.
  template <class Graph>
  static std::size_t number_of_vertices(const Graph& graph)
  {
    const auto range = vertices(graph);
    return std::size_t(std::distance(range.first, range.second));
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H
