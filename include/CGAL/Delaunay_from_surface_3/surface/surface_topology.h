// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H

#include <CGAL/Delaunay_from_surface_3/surface/Embedding_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Find_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/Surface_component_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_halfedge_graph_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_rotation_system.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds the components of a triangulated surface, and of each its Euler characteristic, genus and
boundary loops.

The parameters, preconditions and exceptions are those of `bounded_degree_spanning_subgraph()`.
Complexity: linear time.
*/
template <class HalfedgeGraph, class NamedParameters = parameters::Default_named_parameters>
Surface_topology surface_topology(const HalfedgeGraph& g,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::with_halfedge_graph_reader(g, np, [](const auto& reader) {
    return internal::with_rotation_system(reader, [](auto& surface) {
      using Index = typename std::decay_t<decltype(surface)>::Index;
      return internal::Find_topology<Index>(surface)();
    });
  });
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds the components of a triangulated surface that is given as a graph with the cyclic order of the
edges around every vertex, and of each its Euler characteristic, boundary loops and orientability.

The parameters, preconditions, exceptions and complexity are those of
`bounded_degree_spanning_subgraph()` for an embedded graph.
*/
template <class Graph, class Embedding, class VertexIndexMap, class EdgeIsBoundaryMap>
Surface_topology surface_topology(const Graph& graph, Embedding embedding,
                                  VertexIndexMap vertex_index_map,
                                  EdgeIsBoundaryMap edge_is_boundary_map)
{
  using Reader = internal::Embedding_reader<Graph, Embedding, VertexIndexMap, EdgeIsBoundaryMap>;
  return internal::with_rotation_system(
      Reader(graph, embedding, vertex_index_map, edge_is_boundary_map), [](auto& surface) {
        using Index = typename std::decay_t<decltype(surface)>::Index;
        return internal::Find_topology<Index>(surface)();
      });
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H
