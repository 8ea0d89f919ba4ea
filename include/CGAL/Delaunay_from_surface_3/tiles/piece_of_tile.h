// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The vertices of own stars, own ones first, each by id: by vertex of the tile its place, else -1.
inline std::vector<std::int32_t> places_of_vertices(const Delaunay_tile& tile,
                                                    Delaunay_3_tile& piece)
{
  const Tile_triangulation& tr = tile.triangulation();
  using Id = Tile_triangulation::Id;
  std::vector<char> is_used(tr.vertices_end());
  tr.for_each_cell([&](const Tile_triangulation::Cell& cell) {
    if (std::any_of(cell.v, cell.v + 4, [&](Id v) { return tile.is_own(v); }))
      for (const Id v : cell.v)
        is_used[v] = 1;
  });
  std::vector<Id> used;
  for (std::size_t v = 1; v < is_used.size(); ++v)
    if (is_used[v])
      used.push_back(Id(v));
  std::sort(used.begin(), used.end(), [&](Id v, Id w) {
    return tile.is_own(v) != tile.is_own(w) ? tile.is_own(v) : tr.id(v) < tr.id(w);
  });
  std::vector<std::int32_t> places(tr.vertices_end(), -1);
  for (const Id v : used) {
    places[v] = std::int32_t(piece.ids.size());
    const auto point = tr.point(v);
    piece.ids.push_back(point.id);
    piece.points.push_back({point.coordinates[0], point.coordinates[1], point.coordinates[2]});
    piece.number_of_own_vertices += tile.is_own(v);
  }
  return places;
}

// To each id the smallest that stands for it, where points are equal.
inline void note_equal_points(const Delaunay_tile& tile, Delaunay_3_tile& piece)
{
  std::map<std::uint64_t, std::uint64_t> smaller;
  for (const auto& [p, q] : tile.equal_points())
    smaller.emplace(p, q);
  for (const auto& pair : smaller) {
    auto root = smaller.find(pair.second);
    std::uint64_t id = pair.second;
    for (; root != smaller.end(); root = smaller.find(id))
      id = root->second;
    piece.equal_points.push_back({pair.first, id});
  }
}

// What a tile has when all is done. Sorts its vertices; else linear.
inline Delaunay_3_tile piece_of(const Delaunay_tile& tile)
{
  const Tile_triangulation& tr = tile.triangulation();
  Delaunay_3_tile piece;
  piece.number = tile.number();
  const std::vector<std::int32_t> places = places_of_vertices(tile, piece);
  for (const int kind : {0, 1, 2}) { // owned and finite, owned and infinite, others'
    tr.for_each_cell([&](const Tile_triangulation::Cell& cell) {
      if (std::none_of(cell.v, cell.v + 4, [&](auto v) { return tile.is_own(v); }))
        return;
      const bool is_owned = tr.owner_of(cell) == tile.number();
      if ((is_owned ? int(Tile_triangulation::Complex::is_infinite(cell)) : 2) == kind)
        piece.cells.push_back(
            {places[cell.v[0]], places[cell.v[1]], places[cell.v[2]], places[cell.v[3]]});
    });
    if (kind == 0)
      piece.number_of_owned_finite_cells = piece.cells.size();
    if (kind == 1)
      piece.number_of_owned_cells = piece.cells.size();
  }
  note_equal_points(tile, piece);
  return piece;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H
