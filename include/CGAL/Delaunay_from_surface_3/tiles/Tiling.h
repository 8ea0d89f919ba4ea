// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILING_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILING_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_tree.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What all tiles know.
struct Tiling
{
  Tile_tree tree;
  std::array<Tile_point, 4> start; // positively oriented; every tile keeps these
  double largest, least; // coordinates, in absolute value; the least of those that are not 0
  std::uint64_t number_of_points;
  std::vector<Tile_point> sample; // of all points; each tile is offered these first
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILING_H
