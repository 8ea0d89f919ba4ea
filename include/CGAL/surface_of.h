// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SURFACE_OF_H
#define CGAL_SURFACE_OF_H

#include <CGAL/Delaunay_from_surface_3/surface/Embedding_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Face_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

wraps a mesh as the surface argument of the functions on subgraphs. This function checks nothing:
the exceptions described here are thrown by those functions. The mesh must not be modified until
these have been called.

\tparam HalfedgeGraph a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param g the surface. It must outlive the object returned, as must whatever property maps refer to.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{maps the n vertices of `g` onto 0, …, n-1, one to one. The indices of a
    `Surface_mesh` with removed vertices have gaps, and are refused; `collect_garbage()` closes the
    gaps.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
    `boost::graph_traits<HalfedgeGraph>::%vertex_descriptor` as key type and an integer type as
    value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return an object that refers to `g`

\pre All faces of `g` are triangles, `g` is simple (it has no loops and no two edges with the same
ends, which a valid halfedge graph can have), and no vertex is pinched. Isolated vertices are
allowed.

\throws Surface_input_error if a precondition is violated or the indices are not 0, …, n-1. The
message names a vertex or an edge. Nothing has been written then.

Example: \ref Delaunay_from_surface_3/spanning_subgraph.cpp
*/
template <class HalfedgeGraph, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto surface_of(const HalfedgeGraph& g, const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace DFS = Delaunay_from_surface_3;
  const auto index_map = [&] {
    // CGAL's helper asserts that a map which is given is a numbering: here it is refused by name.
    if constexpr (parameters::is_default_parameter<CGAL_NP_CLASS,
                                                   internal_np::vertex_index_t>::value)
      return get_initialized_vertex_index_map(g);
    else
      return parameters::get_parameter(np, internal_np::vertex_index);
  }();
  using Index_map = std::decay_t<decltype(index_map)>;
  using Reader = DFS::internal::Halfedge_graph_reader<HalfedgeGraph, Index_map>;
  return DFS::Triangulated_surface<Reader>(Reader(g, index_map));
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

wraps a graph, with the cyclic order of the edges around every vertex, as the surface argument of
the functions on subgraphs. Each component may be closed or have boundary, and may be orientable or
not. Edges are the edge descriptors of the graph.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`, undirected
\tparam Embedding a model of `boost::ReadablePropertyMap` from vertex descriptors to ranges of edge
descriptors
\tparam VertexIndexMap a model of `boost::ReadablePropertyMap` from vertex descriptors to integers
\tparam EdgeIsBoundaryMap a model of `boost::ReadablePropertyMap` from edge descriptors to `bool`

\param graph the vertices and edges of the surface. It must outlive the object returned.
\param embedding maps every vertex to the list of its edges: each edge once, in cyclic order, and in
either direction. The lists of two vertices need not agree in direction; this is how a Möbius band
can be described. The list of a vertex on the boundary starts and ends with its two boundary edges.
An `iterator_property_map` over a vector of vectors of edge descriptors will do.
\param vertex_index_map maps the vertices onto 0, …, `num_vertices(graph)` - 1, one to one
\param edge_is_boundary_map says whether an edge has a triangle on one side only

\return an object that refers to `graph`

\pre The graph is simple: it has no loops and no two edges with the same ends. The far ends of two
edges that follow each other in a list are joined by an edge, and the three lists of a triangle
agree. Isolated vertices, with empty lists, are allowed.

\throws Surface_input_error as for a mesh

<b>Complexity</b>: reading the lists takes linear time. Checking that they agree takes the sum over
the edges of the smaller degree of the two ends, which is linear for bounded genus. Edges need no
index: in a simple graph the two ends identify the edge.

Example: \ref Delaunay_from_surface_3/spanning_subgraph_of_moebius_band.cpp
*/
template <class Graph, class Embedding, class VertexIndexMap, class EdgeIsBoundaryMap>
auto surface_of(const Graph& graph, Embedding embedding, VertexIndexMap vertex_index_map,
                EdgeIsBoundaryMap edge_is_boundary_map)
{
  namespace DFS = Delaunay_from_surface_3;
  using Reader =
      DFS::internal::Embedding_reader<Graph, Embedding, VertexIndexMap, EdgeIsBoundaryMap>;
  return DFS::Triangulated_surface<Reader>(
      Reader(graph, embedding, vertex_index_map, edge_is_boundary_map));
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

wraps the triangles of a soup as the surface argument of the functions on subgraphs. The triangles
may have any orientations. An edge is a pair of indices.

\tparam FaceRange a range of ranges of three integers, the indices of vertices

\param number_of_vertices the number of vertices; all indices are less than this
\param faces the triangles. The range must outlive the object returned.

\return an object that refers to `faces`

\pre All indices are in range, no edge has more than two triangles, no triangle has a vertex twice,
and no vertex is pinched.

\throws Surface_input_error as for a mesh; the message names a face or a vertex
*/
template <class FaceRange>
auto surface_of(std::size_t number_of_vertices, const FaceRange& faces)
{
  namespace DFS = Delaunay_from_surface_3;
  using Reader = DFS::internal::Face_reader<FaceRange>;
  return DFS::Triangulated_surface<Reader>(Reader(faces, number_of_vertices));
}

} // namespace CGAL

#endif // CGAL_SURFACE_OF_H
