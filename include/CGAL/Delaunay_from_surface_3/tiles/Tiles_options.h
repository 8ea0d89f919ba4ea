// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

has the options of `delaunay_3_tiles()`.
*/
struct Tiles_options
{
  /// the number of tiles; 0 stands for as many as `memory` requires.
  std::uint32_t number_of_tiles = 0;

  /// the least average number of points of a tile, which limits the number of tiles. Small tiles
  /// come to rest too early, and are told the remaining points one after the other. With fewer than
  /// a thousand points this takes many rounds.
  std::uint32_t least_points = 64;

  /// the approximate number of bytes that the tiles in memory at the same time may take; 0 stands
  /// for no limit. A tile takes 300 bytes for each point that it keeps, and the worst one keeps up
  /// to five times its own points. If all tiles are in memory, the limit holds for each of them.
  std::uint64_t memory = 0;

  /// determines the size of the sample that all tiles are offered: about the number of points of a
  /// tile divided by `sample_share`, but at most 16384.
  std::size_t sample_share = 8;

  /// the number of points that are read at a time, or fewer if `memory` is less than 100 bytes for each, but
  /// not fewer than 16384.
  std::size_t points_at_once = 4000000;

  /// whether the certificate compares cells instead of sums of their hashes.
  bool compares_cells = false;

  /// whether the work begins again with more tiles if one becomes larger than `memory` allows.
  bool starts_again = true;

  /// is called, by any thread but by only one at a time, with the name of the current stage
  /// ("reading", "round 0", …), how much of it is done, and how much there is in all. If it returns
  /// `false`, the work stops.
  std::function<bool(const char*, std::size_t, std::size_t)> progress;
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is thrown by `delaunay_3_tiles()` when `Tiles_options::progress` returns `false`.
*/
class Tiles_stopped : public std::runtime_error
{
public:
  /// constructs the exception with a fixed message.
  Tiles_stopped()
    : std::runtime_error("stopped before all was done")
  {
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is the result of `delaunay_3_tiles()`: counts, and whether the certificate holds.
*/
struct Tiles_report
{
  std::uint64_t points = 0;    ///< the number of points.
  std::uint32_t tiles = 0;     ///< the number of tiles.
  std::size_t rounds = 0;      ///< the number of rounds in which tiles told each other of points.
  std::uint64_t told = 0;      ///< the number of points that they told.
  std::uint64_t kept = 0;      ///< the number of points that they keep, including their own.
  std::uint64_t most_kept = 0; ///< the number of points that the largest tile keeps.
  std::uint64_t cells = 0;     ///< the number of cells, including infinite ones.
  std::uint64_t hash = 0;      ///< the sum of the hashes of all cells, as ids.
  bool is_certified = false;   ///< whether the certificate holds.
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
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

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is thrown if a file cannot be read or written, or does not contain what it should. The message names
the file and the place, on one line.
*/
class Tile_files_error : public std::runtime_error
{
public:
  /// inherits the constructors, which take the message.
  using std::runtime_error::runtime_error;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H
