// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CUT_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CUT_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Triangulated_surface.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_bounded_degree_subgraph.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a cut graph of a triangulated surface. Removing them and the boundary leaves one
open disc of each component that is not a sphere. On a sphere or a disc nothing is written. Boundary
edges are never written.

The cut graph is pruned: no vertex inside the surface has exactly one of its edges. On a component
with Euler characteristic χ that is not a sphere, the degrees in the union of cut graph and boundary
satisfy Σ(deg − 2) = 2(1 − χ). So on a closed surface of genus g > 0 the cut graph has degree at
most 4g.

The parameters, the return value and the exceptions are those of
`bounded_degree_spanning_subgraph()`.

<b>Complexity</b>: linear time, for any genus.
*/
template <class Reader, class EdgeOutputIterator>
EdgeOutputIterator cut_graph(const Triangulated_surface<Reader>& surface, EdgeOutputIterator out)
{
  return internal::write_cut_graph(surface.reader(), out);
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CUT_GRAPH_H
