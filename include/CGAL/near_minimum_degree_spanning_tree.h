// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H
#define CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H

#include <CGAL/Delaunay_from_surface_3/surface/Reduce_degrees.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <CGAL/assertions.h>
#include <CGAL/iterator.h>

#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning tree of every component of a triangulated surface. The largest degree
of the tree is 3, or at most one more than that of any spanning tree of the component.

On a sphere or a disc it is at most 3. On any other closed component with Euler characteristic χ it
is at most the largest of \f$3 + \lfloor (c(x) - 3) / x \rfloor\f$ over all \f$x \ge 3\f$, where
\f$c(x) = \min(\lfloor x (x - 1) / 3 \rfloor, 2 x - 2 \chi)\f$. This is
\f$\sqrt{4 g / 3} + O(1)\f$ for genus g, 4 on a torus, and 5 for g = 2. With boundary,
\f$x (x + 1)\f$ replaces \f$x (x - 1)\f$ (\ref bds_near_minimum "proof"). It is smaller if the
component is k-connected for a k above 3: \f$\sqrt{4 g / (k (k - 2))} + O(1)\f$, and 3 on a torus
(\ref bds_connected). `Delaunay_from_surface_3::Surface_component_topology` has the bound, and the
certificate of `certify_spanning_subgraph()` says whether it is satisfied.

The algorithm starts from the tree of `bounded_degree_spanning_tree()`. While the largest degree is
4 or more and an exchange of edges (\cgalCite{fr-amdst-94}) makes a vertex of this degree lighter,
it makes this exchange.

<b>Complexity</b>: that of `bounded_degree_spanning_tree()` if its tree has no vertex of degree 4 or
more; otherwise, in addition, nearly linear time for each pass around the heaviest vertices, which
tries exchanges near them, and for each phase of the general search. A pass goes on around a vertex
where the last one ended, so all passes together take nearly linear time as a rule; this is not
proved. At most \f$n \ln K\f$ exchanges and phases succeed, where K is the largest degree of the
first tree; \ref bds_near_minimum "the manual" says how many there are in practice.

\tparam Reader determined by `surface_of()`
\tparam EdgeOutputIterator a model of `OutputIterator` that accepts
`Triangulated_surface<Reader>::%edge_descriptor`
\tparam WitnessOutputIterator a model of `OutputIterator` that accepts
`Delaunay_from_surface_3::Minimum_degree_witness`

\param surface the surface, from `surface_of()`
\param out receives the edges of the trees, each once, in no particular order
\param witnesses receives, for every component whose tree has a vertex of degree 4 or more, a set of
vertices that proves a lower bound on the degree of every spanning tree of the component:
`Minimum_degree_witness::least_degree()` is the tree's degree or one less

\return the output iterator `out` past the last edge written

\throws Surface_input_error as described for `surface_of()`

Example: \ref Delaunay_from_surface_3/spanning_subgraph.cpp
*/
template <class Reader, class EdgeOutputIterator, class WitnessOutputIterator = Emptyset_iterator>
EdgeOutputIterator near_minimum_degree_spanning_tree(
    const Delaunay_from_surface_3::Triangulated_surface<Reader>& surface, EdgeOutputIterator out,
    WitnessOutputIterator witnesses = WitnessOutputIterator())
{
  std::vector<Delaunay_from_surface_3::Minimum_degree_witness> found;
  out = Delaunay_from_surface_3::internal::write_near_minimum_degree_tree(surface.reader(), out,
                                                                          found);
  for (auto& witness : found) {
    CGAL_postcondition(witness.is_within_one());
    *witnesses++ = std::move(witness);
  }
  return out;
}

} // namespace CGAL

#endif // CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H
