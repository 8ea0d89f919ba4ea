// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TOO_LARGE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TOO_LARGE_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Thrown when a tile keeps more points than it may. More tiles help, unless one vertex has too many
// neighbours: its owner must have them all.
class Tile_too_large : public std::runtime_error
{
public:
  Tile_too_large(std::uint32_t tile, std::size_t own_points, std::size_t limit, std::uint64_t hub,
                 std::size_t neighbors_of_hub, std::uint32_t tiles)
    : std::runtime_error(
          "tile " + std::to_string(tile) + " of " + std::to_string(own_points) +
          " points keeps more than the " + std::to_string(limit) + " that it may; point " +
          std::to_string(hub) + " alone has " + std::to_string(neighbors_of_hub) + " neighbors; " +
          advice(neighbors_of_hub, limit, tiles_that_would_do(own_points, limit, tiles)))
    , m_tiles(has_hub(neighbors_of_hub, limit) ? 0 : tiles_that_would_do(own_points, limit, tiles))
  {
  }

  // As another process has thrown it.
  Tile_too_large(const std::string& what, std::uint32_t tiles)
    : std::runtime_error(what)
    , m_tiles(tiles)
  {
  }

  // How many tiles would do; 0: no number does.
  std::uint32_t number_of_tiles() const { return m_tiles; }

private:
  // When it is thrown, the hub may not have all its neighbors yet.
  static bool has_hub(std::size_t neighbors, std::size_t limit) { return neighbors > limit / 2; }
  static std::uint32_t tiles_that_would_do(std::size_t own_points, std::size_t limit,
                                           std::uint32_t tiles)
  {
    const double share = 6. * double(own_points) / double(limit); // kept by the worst tile measured
    const double enough = double(tiles) * (share > 2 ? share : 2) + 1;
    return std::uint32_t(enough < 4e9 ? enough : 4e9); // more than there may be
  }
  static std::string advice(std::size_t neighbors, std::size_t limit, std::uint32_t tiles)
  {
    return has_hub(neighbors, limit) ? "no number of tiles will do, only more memory"
                                     : std::to_string(tiles) + " tiles would do";
  }

  std::uint32_t m_tiles;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TOO_LARGE_H
