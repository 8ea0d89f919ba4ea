// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FLAT_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FLAT_ARRAYS_H

// The arrays of points that lie in one plane, on one line, or at one place.
//
// In a plane: one point more, the apex, off the plane. The sphere through a triangle and the apex
// cuts the plane in the circle of the triangle, so the cells at the apex are the triangles of the
// Delaunay triangulation in the plane, infinite ones included, each with the apex on top. CGAL's
// perturbation of points on one circle is the same in both: raising the apex changes no sign, as
// the other four points of a test lie in one plane. So the kernel need not know of planes.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Compact_cell.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The triangles at the apex, the last vertex of what was built, as rows of eight entries: three
// vertices by `names`, three neighbours; the infinite ones last. Returns how many are finite, and how many there
// are.
template <class Index, class Id>
std::pair<std::size_t, std::size_t>
triangles_at(const Built<Id>& built, const std::vector<Index>& names, Page_array<Index>& rows)
{
  using Numbers = Compact_numbers<Id>;
  const Id apex = built.vertex_of[built.number_of_places - 1];
  const auto place_of_apex = [&](std::size_t c) { // 4: none
    const Id* const v = built.cells[c].v;
    return Numbers::is_dead(built.cells[c]) ? std::ptrdiff_t(4) : std::find(v, v + 4, apex) - v;
  };
  std::vector<Index> numbers(built.cells_end, -1);
  std::size_t finite = 0, all = 0;
  for (const bool is_infinite : {false, true}) {
    for (std::size_t c = 0; c < built.cells_end; ++c)
      if (place_of_apex(c) < 4 && Numbers::is_infinite(built.cells[c]) == is_infinite)
        numbers[c] = Index(all++);
    finite = is_infinite ? finite : all;
  }
  rows.allocate(8 * all);
  std::fill(rows.data(), rows.data() + 8 * all, Index(-1));
  for (std::size_t c = 0; c < built.cells_end; ++c)
    if (numbers[c] >= 0) {
      Index* const row = rows.data() + 8 * std::size_t(numbers[c]);
      for (std::size_t k = 0; k < 3; ++k) {
        const unsigned corner = facet_corners[place_of_apex(c)][k];
        row[k] = names[built.cells[c].v[corner]];
        row[4 + k] = numbers[built.cells[c].links[corner] >> 2];
      }
    }
  return {finite, all};
}

// The segments between points in `line`, indices that ascend along a line, as rows of eight: the
// segments first, then the infinite one at each end.
template <class Index>
Page_array<Index> segments_of(const std::vector<Index>& line)
{
  const std::size_t n = line.size();
  Page_array<Index> rows;
  rows.allocate(8 * (n + 1));
  std::fill(rows.data(), rows.data() + 8 * (n + 1), Index(-1));
  for (std::size_t k = 0; k + 1 < n; ++k) {
    Index* const row = rows.data() + 8 * k;
    row[0] = line[k], row[1] = line[k + 1];
    row[4] = k + 2 < n ? Index(k + 1) : Index(n);
    row[5] = k > 0 ? Index(k - 1) : Index(n - 1);
  }
  Index* const first = rows.data() + 8 * (n - 1); // before the first point, and after the last
  Index* const last = first + 8;
  first[0] = line.front(), first[4] = Index(n), first[5] = 0;
  last[0] = line.back(), last[4] = Index(n - 1), last[5] = Index(n - 2);
  return rows;
}

// The arrays of points on a line, or at one place. Throws if an Index cannot number their cells.
template <class Index>
Delaunay_3_arrays<Index> arrays_on_line(const Point_array& points)
{
  using Arrays = Delaunay_3_arrays<Index>;
  const std::size_t n = points.size();
  if (n >= std::size_t((std::numeric_limits<Index>::max)()))
    throw Too_few_ids(std::numeric_limits<Index>::digits);
  const auto point = [&](Index i) {
    const double* const p = points[std::size_t(i)];
    return std::array<double, 3>{p[0], p[1], p[2]};
  };
  std::vector<Index> sorted(n);
  std::iota(sorted.begin(), sorted.end(), Index(0));
  std::sort(sorted.begin(), sorted.end(), [&](Index i, Index j) {
    const auto p = point(i), q = point(j);
    return p != q ? p < q : i < j;
  });
  std::vector<Index> line, vertices_of_points(n);
  for (const Index i : sorted) {
    if (line.empty() || point(line.back()) != point(i))
      line.push_back(i);
    vertices_of_points[std::size_t(i)] = line.back();
  }
  if (line.size() > 1)
    return Arrays(1, line.size() - 1, line.size() + 1, segments_of(line),
                  std::move(vertices_of_points));
  if (line.empty())
    return Arrays();
  Page_array<Index> rows; // a vertex, and the infinite one
  rows.allocate(16);
  std::fill(rows.data(), rows.data() + 16, Arrays::none);
  rows[0] = line.front();
  rows[4] = 1, rows[12] = 0;
  return Arrays(0, 1, 2, std::move(rows), std::move(vertices_of_points));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FLAT_ARRAYS_H
