// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WITH_ROTATION_SYSTEM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WITH_ROTATION_SYSTEM_H

// Chooses the index type: 32 bits wherever the numbers of edges and vertices allow.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Reads the surface and calls function(Rotation_system<Index>&). A reader (Halfedge_graph_reader,
// Embedding_reader) turns one kind of graph into a rotation system, and marked darts back into its
// edges.
template <class Reader, class Function>
auto with_rotation_system(const Reader& reader, const Function& function)
{
  // Cutting the surface open makes copies of vertices, fewer than there are darts; so half of the
  // 32-bit numbers are left for the copies.
  if ((std::max)(reader.number_of_darts(), reader.number_of_vertices()) < (std::size_t(1) << 31)) {
    Rotation_system<std::uint32_t> surface;
    reader.read(surface);
    return function(surface);
  }
  Rotation_system<std::uint64_t> surface;
  reader.read(surface);
  return function(surface);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WITH_ROTATION_SYSTEM_H
