// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H
#define CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H

#include <CGAL/Delaunay_from_surface_3/surface/Minimum_degree_witness.h>
#include <CGAL/Delaunay_from_surface_3/surface/Triangulated_surface.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_near_minimum_degree_tree.h>

#include <CGAL/assertions.h>
#include <CGAL/iterator.h>

#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning tree of every component of a triangulated surface whose largest degree
is 3, or at most one more than that of any spanning tree of the component.

On a sphere or a disc it is at most 3. On a closed component with Euler characteristic χ it is at
most the largest of \f$3 + \lfloor (c(x) - 3) / x \rfloor\f$ over all \f$x \ge 3\f$, where
\f$c(x) = \min(\lfloor x (x - 1) / 3 \rfloor, 2 x - 2 \chi)\f$: that is
\f$\sqrt{4 g / 3} + O(1)\f$ for genus g, 4 on a torus, and 5 for g = 2. With b boundary loops
\f$x (x + 1)\f$ stands in the place of \f$x (x - 1)\f$. The certificate of
`certify_spanning_subgraph()` says whether the bound is kept.

It is the tree of `bounded_degree_spanning_tree()`, of which edges are exchanged as long as its
largest degree is 4 or more and an exchange of \cgalCite{fr-amdst-94} makes a vertex of this degree
lighter.

\tparam WitnessOutputIterator a model of `OutputIterator` that holds
`Delaunay_from_surface_3::Minimum_degree_witness`

\param surface the surface, from `surface_of()`
\param out where the edges of the trees go, each once, in no particular order
\param witnesses gets, for every component whose tree has a vertex of degree 4 or more, a set of
vertices that shows what degree every spanning tree of it must have: its
`Minimum_degree_witness::least_degree()` is the tree's degree or one less

\return the output iterator `out`

\throws Surface_input_error as `surface_of()` says

Complexity: that of `bounded_degree_spanning_tree()` if its tree has no vertex of degree 4; else
nearly linear time for the exchanges near heavy vertices and for each phase of the general search.
Exchanges and phases that succeed are at most \f$n \ln K\f$, with K the largest degree of that tree;
how many there are in practice is in \ref bds_near_minimum.

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
