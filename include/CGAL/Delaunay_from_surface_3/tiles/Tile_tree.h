// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TREE_H

// Who owns a point: the leaf of a kd-tree (Bentley 1975) that it is in, found by comparing its
// doubles with the splitting planes. So equal points have one owner, and no message carries an
// owner.
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
  struct Cut
  {
    double plane = 0;
    unsigned axis = 0;
    std::ptrdiff_t below = 0, error = -1; // points below it; how far that is from what is wanted
  };

  void split(Tile_point* first, Tile_point* last, std::uint32_t tiles)
  {
    if (tiles <= 1)
      return;
    const std::size_t node = m_nodes.size();
    const std::uint32_t below = tiles / 2;
    const Cut cut =
        best_cut(first, last, (last - first) * std::ptrdiff_t(below) / std::ptrdiff_t(tiles));
    Tile_point* const middle = std::partition(
        first, last, [&](const Tile_point& p) { return p.coordinates[cut.axis] < cut.plane; });
    m_nodes.push_back({cut.plane, cut.axis, 0});
    split(first, middle, below);
    m_nodes[node].above = std::uint32_t(m_nodes.size());
    split(middle, last, tiles - below);
  }

  // Across the longest axis on which about as many points are below as are wanted: many may share a
  // coordinate, as in a plane.
  static Cut best_cut(Tile_point* first, Tile_point* last, std::ptrdiff_t wanted)
  {
    double length[3] = {};
    unsigned axes[3] = {0, 1, 2};
    for (unsigned axis = 0; axis < 3 && first != last; ++axis) {
      const auto [low, high] =
          std::minmax_element(first, last, [axis](const Tile_point& p, const Tile_point& q) {
            return p.coordinates[axis] < q.coordinates[axis];
          });
      length[axis] = high->coordinates[axis] / 2 - low->coordinates[axis] / 2; // finite
    }
    std::stable_sort(axes, axes + 3, [&](unsigned a, unsigned b) { return length[a] > length[b]; });
    Cut best;
    for (const unsigned axis : axes) {
      const Cut cut = cut_across(first, last, wanted, axis);
      if (best.error < 0 || cut.error < best.error)
        best = cut;
      if (4 * best.error <= last - first)
        break;
    }
    return best;
  }

  // At the coordinate of the point that has so many before it, or at the next one.
  static Cut cut_across(Tile_point* first, Tile_point* last, std::ptrdiff_t wanted, unsigned axis)
  {
    if (first == last)
      return {0, axis, 0, 0};
    std::nth_element(first, first + wanted, last, [axis](const Tile_point& p, const Tile_point& q) {
      return p.coordinates[axis] < q.coordinates[axis];
    });
    const double at = first[wanted].coordinates[axis];
    double next = at;
    std::ptrdiff_t less = 0, same = 0;
    for (const Tile_point* p = first; p != last; ++p) {
      const double x = p->coordinates[axis];
      less += x < at;
      same += x == at;
      next = x > at && (next == at || x < next) ? x : next;
    }
    if (next != at && less + same - wanted < wanted - less)
      return {next, axis, less + same, less + same - wanted};
    return {at, axis, less, wanted - less};
  }

  std::uint32_t m_number_of_tiles;
  std::vector<Node> m_nodes;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TREE_H
