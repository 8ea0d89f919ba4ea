// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H

// Makes arrays with neighbours and infinite cells from the simplices alone.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Neighbours are found from the vertices alone: they are two simplices that share a facet.

// Holds the vertices of a facet in ascending order, with 0 for missing ones, and whether an odd
// permutation leads there from the order that the simplex induces.
struct Facet_key
{
  std::uint32_t least = 0, middle = 0, greatest = 0;
  bool is_odd = false;
};

// Refers to simplices: corner k of simplex c is rows[stride · c + k], one of 0, …, n-1.
template <class Index>
struct Corners_view
{
  const Index* rows;
  std::size_t stride;
  std::size_t number;
};

// Returns the key of facet f, which belongs to simplex f / Corners and omits corner f % Corners.
template <std::size_t Corners, class Index>
Facet_key key_of_facet(const Corners_view<Index>& simplices, std::size_t f)
{
  const Index* const row = simplices.rows + simplices.stride * (f / Corners);
  const auto vertex = [&](std::size_t i) {
    return std::uint32_t(row[(f % Corners + i) % Corners]);
  };
  Facet_key key;
  key.is_odd = (Corners - 1) * f % 2 != 0; // the parity of the rotation
  key.least = vertex(1);
  if constexpr (Corners > 2) {
    const std::uint32_t v = vertex(2);
    key.is_odd ^= v < key.least;
    key.middle = (std::max)(key.least, v);
    key.least = (std::min)(key.least, v);
  }
  if constexpr (Corners > 3) {
    const std::uint32_t v = vertex(3), m = (std::max)(key.least, v);
    key.is_odd ^= m == v && v < key.middle;
    key.least = (std::min)(key.least, v);
    key.greatest = (std::max)(key.middle, m);
    key.middle = (std::min)(key.middle, m);
  }
  return key;
}

// Tells whether every facet belongs to at most two simplices, and whether they are on both sides.
struct Matched_facets
{
  bool are_pairs = true, are_oriented = true;
};

// Finds facets with the same least vertex by their other vertices.
class Facet_table
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  void reset(std::size_t size)
  {
    m_entries.clear();
    m_mask = 15;
    while (m_mask < 2 * size)
      m_mask = 2 * m_mask + 1;
    m_chains.assign(m_mask + 1, none);
  }

  // Returns the earlier facet with these vertices, or `none` if this is the first.
  std::uint32_t add(const Facet_key& key, std::uint32_t number)
  {
    const std::uint64_t both = std::uint64_t(key.middle) << 32 | key.greatest;
    std::uint32_t& chain = m_chains[std::size_t(both * 0x9e3779b97f4a7c15 >> 32) & m_mask];
    for (std::uint32_t i = chain; i != none; i = m_entries[i].next)
      if (m_entries[i].both == both) {
        m_matched.are_pairs &= !std::exchange(m_entries[i].has_partner, true);
        m_matched.are_oriented &= m_entries[i].is_odd != key.is_odd;
        return m_entries[i].number;
      }
    m_entries.push_back({both, number, chain, key.is_odd, false});
    chain = std::uint32_t(m_entries.size() - 1);
    return none;
  }

  // Returns the result for all facets so far.
  const Matched_facets& matched() const { return m_matched; }

private:
  struct Entry
  {
    std::uint64_t both;
    std::uint32_t number, next;
    bool is_odd, has_partner;
  };

  std::vector<std::uint32_t> m_chains;
  std::size_t m_mask = 0;
  std::vector<Entry> m_entries;
  Matched_facets m_matched;
};

