// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H

// Full_graph takes T = F. Choi 2002, §3.1: "Some surface meshes already have bounded degree", such
// as isosurfaces.

#include <boost/graph/graph_traits.hpp>

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

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H
