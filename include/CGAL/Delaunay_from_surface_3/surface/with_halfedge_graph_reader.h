// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WITH_HALFEDGE_GRAPH_READER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WITH_HALFEDGE_GRAPH_READER_H

// Named parameters to reader: the one thing that the public forms for halfedge graphs have in
// common.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Halfedge_graph_reader.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class HalfedgeGraph, class NamedParameters, class Function>
auto with_halfedge_graph_reader(const HalfedgeGraph& g, const NamedParameters& np,
                                const Function& function)
{
  const auto vertex_index_map = get_initialized_vertex_index_map(g, np);
  using Vertex_index_map = std::decay_t<decltype(vertex_index_map)>;
  return function(Halfedge_graph_reader<HalfedgeGraph, Vertex_index_map>(g, vertex_index_map));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WITH_HALFEDGE_GRAPH_READER_H
