// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_CERTIFICATE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_CERTIFICATE_H

// The certificate of a tile's triangulation, such that all of them together can tell whether the
// union of the stars is the Delaunay triangulation of all points: for each partner it sums up the
// cells that have vertices of both, and it counts the tile's own part of the convex hull.
//
// If
//   (a) any two tiles see the same common cells,
//   (b) the hull that the infinite cells form is a sphere: V - E + F = 2, that is 2 V - F = 4, as
//       facets are triangles,
//   (c) every point is in the tile that owns it,
// then the union of the stars is the Delaunay triangulation of all points. Proof. A cell is seen by
// all owners of its vertices, so by (a) the union is a closed 3-manifold, and the star of each
// vertex in it equals its star in its owner's Delaunay triangulation. Lift the points to the
// paraboloid, perturbed as the predicates do it: at each vertex the lifted star is part of the
// boundary of a convex body, either the lower hull of the owner's points or a vertical wall over a
// facet of their hull. So the lifted complex is locally convex at each vertex, hence everywhere;
// walls over coplanar facets are only weakly convex. It is complete, and strictly convex at a
// vertex of the hull. A complete, connected, locally convex hypersurface with a strictly convex
// point is the boundary of a convex body (van Heijenoort 1952), for each perturbation that is small
// enough. So each component is the Delaunay triangulation of its vertices, with a hull of its own.
// By (b) there is one component, and by (c) it has all points. Equal points are one vertex, which
// has the smallest of their ids, and one owner.
//
// Cells are compared by sums of hashes of 128 bits, keyed by a seed that is drawn when no cell
// changes any more: "up to a collision" of probability 2^-128. A vertex has a key of 128 bits, made
// of its id and coordinates; a cell is hashed by the sum of its four keys, which does not depend on
// their order.

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The number of cells in a set, and the sum of their hashes.
struct Cell_sum
{
  std::uint64_t number = 0, hash[2] = {0, 0};

  Cell_sum& operator+=(const Cell_sum& other)
  {
    number += other.number;
    hash[0] += other.hash[0];
    hash[1] += other.hash[1];
    return *this;
  }
  friend bool operator==(const Cell_sum& s, const Cell_sum& t)
  {
    return s.number == t.number && s.hash[0] == t.hash[0] && s.hash[1] == t.hash[1];
  }
};

// Keyed hashes of cells: the keys of a cell's vertices are added, and the sum is hashed.
class Cell_hashes
{
public:
  Cell_hashes(const Tile_triangulation& tr, std::uint64_t seed)
    : m_tr(tr)
    , m_seeds{Split_mix(seed)(), Split_mix(seed + 1)()}
    , m_keys(tr.vertices_end())
  {
  }

  Cell_sum operator()(const Tile_triangulation::Cell& cell)
  {
    std::uint64_t first = 0, second = 0;
    for (const auto v : cell.v) {
      const Key& of_vertex = key(v);
      first += of_vertex[0];
      second += of_vertex[1];
    }
    return {1, {Split_mix(first)(), Split_mix(second)()}};
  }

private:
  using Key = std::array<std::uint64_t, 2>;

  // Makes the key on demand, since most vertices are in no cell that is asked for.
  const Key& key(Tile_triangulation::Id v)
  {
    if (m_keys[v][0] == 0)
      m_keys[v] = make_key(v);
    return m_keys[v];
  }

  Key make_key(Tile_triangulation::Id v) const
  {
    Tile_point point{Tile_triangulation::infinite_id, {0, 0, 0}};
    if (v != 0)
      point = m_tr.point(v);
    Key key;
    for (std::size_t half = 0; half < 2; ++half) {
      std::uint64_t h = Split_mix(m_seeds[half] ^ point.id)();
      for (const double x : point.coordinates) {
        const double of_any_zero = x + 0.; // 0 and -0 are one place
        std::uint64_t bits;
        std::memcpy(&bits, &of_any_zero, sizeof(bits));
        h = Split_mix(h ^ bits)();
      }
      key[half] = h;
    }
    return key;
  }

  const Tile_triangulation& m_tr;
  const std::uint64_t m_seeds[2];
  std::vector<Key> m_keys; // by vertex; 0: not made yet
};

struct Tile_certificate
{
  std::uint32_t tile = 0;
  std::map<std::uint32_t, Cell_sum> common; // by partner
  std::uint64_t hull_vertices = 0;          // its own
  std::uint64_t hull_facets = 0;            // those whose smallest vertex is its own
  std::uint64_t own_points = 0, points_kept = 0;
  std::uint64_t owned_cells = 0, hash = 0; // the same for cells; the hash is of their ids

