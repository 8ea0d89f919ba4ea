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
#include <tuple>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What a cell is to a tile.
enum Kind_of_cell : unsigned char { OWNED_FINITE, OWNED_INFINITE, OF_OTHERS, FAR };

// By cell, in their order; FAR are those without a vertex of the tile's own.
inline std::vector<Kind_of_cell> kinds_of_cells(const Delaunay_tile& tile)
{
  const Tile_triangulation& tr = tile.triangulation();
  std::vector<Kind_of_cell> kinds;
  tr.for_each_cell([&](const Tile_triangulation::Cell& cell) {
    const auto own = std::count_if(cell.v, cell.v + 4, [&](auto v) { return tile.is_own(v); });
    const bool is_owned = own == 4 || (own > 0 && tr.owner_of(cell) == tile.number());
    kinds.push_back(own == 0                                         ? FAR
                    : !is_owned                                      ? OF_OTHERS
                    : Tile_triangulation::Complex::is_infinite(cell) ? OWNED_INFINITE
                                                                     : OWNED_FINITE);
  });
  return kinds;
}

// The vertices of own stars, own ones first, each by id: by vertex of the tile its place, else -1.
inline std::vector<std::int32_t> places_of_vertices(const Delaunay_tile& tile,
                                                    const std::vector<Kind_of_cell>& kinds,
                                                    Delaunay_3_tile& piece)
{
  const Tile_triangulation& tr = tile.triangulation();
  using Id = Tile_triangulation::Id;
  std::vector<char> is_used(tr.vertices_end());
  auto kind = kinds.begin();
  tr.for_each_cell([&](const Tile_triangulation::Cell& cell) {
    if (*kind++ != FAR)
      for (const Id v : cell.v)
        is_used[v] = 1;
  });
  std::vector<std::tuple<bool, std::uint64_t, Id>> used; // whether it is another's, and its id
  for (std::size_t v = 1; v < is_used.size(); ++v)
    if (is_used[v])
      used.emplace_back(!tile.is_own(Id(v)), tr.id(Id(v)), Id(v));
  std::sort(used.begin(), used.end());
  std::vector<std::int32_t> places(tr.vertices_end(), -1);
  piece.ids.reserve(used.size());
  piece.points.reserve(used.size());
  for (const auto& [is_foreign, id, v] : used) {
    places[v] = std::int32_t(piece.ids.size());
    const auto point = tr.point(v);
    piece.ids.push_back(id);
    piece.points.push_back({point.coordinates[0], point.coordinates[1], point.coordinates[2]});
    piece.number_of_own_vertices += !is_foreign;
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
  const std::vector<Kind_of_cell> kinds = kinds_of_cells(tile);
  const std::vector<std::int32_t> places = places_of_vertices(tile, kinds, piece);
  std::array<std::size_t, 4> ends{}; // of the cells of a kind, and of those before
  for (const Kind_of_cell kind : kinds)
    ++ends[kind];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  piece.number_of_owned_finite_cells = ends[OWNED_FINITE];
  piece.number_of_owned_cells = ends[OWNED_INFINITE];
  piece.cells.resize(ends[OF_OTHERS]);
  std::array<std::size_t, 4> next = {0, ends[0], ends[1], 0};
  auto kind = kinds.begin();
  tr.for_each_cell([&](const Tile_triangulation::Cell& cell) {
    if (*kind != FAR)
      piece.cells[next[*kind]++] = {places[cell.v[0]], places[cell.v[1]], places[cell.v[2]],
                                    places[cell.v[3]]};
    ++kind;
  });
  note_equal_points(tile, piece);
  return piece;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H
