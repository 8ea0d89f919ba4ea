// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TREE_H

// Who owns a point: the leaf of a kd-tree (Bentley 1975) that it is in, found by comparing its doubles
// with the splitting planes. So equal points have one owner, and no message carries an owner.
//
// Cost: O(s log T) for T tiles from a sample of s points, O(log T) for a point.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tile_tree
{
public:
  // The node of what lies below the plane follows; that of the rest is `above`.
  struct Node
  {
    double plane;
    std::uint32_t axis, above;
  };

  // So many tiles, which have about equal shares of the sample. Its points are reordered.
  Tile_tree(std::vector<Tile_point>& sample, std::uint32_t number_of_tiles)
    : m_number_of_tiles(number_of_tiles)
  {
    split(sample.data(), sample.data() + sample.size(), number_of_tiles);
  }

  // As it was.
  Tile_tree(std::vector<Node> nodes, std::uint32_t number_of_tiles)
    : m_number_of_tiles(number_of_tiles)
    , m_nodes(std::move(nodes))
  {
  }

  std::uint32_t number_of_tiles() const { return m_number_of_tiles; }
  const std::vector<Node>& nodes() const { return m_nodes; }

  std::uint32_t owner(const double* p) const
  {
    std::uint32_t tile = 0, tiles = m_number_of_tiles;
    for (std::size_t node = 0; tiles > 1;) {
      const Node& n = m_nodes[node];
      const std::uint32_t below = tiles / 2;
      if (p[n.axis] < n.plane) { // 0 and -0 are the same
        tiles = below;
        ++node;
      } else {
        tile += below;
        tiles -= below;
        node = n.above;
      }
    }
    return tile;
  }

private:
  void split(Tile_point* first, Tile_point* last, std::uint32_t tiles)
  {
    if (tiles <= 1)
      return;
    const std::size_t node = m_nodes.size();
    const unsigned axis = longest_axis(first, last);
    const std::uint32_t below = tiles / 2;
    Tile_point* const middle =
        first + (last - first) * std::ptrdiff_t(below) / std::ptrdiff_t(tiles);
    std::nth_element(first, middle, last, [axis](const Tile_point& p, const Tile_point& q) {
      return p.coordinates[axis] < q.coordinates[axis];
    });
    m_nodes.push_back({middle == last ? 0. : middle->coordinates[axis], axis, 0});
    split(first, middle, below);
    m_nodes[node].above = std::uint32_t(m_nodes.size());
    split(middle, last, tiles - below);
  }

  static unsigned longest_axis(const Tile_point* first, const Tile_point* last)
  {
    unsigned longest = 0;
    double length = -1;
    for (unsigned axis = 0; axis < 3 && first != last; ++axis) {
      const auto [low, high] =
          std::minmax_element(first, last, [axis](const Tile_point& p, const Tile_point& q) {
            return p.coordinates[axis] < q.coordinates[axis];
          });
      const double l = high->coordinates[axis] / 2 - low->coordinates[axis] / 2; // finite
      if (l > length) {
        length = l;
        longest = axis;
      }
    }
    return longest;
  }

  std::uint32_t m_number_of_tiles;
  std::vector<Node> m_nodes;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TREE_H
