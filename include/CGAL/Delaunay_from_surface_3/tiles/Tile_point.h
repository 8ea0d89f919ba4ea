// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_POINT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_POINT_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A point as tiles tell it to each other: 32 bytes. Its id is its place in the input.
struct Tile_point
{
  std::uint64_t id;
  double coordinates[3];
};

// What one tile tells another.
struct Tile_message
{
  std::uint32_t from, to;
  std::vector<Tile_point> points;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_POINT_H
