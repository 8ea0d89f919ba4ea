// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H

// Tetrahedra between which there is no triangle of a surface. The winding number of a closed
// surface is the same in all of a region, so one of them is asked.
//
// Most triangles of a dense sample are facets. Those that are not, and those that close the
// openings, cut tetrahedra: these are regions of their own.
// Invariant: from the centre of a tetrahedron to that of another of its region a path through
// facets meets no triangle. Expected linear, but for what is cut.

#include <CGAL/Delaunay_from_surface_3/inside/Box_tree.h>
#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vector_products.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Corners = std::array<std::uint32_t, 3>;

// Three vertices in ascending order.
inline Corners ascending(Corners corners)
{
  if (corners[0] > corners[1])
    std::swap(corners[0], corners[1]);
  if (corners[1] > corners[2])
    std::swap(corners[1], corners[2]);
  if (corners[0] > corners[1])
    std::swap(corners[0], corners[1]);
  return corners;
}

class Regions
{
public:
  // Of cells, whose neighbors_of(c) are numbers, and those at the hull none of theirs; and of
  // triangles in ascending order, on n points.
  template <class Cells>
  Regions(const Cells& cells, std::size_t n, const std::vector<Corners>& triangles,
          const Executor& executor)
    : m_sets(cells.number)
    , m_is_cut(cells.number, 0)
    , m_walls(cells.number, 0)
  {
    find_facets(cells, n, triangles, executor);
  }

  // Triangles that are no facets.
  const std::vector<Corners>& missing() const { return m_missing; }

  // Cuts what meets the triangles of the tree, and unites the others.
  template <class Cells>
  void cut(const Box_tree& tree, const Cells& cells, const Executor& executor)
  {
    const std::size_t m = m_is_cut.size();
    std::vector<float> radii(m);
    for_each_block(executor, m, number_of_blocks(executor, m, 1024),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     for (std::size_t c = first; c < last; ++c) {
                       const std::array<Vector_3d, 4> corners = cells(c);
                       m_is_cut[c] = char(tree.meets(corners));
                       radii[c] = float(inradius(corners));
                     }
                   });
    for (std::size_t c = 0; c < m; ++c) {
      const auto neighbors = cells.neighbors_of(c);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto d = std::size_t(neighbors[k]);
        if (c < d && d < m && (m_walls[c] >> k & 1) == 0 && !m_is_cut[c] && !m_is_cut[d])
          m_sets.unite(std::uint32_t(c), std::uint32_t(d));
      }
    }
    find_largest(radii);
  }

  // One tetrahedron for each region, that with the largest inscribed sphere: the center of a flat
  // one may lie on the wrong side of the surface.
  std::uint32_t largest(std::uint32_t c) { return m_largest[m_sets.root(c)]; }
  bool is_cut(std::size_t c) const { return m_is_cut[c] != 0; }

private:
  static double inradius(const std::array<Vector_3d, 4>& p)
  {
    const Vector_3d a = minus(p[1], p[0]), b = minus(p[2], p[0]), c = minus(p[3], p[0]);
    const auto area = [](const Vector_3d& u, const Vector_3d& v) {
      const Vector_3d n = cross(u, v);
      return std::sqrt(dot(n, n));
    };
    const double areas = area(a, b) + area(b, c) + area(c, a) + area(minus(b, a), minus(c, a));
    return areas > 0 ? std::abs(dot(a, cross(b, c))) / areas : 0;
  }

  // The first of those that are equally large.
  void find_largest(const std::vector<float>& radii)
  {
    constexpr auto none = std::uint32_t(-1);
    m_largest.assign(radii.size(), none);
    for (std::uint32_t c = 0; c < radii.size(); ++c) {
      std::uint32_t& largest = m_largest[m_sets.root(c)];
      if (largest == none || radii[c] > radii[largest])
        largest = c;
    }
  }

  // Looks each facet up among the triangles with the same least vertex.
  template <class Cells>
  void find_facets(const Cells& cells, std::size_t n, const std::vector<Corners>& triangles,
                   const Executor& executor)
  {
    const auto lists = in_lists<std::uint32_t>(
        n,
        Listed_items(
            triangles.size(), [&](std::size_t t) { return std::size_t(triangles[t][0]); },
            [](std::size_t t) { return std::uint32_t(t); }),
        executor);
    std::vector<Corners> listed;
    listed.reserve(triangles.size());
    for (const std::uint32_t t : lists.items)
      listed.push_back(triangles[t]);
    for (std::size_t v = 0; v < n; ++v)
      std::sort(listed.begin() + std::ptrdiff_t(lists.first[v]),
                listed.begin() + std::ptrdiff_t(lists.first[v + 1]));
    std::vector<char> is_facet(listed.size(), 0);
    for_each_block(executor, cells.number, number_of_blocks(executor, cells.number, 4096),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     for (std::size_t c = first; c < last; ++c)
                       m_walls[c] = walls_of(cells, c, lists, listed, is_facet);
                   });
    for (std::size_t t = 0; t < listed.size(); ++t)
      if (!is_facet[t])
        m_missing.push_back(listed[t]);
    m_missing.erase(std::unique(m_missing.begin(), m_missing.end()), m_missing.end());
  }

  // Which facets of tetrahedron c are triangles, by their bits; between two the first one is asked.
  template <class Cells>
  static unsigned char walls_of(const Cells& cells, std::size_t c,
                                const Lists<std::uint32_t>& lists,
                                const std::vector<Corners>& listed, std::vector<char>& is_facet)
  {
    unsigned walls = 0;
    const auto neighbors = cells.neighbors_of(c);
    const auto v = cells.vertices_of(c);
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::size_t(neighbors[k]) < c)
        continue;
      const auto at = [&](std::size_t i) { return std::uint32_t(v[(k + i) % 4]); };
      const Corners facet = ascending({at(1), at(2), at(3)});
      const auto found =
          std::equal_range(listed.begin() + std::ptrdiff_t(lists.first[facet[0]]),
                           listed.begin() + std::ptrdiff_t(lists.first[facet[0] + 1]), facet);
      for (auto t = found.first; t != found.second; ++t)
        is_facet[std::size_t(t - listed.begin())] = 1;
      walls |= unsigned(found.first != found.second) << k;
    }
    return static_cast<unsigned char>(walls);
  }

  Disjoint_sets<std::uint32_t> m_sets;
  std::vector<char> m_is_cut;
  std::vector<unsigned char> m_walls;   // of each tetrahedron: bit k for the facet opposite to k
  std::vector<std::uint32_t> m_largest; // of each set, at its root
  std::vector<Corners> m_missing;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
