// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H
#define CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Embedding_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_bounded_degree_subgraph.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning subgraph of bounded degree of a triangulated surface of any genus,
with or without boundary, with one component or several.

The degree of every vertex is at most
- 3 on a component that is a sphere or a disc,
- 8g on a closed component of genus g > 0,
- 8g + 2b + 1 on a component of genus g with b > 0 boundary loops.

On each component the subgraph contains the graph along which it was cut open (see
`Delaunay_from_surface_3::cut_graph()`) and the boundary, or the triangle by which a sphere was
opened; the rest hangs on these as trees.

\tparam HalfedgeGraph a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam EdgeOutputIterator a model of `OutputIterator` that holds
`boost::graph_traits<HalfedgeGraph>::%edge_descriptor`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param g the surface
\param out where the subgraph's edges go, each once, in no particular order
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{the indices of the n vertices of `g`: 0, …, n-1. Those of a `Surface_mesh`
    with removed vertices have gaps, and are refused; `collect_garbage()` closes them}
    \cgalParamType{a class model of `ReadablePropertyMap` with
    `boost::graph_traits<HalfedgeGraph>::%vertex_descriptor` as key type and an integer type as
    value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre All faces of `g` are triangles, `g` is simple (no loops and no two edges with the same ends; a
valid halfedge graph can have such), and no vertex is pinched. Isolated vertices are allowed.

\return the output iterator

\throws Surface_input_error that names a vertex or an edge, if a precondition is violated or the
indices are not 0, …, n-1. Nothing has been written then.

Complexity: time linear in the size of `g`, without recursion, and at most about 40 bytes of memory
per vertex besides `g`, where there are about three edges per vertex.

The algorithm is that of \cgalCite{choi-dtsm-02}, Section 3.2, with the corrections given in the
user manual.
*/
template <class HalfedgeGraph, class EdgeOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
EdgeOutputIterator
bounded_degree_spanning_subgraph(const HalfedgeGraph& g, EdgeOutputIterator out,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Delaunay_from_surface_3::internal;
  return internal::with_halfedge_graph_reader(g, np, [&](const auto& reader) {
    return internal::write_bounded_degree_subgraph(reader, internal::Subgraph_kind::SUBGRAPH, out);
  });
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning tree of bounded degree of every component of a triangulated surface:
the subgraph of `bounded_degree_spanning_subgraph()`, from which cycles have been dropped at the
heaviest vertices.

The degree of every vertex is at most max(3, 6g + 2b) on a component of genus g with b boundary
loops.

The parameters, preconditions and exceptions are those of `bounded_degree_spanning_subgraph()`.
Complexity: nearly linear time, \f$O(n \alpha(n))\f$ for n vertices and edges.
*/
template <class HalfedgeGraph, class EdgeOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
EdgeOutputIterator
bounded_degree_spanning_tree(const HalfedgeGraph& g, EdgeOutputIterator out,
                             const NamedParameters& np = parameters::default_values())
{
  namespace internal = Delaunay_from_surface_3::internal;
  return internal::with_halfedge_graph_reader(g, np, [&](const auto& reader) {
    return internal::write_bounded_degree_subgraph(reader, internal::Subgraph_kind::TREE, out);
  });
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning subgraph of bounded degree of a triangulated surface that is given as
a graph with the cyclic order of the edges around every vertex. Each component of the surface may be
closed or have boundary, and be orientable or not.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`, undirected
\tparam Embedding a model of `boost::ReadablePropertyMap` whose key type is the vertex descriptor
and whose value type is a range of edge descriptors
\tparam EdgeOutputIterator a model of `OutputIterator` that holds edge descriptors
\tparam VertexIndexMap a model of `boost::ReadablePropertyMap` from vertex descriptors to integers
\tparam EdgeIsBoundaryMap a model of `boost::ReadablePropertyMap` from edge descriptors to `bool`

\param graph the surface's vertices and edges
\param embedding for every vertex its edges in cyclic order, in either direction: the lists of two
vertices need not agree in direction, which is how a Möbius band is written down. The list of a
vertex on the boundary starts and ends with its two boundary edges.
\param out where the subgraph's edges go, each once, in no particular order
\param vertex_index_map a bijection onto `0`, …, `num_vertices(graph) - 1`
\param edge_is_boundary_map whether an edge has a triangle on one side only

\pre The graph is simple: no loops and no two edges with the same ends. The far ends of two edges
that follow each other in a list are joined by an edge, and the three lists of a triangle agree. An
isolated vertex, with an empty list, is allowed.

\return the output iterator

\throws Surface_input_error that names a vertex or an edge, if a precondition is violated. Nothing
has been written then.

The degree is at most 3 on spheres and discs. On a component with Euler characteristic
χ = 2 − h − b and b boundary loops (h is twice the genus if it is orientable, else the
non-orientable genus) it is at most 4h if b = 0 and 4h + 2b + 1 otherwise.

Complexity: linear time; for the check of the lists the sum over the edges of the smaller degree of
the two ends, which is linear for bounded genus. At most about 40 bytes of memory per vertex. Edges
are not paired and need no index: in a simple graph two ends name the edge, and where the surface is
cut its edges are paired by bucket, in time linear in the cut.

The algorithm is that of \cgalCite{choi-dtsm-02}, Section 3.2, with the corrections given in the
user manual.
*/
template <class Graph, class Embedding, class EdgeOutputIterator, class VertexIndexMap,
          class EdgeIsBoundaryMap>
EdgeOutputIterator bounded_degree_spanning_subgraph(const Graph& graph, Embedding embedding,
                                                    EdgeOutputIterator out,
                                                    VertexIndexMap vertex_index_map,
                                                    EdgeIsBoundaryMap edge_is_boundary_map)
{
  namespace internal = Delaunay_from_surface_3::internal;
  using Reader = internal::Embedding_reader<Graph, Embedding, VertexIndexMap, EdgeIsBoundaryMap>;
  return internal::write_bounded_degree_subgraph(
      Reader(graph, embedding, vertex_index_map, edge_is_boundary_map),
      internal::Subgraph_kind::SUBGRAPH, out);
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes a spanning tree of `bounded_degree_spanning_subgraph()`, one per component: its cycles are
dropped at the heaviest vertices.

The parameters, preconditions and exceptions are those of
`bounded_degree_spanning_subgraph()` for an embedded graph. The degree is at most max(3, 3h + 2b),
and 4 on the projective plane.

Complexity: nearly linear time, \f$O(n \alpha(n))\f$ for n vertices and edges, and the check of the
lists.
*/
template <class Graph, class Embedding, class EdgeOutputIterator, class VertexIndexMap,
          class EdgeIsBoundaryMap>
EdgeOutputIterator bounded_degree_spanning_tree(const Graph& graph, Embedding embedding,
                                                EdgeOutputIterator out,
                                                VertexIndexMap vertex_index_map,
                                                EdgeIsBoundaryMap edge_is_boundary_map)
{
  namespace internal = Delaunay_from_surface_3::internal;
  using Reader = internal::Embedding_reader<Graph, Embedding, VertexIndexMap, EdgeIsBoundaryMap>;
  return internal::write_bounded_degree_subgraph(
      Reader(graph, embedding, vertex_index_map, edge_is_boundary_map),
      internal::Subgraph_kind::TREE, out);
}

} // namespace CGAL

#endif // CGAL_BOUNDED_DEGREE_SPANNING_SUBGRAPH_H
