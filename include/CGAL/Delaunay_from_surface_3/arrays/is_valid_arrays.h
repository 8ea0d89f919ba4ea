// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_IS_VALID_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_IS_VALID_ARRAYS_H

// What of arrays is checked by the points: the core's predicates, on cells that are put together
// here.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Delaunay_validity_level.h>
#include <CGAL/Delaunay_from_surface_3/arrays/Links_of_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/apex_of_plane.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Arrays of dimension 2 or 3, cell by cell: in a plane each triangle with an apex off it on top
// (flat_arrays.h).
template <class Index>
class Cells_of_arrays
{
  using Arrays = Delaunay_3_arrays<Index>;
  using Id = std::make_unsigned_t<Index>;
  using Complex = Compact_complex<Id>;

public:
  // Keeps references. The links are valid; the dimension is that of the points.
  Cells_of_arrays(const Arrays& arrays, const Point_array& points, const Starting_simplex& simplex)
    : m_arrays(arrays)
    , m_vertices(vertices_of(points, simplex))
  {
    if (is_flat() && arrays.number_of_simplices() > 0)
      m_is_turned = sign_of_cell(cell(0)) < 0;
  }

  // Whether cells are positive and, if that is asked, in conflict with no vertex across a facet, which is
  // the same from both sides. In one pass.
  bool are_right(bool are_without_conflict, const Executor& executor) const
  {
    const Links_of_arrays<Index> links(m_arrays, executor);
    return holds_for_all(executor, m_arrays.number_of_cells(), [&](std::size_t c) {
      const Compact_cell<Id> here = cell(c);
      if (!m_arrays.is_infinite(Index(c)) && sign_of_cell(here) <= 0)
        return false;
      Insertion_counts uncounted;
      Compact_predicates<Id> predicates(m_vertices.complex, uncounted);
      const auto neighbors = m_arrays.neighbors(c), corners = m_arrays.vertices(c);
      for (int k = 0; are_without_conflict && k <= m_arrays.dimension(); ++k) {
        const std::size_t d = std::size_t(neighbors[k]);
        if (d < c && corners[k] != Arrays::none)
          continue; // seen from there
        const Index across = m_arrays.vertices(d)[links.place_across(c, std::size_t(k))];
        if (across != Arrays::none && predicates.is_in_conflict(here, vertex(across)))
          return false;
      }
      return true;
    });
  }

private:
  // The vertices, in the order of the points; of the cells none is used.
  static Ordered_complex<Id> vertices_of(const Point_array& points, const Starting_simplex& simplex)
  {
    std::vector<std::size_t> numbers(points.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    const Order_view order = {numbers.data(), numbers.size(), nullptr, 0, nullptr};
    Watcher nobody;
    if (simplex.dimension == 3)
      return Ordered_complex<Id>(points, order, nullptr, nobody);
    const auto apex = apex_of_plane(points[simplex.points[0]], points[simplex.points[1]],
                                    points[simplex.points[2]]);
    return Ordered_complex<Id>(points, order, apex.data(), nobody);
  }

  bool is_flat() const { return m_arrays.dimension() == 2; }
  static Id vertex(Index i) { return i == Arrays::none ? Complex::infinite : Id(i) + 1; }

  // With the infinite vertex last.
  Compact_cell<Id> cell(std::size_t c) const
  {
    const auto v = m_arrays.vertices(c);
    Compact_cell<Id> cell = {
        {vertex(v[0]), vertex(v[1]), vertex(v[2]),
         is_flat() ? Complex::vertex_of_point(m_arrays.number_of_points()) : vertex(v[3])},
        {0, 0, 0, 0}};
    if (m_is_turned)
      std::swap(cell.v[0], cell.v[1]);
    const auto infinite = std::find(cell.v, cell.v + 4, Complex::infinite) - cell.v;
    if (infinite < 3) { // two swaps are an even permutation
      std::swap(cell.v[infinite], cell.v[3]);
      std::swap(cell.v[(infinite + 1) % 3], cell.v[(infinite + 2) % 3]);
    }
    return cell;
  }

  int sign_of_cell(const Compact_cell<Id>& cell) const
  {
    const auto at = [&](unsigned k) { return m_vertices.complex.exact_coordinates(cell.v[k]); };
    return orientation(at(0), at(1), at(2), at(3));
  }

  const Arrays& m_arrays;
  const Ordered_complex<Id> m_vertices;
  bool m_is_turned = false; // triangles are seen from the other side than the apex
};

// On a line: whether the segments are those between neighbours.
template <class Index>
bool is_line_of_segments(const Delaunay_3_arrays<Index>& arrays, const Point_array& points)
{
  const auto point = [&](Index i) {
    const double* const p = points[std::size_t(i)];
    return std::array<double, 3>{p[0], p[1], p[2]};
  };
  std::vector<std::pair<Index, Index>> segments;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    const auto v = arrays.vertices(c);
    segments.push_back(point(v[0]) < point(v[1]) ? std::make_pair(v[0], v[1])
                                                 : std::make_pair(v[1], v[0]));
  }
  std::sort(segments.begin(), segments.end(),
            [&](const auto& s, const auto& t) { return point(s.first) < point(t.first); });
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (!(point(segments[k].first) < point(segments[k].second)) ||
        (k > 0 && segments[k - 1].second != segments[k].first))
      return false;
  return true;
}

// Whether they are those of these points, if their links are known to be right.
template <class Index>
bool is_valid_if_linked(const Delaunay_3_arrays<Index>& arrays, const Point_array& points,
                        Delaunay_validity_level level, const Executor& executor)
{
  using Level = Delaunay_validity_level;
  const Links_of_arrays<Index> links(arrays, executor);
  if (arrays.number_of_points() != points.size() || !links.have_vertices() ||
      (level >= Level::EULER && points.size() > 0 && !links.are_spheres()))
    return false;
  if (level < Level::ORIENTATION)
    return true;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::equal(points[i], points[i] + 3, points[std::size_t(arrays.vertex_of_point(i))]))
      return false;
  const Starting_simplex simplex =
      starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
  if (simplex.dimension != arrays.dimension())
    return false;
  if (simplex.dimension < 1)
    return true;
  if (simplex.dimension == 1)
    return is_line_of_segments(arrays, points);
  const Cells_of_arrays<Index> cells(arrays, points, simplex);
  return cells.are_right(level >= Level::DELAUNAY, executor);
}

// Whether they are those of these points. Neighbours and infinite cells are still there.
template <class Index>
bool is_valid(const Delaunay_3_arrays<Index>& arrays, const Point_array& points,
              Delaunay_validity_level level, const Executor& executor = Alone())
{
  return Links_of_arrays<Index>(arrays, executor).are_valid() &&
         is_valid_if_linked(arrays, points, level, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_IS_VALID_ARRAYS_H
