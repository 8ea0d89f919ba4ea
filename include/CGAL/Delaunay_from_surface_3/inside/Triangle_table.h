// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_TRIANGLE_TABLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_TRIANGLE_TABLE_H

// The triangles of a surface by their vertices: how often the surface has each, those turned round
// taken off. Most facets of a triangulation are none, as a word for each vertex tells.

#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Corners = std::array<std::uint32_t, 3>;

// Without branches, which nobody could foretell.
inline Corners ascending(const Corners& t)
{
  const std::uint32_t low = (std::min)(t[0], t[1]), high = (std::max)(t[0], t[1]);
  return {(std::min)(low, t[2]), (std::max)(low, (std::min)(high, t[2])), (std::max)(high, t[2])};
}

// Whether ascending order turns three different vertices round.
inline bool is_turned(const Corners& t)
{
  return ((t[0] > t[1]) != (t[1] > t[2])) != (t[0] > t[2]);
}

class Triangle_table
{
public:
  struct Row
  {
    std::uint32_t middle, greatest;
    int number; // how often these, with the least vertex first, are in order, less how often turned
  };

  static constexpr std::uint32_t none = std::uint32_t(-1);

  // Of triangles on n vertices.
  Triangle_table(const std::vector<Corners>& triangles, std::size_t n)
    : m_first(n + 1, 0)
    , m_words(n, 0)
  {
    for (const Corners& t : triangles)
      ++m_first[ascending(t)[0] + 1];
    for (std::size_t v = 0; v < n; ++v)
      m_first[v + 1] += m_first[v];
    m_rows.resize(triangles.size());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (const Corners& triangle : triangles) {
      const Corners t = ascending(triangle);
      m_rows[next[t[0]]++] = {t[1], t[2], is_turned(triangle) ? -1 : 1};
      m_words[t[0]] |= bit(t[1], t[2]);
    }
    unite_equal_ones();
  }

  std::size_t size() const { return m_rows.size(); }
  const Row& operator[](std::size_t r) const { return m_rows[r]; }

  // The row of three vertices in ascending order.
  std::uint32_t find(const Corners& t) const
  {
    if ((m_words[t[0]] & bit(t[1], t[2])) == 0)
      return none;
    const auto first = m_rows.begin() + std::ptrdiff_t(m_first[t[0]]),
               last = m_rows.begin() + std::ptrdiff_t(m_first[t[0] + 1]);
    const Row row = {t[1], t[2], 0};
    const auto found = std::lower_bound(first, last, row, is_less);
    return found != last && !is_less(row, *found) ? std::uint32_t(found - m_rows.begin()) : none;
  }

  // Calls visit(least vertex, number of a row) for all.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    for (std::size_t v = 0; v + 1 < m_first.size(); ++v)
      for (std::uint32_t r = m_first[v]; r < m_first[v + 1]; ++r)
        visit(std::uint32_t(v), r);
  }

private:
  static std::uint64_t bit(std::uint32_t middle, std::uint32_t greatest)
  {
    return std::uint64_t(1) << ((middle * 0x9e3779b1u ^ greatest * 0x85ebca6bu) >> 26);
  }
  static bool is_less(const Row& r, const Row& s)
  {
    return std::tie(r.middle, r.greatest) < std::tie(s.middle, s.greatest);
  }

  void unite_equal_ones()
  {
    std::uint32_t end = 0;
    for (std::size_t v = 0; v < m_words.size(); ++v) {
      const std::uint32_t first = std::exchange(m_first[v], end), last = m_first[v + 1];
      std::sort(m_rows.begin() + std::ptrdiff_t(first), m_rows.begin() + std::ptrdiff_t(last),
                is_less);
      for (std::uint32_t r = first; r < last; ++r)
        if (end > m_first[v] && !is_less(m_rows[end - 1], m_rows[r]))
          m_rows[end - 1].number += m_rows[r].number;
        else
          m_rows[end++] = m_rows[r];
    }
    m_first.back() = end;
    m_rows.resize(end);
  }

  std::vector<std::uint32_t> m_first; // row of each vertex
  std::vector<Row> m_rows;
  std::vector<std::uint64_t> m_words; // of each vertex: the bits of its rows
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_TRIANGLE_TABLE_H
