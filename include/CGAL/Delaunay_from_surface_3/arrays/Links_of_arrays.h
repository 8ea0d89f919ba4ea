// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_LINKS_OF_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_LINKS_OF_ARRAYS_H

// What can be checked of arrays without looking at points.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/are_links_spheres.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
class Links_of_arrays
{
  using Arrays = Delaunay_3_arrays<Index>;
  using Cell = std::array<Index, 4>;

public:
  // Keeps references. Neighbours and infinite cells are still there.
  Links_of_arrays(const Arrays& arrays, const Executor& executor)
    : m_arrays(arrays)
    , m_executor(executor)
    , m_corners(std::size_t(arrays.dimension() + 1))
  {
  }

  // Whether neighbours lead back, and the vertices are right.
  bool are_valid() const
  {
    return have_vertices() && holds_for_all(m_executor, m_arrays.number_of_cells(),
                                            [&](std::size_t c) { return has_neighbors(c); });
  }

  // Whether vertices are points, each the first of those at its place and in a cell.
  bool have_vertices() const
  {
    if (!holds_for_all(m_executor, m_arrays.number_of_cells(),
                       [&](std::size_t c) { return has_vertices(c); }))
      return false;
    std::vector<char> is_in_cell(m_arrays.number_of_points());
    Steps step(m_executor);
    for (std::size_t c = 0; c < m_arrays.number_of_cells(); ++c, step())
      for (std::size_t k = 0; k < m_corners; ++k)
        if (const Index v = m_arrays.vertices(c)[k]; v != Arrays::none)
          is_in_cell[std::size_t(v)] = 1;
    for (std::size_t i = 0; i < is_in_cell.size(); ++i) {
      const Index v = m_arrays.vertex_of_point(i);
      if (v < 0 || std::size_t(v) > i || is_in_cell[std::size_t(v)] == 0 ||
          m_arrays.vertex_of_point(std::size_t(v)) != v)
        return false;
    }
    return true;
  }

  // Which vertex of the neighbour lies opposite to vertex k of cell c; m_corners if none fits.
  std::size_t place_across(std::size_t c, std::size_t k) const
  {
    const Cell there = m_arrays.neighbors(std::size_t(m_arrays.neighbors(c)[k]));
    return std::size_t(
        std::find(there.begin(), there.begin() + std::ptrdiff_t(m_corners), Index(c)) -
        there.begin());
  }

  // Whether there is a sphere around each vertex, if links are valid; and whether all is connected.
  bool are_spheres() const
  {
    const std::size_t cells = m_arrays.number_of_cells(), n = m_arrays.number_of_vertices() + 1;
    if (!is_connected())
      return false;
    switch (m_arrays.dimension()) {
    case 0:
      return cells == 2 && n == 2;
    case 1:
      return cells == n;
    case 2:
      return cells + 4 == 2 * n;
    default:
      using Id = std::make_unsigned_t<Index>; // the infinite vertex is number 0
      return are_links_spheres<Id>(
          cells, m_arrays.number_of_points() + 1,
          [&](std::size_t c, unsigned k) {
            return Id(m_arrays.vertices_data()[c * m_arrays.stride() + k] + 1);
          },
          m_executor);
    }
  }

private:
  bool has_vertices(std::size_t c) const
  {
    const Cell v = m_arrays.vertices(c);
    for (std::size_t k = 0; k < m_corners; ++k) {
      const bool is_infinite = v[k] == Arrays::none;
      if (is_infinite ? !m_arrays.is_infinite(Index(c))
                      : v[k] < 0 || std::size_t(v[k]) >= m_arrays.number_of_points() ||
                            m_arrays.vertex_of_point(std::size_t(v[k])) != v[k])
        return false;
      if (std::find(v.begin(), v.begin() + std::ptrdiff_t(k), v[k]) !=
          v.begin() + std::ptrdiff_t(k))
        return false; // twice
    }
    return !m_arrays.is_infinite(Index(c)) ||
           std::count(v.begin(), v.begin() + std::ptrdiff_t(m_corners), Arrays::none) == 1;
  }

  bool has_neighbors(std::size_t c) const
  {
    for (std::size_t k = 0; k < m_corners; ++k) {
      const Index d = m_arrays.neighbors(c)[k];
      if (d < 0 || std::size_t(d) >= m_arrays.number_of_cells() || std::size_t(d) == c ||
          place_across(c, k) == m_corners)
        return false;
      if (m_corners > 1 && !shares_facet(c, k))
        return false;
    }
    return true;
  }

  // The facet is the same, and seen from the other side: with the vertex across in place of vertex
  // k the cell is the neighbour, turned inside out. Segments need not be oriented alike.
  bool shares_facet(std::size_t c, std::size_t k) const
  {
    const Cell there = m_arrays.vertices(std::size_t(m_arrays.neighbors(c)[k]));
    Cell v = m_arrays.vertices(c);
    v[k] = there[place_across(c, k)];
    bool is_odd = false;
    for (std::size_t i = 0; i < m_corners; ++i) {
      const auto last = v.begin() + std::ptrdiff_t(m_corners);
      const auto found = std::find(v.begin() + std::ptrdiff_t(i), last, there[i]);
      if (found == last)
        return false;
      is_odd = is_odd != (found != v.begin() + std::ptrdiff_t(i));
      std::iter_swap(found, v.begin() + std::ptrdiff_t(i));
    }
    return is_odd || m_corners == 2;
  }

  bool is_connected() const
  {
    std::size_t parts = m_arrays.number_of_cells();
    Disjoint_sets<Index> sets(parts);
    Steps step(m_executor);
    for (std::size_t c = 0; c < m_arrays.number_of_cells(); ++c, step())
      for (std::size_t k = 0; k < m_corners; ++k)
        if (const Index d = m_arrays.neighbors(c)[k]; std::size_t(d) < c && sets.unite(Index(c), d))
          --parts;
    return parts <= 1;
  }

  const Arrays& m_arrays;
  const Executor& m_executor;
  const std::size_t m_corners; // of a cell
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_LINKS_OF_ARRAYS_H
