// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_3_TILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_3_TILE_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is what `delaunay_3_tiles()` gives for a tile: the stars of the vertices that are the tile's own, in
the Delaunay triangulation of all points. Every cell is in the tiles of its vertices; one of these,
that of the vertex with the smallest id, *owns* it, so each cell is owned once.
*/
struct Delaunay_3_tile
{
  /// Four vertices, as places in `ids`, in positive orientation; -1 is the infinite vertex, always
  /// last.
  using Cell = std::array<std::int32_t, 4>;

  /// The number of the tile.
  std::uint32_t number = 0;

  /// The ids of the vertices, which are places in the input; of equal points the smallest. First
  /// those of the tile's own vertices, ascending, then those of others, ascending.
  std::vector<std::uint64_t> ids;

  /// Their coordinates.
  std::vector<std::array<double, 3>> points;

  /// How many of them are the tile's own.
  std::size_t number_of_own_vertices = 0;

  /// All cells that have a vertex of the tile's own: first those that the tile owns and that are
  /// finite, then the infinite ones that it owns, then all others.
  std::vector<Cell> cells;

  /// How many cells the tile owns.
  std::size_t number_of_owned_cells = 0;

  /// How many of these are finite.
  std::size_t number_of_owned_finite_cells = 0;

  /// Points of the tile that have the place of another: their ids, and those of their vertices.
  std::vector<std::array<std::uint64_t, 2>> equal_points;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_3_TILE_H