  auto parts()
  {
    return std::tie(tile, common, hull_vertices, hull_facets, own_points, points_kept, owned_cells,
                    hash);
  }
};

// Returns whether, by their numbers, all own points are own vertices or equal to others.
inline bool has_own_points(const Delaunay_tile& tile)
{
  std::size_t vertices = 0;
  for (std::size_t v = 1; v < tile.triangulation().vertices_end(); ++v)
    vertices += tile.is_own(Delaunay_tile::Id(v));
  return vertices + tile.equal_points().size() == tile.number_of_own_points();
}

// Returns the certificate of a tile, when no tile has anything to tell. Linear.
inline Tile_certificate certificate_of(const Delaunay_tile& tile, std::uint64_t seed)
{
  const Tile_triangulation& tr = tile.triangulation();
  Tile_certificate result;
  result.tile = tile.number();
  result.own_points = has_own_points(tile) ? tile.number_of_own_points() : 0;
  result.points_kept = tile.number_of_points_kept();
  Cell_hashes hash_of(tr, seed);
  std::vector<std::uint64_t> hashes_of_ids(tr.vertices_end());
  for (std::size_t v = 0; v < hashes_of_ids.size(); ++v)
    hashes_of_ids[v] = Split_mix(tr.id(Tile_triangulation::Id(v)))();
  std::vector<char> is_on_hull(tr.vertices_end());
  std::pair<const std::uint32_t, Cell_sum>* last = nullptr; // the sum that a cell was added to
  tr.for_each_cell([&](const Tile_triangulation::Cell& cell) {
    std::uint32_t owners[4];
    unsigned own = 0;
    for (unsigned k = 0; k < 4; ++k) {
      owners[k] = tr.owner(cell.v[k]);
      own += owners[k] == tile.number();
    }
    if (own == 0)
      return;
    const bool is_infinite = Tile_triangulation::Complex::is_infinite(cell);
    for (unsigned k = 0; k < 4 && is_infinite; ++k)
      if (owners[k] == tile.number() && is_on_hull[cell.v[k]] == 0) {
        is_on_hull[cell.v[k]] = 1;
        ++result.hull_vertices;
      }
    if (own == 4 || tr.owner_of(cell) == tile.number()) {
      result.hull_facets += is_infinite;
      ++result.owned_cells;
      std::uint64_t h = 0;
      for (const auto v : cell.v)
        h += hashes_of_ids[v];
      result.hash += Split_mix(h)();
    }
    if (own == 4) // nearly always
      return;
    const Cell_sum sum = hash_of(cell);
    for (unsigned k = 0; k < 4; ++k) {
      bool is_partner = owners[k] != tile.number() && owners[k] != Tile_triangulation::nobody;
      for (unsigned j = 0; j < k; ++j)
        is_partner &= owners[j] != owners[k];
      if (!is_partner)
        continue;
      if (last == nullptr || last->first != owners[k]) // often the same one
        last = &*result.common.try_emplace(owners[k]).first;
      last->second += sum;
    }
  });
  return result;
}

using Tile_pairs = std::vector<std::array<std::uint32_t, 2>>;

// Returns the pairs of tiles that see different common cells, given all certificates by tile.
inline Tile_pairs tiles_that_differ(const std::vector<Tile_certificate>& tiles)
{
  Tile_pairs result;
  for (const Tile_certificate& a : tiles)
    for (const auto& [partner, sum] : a.common) {
      const Tile_certificate& b = tiles.at(partner);
      const auto found = b.common.find(a.tile); // b need not have listed a
      if (found == b.common.end() || !(found->second == sum))
        result.push_back({(std::min)(a.tile, partner), (std::max)(a.tile, partner)});
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Returns whether these tiles together have the Delaunay triangulation of `number_of_points`
// points. It is false, too, if they are not all `number_of_tiles` tiles in their order.
inline bool is_certified(const std::vector<Tile_certificate>& tiles, std::size_t number_of_tiles,
                         std::uint64_t number_of_points)
{
  if (tiles.size() != number_of_tiles)
    return false;
  std::uint64_t vertices = 0, facets = 0, points = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (tiles[t].tile != t)
      return false;
    for (const auto& [partner, sum] : tiles[t].common)
      if (partner >= tiles.size() || sum.number == 0)
        return false;
    vertices += tiles[t].hull_vertices;
    facets += tiles[t].hull_facets;
    points += tiles[t].own_points;
  }
  return points == number_of_points && 2 * vertices == facets + 4 &&
         tiles_that_differ(tiles).empty();
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_CERTIFICATE_H
