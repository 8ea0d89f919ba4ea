// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H

// The options of tiles, the source of their points, and a tile as the caller gets it.

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {
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
  /// to five times its own points. If all tiles are in memory, the limit holds for each of them. While
  /// the array of its cells grows, a tile may take half as much again.
  std::uint64_t memory = 0;

  /// determines the size of the sample that all tiles are offered: about the number of points of a
  /// tile divided by `sample_share`, but at most 16384.
  std::size_t sample_share = 8;

  /// the number of points that are read at a time, or fewer if `memory` is less than 100 bytes for
  /// each, but not fewer than 16384.
  std::size_t points_at_once = 4000000;

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

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is what `delaunay_3_tiles()` gives for a tile: the stars of the vertices that are the tile's own, in
the Delaunay triangulation of all points. Every cell is in the tiles of its vertices; the tile of
the vertex with the smallest id *owns* it, so each cell is owned once.
*/
struct Delaunay_3_tile
{
  /// four vertices, as positions in `ids`, in positive orientation; -1 is the infinite vertex,
  /// which is always last.
  using Cell = std::array<std::int32_t, 4>;

  /// the number of the tile.
  std::uint32_t number = 0;

  /// the ids of the vertices, which are positions in the input, and for equal points the smallest:
  /// first those of the tile's own vertices, then those of others, both in ascending order.
  std::vector<std::uint64_t> ids;

  /// the coordinates of these vertices.
  std::vector<std::array<double, 3>> points;

  /// the number of the tile's own vertices.
  std::size_t number_of_own_vertices = 0;

  /// all cells that have a vertex of the tile's own: first the finite cells that the tile owns,
  /// then the infinite cells that it owns, then all others.
  std::vector<Cell> cells;

  /// the number of cells that the tile owns.
  std::size_t number_of_owned_cells = 0;

  /// the number of finite cells that the tile owns.
  std::size_t number_of_owned_finite_cells = 0;

  /// the tile's points that are equal to another: pairs of the id of the point and the id of its
  /// vertex.
  std::vector<std::array<std::uint64_t, 2>> equal_points;
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is the base class of the sources of points for `delaunay_3_tiles()`, which reads any range of points
at any time, by any thread. The id of a point is its position, from 0 on.
*/
class Tile_source_3
{
public:
  virtual ~Tile_source_3() = default;

  /// returns the number of points.
  virtual std::uint64_t size() const = 0;

  /// writes the coordinates of the points `first`, …, `first + n - 1` to `coordinates`, three for
  /// each point.
  virtual void read(std::uint64_t first, std::size_t n, double* coordinates) const = 0;

  /// returns the first point of part `part` of `parts` consecutive parts; part `parts` begins at
  /// `size()`. Processes that share the work read one part each, and nothing else. If the points
  /// are distributed over the memories of several processes, redefine this function accordingly.
  virtual std::uint64_t first_of_part(std::uint64_t part, std::uint64_t parts) const
  {
    return size() / parts * part + size() % parts * part / parts;
  }

  /// returns a number that differs if the points may have changed, for example by the times of
  /// files. An interrupted run continues only with the points with which it began.
  virtual std::uint64_t stamp() const { return 0; }

  /// returns the files that the points are read from, if any. A run that would overwrite one of
  /// them is refused.
  virtual std::vector<std::filesystem::path> files() const { return {}; }

  /// returns a name of point `i`, for messages.
  virtual std::string name_of(std::uint64_t i) const { return "point " + std::to_string(i); }
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
/// \endcond

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is a source of `n` points in memory, stored as `3 n` numbers that the caller owns.
*/
class Tile_array_source_3 : public Tile_source_3
{
public:
  /// keeps the pointer, not a copy of the numbers.
  Tile_array_source_3(const double* coordinates, std::uint64_t n)
    : m_coordinates(coordinates)
    , m_size(n)
  {
  }

  /// returns `n`.
  std::uint64_t size() const override { return m_size; }

  /// copies the coordinates.
  void read(std::uint64_t first, std::size_t n, double* coordinates) const override
  {
    std::copy(m_coordinates + 3 * first, m_coordinates + 3 * (first + n), coordinates);
  }

  /// returns a hash of all coordinates. Linear: they are read once more when work in a folder
  /// begins or continues.
  std::uint64_t stamp() const override
  {
    std::uint64_t stamp = 0;
    for (const double* x = m_coordinates; x != m_coordinates + 3 * m_size; ++x) {
      std::uint64_t bits;
      std::memcpy(&bits, x, sizeof(bits));
      stamp = Delaunay_from_surface_3::core::Split_mix(stamp ^ bits)();
    }
    return stamp;
  }

private:
  const double* m_coordinates;
  std::uint64_t m_size;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {

// Is thrown when a tile keeps more points than it may. More tiles help, unless one vertex has too
// many neighbours: its owner must have them all.
class Tile_too_large : public std::runtime_error
{
public:
  // `enough` tiles would do (0: no number does) where there are `tiles` (0: not known here).
  Tile_too_large(const std::string& what, std::uint32_t enough, std::uint32_t tiles = 0)
    : std::runtime_error(what)
    , m_enough(enough)
    , m_tiles(tiles)
  {
  }

  std::uint32_t number_of_tiles() const { return m_enough; }
  std::uint32_t number_of_tiles_now() const { return m_tiles; }

private:
  std::uint32_t m_enough, m_tiles;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H
