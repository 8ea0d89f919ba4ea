// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SURFACE_OF_H
#define CGAL_SURFACE_OF_H

#include <CGAL/Delaunay_from_surface_3/surface/Embedding_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Face_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Triangulated_surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

returns a mesh as the surface that the functions on subgraphs take. Nothing is checked yet: what is
said here of exceptions is said of these functions. The mesh stays as it is until they have been
called.

\tparam HalfedgeGraph a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param g the surface, which must live as long as what is returned, as what property maps refer to
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

\throws Surface_input_error that names a vertex or an edge, if a precondition is violated or the
indices are not 0, …, n-1. Nothing has been written then.

Example: \ref Delaunay_from_surface_3/spanning_subgraph.cpp
*/
template <class HalfedgeGraph, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto surface_of(const HalfedgeGraph& g, const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace DFS = Delaunay_from_surface_3;
  const auto index_map = get_initialized_vertex_index_map(g, np);
  using Index_map = std::decay_t<decltype(index_map)>;
  using Reader = DFS::internal::Halfedge_graph_reader<HalfedgeGraph, Index_map>;
  return DFS::Triangulated_surface<Reader>(Reader(g, index_map));
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

returns a graph with the cyclic order of the edges around every vertex as the surface that the
functions on subgraphs take. Each component may be closed or have boundary, and be orientable or
not. An edge is what the graph calls it.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`, undirected
\tparam Embedding a model of `SurfaceEmbedding`
\tparam VertexIndexMap a model of `boost::ReadablePropertyMap` from vertex descriptors to integers
\tparam EdgeIsBoundaryMap a model of `boost::ReadablePropertyMap` from edge descriptors to `bool`

\param graph the surface's vertices and edges, which must live as long as what is returned
\param embedding for every vertex its edges in cyclic order
\param vertex_index_map a bijection onto 0, …, `num_vertices(graph)` - 1
\param edge_is_boundary_map whether an edge has a triangle on one side only

\pre The graph is simple: no loops and no two edges with the same ends. The far ends of two edges
that follow each other in a list are joined by an edge, and the three lists of a triangle agree. An
isolated vertex, with an empty list, is allowed.

\throws Surface_input_error as for a mesh. To read the lists takes linear time, and to check that
they agree the sum over the edges of the smaller degree of the two ends, which is linear for bounded
genus. Edges need no index: in a simple graph two ends name the edge.

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

returns the triangles of a soup as the surface that the functions on subgraphs take. They may be
oriented at random, and an edge is a pair of indices.

\tparam FaceRange a range of ranges of three integers, the indices of vertices

\param number_of_vertices the indices are less than this
\param faces the triangles, which must live as long as what is returned

\pre The indices are those of vertices, no edge has more than two triangles, no triangle has a
vertex twice, and no vertex is pinched.

\throws Surface_input_error as for a mesh, of a face or a vertex
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
