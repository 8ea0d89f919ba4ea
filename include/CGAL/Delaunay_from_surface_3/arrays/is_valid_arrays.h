// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_IS_VALID_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_IS_VALID_ARRAYS_H

// Checks arrays against their points by the core's predicates, on cells that are put together here.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Delaunay_validity_level.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
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
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Checks the properties of arrays that do not depend on coordinates.

template <class Index>
class Links_of_arrays
{
  using Arrays = Delaunay_3_arrays<Index>;
  using Cell = std::array<Index, 4>;

public:
  // Keeps references. The arrays must still have neighbours and infinite cells.
  Links_of_arrays(const Arrays& arrays, const Executor& executor, bool may_hide_points = false)
    : m_arrays(arrays)
    , m_executor(executor)
    , m_may_hide_points(may_hide_points)
    , m_corners(std::size_t(arrays.dimension() + 1))
  {
  }

  // Returns whether have_vertices() holds and all neighbours lead back.
  bool are_valid() const
  {
    return have_vertices() && holds_for_all(m_executor, m_arrays.number_of_cells(),
                                            [&](std::size_t c) { return has_neighbors(c); });
  }

  // Returns whether all vertices are points, each in a cell and with the least index at its place,
  // and only those have none that may be hidden.
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
      if (v == Arrays::none && m_may_hide_points)
        continue;
      if (v < 0 || std::size_t(v) > i || is_in_cell[std::size_t(v)] == 0 ||
          m_arrays.vertex_of_point(std::size_t(v)) != v)
        return false;
    }
    return true;
  }

  // Returns the place of the vertex across from vertex k of cell c in that neighbour, or m_corners
  // if the neighbour does not lead back.
  std::size_t place_across(std::size_t c, std::size_t k) const
  {
    const Cell there = m_arrays.neighbors(std::size_t(m_arrays.neighbors(c)[k]));
    return std::size_t(
        std::find(there.begin(), there.begin() + std::ptrdiff_t(m_corners), Index(c)) -
        there.begin());
  }

  // Returns whether the cells are connected, with the Euler characteristic of a sphere: of each
  // vertex link in dimension 3, otherwise of the whole. are_valid() must hold.
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
      using Number = std::make_unsigned_t<Index>; // the infinite vertex is number 0
      return are_links_spheres<Number>(
          cells, m_arrays.number_of_points() + 1,
          [&](std::size_t c, unsigned k) {
            return Number(m_arrays.vertices_data()[c * m_arrays.stride() + k] + 1);
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
        return false; // the vertex is there twice
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

  // Returns whether the facet is the same in the neighbour, seen from the other side: with the
  // vertex across in place of vertex k, the cell is the neighbour turned inside out. Segments need
  // not be oriented alike.
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
  const bool m_may_hide_points;
  const std::size_t m_corners; // the number of corners of a cell
};

// Presents arrays of dimension 2 or 3 as the core's cells: in a plane each triangle gets an apex
// off the plane on top (arrays_of_built.h).
template <class Vertex, class Index>
class Cells_of_arrays
{
  using Arrays = Delaunay_3_arrays<Index>;
  using Complex = Compact_complex<Vertex>;

public:
  // Keeps references. The links are valid; the dimension is that of the points. Weights are null if
  // vertices have none.
  Cells_of_arrays(const Arrays& arrays, const Point_array& points, const double* weights,
                  const Starting_simplex& simplex)
    : m_arrays(arrays)
    , m_vertices(vertices_of(points, weights, simplex))
  {
    if (is_flat() && arrays.number_of_simplices() > 0)
      m_is_turned = sign_of_cell(cell(0)) < 0;
  }

  // Returns whether all cells are positive and, if asked, not in conflict with a vertex across a
  // facet. A conflict is the same from both sides of a facet, so one side is tested. One pass.
  bool are_right(bool are_without_conflict, const Executor& executor) const
  {
    const Links_of_arrays<Index> links(m_arrays, executor);
    return holds_for_all(executor, m_arrays.number_of_cells(), [&](std::size_t c) {
      const Compact_cell here = cell(c);
      if (!m_arrays.is_infinite(Index(c)) && sign_of_cell(here) <= 0)
        return false;
      Insertion_counts uncounted;
      Compact_predicates<Vertex> predicates(m_vertices, uncounted);
      const auto neighbors = m_arrays.neighbors(c), corners = m_arrays.vertices(c);
      for (int k = 0; are_without_conflict && k <= m_arrays.dimension(); ++k) {
        const std::size_t d = std::size_t(neighbors[k]);
        if (d < c && corners[k] != Arrays::none)
          continue; // tested from the other side
        const Index across = m_arrays.vertices(d)[links.place_across(c, std::size_t(k))];
        if (across != Arrays::none && predicates.is_in_conflict(here, vertex(across)))
          return false;
      }
      return true;
    });
  }

  // Returns whether no point is in two cells, if are_right() holds: cells could still wind around
  // an edge twice. Let x be a point of cell 0 infinitely close to its first vertex. If x lies on
  // the inner side of every facet of the hull, the projection from x maps the hull onto a sphere
  // around x and covers it as often as cells contain x. If only cell 0 contains x, the hull is
  // star-shaped and does not meet itself. The number of cells that contain a point changes only
  // across the hull, so it is 1 inside. Linear; nearly all cells are settled by comparing
  // coordinates.
  bool are_apart(const Executor& executor) const
  {
    const Compact_cell first = cell(0);
    return holds_for_all(executor, m_arrays.number_of_cells(), [&](std::size_t c) {
      const Compact_cell here = cell(c);
      if (Complex::is_infinite(here))
        return side_of(first, here, 3) < 0;
      return c == 0 || is_outside(first.v[0], here) || side_of(first, here, 0) < 0 ||
             side_of(first, here, 1) < 0 || side_of(first, here, 2) < 0 ||
             side_of(first, here, 3) < 0;
    });
  }

  // Returns whether each point without a vertex lies in a cell that is not in conflict with it, and
  // has no vertex there, if are_right() and are_apart() hold. Each thread sorts a part of them in
  // space, and walks from one to the next.
  bool are_hidden(const Point_array& points, const Executor& executor) const
  {
    std::vector<std::size_t> hidden;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (m_arrays.vertex_of_point(i) == Arrays::none)
        hidden.push_back(i);
    const std::size_t blocks = number_of_blocks(executor, hidden.size(), 1024);
    std::vector<char> is_wrong(blocks, 0);
    for_each_block(
        executor, hidden.size(), blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
          Sort_by_halves()(points, hidden.data() + first, hidden.data() + last);
          Insertion_counts uncounted;
          Compact_predicates<Vertex> predicates(m_vertices, uncounted);
          Steps step(executor);
          std::size_t c = 0;
          for (std::size_t k = first; k < last && !is_wrong[b]; ++k) {
            const Id v = vertex(Index(hidden[k]));
            step(64); // about as many cells are on the way
            c = cell_with(v, c);
            is_wrong[b] = m_arrays.is_infinite(Index(c)) || predicates.vertex_at(cell(c), v) != 0 ||
                          predicates.is_in_conflict(cell(c), v);
          }
        });
    return std::find(is_wrong.begin(), is_wrong.end(), 1) == is_wrong.end();
  }

private:
  // Returns the finite cell that contains v, or an infinite one if v is beyond the hull, by a walk
  // from cell c. In a regular triangulation, the walk never returns to a cell.
  std::size_t cell_with(Id v, std::size_t c) const
  {
    for (int k = 0; k <= m_arrays.dimension() && !m_arrays.is_infinite(Index(c));) {
      Compact_cell with_v = cell(c);
      with_v.v[m_is_turned && k < 2 ? 1 - k : k] = v;
      const bool is_beyond = sign_of_cell(with_v) < 0;
      c = is_beyond ? std::size_t(m_arrays.neighbors(c)[std::size_t(k)]) : c;
      k = is_beyond ? 0 : k + 1;
    }
    return c;
  }

  // Returns the orientation of a cell with x in place of its vertex k. x is on the same side as the
  // first corner of cell 0 that is not in the plane of the other three vertices.
  int side_of(const Compact_cell& first, Compact_cell cell, unsigned k) const
  {
    int side = 0;
    for (unsigned i = 0; i < 4 && side == 0; ++i) {
      cell.v[k] = first.v[i];
      side = sign_of_cell(cell);
    }
    return side;
  }

  // Returns whether a vertex lies outside the bounding box of a cell.
  bool is_outside(Id v, const Compact_cell& cell) const
  {
    const Complex& complex = m_vertices;
    const double* const p = complex.exact_coordinates(v);
    const double* const q[4] = {
        complex.exact_coordinates(cell.v[0]), complex.exact_coordinates(cell.v[1]),
        complex.exact_coordinates(cell.v[2]), complex.exact_coordinates(cell.v[3])};
    for (unsigned i = 0; i < 3; ++i)
      if ((q[0][i] < p[i] && q[1][i] < p[i] && q[2][i] < p[i] && q[3][i] < p[i]) ||
          (q[0][i] > p[i] && q[1][i] > p[i] && q[2][i] > p[i] && q[3][i] > p[i]))
        return true;
    return false;
  }

  // Returns a complex with the vertices in the order of the points; its cells are not used.
  static Complex vertices_of(const Point_array& points, const double* weights,
                             const Starting_simplex& simplex)
  {
    std::vector<std::size_t> numbers(points.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    Ordered_complex<Vertex> made;
    made.order = {numbers.data(), numbers.size(), nullptr, 0, nullptr};
    std::array<double, 3> apex;
    if (simplex.dimension == 2)
      apex = apex_of_plane(points[simplex.points[0]], points[simplex.points[1]],
                           points[simplex.points[2]]);
    made.start(points, simplex.dimension == 2 ? apex.data() : nullptr, Alone(),
               Compact_numbers::max_cells, weights);
    return std::move(made.complex);
  }

  bool is_flat() const { return m_arrays.dimension() == 2; }
  static Id vertex(Index i) { return i == Arrays::none ? Complex::infinite : Id(i) + 1; }

  // Returns cell c with the infinite vertex, if it has one, last.
  Compact_cell cell(std::size_t c) const
  {
    const auto v = m_arrays.vertices(c);
    Compact_cell cell = {
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

  int sign_of_cell(const Compact_cell& cell) const
  {
    const auto at = [&](unsigned k) { return m_vertices.exact_coordinates(cell.v[k]); };
    return orientation(at(0), at(1), at(2), at(3));
  }

  const Arrays& m_arrays;
  const Complex m_vertices;
  bool m_is_turned = false; // triangles are seen from the other side than the apex
};

// Returns whether the segments of points on a line join successive points.
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

// Returns whether points have the coordinates of their vertices, and the weights if there are any.
template <class Index>
bool are_equal_to_vertices(const Delaunay_3_arrays<Index>& arrays, const Point_array& points,
                           const double* weights)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Index v = arrays.vertex_of_point(i);
    if (v >= 0 && (!std::equal(points[i], points[i] + 3, points[std::size_t(v)]) ||
                   (weights != nullptr && weights[i] != weights[v])))
      return false;
  }
  return true;
}

// Returns whether arrays are valid up to a level, if their neighbours are known to be right. Weights
// are null if a Vertex has none.
template <class Vertex = Compact_vertex, class Index>
bool is_valid_if_linked(const Delaunay_3_arrays<Index>& arrays, const Point_array& points,
                        Delaunay_validity_level level, const Executor& executor,
                        const double* weights = nullptr)
{
  using Level = Delaunay_validity_level;
  const Links_of_arrays<Index> links(arrays, executor, weights != nullptr);
  if (arrays.number_of_points() != points.size() || !links.have_vertices() ||
      (level >= Level::EULER && points.size() > 0 && !links.are_spheres()))
    return false;
  if (level < Level::ORIENTATION)
    return true;
  if (!are_equal_to_vertices(arrays, points, weights))
    return false;
  const Starting_simplex simplex =
      starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
  if (simplex.dimension != arrays.dimension())
    return false;
  if (simplex.dimension <= 1)
    return (simplex.dimension < 1 || is_line_of_segments(arrays, points)) &&
           (weights == nullptr || level < Level::DELAUNAY ||
            arrays_on_line<Index>(points, weights).vertices_of_points() ==
                arrays.vertices_of_points());
  const Cells_of_arrays<Vertex, Index> cells(arrays, points, weights, simplex);
  return cells.are_right(level >= Level::DELAUNAY, executor) &&
         (level < Level::DELAUNAY || (cells.are_apart(executor) &&
                                      (weights == nullptr || cells.are_hidden(points, executor))));
}

// Returns whether arrays, which must have neighbours and infinite cells, are valid up to a level.
template <class Vertex = Compact_vertex, class Index>
bool is_valid(const Delaunay_3_arrays<Index>& arrays, const Point_array& points,
              Delaunay_validity_level level, const Executor& executor = Alone(),
              const double* weights = nullptr)
{
  return Links_of_arrays<Index>(arrays, executor, weights != nullptr).are_valid() &&
         is_valid_if_linked<Vertex>(arrays, points, level, executor, weights);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_IS_VALID_ARRAYS_H
