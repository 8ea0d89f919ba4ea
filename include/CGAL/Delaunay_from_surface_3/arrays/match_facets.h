// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MATCH_FACETS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MATCH_FACETS_H

// The neighbours of simplices, from their vertices alone: two that share a facet.

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The vertices of a facet in ascending order; 0 in place of those that it lacks. And whether they were
// swapped an odd number of times, from the order in which the simplex is oriented.
struct Facet_key
{
  std::uint32_t least = 0, middle = 0, greatest = 0;
  bool is_odd = false;
};

// Simplices: corner k of simplex c is rows[stride · c + k], one of 0, …, n-1.
template <class Index>
struct Corners_view
{
  const Index* rows;
  std::size_t stride;
  std::size_t number;
};

// The key of facet f: that of simplex f / Corners which leaves out corner f % Corners.
template <std::size_t Corners, class Index>
Facet_key key_of_facet(const Corners_view<Index>& simplices, std::size_t f)
{
  const Index* const row = simplices.rows + simplices.stride * (f / Corners);
  const auto vertex = [&](std::size_t i) {
    return std::uint32_t(row[(f % Corners + i) % Corners]);
  };
  Facet_key key;
  key.is_odd = (Corners - 1) * f % 2 != 0; // so many swaps bring the corner to the front
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

// Facets with the same least vertex, by the two others.
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

  // Returns the other one with these vertices, or `none` if this is the first.
  std::uint32_t add(const Facet_key& key, std::uint32_t number)
  {
    const std::uint64_t both = std::uint64_t(key.middle) << 32 | key.greatest;
    std::uint32_t& chain = m_chains[std::size_t(both * 0x9e3779b97f4a7c15 >> 32) & m_mask];
    for (std::uint32_t i = chain; i != none; i = m_entries[i].next)
      if (m_entries[i].both == both) {
        m_has_pairs_only &= !std::exchange(m_entries[i].has_partner, true);
        m_is_oriented &= m_entries[i].is_odd != key.is_odd;
        return m_entries[i].number;
      }
    m_entries.push_back({both, number, chain, key.is_odd, false});
    chain = std::uint32_t(m_entries.size() - 1);
    return none;
  }

  // Whether there never was a third one.
  bool has_pairs_only() const { return m_has_pairs_only; }
  // Whether the two of each pair are seen from two sides.
  bool is_oriented() const { return m_is_oriented; }

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
  bool m_has_pairs_only = true, m_is_oriented = true;
};

// What all the facets have that simplices share: at most two simplices each, and these on two sides.
struct Matched_facets
{
  bool are_pairs = true, are_oriented = true;
};

// Calls set(c, k, d) for facet k of simplex c and the simplex d across, both ways; a facet that has no
// partner is left out. If one has several the simplices are those of no triangulation. Throws if there are 2^30 simplices; `set` is called by several threads. Expected linear; 16 bytes
// for each simplex, and 4 for each of the n vertices.
template <std::size_t Corners, class Index, class Set>
Matched_facets match_facets(const Corners_view<Index>& simplices, std::size_t n, const Set& set,
                            const Executor& executor)
{
  const auto key = [&](std::size_t f) { return key_of_facet<Corners>(simplices, f); };
  const Lists<std::uint32_t> facets = in_lists<std::uint32_t>(
      n,
      Listed_items(
          Corners * simplices.number, [&](std::size_t f) { return std::size_t(key(f).least); },
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
    matched[b] = {table.has_pairs_only(), table.is_oriented()};
  });
  Matched_facets all;
  for (const Matched_facets& of_block : matched) {
    all.are_pairs &= of_block.are_pairs;
    all.are_oriented &= of_block.are_oriented;
  }
  return all;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MATCH_FACETS_H
