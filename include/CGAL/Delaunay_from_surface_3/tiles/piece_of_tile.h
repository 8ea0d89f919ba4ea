// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What a tile has when all is done, as a Delaunay_3_tile, but its cells one after the other: an array
// of them would take half as much memory as the triangulation. Keeps a reference. Sorts the vertices;
// else linear.
class Piece_of_tile
{
public:
  using Id = Tile_triangulation::Id;

  explicit Piece_of_tile(const Delaunay_tile& tile)
    : m_tile(tile)
  {
    find_kinds();
    sort_vertices();
    note_equal_points();
  }

  std::uint32_t number() const { return m_tile.number(); }
  std::size_t number_of_own_vertices() const { return m_number_of_own_vertices; }
  std::size_t number_of_cells() const
  {
    return number_of_owned_cells() + m_number_of_cells[OF_OTHERS];
  }
  std::size_t number_of_owned_cells() const
  {
    return number_of_owned_finite_cells() + m_number_of_cells[OWNED_INFINITE];
  }
  std::size_t number_of_owned_finite_cells() const { return m_number_of_cells[OWNED_FINITE]; }

  // Of points that have the place of others: to each id the smallest that stands for it.
  const std::vector<std::array<std::uint64_t, 2>>& equal_points() const { return m_equal_points; }

  // The vertices of own stars, own ones first, each by id.
  std::size_t number_of_vertices() const { return m_vertices.size(); }
  template <class Visit>
  void for_each_vertex(const Visit& visit) const
  {
    for (const Id v : m_vertices)
      visit(m_tile.triangulation().point(v));
  }

  template <class Visit>
  void for_each_cell(const Visit& visit) const
  {
    std::vector<std::int32_t> places(m_tile.triangulation().vertices_end(), -1);
    for (std::size_t k = 0; k < m_vertices.size(); ++k)
      places[m_vertices[k]] = std::int32_t(k);
    for (const Kind wanted : {OWNED_FINITE, OWNED_INFINITE, OF_OTHERS})
      for_each_cell_and_kind([&](const Cell& cell, Kind kind) {
        if (kind == wanted)
          visit(Delaunay_3_tile::Cell{places[cell.v[0]], places[cell.v[1]], places[cell.v[2]],
                                      places[cell.v[3]]});
      });
  }

private:
  using Cell = Tile_triangulation::Cell;

  // What a cell is to a tile; FAR are those without a vertex of its own.
  enum Kind : unsigned char { OWNED_FINITE, OWNED_INFINITE, OF_OTHERS, FAR };

  template <class Visit>
  void for_each_cell_and_kind(const Visit& visit) const
  {
    auto kind = m_kinds.begin();
    m_tile.triangulation().for_each_cell([&](const Cell& cell) { visit(cell, *kind++); });
  }

  void find_kinds()
  {
    const Tile_triangulation& tr = m_tile.triangulation();
    tr.for_each_cell([&](const Cell& cell) {
      const auto own = std::count_if(cell.v, cell.v + 4, [&](Id v) { return m_tile.is_own(v); });
      const bool is_owned = own == 4 || (own > 0 && tr.owner_of(cell) == number());
      m_kinds.push_back(own == 0                                         ? FAR
                        : !is_owned                                      ? OF_OTHERS
                        : Tile_triangulation::Complex::is_infinite(cell) ? OWNED_INFINITE
                                                                         : OWNED_FINITE);
      ++m_number_of_cells[m_kinds.back()];
    });
  }

  void sort_vertices()
  {
    const Tile_triangulation& tr = m_tile.triangulation();
    std::vector<char> is_used(tr.vertices_end());
    for_each_cell_and_kind([&](const Cell& cell, Kind kind) {
      if (kind != FAR)
        for (const Id v : cell.v)
          is_used[v] = 1;
    });
    m_vertices.reserve(std::size_t(std::count(is_used.begin() + 1, is_used.end(), 1)));
    for (const bool of_others : {false, true}) {
      const auto first = std::ptrdiff_t(m_vertices.size());
      for (std::size_t v = 1; v < is_used.size(); ++v)
        if (is_used[v] && m_tile.is_own(Id(v)) != of_others)
          m_vertices.push_back(Id(v));
      std::sort(m_vertices.begin() + first, m_vertices.end(),
                [&](Id v, Id w) { return tr.id(v) < tr.id(w); });
      if (!of_others)
        m_number_of_own_vertices = m_vertices.size();
    }
  }

  void note_equal_points()
  {
    std::map<std::uint64_t, std::uint64_t> smaller;
    for (const auto& [p, q] : m_tile.equal_points())
      smaller.emplace(p, q);
    for (const auto& pair : smaller) {
      auto root = smaller.find(pair.second);
      std::uint64_t id = pair.second;
      for (; root != smaller.end(); root = smaller.find(id))
        id = root->second;
      m_equal_points.push_back({pair.first, id});
    }
  }

  const Delaunay_tile& m_tile;
  std::vector<Kind> m_kinds; // by cell, in their order
  std::array<std::size_t, 4> m_number_of_cells{};
  std::vector<Id> m_vertices;
  std::size_t m_number_of_own_vertices = 0;
  std::vector<std::array<std::uint64_t, 2>> m_equal_points;
};

inline Delaunay_3_tile piece_of(const Delaunay_tile& tile)
{
  const Piece_of_tile from(tile);
  Delaunay_3_tile piece;
  piece.number = from.number();
  piece.ids.reserve(from.number_of_vertices());
  piece.points.reserve(from.number_of_vertices());
  from.for_each_vertex([&](const Tile_point& p) {
    piece.ids.push_back(p.id);
    piece.points.push_back({p.coordinates[0], p.coordinates[1], p.coordinates[2]});
  });
  piece.number_of_own_vertices = from.number_of_own_vertices();
  piece.cells.reserve(from.number_of_cells());
  from.for_each_cell([&](const Delaunay_3_tile::Cell& cell) { piece.cells.push_back(cell); });
  piece.number_of_owned_cells = from.number_of_owned_cells();
  piece.number_of_owned_finite_cells = from.number_of_owned_finite_cells();
  piece.equal_points = from.equal_points();
  return piece;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PIECE_OF_TILE_H
