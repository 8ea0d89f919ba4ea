// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H

#include <CGAL/Delaunay_from_surface_3/surface/Find_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/Surface_component_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/Triangulated_surface.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_rotation_system.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds the components of a triangulated surface, and the Euler characteristic, boundary loops,
orientability and genus of each.

<b>Complexity</b>: linear time.

\param surface the surface, from `surface_of()`

\throws Surface_input_error as described for `surface_of()`
*/
template <class Reader>
Surface_topology surface_topology(const Triangulated_surface<Reader>& surface)
{
  return internal::with_rotation_system(surface.reader(), [](auto& rotations) {
    using Index = typename std::decay_t<decltype(rotations)>::Index;
    return internal::Find_topology<Index>(rotations)();
  });
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H
