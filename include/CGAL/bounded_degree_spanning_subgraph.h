// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H
#define CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_marks.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning subgraph of bounded degree of a triangulated surface of any genus,
with or without boundary, orientable or not, with one component or several.

The degree of every vertex is at most
- 3 on a component that is a sphere or a disc,
- 8g on a closed component of genus g > 0,
- 8g + 2b + 1 on a component of genus g with b > 0 boundary loops;

where 2g stands for the non-orientable genus if the component is not orientable.

On each component the subgraph contains the graph along which it was cut open (see
`Delaunay_from_surface_3::cut_graph()`) and the boundary, or the triangle by which a sphere was
opened. The rest is attached to these as trees.

The algorithm is that of \cgalCite{choi-dtsm-02}, §3.2, with corrections that the manual explains
(\ref bds_disc, \ref bds_proof_subgraph).

<b>Complexity</b>: time linear in the size of the surface, without recursion. With about three edges
per vertex, at most about 40 bytes of memory per vertex are used besides the surface.

\tparam Reader determined by `surface_of()`
\tparam EdgeOutputIterator a model of `OutputIterator` that accepts
`Triangulated_surface<Reader>::%edge_descriptor`

\param surface the surface, from `surface_of()`
\param out receives the edges of the subgraph, each once, in no particular order

\return the output iterator past the last edge written

\throws Surface_input_error as described for `surface_of()`

Example: \ref Delaunay_from_surface_3/spanning_subgraph.cpp
*/
template <class Reader, class EdgeOutputIterator>
EdgeOutputIterator bounded_degree_spanning_subgraph(
    const Delaunay_from_surface_3::Triangulated_surface<Reader>& surface, EdgeOutputIterator out)
{
  namespace internal = Delaunay_from_surface_3::internal;
  return internal::write_bounded_degree_subgraph(surface.reader(),
                                                 internal::Subgraph_kind::SUBGRAPH, out);
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning tree of bounded degree of every component of a triangulated surface. It
is the subgraph of `bounded_degree_spanning_subgraph()` without the edges that close cycles; these are
removed preferably at vertices of large degree (\ref bds_tree).

The degree of every vertex is at most max(3, 6g + 2b) on a component of genus g with b boundary
loops, where 2g stands for the non-orientable genus if the component is not orientable; on the
projective plane it is at most 4.

The parameters, the return value and the exceptions are those of
`bounded_degree_spanning_subgraph()`.

<b>Complexity</b>: nearly linear time, \f$O(n \alpha(n))\f$ for n vertices and edges.

Example: \ref Delaunay_from_surface_3/spanning_subgraph_of_moebius_band.cpp
*/
template <class Reader, class EdgeOutputIterator>
EdgeOutputIterator
bounded_degree_spanning_tree(const Delaunay_from_surface_3::Triangulated_surface<Reader>& surface,
                             EdgeOutputIterator out)
{
  namespace internal = Delaunay_from_surface_3::internal;
  return internal::write_bounded_degree_subgraph(surface.reader(), internal::Subgraph_kind::TREE,
                                                 out);
}

} // namespace CGAL

#endif // CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H
