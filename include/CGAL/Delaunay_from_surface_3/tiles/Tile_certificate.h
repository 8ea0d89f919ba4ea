// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_CERTIFICATE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_CERTIFICATE_H

// What a tile says of its triangulation, so that all together can tell whether the union of the stars
// is the Delaunay triangulation of all points: for each partner the cells that have vertices of both,
// and the part of the convex hull that is its own.
//
// If, of each two tiles, both see the same common cells, the union is a closed 3-manifold in which
// each star is in one tile's Delaunay triangulation. The lifted, perturbed complex is then locally
// convex, and a complete, locally convex, connected hypersurface bounds a convex body (van Heijenoort
// 1952). Hence each component is the Delaunay triangulation of its vertices; and there is one if the
// hull is a sphere: V - E + F = 2, that is 2 V - F = 4 where facets are triangles.
//
// Cells are compared by sums of hashes of 128 bits, keyed by a seed that is drawn when no cell changes
// any more: up to a collision.

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Of a set of cells.
struct Cell_sum
{
  std::uint64_t number = 0, hash[2] = {0, 0};

  friend bool operator==(const Cell_sum& s, const Cell_sum& t)
  {
    return s.number == t.number && s.hash[0] == t.hash[0] && s.hash[1] == t.hash[1];
  }
};

// The ids of the cell's vertices in ascending order; that of the infinite vertex is the largest number.
inline void add_cell(Cell_sum& sum, const std::array<std::uint64_t, 4>& sorted_ids,
                     std::uint64_t seed)
{
  ++sum.number;
  for (std::uint64_t half = 0; half < 2; ++half) {
    std::uint64_t h = Split_mix(seed + half)();
    for (const std::uint64_t id : sorted_ids)
      h = Split_mix(h ^ id)();
    sum.hash[half] += h;
  }
}

struct Tile_certificate
{
  std::uint32_t tile;
  std::map<std::uint32_t, Cell_sum> common; // by partner
  std::uint64_t hull_vertices = 0;          // its own
  std::uint64_t hull_facets = 0;            // whose smallest vertex is its own
};

// Do all tiles together have the Delaunay triangulation of all points? By tile, of all tiles.
inline bool is_certified(const std::vector<Tile_certificate>& tiles)
{
  std::uint64_t vertices = 0, facets = 0;
  for (const Tile_certificate& a : tiles) {
    vertices += a.hull_vertices;
    facets += a.hull_facets;
    for (const auto& [partner, sum] : a.common) {
      if (partner >= tiles.size() || tiles[partner].tile != partner)
        return false;
      const auto& theirs = tiles[partner].common;
      const auto found = theirs.find(a.tile); // it need not have listed this one
      if (found == theirs.end() || !(found->second == sum))
        return false;
    }
  }
  return 2 * vertices == facets + 4;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_CERTIFICATE_H
