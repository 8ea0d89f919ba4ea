// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H
#define CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Triangulated_surface.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_bounded_degree_subgraph.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning subgraph of bounded degree of a triangulated surface of any genus,
with or without boundary, orientable or not, with one component or several.

The degree of every vertex is at most
- 3 on a component that is a sphere or a disc,
- 8g on a closed component of genus g > 0,
- 8g + 2b + 1 on a component of genus g with b > 0 boundary loops;

where the component is not orientable, 2g is its non-orientable genus.

On each component the subgraph contains the graph along which it was cut open (see
`Delaunay_from_surface_3::cut_graph()`) and the boundary, or the triangle by which a sphere was
opened; the rest hangs on these as trees.

\tparam Reader what `surface_of()` says
\tparam EdgeOutputIterator a model of `OutputIterator` that holds
`Triangulated_surface<Reader>::%edge_descriptor`

\param surface the surface, from `surface_of()`
\param out where the subgraph's edges go, each once, in no particular order

\return the output iterator

\throws Surface_input_error as `surface_of()` says

Complexity: time linear in the size of the surface, without recursion, and at most about 40 bytes of
memory per vertex besides it, where there are about three edges per vertex.

The algorithm is that of \cgalCite{choi-dtsm-02}, Section 3.2, with the corrections given on
the page \ref delaunay_from_surface_3_the_paper.
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

writes the edges of a spanning tree of bounded degree of every component of a triangulated surface:
the subgraph of `bounded_degree_spanning_subgraph()`, from which cycles have been dropped at the
heaviest vertices.

The degree of every vertex is at most max(3, 6g + 2b) on a component of genus g with b boundary
loops, where 2g is the non-orientable genus if it is not orientable; and 4 on the projective plane.

The parameters and exceptions are those of `bounded_degree_spanning_subgraph()`.
Complexity: nearly linear time, \f$O(n \alpha(n))\f$ for n vertices and edges.
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
