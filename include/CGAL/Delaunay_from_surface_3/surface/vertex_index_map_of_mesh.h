// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_VERTEX_INDEX_MAP_OF_MESH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_VERTEX_INDEX_MAP_OF_MESH_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// CGAL's helper is used only where no map is given: it asserts that a map is a bijection onto
// 0 .. n-1, and what is none shall be refused by name.
template <class FaceGraph, class NamedParameters>
auto vertex_index_map_of_mesh(const FaceGraph& mesh, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::vertex_index_t>::value)
    return get_initialized_vertex_index_map(mesh);
  else
    return parameters::get_parameter(np, internal_np::vertex_index);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_VERTEX_INDEX_MAP_OF_MESH_H
