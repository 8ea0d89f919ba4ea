// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_CERTIFY_SPANNING_SUBGRAPH_H
#define CGAL_CERTIFY_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Spanning_subgraph_certificate.h>
#include <CGAL/Delaunay_from_surface_3/surface/certify_edges.h>
#include <CGAL/Delaunay_from_surface_3/surface/Triangulated_surface.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_rotation_system.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds out whether edges of a triangulated surface span it, with what degrees, and whether the
degrees keep within the bounds that follow from the surface's own Euler characteristic. It shares
nothing with the construction of `bounded_degree_spanning_subgraph()` but the reading of the
surface, and serves for any set of its edges.

\tparam Reader what `surface_of()` says
\tparam EdgeRange a range of `Triangulated_surface<Reader>::%edge_descriptor`

\param surface the surface, from `surface_of()`
\param subgraph_edges the edges to look at

\throws Surface_input_error as `surface_of()` says, and if two indices of a soup are no edge of it

Complexity: linear time for the surface, and \f$O(m \log m)\f$ for m edges of the subgraph.

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