// Calls set(c, k, d) for facet k of simplex c and the simplex d across, both ways; a facet without
// a partner is skipped. If a facet has several, the simplices form no triangulation. Throws if
// there are 2^30 simplices; several threads call `set`. Expected linear; takes 16 bytes for each
// simplex, and 4 for each of the n vertices.
template <std::size_t Corners, class Index, class Set>
Matched_facets match_facets(const Corners_view<Index>& simplices, std::size_t n, const Set& set,
                            const Executor& executor)
{
  const auto key = [&](std::size_t f) { return key_of_facet<Corners>(simplices, f); };
  const Lists<std::uint32_t> facets =
      in_lists<std::uint32_t>(n,
                              Listed_items(
                                  Corners * simplices.number,
                                  [&](std::size_t f) {
                                    if (f % (1 << 16) == 0)
                                      executor.interruption_point();
                                    return std::size_t(key(f).least);
                                  },
                                  [](std::size_t f) { return std::uint32_t(f); }),
                              executor);
  const std::size_t blocks = number_of_blocks(executor, n, 4096);
  std::vector<Matched_facets> matched(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    Facet_table table;
    Steps step(executor);
    const std::uint32_t* const end = facets.items.data() + facets.items.size();
    for (std::size_t v = first; v < last; ++v) {
      table.reset(std::size_t(facets.end(v) - facets.begin(v)));
      step(std::size_t(facets.end(v) - facets.begin(v)));
      for (const std::uint32_t* f = facets.begin(v); f != facets.end(v); ++f) {
        if (end - f > std::ptrdiff_t(prefetch_distance))
          prefetch(simplices.rows + simplices.stride * (f[prefetch_distance] / Corners));
        const std::uint32_t g = table.add(key(*f), *f);
        if (g != Facet_table::none) {
          set(*f / Corners, *f % Corners, g / Corners);
          set(g / Corners, g % Corners, *f / Corners);
        }
      }
    }
    matched[b] = table.matched();
  });
  Matched_facets all;
  for (const Matched_facets& of_block : matched) {
    all.are_pairs &= of_block.are_pairs;
    all.are_oriented &= of_block.are_oriented;
  }
  return all;
}

// Returns corner i of facet k in the order of an infinite cell beyond it: with a point there as
// last corner, this cell has the orientation of the simplex, except on a line.
template <std::size_t Corners>
constexpr std::size_t corner_beyond(std::size_t k, std::size_t i)
{
  if constexpr (Corners == 4)
    return facet_corners[k][i];
  else
    return Corners == 3 ? (k + 2 - i) % 3 : 1 - k;
}

// Returns arrays of simplices with this many corners, or nothing (see complete_arrays()). Infinite
// cells are linked where their finite facets share an edge, or a vertex in a plane.
template <std::size_t Corners, class Index>
std::optional<Delaunay_3_arrays<Index>>
complete_simplices(const std::vector<std::array<Index, 4>>& simplices,
                   std::vector<Index> vertices_of_points, const Executor& executor)
{
  const std::size_t finite = simplices.size(), n = vertices_of_points.size();
  Page_array<Index> rows;
  rows.reserve(8 * (finite + 2 * n), 0); // no convex hull has more facets
  rows.touch(0, 8 * finite);
  Steps step(executor);
  for (std::size_t c = 0; c < finite; ++c, step())
    std::fill_n(std::copy_n(simplices[c].data(), 4, rows.data() + 8 * c), 4, Index(-1));
  const auto link = [](Index* cells, std::size_t c, std::size_t k, std::size_t d) {
    cells[8 * c + 4 + k] = Index(d);
  };
  const Matched_facets inner = match_facets<Corners>(
      Corners_view<Index>{rows.data(), 8, finite}, n,
      [&](std::size_t c, std::size_t k, std::size_t d) { link(rows.data(), c, k, d); }, executor);
  Index* const infinite = rows.data() + 8 * finite;
  std::size_t hull = 0;
  for (std::size_t c = 0; c < finite; ++c)
    for (std::size_t k = 0; k < Corners; ++k)
      if (rows[8 * c + 4 + k] < 0) {
        if (hull == 2 * n)
          return std::nullopt;
        link(rows.data(), c, k, finite + hull);
        Index* const row = infinite + 8 * hull;
        rows.touch(8 * (finite + hull), 8 * (finite + hull + 1));
        std::fill_n(row, 8, Index(-1));
        for (std::size_t i = 0; i + 1 < Corners; ++i)
          row[i] = rows[8 * c + corner_beyond<Corners>(k, i)];
        link(infinite, hull++, Corners - 1, c);
      }
  Matched_facets outer;
  std::size_t linked = 0;
  const auto link_to_infinite = [&](std::size_t h, std::size_t k, std::size_t g) {
    link(infinite, h, k, finite + g);
    ++linked;
  };
  if constexpr (Corners > 2)
    outer = match_facets<Corners - 1>(Corners_view<Index>{infinite, 8, hull}, n, link_to_infinite,
                                      Alone());
  else if (hull == 2) {
    link_to_infinite(0, 0, 1);
    link_to_infinite(1, 0, 0);
  }
  if (!inner.are_pairs || !outer.are_pairs || linked != (Corners - 1) * hull ||
      (Corners > 2 && !(inner.are_oriented && outer.are_oriented)))
    return std::nullopt;
  return Delaunay_3_arrays<Index>(int(Corners) - 1, finite, finite + hull, std::move(rows),
                                  std::move(vertices_of_points));
}

