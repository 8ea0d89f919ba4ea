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

// Who was told of a point.
struct Told
{
  std::uint64_t id, to;

  friend bool operator==(const Told& s, const Told& t) { return s.id == t.id && s.to == t.to; }
  friend bool operator<(const Told& s, const Told& t)
  {
    return s.id != t.id ? s.id < t.id : s.to < t.to;
  }
};

// What makes a tile again as it was, beside its own points.
struct Tile_state
{
  std::vector<Tile_point> kept;     // others' points in its triangulation
  std::vector<std::uint64_t> known; // ids of all that was offered, ascending
  std::vector<Told> told;           // ascending
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_POINT_H
