// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_TILE_CALLS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_TILE_CALLS_H

// What tests of all engines hand to delaunay_3_tiles().

#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <array>
#include <cstdint>
#include <vector>

namespace tests {

inline CGAL::Tile_array_source_3 source_of(const std::vector<std::array<double, 3>>& points)
{
  return {points.front().data(), points.size()};
}

// So many tiles, also of few points.
inline CGAL::Tiles_options options_of(std::uint32_t tiles)
{
  CGAL::Tiles_options options;
  options.number_of_tiles = tiles;
  options.least_points = 1;
  return options;
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_TILE_CALLS_H