// Returns the arrays of simplices whose entries beyond the dimension are -1; other entries are
// numbers of points. Returns nothing if a facet belongs to more than two simplices, or to two on
// the same side, or if the facets of the hull do not form a closed surface.
template <class Index>
std::optional<Delaunay_3_arrays<Index>>
complete_arrays(int dimension, const std::vector<std::array<Index, 4>>& simplices,
                std::vector<Index> vertices_of_points, const Executor& executor)
{
  switch (dimension) {
  case 3:
    return complete_simplices<4>(simplices, std::move(vertices_of_points), executor);
  case 2:
    return complete_simplices<3>(simplices, std::move(vertices_of_points), executor);
  case 1:
    return complete_simplices<2>(simplices, std::move(vertices_of_points), executor);
  case 0: {
    if (simplices.size() != 1)
      return std::nullopt;
    Page_array<Index> rows;
    rows.allocate(16);
    std::fill_n(rows.data(), 16, Index(-1));
    rows[0] = simplices[0][0];
    rows[4] = 1;
    rows[12] = 0;
    return Delaunay_3_arrays<Index>(0, 1, 2, std::move(rows), std::move(vertices_of_points));
  }
  default:
    return Delaunay_3_arrays<Index>();
  }
}

// Lists the vertices that are joined with v by an edge: items[first[v]], …, items[first[v+1] - 1],
// in ascending order.
template <class Index>
struct Adjacent_vertices
{
  std::vector<std::int64_t> first;
  std::vector<Index> items;
};

// Lists the edges of `number` simplices with corners vertex_of(c, k), k < corners, on n vertices.
// Linear, apart from sorting the lists.
template <class Index, class VertexOf>
Adjacent_vertices<Index> adjacent_vertices(std::size_t number, std::size_t corners, std::size_t n,
                                           const VertexOf& vertex_of, const Executor& executor)
{
  const Lists<std::uint32_t> simplices =
      in_lists<std::uint32_t>(n,
                              Listed_items(
                                  corners * number,
                                  [&](std::size_t i) {
                                    if (i % (1 << 16) == 0)
                                      executor.interruption_point();
                                    return std::size_t(vertex_of(i / corners, i % corners));
                                  },
                                  [=](std::size_t i) { return std::uint32_t(i / corners); }),
                              executor);
  const std::size_t blocks = number_of_blocks(executor, n, 4096);
  std::vector<std::vector<Index>> items(blocks);
  Adjacent_vertices<Index> adjacent;
  adjacent.first.assign(n + 1, 0);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    std::vector<Index> met_by(n, Index(-1));
    Steps step(executor);
    for (std::size_t v = first; v < last; ++v) {
      const std::size_t begin = items[b].size();
      met_by[v] = Index(v);
      step(corners * std::size_t(simplices.end(v) - simplices.begin(v)));
      for (const std::uint32_t* c = simplices.begin(v); c != simplices.end(v); ++c)
        for (std::size_t k = 0; k < corners; ++k) {
          const Index w = vertex_of(*c, k);
          if (met_by[std::size_t(w)] != Index(v)) {
            met_by[std::size_t(w)] = Index(v);
            items[b].push_back(w);
          }
        }
      std::sort(items[b].begin() + std::ptrdiff_t(begin), items[b].end());
      adjacent.first[v + 1] = std::int64_t(items[b].size() - begin);
    }
  });
  for (std::size_t v = 0; v < n; ++v)
    adjacent.first[v + 1] += adjacent.first[v];
  executor.interruption_point();
  adjacent.items.reserve(std::size_t(adjacent.first[n]));
  for (const std::vector<Index>& part : items)
    adjacent.items.insert(adjacent.items.end(), part.begin(), part.end());
  return adjacent;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H
