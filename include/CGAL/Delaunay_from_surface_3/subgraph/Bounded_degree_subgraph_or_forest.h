// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_BOUNDED_DEGREE_SUBGRAPH_OR_FOREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_BOUNDED_DEGREE_SUBGRAPH_OR_FOREST_H

// A spanning subgraph T for whatever comes: of bounded degree where Choi 2002, §3.2 applies, else a forest.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Spanning_forest.h>

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of `Bounded_degree_subgraph` where `graph` is a simple triangulated surface, and those of
`Spanning_forest`, whose degree has no bound, where it is not.

O(m α(n)) for m edges.

\cgalModels{SurfaceSubgraph}
*/
class Bounded_degree_subgraph_or_forest
{
public:
  /*!
  writes edges of `graph` that span every component and are connected there.

  \tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`. Only a model of `HalfedgeListGraph` and
  `FaceListGraph` can be recognised as a surface.
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  \tparam EdgeOutputIterator accepts edge descriptors of `graph`
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    std::string why_forest;
    return (*this)(graph, index_map, out, why_forest);
  }

  /// does the same, and says in `why_forest` why it is a forest; that is left empty if it is not one.
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out, std::string& why_forest) const
  {
    why_forest.clear();
    if constexpr (has_halfedges<Graph>(0)) {
      try {
        return Bounded_degree_subgraph()(graph, index_map, out);
      } catch (const Surface_input_error& e) { // nothing has been written
        why_forest = e.what();
      }
    } else
      why_forest = "a graph without faces";
    return Spanning_forest()(graph, index_map, out);
  }

private:
  template <class Graph, class = typename boost::graph_traits<Graph>::halfedge_descriptor,
            class = typename boost::graph_traits<Graph>::face_descriptor>
  static constexpr bool has_halfedges(int)
  {
    return true;
  }
  template <class Graph>
  static constexpr bool has_halfedges(...)
  {
    return false;
  }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_BOUNDED_DEGREE_SUBGRAPH_OR_FOREST_H
