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

template <std::size_t Corners, class Index>
void write_complete_rows(std::vector<std::array<Index, 4>>& cells, std::size_t number_of_points,
                         Page_array<Index>& rows, const Executor& executor)
{
  const auto view = [&] {
    return Corners_view<Index>{cells.empty() ? nullptr : cells[0].data(), 4, cells.size(), 1};
  };
  const std::size_t finite = cells.size();
  std::vector<char> has_neighbor(Corners * finite, 0);
  match_facets<Corners>(
      view(), number_of_points + 1,
      [&](std::size_t c, std::size_t k, std::size_t) { has_neighbor[Corners * c + k] = 1; },
      executor);
  for (std::size_t f = 0; f < has_neighbor.size(); ++f)
    if (!has_neighbor[f]) {
      std::array<Index, 4> infinite = {-1, -1, -1, -1};
      for (std::size_t i = 0; i + 1 < Corners; ++i)
        infinite[i] = cells[f / Corners][corner_beyond<Corners>(f % Corners, i)];
      cells.push_back(infinite);
    }
  rows.allocate(8 * cells.size());
  std::fill(rows.data(), rows.data() + 8 * cells.size(), Index(-1));
  for (std::size_t c = 0; c < cells.size(); ++c)
    std::copy_n(cells[c].data(), Corners, rows.data() + 8 * c);
  match_facets<Corners>(
      view(), number_of_points + 1,
      [&](std::size_t c, std::size_t k, std::size_t d) { rows[8 * c + 4 + k] = Index(d); },
      executor);
}

// `simplices` are taken; entries beyond the dimension are -1, the others numbers of points. Where facets
// do not come in pairs, links are missing.
template <class Index>
Delaunay_3_arrays<Index> complete_arrays(int dimension, std::vector<std::array<Index, 4>> simplices,
                                         std::vector<Index> vertices_of_points,
                                         const Executor& executor)
{
  const std::size_t finite = simplices.size(), n = vertices_of_points.size();
  Page_array<Index> rows;
  switch (dimension) {
  case 3:
    write_complete_rows<4>(simplices, n, rows, executor);
    break;
  case 2:
    write_complete_rows<3>(simplices, n, rows, executor);
    break;
  case 1:
    write_complete_rows<2>(simplices, n, rows, executor);
    break;
  case 0:
    simplices.push_back({-1, -1, -1, -1});
    rows.allocate(8 * simplices.size());
    std::fill(rows.data(), rows.data() + 8 * simplices.size(), Index(-1));
    for (std::size_t c = 0; c < simplices.size(); ++c) {
      rows[8 * c] = simplices[c][0];
      rows[8 * c + 4] = Index(simplices.size() - 1 - c);
    }
    break;
  default:
    return {};
  }
  return {dimension, finite, simplices.size(), std::move(rows), std::move(vertices_of_points)};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_COMPLETE_ARRAYS_H
