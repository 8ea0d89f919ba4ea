// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_TOPOLOGY_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
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
  std::size_t count = surface.points.size();
  CGAL::Delaunay_from_surface_3::internal::Disjoint_sets<std::size_t> pieces(count);
  for (const Indexed_surface::Face& face : surface.faces)
    for (int i = 1; i < 3; ++i)
      count -= pieces.unite(face[0], face[i]);
  return count;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_TOPOLOGY_H
