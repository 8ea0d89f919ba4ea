// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_CERTIFY_SPANNING_SUBGRAPH_H
#define CGAL_CERTIFY_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/surface/Spanning_subgraph_certificate.h>
#include <CGAL/Delaunay_from_surface_3/surface/certify_edges.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds out whether edges of a triangulated surface span it, with what degrees, and whether the
degrees keep within the bounds that follow from the surface's own Euler characteristic.

\param graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`
\param subgraph_edges a range of edge descriptors of `graph`
\param topology what `Delaunay_from_surface_3::surface_topology()` says of `graph`
\param vertex_index_map a bijection onto `0`, …, `num_vertices(graph) - 1`

Complexity: \f$O(m \log m)\f$ for m edges.
*/
template <class Graph, class EdgeRange, class VertexIndexMap>
Delaunay_from_surface_3::Spanning_subgraph_certificate
certify_spanning_subgraph(const Graph& graph, const EdgeRange& subgraph_edges,
                          const Delaunay_from_surface_3::Surface_topology& topology,
                          VertexIndexMap vertex_index_map)
{
  return Delaunay_from_surface_3::internal::certify_edges(graph, subgraph_edges, topology,
                                                          vertex_index_map);
}

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds out whether edges of a triangulated surface span it, with what degrees, and whether the
degrees keep within the bounds that follow from the surface's own Euler characteristic. It shares
nothing with the construction of `bounded_degree_spanning_subgraph()` but the reading of the
surface, and serves for any set of edges.

\tparam EdgeRange a range of `boost::graph_traits<HalfedgeGraph>::%edge_descriptor`

\param g the surface
\param subgraph_edges the edges to look at
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_index_map`,
as for `bounded_degree_spanning_subgraph()`

The preconditions and exceptions are those of `bounded_degree_spanning_subgraph()`.
Complexity: \f$O(n \log n)\f$.
*/
template <class HalfedgeGraph, class EdgeRange,
          class NamedParameters = parameters::Default_named_parameters>
Delaunay_from_surface_3::Spanning_subgraph_certificate
certify_spanning_subgraph(const HalfedgeGraph& g, const EdgeRange& subgraph_edges,
                          const NamedParameters& np = parameters::default_values())
{
  return certify_spanning_subgraph(g, subgraph_edges,
                                   Delaunay_from_surface_3::surface_topology(g, np),
                                   get_initialized_vertex_index_map(g, np));
}

} // namespace CGAL

#endif // CGAL_CERTIFY_SPANNING_SUBGRAPH_H
