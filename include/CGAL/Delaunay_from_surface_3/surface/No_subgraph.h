// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H

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

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_NO_SUBGRAPH_H
