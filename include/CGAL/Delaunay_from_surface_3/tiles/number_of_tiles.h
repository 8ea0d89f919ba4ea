// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_NUMBER_OF_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_NUMBER_OF_TILES_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_too_large.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Out of core, 250 of them for the triangulation. In memory a tile keeps its piece beside it, and
// takes half as much again.
constexpr std::uint64_t bytes_per_point_kept = 300;
constexpr std::uint64_t most_points_of_tile = std::uint64_t(1) << 27; // 30 bits for its cells

// How many points a tile may keep, of so many that are in memory at once.
inline std::size_t most_points_kept(const Tiles_options& options, std::size_t at_once)
{
  const std::uint64_t memory = options.memory / (std::max)(at_once, std::size_t(1));
  return std::size_t(options.memory == 0
                         ? most_points_of_tile
                         : (std::min)(most_points_of_tile, (std::max)(memory / bytes_per_point_kept,
                                                                      std::uint64_t(64))));
}

// How many points are read at a time: 60 bytes each while they are sorted by tiles.
inline std::size_t most_points_read(const Tiles_options& options, std::size_t at_once)
{
  const std::uint64_t fit = options.memory / (std::max)(at_once, std::size_t(1)) / 100;
  const std::size_t most =
      options.memory == 0 ? options.points_at_once
                          : std::size_t((std::min)(std::uint64_t(options.points_at_once), fit));
  return std::clamp(most, std::size_t(1), std::size_t(1) << 30);
}

// For n points, if the worst tile keeps five times its own points, which are up to a tenth more
// than those of others.
inline std::uint32_t number_of_tiles(const Tiles_options& options, std::uint64_t n,
                                     std::size_t at_once)
{
  const std::uint64_t most = n / (std::max)(options.least_points, std::uint32_t(1)) + 1;
  if (options.number_of_tiles > 0)
    return std::uint32_t((std::min)(most, std::uint64_t(options.number_of_tiles)));
  const double kept = 5.5 * double(n);
  const double tiles = kept / double(most_points_kept(options, at_once)) + 1;
  return std::uint32_t((std::min)(double(most), (std::min)(tiles, 1e6)));
}

// After a tile of n points in all was too large: asks for as many as would do. False if there are
// none, or not to be asked for. Throws if there may not be so many.
inline bool ask_for_more_tiles(Tiles_options& options, const Tile_too_large& error, std::uint64_t n,
                               std::uint32_t tiles)
{
  options.number_of_tiles = error.number_of_tiles();
  if (error.number_of_tiles() == 0)
    return false;
  const std::uint32_t most = number_of_tiles(options, n, 1);
  if (most <= tiles)
    throw Tile_too_large(std::string(error.what()) + ", but there may be " + std::to_string(most) +
                             " only, of " + std::to_string(options.least_points) + " points each",
                         0);
  return options.starts_again;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_NUMBER_OF_TILES_H
