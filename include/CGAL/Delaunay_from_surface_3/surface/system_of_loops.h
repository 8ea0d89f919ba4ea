// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SYSTEM_OF_LOOPS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SYSTEM_OF_LOOPS_H

#include <CGAL/Delaunay_from_surface_3/surface/with_halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_system_of_loops.h>

#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes a system of loops of a closed triangulated surface: on every component of genus g > 0 these
are 2g closed walks through one base vertex such that the component without them is an open disc.

\cgalCite{choi-dtsm-02} cuts along 2g cycles too, found by the algorithm of \cgalCite{l-ps-01}. This is
not that algorithm: the loops are those of a tree and a cotree. They are here for comparison. Each
loop follows a breadth-first tree from the base vertex, crosses over one edge and follows the tree
back; loops share the parts of the tree that lie near the base.

\tparam LoopOutputIterator a model of `OutputIterator` that holds
`std::vector<boost::graph_traits<HalfedgeGraph>::%edge_descriptor>`: the edges of a loop in order,
starting and ending at the base vertex. An edge that a loop passes in both directions is there
twice.

The other parameters, preconditions and exceptions are those of
`bounded_degree_spanning_subgraph()`.
\pre `g` is closed.
Complexity: linear time plus the length of the loops, \f$O(g n)\f$; some 120 bytes per vertex.
*/
template <class HalfedgeGraph, class LoopOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
LoopOutputIterator system_of_loops(const HalfedgeGraph& g, LoopOutputIterator out,
                                   const NamedParameters& np = parameters::default_values())
{
  using Edge = typename boost::graph_traits<HalfedgeGraph>::edge_descriptor;
  return internal::with_halfedge_graph_reader(g, np, [&](const auto& reader) {
    return internal::write_system_of_loops<Edge>(reader, out);
  });
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SYSTEM_OF_LOOPS_H
