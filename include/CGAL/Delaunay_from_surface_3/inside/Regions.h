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
#include <numeric>
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
  // Of m tetrahedra vertices_of(c) on n points, and triangles in ascending order.
  template <class VerticesOf>
  Regions(std::size_t m, std::size_t n, const VerticesOf& vertices_of,
          const std::vector<Corners>& triangles, const Executor& executor)
    : m_sets(m)
    , m_is_cut(m, 0)
  {
    find_facets(m, n, vertices_of, triangles, executor);
  }

  // Triangles that are no facets, by their numbers.
  const std::vector<std::uint32_t>& missing() const { return m_missing; }

  // Cuts what meets the triangles of the tree, and unites the others.
  template <class CornersOf>
  void cut(const Box_tree& tree, const CornersOf& corners_of, const Executor& executor)
  {
    const std::size_t m = m_is_cut.size();
    std::vector<float> radii(m);
    for_each_block(executor, m, number_of_blocks(executor, m, 1024),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     for (std::size_t c = first; c < last; ++c) {
                       const std::array<Vector_3d, 4> corners = corners_of(c);
                       m_is_cut[c] = char(tree.meets(corners));
                       radii[c] = float(inradius(corners));
                     }
                   });
    for (const auto& [c, d] : m_pairs)
      if (!m_is_cut[c] && !m_is_cut[d])
        m_sets.unite(c, d);
    m_pairs = {};
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

  void find_largest(const std::vector<float>& radii)
  {
    m_largest.resize(radii.size());
    std::iota(m_largest.begin(), m_largest.end(), std::uint32_t(0));
    for (std::uint32_t c = 0; c < radii.size(); ++c) {
      std::uint32_t& largest = m_largest[m_sets.root(c)];
      if (radii[c] > radii[largest])
        largest = c;
    }
  }

  // Facet 4 c + k leaves out corner k.
  template <class VerticesOf>
  static Corners facet(const VerticesOf& vertices_of, std::size_t f)
  {
    const auto v = vertices_of(f / 4);
    const auto at = [&](std::size_t i) { return std::uint32_t(v[(f + i) % 4]); };
    return ascending({at(1), at(2), at(3)});
  }

  struct Item
  {
    std::uint64_t others;
    std::uint32_t number; // of a tetrahedron or triangle
    bool is_triangle;
  };
  struct Found
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<std::uint32_t> missing;
  };

  // At each vertex, facets and triangles whose least vertex it is, in the order of the two others.
  template <class VerticesOf>
  void find_facets(std::size_t m, std::size_t n, const VerticesOf& vertices_of,
                   const std::vector<Corners>& triangles, const Executor& executor)
  {
    const auto facets = in_lists<std::uint32_t>(
        n,
        Listed_items(
            4 * m, [&](std::size_t f) { return std::size_t(facet(vertices_of, f)[0]); },
            [](std::size_t f) { return std::uint32_t(f); }),
        executor);
    const auto lists = in_lists<std::uint32_t>(
        n,
        Listed_items(
            triangles.size(), [&](std::size_t t) { return std::size_t(triangles[t][0]); },
            [](std::size_t t) { return std::uint32_t(t); }),
        executor);
    const auto others = [](const Corners& c) { return std::uint64_t(c[1]) << 32 | c[2]; };
    std::vector<Found> found(number_of_blocks(executor, n, 4096));
    for_each_block(executor, n, found.size(),
                   [&](std::size_t first, std::size_t last, std::size_t block) {
                     std::vector<Item> items;
                     for (std::size_t v = first; v < last; ++v) {
                       items.clear();
                       for (const std::uint32_t* f = facets.begin(v); f != facets.end(v); ++f)
                         items.push_back({others(facet(vertices_of, *f)), *f / 4, false});
                       for (const std::uint32_t* t = lists.begin(v); t != lists.end(v); ++t)
                         items.push_back({others(triangles[*t]), *t, true});
                       match(items, found[block]);
                     }
                   });
    for (Found& part : found) {
      m_pairs.insert(m_pairs.end(), part.pairs.begin(), part.pairs.end());
      m_missing.insert(m_missing.end(), part.missing.begin(), part.missing.end());
      part = Found();
    }
  }

  // Two facets are a pair if no triangle lies between them; a triangle without a facet is missing.
  static void match(std::vector<Item>& items, Found& found)
  {
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
      return a.others != b.others ? a.others < b.others : a.is_triangle < b.is_triangle;
    });
    for (std::size_t first = 0, last = 0; first < items.size(); first = last) {
      while (last < items.size() && items[last].others == items[first].others)
        ++last;
      if (items[first].is_triangle)
        found.missing.push_back(items[first].number);
      else if (last - first == 2 && !items[first + 1].is_triangle)
        found.pairs.emplace_back(items[first].number, items[first + 1].number);
    }
  }

  Disjoint_sets<std::uint32_t> m_sets;
  std::vector<char> m_is_cut;
  std::vector<std::uint32_t> m_largest; // of each set, at its root
  std::vector<std::uint32_t> m_missing;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> m_pairs;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
