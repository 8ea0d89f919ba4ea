// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EULER_COUNT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EULER_COUNT_H

// Counts that give the Euler characteristic of a surface or of one component: vertices - edges +
// triangles.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Euler_count
{
  std::size_t vertices = 0;
  std::size_t darts = 0;   // two per edge
  std::size_t corners = 0; // three per triangle
  std::size_t boundary_vertices = 0;

  template <class Index>
  void add(const Rotation_system<Index>& surface, Index v)
  {
    ++vertices;
    darts += surface.degree(v);
    corners += surface.number_of_corners(v);
    boundary_vertices += surface.on_boundary[v] ? 1 : 0;
  }

  std::ptrdiff_t characteristic() const
  {
    return std::ptrdiff_t(vertices) - std::ptrdiff_t(darts / 2) + std::ptrdiff_t(corners / 3);
  }

  // What a connected surface with these counts is; a disc has one boundary loop.
  bool is_sphere() const { return characteristic() == 2 && boundary_vertices == 0; }
  bool is_disc() const { return characteristic() == 1 && boundary_vertices > 0; }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EULER_COUNT_H
