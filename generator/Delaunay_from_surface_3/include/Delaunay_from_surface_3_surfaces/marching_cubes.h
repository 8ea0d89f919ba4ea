// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H

#include <Delaunay_from_surface_3_surfaces/Crossed_lattice.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Marching_cubes_table.h>
#include <Delaunay_from_surface_3_surfaces/Volume.h>

#include <cstddef>
#include <vector>

namespace surfaces {

/// The surface between the lattice points inside and outside a volume, by marching cubes: a closed
/// 2-manifold, oriented counterclockwise from outside, with a point on each lattice edge that it
/// crosses. O(n^3) for n x n x n lattice points.
inline Indexed_surface marching_cubes(const Volume& volume)
{
  const Marching_cubes_table table;
  const Crossed_lattice lattice(volume);
  Indexed_surface surface;
  surface.points = lattice.points();
  lattice.for_each_cube([&](std::size_t cube) {
    const int inside = lattice.inside(cube);
    const auto& loops = table.loops(inside);
    for (std::size_t k = 0; k < loops.size(); ++k) {
      const std::vector<std::size_t> corners = lattice.points_of(cube, loops[k]);
      for (const auto& t : table.triangulations_of_loops(inside)[k])
        surface.faces.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    }
  });
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H
