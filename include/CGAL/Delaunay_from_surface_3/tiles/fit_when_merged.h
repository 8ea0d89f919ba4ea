// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FIT_WHEN_MERGED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FIT_WHEN_MERGED_H

// Equal points are one vertex, so they count once where the points of a tile do.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether there are at most so many points. If there are more, of equal ones only that with the
// smallest id stays; the ids of the others are noted beside it. Those that are vertices already stay,
// too: they are noted when they meet these.
inline bool fit_when_merged(std::vector<Tile_point>& points, std::size_t limit,
                            const std::array<Tile_point, 4>& vertices,
                            std::vector<std::array<std::uint64_t, 2>>& equal)
{
  if (points.size() <= limit)
    return true;
  const auto is_before = [](const Tile_point& p, const Tile_point& q) {
    return std::lexicographical_compare(p.coordinates, p.coordinates + 3, q.coordinates,
                                        q.coordinates + 3);
  };
  const auto is_vertex = [&](const Tile_point& p) {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](const Tile_point& v) { return v.id == p.id; });
  };
  std::sort(points.begin(), points.end(), [&](const Tile_point& p, const Tile_point& q) {
    return is_before(p, q) || (!is_before(q, p) && p.id < q.id);
  });
  std::size_t end = 0;
  std::uint64_t smallest = 0; // id, of those that are equal
  for (const Tile_point& p : points) {
    const bool is_first = end == 0 || is_before(points[end - 1], p);
    smallest = is_first ? p.id : smallest;
    if (is_first || is_vertex(p))
      points[end++] = p;
    else
      equal.push_back({p.id, smallest});
  }
  points.resize(end);
  return end <= limit;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FIT_WHEN_MERGED_H
