// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ARE_LINKS_SPHERES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ARE_LINKS_SPHERES_H

// Euler's formula, vertex by vertex.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether the link of each vertex is a sphere, for tetrahedra whose facets are shared by two each.
// It is a closed surface of as many triangles as the vertex has cells, f, and as many vertices as
// it has neighbours, v; it has 3 f / 2 edges, so v - f / 2 is its Euler characteristic if it is
// connected, which is 2 for spheres alone. One of several components has a larger sum; where that
// is made up for by handles, nothing is seen.
//
// Vertices are 0, …, n - 1. O(m log m) for m cells, and 48 bytes for each if an Id has 32 bits.
template <class Id>
bool are_links_spheres(const std::vector<std::array<Id, 4>>& cells, std::size_t n)
{
  std::vector<std::pair<Id, Id>> edges;
  edges.reserve(6 * cells.size());
  std::vector<std::size_t> number_of_cells(n), number_of_neighbors(n);
  for (const std::array<Id, 4>& v : cells)
    for (unsigned i = 0; i < 4; ++i) {
      ++number_of_cells[v[i]];
      for (unsigned j = i + 1; j < 4; ++j)
        edges.emplace_back((std::min)(v[i], v[j]), (std::max)(v[i], v[j]));
    }
  std::sort(edges.begin(), edges.end());
  const auto end = std::unique(edges.begin(), edges.end());
  for (auto e = edges.begin(); e != end; ++e) {
    ++number_of_neighbors[e->first];
    ++number_of_neighbors[e->second];
  }
  for (std::size_t v = 0; v < n; ++v)
    if (number_of_cells[v] > 0 && 2 * number_of_neighbors[v] != number_of_cells[v] + 4)
      return false;
  return true;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ARE_LINKS_SPHERES_H
