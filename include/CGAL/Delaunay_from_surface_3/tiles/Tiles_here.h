// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_HERE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_HERE_H

// An engine for tiles that are all in this process: for tests, and the one that others are compared
// with. Two verbs: exchange, gather.

#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_here
{
public:
  // The points are numbered by their places. So many of a tile's points as 1 / sample_share come into
  // the sample that all tiles see. The points do not lie in one plane.
  Tiles_here(const Point_array& points, std::uint32_t number_of_tiles, std::size_t sample_share = 8)
    : m_tiling(tiling_of(points, number_of_tiles, sample_share, m_sample))
  {
    const Rounding_to_nearest rounding;
    std::vector<std::vector<Tile_point>> own(number_of_tiles);
    for (std::size_t i = 0; i < points.size(); ++i)
      own[m_tiling.tree.owner(points[i])].push_back(tile_point(points, i));
    for (std::uint32_t t = 0; t < number_of_tiles; ++t) {
      m_tiles.push_back(std::make_unique<Delaunay_tile>(m_tiling, t, own[t]));
      m_inboxes.push_back(m_sample);
    }
  }

  // Every tile hears what was told, and tells. Returns how many points were told.
  std::size_t exchange()
  {
    return exchange([](Tile_message&) {});
  }

  // The same by a post that may lose or change messages, as tests have it.
  template <class Post>
  std::size_t exchange(const Post& post)
  {
    const Rounding_to_nearest rounding;
    std::vector<std::vector<Tile_point>> inboxes(m_tiles.size());
    std::size_t told = 0;
    for (std::size_t t = 0; t < m_tiles.size(); ++t) {
      for (Tile_message& message : m_tiles[t]->absorb(m_inboxes[t])) {
        post(message);
        auto& inbox = inboxes[message.to];
        inbox.insert(inbox.end(), message.points.begin(), message.points.end());
        told += message.points.size();
      }
    }
    m_inboxes.swap(inboxes);
    return told;
  }

  std::vector<Tile_certificate> gather(std::uint64_t seed) const
  {
    std::vector<Tile_certificate> certificates;
    for (const auto& tile : m_tiles)
      certificates.push_back(tile->certificate(seed));
    return certificates;
  }

  Tiles_here(const Tiles_here&) = delete; // tiles refer to what all know

  const std::vector<std::unique_ptr<Delaunay_tile>>& tiles() const { return m_tiles; }

private:
  static Tile_point tile_point(const Point_array& points, std::size_t i)
  {
    return {i, {points[i][0], points[i][1], points[i][2]}};
  }

  // The sample is drawn by a hash of the ids.
  static Tiling tiling_of(const Point_array& points, std::uint32_t number_of_tiles,
                          std::size_t sample_share, std::vector<Tile_point>& sample)
  {
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(number_of_tiles > 0 && sample_share > 0);
    const std::size_t share = sample_share * number_of_tiles;
    double largest = 0, least = (std::numeric_limits<double>::max)();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (Split_mix(i)() % share == 0)
        sample.push_back(tile_point(points, i));
      for (unsigned k = 0; k < 3; ++k) {
        const double size = std::abs(points[i][k]);
        largest = (std::max)(largest, size);
        least = size == 0 ? least : (std::min)(least, size);
      }
    }
    const Starting_simplex simplex =
        starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(simplex.dimension == 3);
    std::array<Tile_point, 4> start;
    for (unsigned k = 0; k < 4; ++k)
      start[k] = tile_point(points, simplex.points[k]);
    std::vector<Tile_point> cut = sample;
    return {Tile_tree(cut, number_of_tiles), start, largest, least};
  }

  std::vector<Tile_point> m_sample;
  const Tiling m_tiling;
  std::vector<std::unique_ptr<Delaunay_tile>> m_tiles;
  std::vector<std::vector<Tile_point>> m_inboxes;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_HERE_H
