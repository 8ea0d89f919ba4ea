// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_TOPOLOGY_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace surfaces {

/// The edges of the faces, each once, as sorted pairs of indices in ascending order. O(n log n).
inline std::vector<std::pair<std::size_t, std::size_t>> edges(const Indexed_surface& surface)
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  result.reserve(3 * surface.faces.size());
  for (const Indexed_surface::Face& face : surface.faces)
    for (int i = 0; i < 3; ++i)
      result.push_back(std::minmax<std::size_t>(face[i], face[(i + 1) % 3]));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Vertices - edges + faces.
inline std::ptrdiff_t euler_characteristic(const Indexed_surface& surface)
{
  return static_cast<std::ptrdiff_t>(surface.points.size() + surface.faces.size()) -
         static_cast<std::ptrdiff_t>(edges(surface).size());
}

/// The number of pieces that hang together through faces; a point on no face is a piece.
inline std::size_t number_of_components(const Indexed_surface& surface)
{
  const std::size_t n = surface.points.size();
  std::vector<std::size_t> rank(n, 0), parent(n);
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
  for (const Indexed_surface::Face& face : surface.faces) {
    sets.union_set(face[0], face[1]);
    sets.union_set(face[0], face[2]);
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < n; ++v)
    count += parent[v] == v;
  return count;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_TOPOLOGY_H
