// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H

// The winding numbers of a closed surface at the centres of tetrahedra: whole numbers, 0 outside
// the hull, which change from one tetrahedron to the next by the triangles that the way crosses.
// Most triangles of a dense sample are facets; ways cross them there. The others are searched for.
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
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Cells>
class Regions
{
public:
  // Of positively oriented cells, whose neighbors_of(c) are numbers, and those at the hull none of
  // theirs.
  Regions(const Cells& cells, const std::vector<Corners>& triangles, const Executor& executor)
    : m_cells(cells)
    , m_executor(executor)
    , m_jumps(cells.number, Jumps{0, 0, 0, 0})
  {
    cross_facets(Triangle_table(triangles, cells.points.size()));
  }

  // The triangles that are no facets; each once, with how often it counts, which is not 0.
  const std::vector<Cutting_triangle>& no_facets() const { return m_no_facets; }

  // Of the triangles less those that close them. ask(c) is the number of tetrahedron c.
  template <class Ask>
  std::vector<std::int32_t> numbers(const std::vector<Triangle_3d>& closing, const Ask& ask)
  {
    std::vector<Cutting_triangle> cutting = m_no_facets;
    for (const Triangle_3d& t : closing)
      cutting.emplace_back(t, -1);
    if (!cutting.empty())
      cross_others(Box_tree(std::move(cutting)));
    join();
    const std::size_t m = m_cells.number;
    std::vector<std::int32_t> numbers(m);
    const Place outside = place(std::uint32_t(m));
    std::map<std::uint32_t, std::uint32_t> roundest; // of the regions not reached, by their roots
    for (std::uint32_t c = 0; c < m; ++c) {
      const Place p = place(c);
      numbers[c] = p.number - outside.number;
      if (p.root == outside.root)
        continue;
      std::uint32_t& best = roundest.emplace(p.root, c).first->second;
      if (inradius(m_cells(c)) > inradius(m_cells(best)))
        best = c;
    }
    if (roundest.empty())
      return numbers;
    std::map<std::uint32_t, std::int32_t> shifts;
    for (const auto& [root, c] : roundest)
      shifts[root] = std::int32_t(std::lround(ask(c))) - numbers[c];
    for (std::uint32_t c = 0; c < m; ++c) {
      const auto shift = shifts.find(place(c).root);
      if (shift != shifts.end())
        numbers[c] += shift->second;
    }
    return numbers;
  }

private:
  // Counts facets that are triangles, between two tetrahedra at the first one; keeps the triangles
  // that are none.
  void cross_facets(const Triangle_table& table)
  {
    std::vector<char> is_facet(table.size(), 0);
    for_each_block(m_executor, m_cells.number, number_of_blocks(m_executor, m_cells.number, 4096),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     Steps step(m_executor);
                     for (std::size_t c = first; c < last; ++c, step())
                       cross_facets_of(c, table, is_facet);
                   });
    table.for_each([&](std::uint32_t v, std::uint32_t r) {
      if (!is_facet[r] && table[r].number != 0)
        m_no_facets.emplace_back(Triangle_3d{m_cells.points[v], m_cells.points[table[r].middle],
                                             m_cells.points[table[r].greatest]},
                                 table[r].number);
    });
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

  void cross_others(const Box_tree& tree)
  {
    for_each_block(m_executor, m_cells.number, number_of_blocks(m_executor, m_cells.number, 1024),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     Steps step(m_executor);
                     for (std::size_t c = first; c < last; ++c, step()) {
                       const Jumps crossings = Crossings::of(tree, m_cells, c);
                       for (std::size_t k = 0; k < 4; ++k)
                         m_jumps[c][k] =
                             crossings[k] == unknown_jump || m_jumps[c][k] == unknown_jump
                                 ? std::int8_t(unknown_jump)
                                 : as_jump(crossings[k] + m_jumps[c][k]);
                     }
                   });
  }

  // A tetrahedron as one of a set; the number is its own less that of the root.
  struct Place
  {
    std::uint32_t root;
    std::int32_t number;
  };

  // Tetrahedra between which a way is known, and what is outside, the last one.
  void join()
  {
    const std::size_t m = m_cells.number;
    m_places.reserve(m + 1);
    for (std::uint32_t c = 0; c <= m; ++c)
      m_places.push_back({c, 0});
    Steps step(m_executor);
    for (std::size_t c = 0; c < m; ++c, step()) {
      const auto neighbors = m_cells.neighbors_of(c);
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t d = (std::min)(std::size_t(neighbors[k]), m);
        if (d < c || m_jumps[c][k] == unknown_jump)
          continue;
        const int back = d < m ? jump_to(d, c) : 0;
        if (back != unknown_jump)
          join(std::uint32_t(c), std::uint32_t(d), m_jumps[c][k] - back);
      }
    }
  }

  // The number of d is larger by the difference than that of c.
  void join(std::uint32_t c, std::uint32_t d, int difference)
  {
    const Place p = place(c), q = place(d);
    if (p.root < q.root) // and so they are no deep trees
      m_places[q.root] = {p.root, p.number + difference - q.number};
    else if (p.root > q.root)
      m_places[p.root] = {q.root, q.number - difference - p.number};
  }

  // Halves the path to the root; a root has the number 0.
  Place place(std::uint32_t c)
  {
    std::int32_t number = 0;
    while (m_places[c].root != c) {
      Place& p = m_places[c];
      const Place& next = m_places[p.root];
      p = {next.root, p.number + next.number};
      number += p.number;
      c = p.root;
    }
    return {c, number};
  }

  int jump_to(std::size_t d, std::size_t c) const
  {
    const Jumps& jumps = m_jumps[d];
    if ((jumps[0] | jumps[1] | jumps[2] | jumps[3]) == 0)
      return 0;
    const auto neighbors = m_cells.neighbors_of(d);
    std::size_t k = 0;
    while (std::size_t(neighbors[k]) != c)
      ++k;
    return jumps[k];
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
  const Executor& m_executor;
  std::vector<Cutting_triangle> m_no_facets;
  std::vector<Jumps> m_jumps;
  std::vector<Place> m_places;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
