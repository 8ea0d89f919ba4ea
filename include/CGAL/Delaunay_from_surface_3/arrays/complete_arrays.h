// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H

// Arrays with neighbours and infinite cells, from the simplices alone.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/match_facets.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Compact_cell.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The corners of facet k, as a simplex beyond it has them: with a point there as their last one, it is
// positive where the simplex is. In a plane: has the same orientation.
template <std::size_t Corners>
constexpr std::size_t corner_beyond(std::size_t k, std::size_t i)
{
  if constexpr (Corners == 4)
    return facet_corners[k][i];
  else
    return Corners == 3 ? (k + 2 - i) % 3 : 1 - k;
}

// Arrays of simplices with this many corners, or nothing (see below). Infinite cells are linked along the edges that the finite
// facets of these share.
template <std::size_t Corners, class Index>
std::optional<Delaunay_3_arrays<Index>>
complete_simplices(const std::vector<std::array<Index, 4>>& simplices,
                   std::vector<Index> vertices_of_points, const Executor& executor)
{
  const std::size_t finite = simplices.size(), n = vertices_of_points.size();
  Page_array<Index> rows;
  rows.reserve(8 * (finite + 2 * n), 0); // no convex hull has more facets
  rows.touch(0, 8 * finite);
  for_each_part(finite, executor, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c)
      std::fill_n(std::copy_n(simplices[c].data(), 4, rows.data() + 8 * c), 4, Index(-1));
  });
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

// Entries of simplices beyond the dimension are -1, the others numbers of points. Nothing if their facets
// do not come in pairs, seen from two sides, or a surface is not closed.
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H
