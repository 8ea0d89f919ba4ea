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

  /// the tile's points that are equal to another: pairs of the id of the point and that of its
  /// vertex.
  std::vector<std::array<std::uint64_t, 2>> equal_points;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_3_TILE_H
