// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H
#define CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H

#include <CGAL/Delaunay_from_surface_3/surface/Embedding_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_degree_witness.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_near_minimum_degree_tree.h>

#include <CGAL/assertions.h>

#include <algorithm>
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

\param g the surface
\param out where the edges of the trees go, each once, in no particular order
\param witnesses gets, for every component whose tree has a vertex of degree 4 or more, a set of
vertices that shows what degree every spanning tree of it must have: its
`Minimum_degree_witness::least_degree()` is the tree's degree or one less
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_index_map`,
as for `bounded_degree_spanning_subgraph()`

The preconditions and exceptions are those of `bounded_degree_spanning_subgraph()`.

Complexity: that of `bounded_degree_spanning_tree()` if its tree has no vertex of degree 4; else
nearly linear time for the exchanges near heavy vertices and for each phase of the general search.
Exchanges and phases that succeed are at most \f$n \ln K\f$, with K the largest degree of that tree;
how many there are in practice is in the user manual.
*/
template <class HalfedgeGraph, class EdgeOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
EdgeOutputIterator near_minimum_degree_spanning_tree(
    const HalfedgeGraph& g, EdgeOutputIterator out,
    std::vector<Delaunay_from_surface_3::Minimum_degree_witness>& witnesses,
    const NamedParameters& np = parameters::default_values())
{
  namespace internal = Delaunay_from_surface_3::internal;
  out = internal::with_halfedge_graph_reader(g, np, [&](const auto& reader) {
    return internal::write_near_minimum_degree_tree(reader, out, witnesses);
  });
  CGAL_postcondition(std::all_of(witnesses.begin(), witnesses.end(),
                                 [](const auto& witness) { return witness.is_within_one(); }));
  return out;
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

does the same without witnesses.
*/
template <class HalfedgeGraph, class EdgeOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
EdgeOutputIterator
near_minimum_degree_spanning_tree(const HalfedgeGraph& g, EdgeOutputIterator out,
                                  const NamedParameters& np = parameters::default_values())
{
  std::vector<Delaunay_from_surface_3::Minimum_degree_witness> witnesses;
  return near_minimum_degree_spanning_tree(g, out, witnesses, np);
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

does the same for a triangulated surface that is given as a graph with the cyclic order of the edges
around every vertex, orientable or not.

The parameters, preconditions and exceptions are those of `bounded_degree_spanning_subgraph()` for
an embedded graph, and `witnesses` as above.
*/
template <class Graph, class Embedding, class EdgeOutputIterator, class VertexIndexMap,
          class EdgeIsBoundaryMap>
EdgeOutputIterator near_minimum_degree_spanning_tree(
    const Graph& graph, Embedding embedding, EdgeOutputIterator out,
    VertexIndexMap vertex_index_map, EdgeIsBoundaryMap edge_is_boundary_map,
    std::vector<Delaunay_from_surface_3::Minimum_degree_witness>& witnesses)
{
  namespace internal = Delaunay_from_surface_3::internal;
  using Reader = internal::Embedding_reader<Graph, Embedding, VertexIndexMap, EdgeIsBoundaryMap>;
  out = internal::write_near_minimum_degree_tree(
      Reader(graph, embedding, vertex_index_map, edge_is_boundary_map), out, witnesses);
  CGAL_postcondition(std::all_of(witnesses.begin(), witnesses.end(),
                                 [](const auto& witness) { return witness.is_within_one(); }));
  return out;
}

} // namespace CGAL

#endif // CGAL_NEAR_MINIMUM_DEGREE_SPANNING_TREE_H
