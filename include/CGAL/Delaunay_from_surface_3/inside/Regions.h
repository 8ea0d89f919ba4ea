// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H

// The winding numbers of a closed surface at the centres of tetrahedra: whole numbers, 0 outside the
// hull, which change from one tetrahedron to the next by the triangles that the way crosses. Most
// triangles of a dense sample are facets; the ways cross them there. The others are searched for.
//
// Where no way is known a region remains without a number, and one of its tetrahedra is asked: that
// with the largest inscribed sphere, as the centre of a flat one may lie on the wrong side.
// Expected linear, but for what is no facet.

#include <CGAL/Delaunay_from_surface_3/inside/Box_tree.h>
#include <CGAL/Delaunay_from_surface_3/inside/Crossings.h>
#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/Triangle_table.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vector_products.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Cells>
class Regions
{
  static constexpr std::int32_t none = (std::numeric_limits<std::int32_t>::max)();

public:
  // Of positively oriented cells, whose neighbors_of(c) are numbers, and those at the hull none of
  // theirs. The triangles less those that close them are closed.
  Regions(const Cells& cells, const std::vector<Corners>& triangles,
          const std::vector<Triangle_3d>& closing, const Executor& executor)
    : m_cells(cells)
    , m_jumps(cells.number, Jumps{0, 0, 0, 0})
    , m_numbers(cells.number, none)
  {
    std::vector<Cutting_triangle> cutting =
        cross_facets(Triangle_table(triangles, cells.points.size()), executor);
    for (const Triangle_3d& t : closing)
      cutting.emplace_back(t, -1);
    if (!cutting.empty())
      cross_others(Box_tree(std::move(cutting)), executor);
  }

  // ask(c) is the number of tetrahedron c.
  template <class Ask>
  std::vector<std::int32_t> numbers(const Ask& ask)
  {
    std::vector<std::uint32_t> reached;
    for (std::uint32_t c = 0; c < m_numbers.size(); ++c) {
      const auto neighbors = m_cells.neighbors_of(c);
      for (std::size_t k = 0; k < 4; ++k)
        if (std::size_t(neighbors[k]) >= m_numbers.size() && m_jumps[c][k] != unknown_jump) {
          m_numbers[c] = -m_jumps[c][k];
          reached.push_back(c);
          break;
        }
    }
    spread(reached, false);
    for (std::uint32_t c = 0; c < m_numbers.size(); ++c)
      if (m_numbers[c] == none) {
        m_numbers[c] = 0;
        reached.assign(1, c);
        spread(reached, true);
        const std::uint32_t round = roundest(reached);
        const std::int32_t shift = std::int32_t(std::lround(ask(round))) - m_numbers[round];
        for (const std::uint32_t d : reached)
          m_numbers[d] += shift;
      }
    return std::move(m_numbers);
  }

private:
  // Counts facets that are triangles, between two tetrahedra at the first one; returns the triangles that are none.
  std::vector<Cutting_triangle> cross_facets(const Triangle_table& table, const Executor& executor)
  {
    std::vector<char> is_facet(table.size(), 0);
    for_each_block(executor, m_cells.number, number_of_blocks(executor, m_cells.number, 4096),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     for (std::size_t c = first; c < last; ++c)
                       cross_facets_of(c, table, is_facet);
                   });
    std::vector<Cutting_triangle> others;
    table.for_each([&](std::uint32_t v, std::uint32_t r) {
      if (!is_facet[r] && table[r].number != 0)
        others.emplace_back(Triangle_3d{m_cells.points[v], m_cells.points[table[r].middle],
                                        m_cells.points[table[r].greatest]},
                            table[r].number);
    });
    return others;
  }

  void cross_facets_of(std::size_t c, const Triangle_table& table, std::vector<char>& is_facet)
  {
    const auto neighbors = m_cells.neighbors_of(c);
    const auto v = m_cells.vertices_of(c);
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::size_t(neighbors[k]) < c)
        continue;
      const auto at = [&](std::size_t i) { return std::uint32_t(v[(k + i) % 4]); };
      const Corners facet = {at(1), at(2), at(3)};
      const std::uint32_t r = table.find(ascending(facet));
      if (r == Triangle_table::none)
        continue;
      is_facet[r] = 1;
      const bool is_inward = is_turned(facet) != (k % 2 == 1); // if its vertices ascend
      m_jumps[c][k] = as_jump(is_inward ? table[r].number : -table[r].number);
    }
  }

  void cross_others(const Box_tree& tree, const Executor& executor)
  {
    for_each_block(executor, m_cells.number, number_of_blocks(executor, m_cells.number, 1024),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     for (std::size_t c = first; c < last; ++c) {
                       const Jumps crossings = Crossings::of(tree, m_cells, c);
                       for (std::size_t k = 0; k < 4; ++k)
                         m_jumps[c][k] =
                             crossings[k] == unknown_jump || m_jumps[c][k] == unknown_jump
                                 ? std::int8_t(unknown_jump)
                                 : as_jump(crossings[k] + m_jumps[c][k]);
                     }
                   });
  }

  // From the tetrahedra that are reached, to all that can be; these are kept, or used up.
  void spread(std::vector<std::uint32_t>& reached, bool are_kept)
  {
    for (std::size_t next = 0; next < reached.size();) {
      const std::uint32_t c = reached[are_kept ? next++ : reached.size() - 1];
      if (!are_kept)
        reached.pop_back();
      const auto neighbors = m_cells.neighbors_of(c);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto d = std::size_t(neighbors[k]);
        if (d >= m_numbers.size() || m_numbers[d] != none || m_jumps[c][k] == unknown_jump)
          continue;
        const int back = jump_to(d, c);
        if (back == unknown_jump)
          continue;
        m_numbers[d] = m_numbers[c] + m_jumps[c][k] - back;
        reached.push_back(std::uint32_t(d));
      }
    }
  }

  int jump_to(std::size_t d, std::size_t c) const
  {
    const Jumps& jumps = m_jumps[d];
    if (jumps == Jumps{0, 0, 0, 0})
      return 0;
    const auto neighbors = m_cells.neighbors_of(d);
    std::size_t k = 0;
    while (std::size_t(neighbors[k]) != c)
      ++k;
    return jumps[k];
  }

  // The first of those that are equally round.
  std::uint32_t roundest(const std::vector<std::uint32_t>& some) const
  {
    return *std::max_element(some.begin(), some.end(), [&](std::uint32_t c, std::uint32_t d) {
      return inradius(m_cells(c)) < inradius(m_cells(d));
    });
  }

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

  const Cells& m_cells;
  std::vector<Jumps> m_jumps;
  std::vector<std::int32_t> m_numbers;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
