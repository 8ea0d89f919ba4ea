// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_CERTIFY_SPANNING_SUBGRAPH_H
#define CGAL_CERTIFY_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

checks whether a set of edges of a triangulated surface spans it, computes the degrees, and checks
whether these satisfy the bounds that follow from Euler characteristic and connectivity, as found by
`Delaunay_from_surface_3::surface_topology()`. It accepts any set of edges. With the construction of
`bounded_degree_spanning_subgraph()` it shares only the code that reads the surface.

<b>Complexity</b>: that of `Delaunay_from_surface_3::surface_topology()`, \f$O(m \log m)\f$ for m
edges of the subgraph, and for each of these the smaller degree of its ends in the surface.

\tparam Reader determined by `surface_of()`
\tparam EdgeRange a range of `Triangulated_surface<Reader>::%edge_descriptor`

\param surface the surface, from `surface_of()`
\param subgraph_edges the edges to check

\return what was found

\throws Surface_input_error as described for `surface_of()`, and if an edge is not one of the
surface

Example: \ref Delaunay_from_surface_3/spanning_subgraph.cpp
*/
template <class Reader, class EdgeRange>
Delaunay_from_surface_3::Spanning_subgraph_certificate
certify_spanning_subgraph(const Delaunay_from_surface_3::Triangulated_surface<Reader>& surface,
                          const EdgeRange& subgraph_edges)
{
  namespace internal = Delaunay_from_surface_3::internal;
  return internal::with_rotation_system(surface.reader(), [&](const auto& rotations) {
    return internal::certify_edges(surface.reader(), rotations, subgraph_edges);
  });
}

} // namespace CGAL

#endif // CGAL_CERTIFY_SPANNING_SUBGRAPH_H
