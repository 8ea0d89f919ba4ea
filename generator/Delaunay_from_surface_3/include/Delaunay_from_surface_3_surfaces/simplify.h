// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SIMPLIFY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SIMPLIFY_H

#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>
#include <cstdint>

namespace surfaces {

/// A closed triangle mesh with about `n` vertices, fewer than it has: edges are collapsed.
inline Indexed_surface simplified(Mesh mesh, std::size_t n)
{
  internal::require_triangles(mesh);
  // Three edges per vertex, which is what is counted.
  const auto stop = [n](const auto&, const auto&, std::size_t, std::size_t edges) {
    return edges <= 3 * n;
  };
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
  return from_mesh(mesh);
}

/// A closed triangle mesh with `n` vertices, exactly if it has no more of them, else about:
/// `simplified()` or `densified()`, with jitter in both cases, so that the surfaces of all sizes
/// are equally rough.
inline Indexed_surface resized(const Mesh& mesh, std::size_t n, double fraction = 0.05,
                               std::uint64_t seed = 0)
{
  if (mesh.number_of_vertices() <= n)
    return densified(mesh, n, fraction, seed);
  Indexed_surface surface = simplified(mesh, n);
  jitter(surface, fraction, seed);
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SIMPLIFY_H
