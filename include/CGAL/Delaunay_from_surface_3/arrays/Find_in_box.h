// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_IN_BOX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_IN_BOX_H

// Finds the copy of a tetrahedron that contains a point in a periodic box, by the walk of
// Find_simplex.h from copy to copy. Neither the point nor the corners are rounded: both are wrapped
// into the box by what is left of a division, and then corners are as many periods away as it takes.

#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Number_of_periods = std::array<std::int32_t, 3>;

// The periods, infinite ones as 0. Where products of lengths and small numbers may not be exact in
// two doubles, only integers of any width are.
inline Periods periods_of(const double* box)
{
  Periods periods = {{0, 0, 0}, true};
  for (std::size_t a = 0; a < 3; ++a)
    if (box[a] <= (std::numeric_limits<double>::max)()) {
      periods.lengths[a] = box[a];
      periods.are_scaled = periods.are_scaled && box[a] > 0x1p-900 && box[a] < 0x1p900;
    }
  return periods;
}

// Moves a point by whole periods until its coordinates are smaller than these, and returns by how many
// it is moved back. Nothing is rounded.
inline Number_of_periods wrap(const Periods& periods, double* p, const std::string& name)
{
  Number_of_periods back = {0, 0, 0};
  for (std::size_t a = 0; a < 3; ++a)
    if (periods.lengths[a] > 0) {
      const double by = wrap(p[a], periods.lengths[a]);
      if (!(std::abs(by) < too_many_periods))
        throw std::invalid_argument(name + " is 2^29 or more periods away from the box along " +
                                    "xyz"[a]);
      back[a] = std::int32_t(by);
    }
  return back;
}

// Points, wrapped into the box.
class Points_in_box
{
public:
  // point_of(i) returns the coordinates of point i.
  template <class PointOf>
  Points_in_box(std::size_t n, const PointOf& point_of, const double* box)
    : m_periods(periods_of(box))
    , m_wraps(n)
  {
    m_points.reserve(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<double, 3> p = point_of(i);
      if (!is_finite_number(p[0]) || !is_finite_number(p[1]) || !is_finite_number(p[2]))
        throw std::invalid_argument("a coordinate of a point is not a finite number any more");
      m_points.insert(m_points.end(), p.begin(), p.end());
      m_wraps[i] = wrap(m_periods, &m_points[3 * i], "point " + std::to_string(i));
    }
    for (std::size_t i = 0; i < n; ++i)
      m_periods.are_scaled = m_periods.are_scaled && !is_far(&m_points[3 * i]);
    m_far_periods.lengths[0] = m_periods.lengths[0];
    m_far_periods.lengths[1] = m_periods.lengths[1];
    m_far_periods.lengths[2] = m_periods.lengths[2];
  }
  Points_in_box(const Points_in_box&) = delete;
  Points_in_box& operator=(const Points_in_box&) = delete;

  const Periods& periods() const { return m_periods; }
  const double* operator[](std::size_t i) const { return &m_points[3 * i]; }

  // How many periods the point itself is away from where it is wrapped to.
  const Number_of_periods& wraps(std::size_t i) const { return m_wraps[i]; }

  // A point that is looked for. Keeps a pointer to it, as the next function does.
  Copy_place<false> place(const double* q) const
  {
    return {q, is_far(q) ? &m_far_periods : &m_periods, {}};
  }

  // A wrapped point, moved again.
  Copy_place<false> place(const double* p, const Number_of_periods& by) const
  {
    Copy_place<false> place = {p, &m_periods, {}};
    for (std::size_t a = 0; a < 3; ++a) {
      if (std::abs(by[a]) > (std::numeric_limits<std::int16_t>::max)())
        throw std::invalid_argument("box: a corner is more than 32767 periods away from a point");
      place.shift[a] = std::int16_t(by[a]);
    }
    return place;
  }

private:
  // So that differences may not be numbers.
  static bool is_far(const double* p)
  {
    return !(std::abs(p[0]) < 0x1p1000 && std::abs(p[1]) < 0x1p1000 && std::abs(p[2]) < 0x1p1000);
  }

  Periods m_periods, m_far_periods = {{0, 0, 0}, false};
  std::vector<double> m_points;
  std::vector<Number_of_periods> m_wraps;
};

// A copy of a simplex, moved by so many periods from where it is kept; none if the number is -1.
template <class Index>
struct Simplex_copy
{
  Index simplex;
  Number_of_periods offset;

  bool operator<(const Simplex_copy& other) const
  {
    return std::tie(simplex, offset) < std::tie(other.simplex, other.offset);
  }
};

// Refers to the tetrahedra of a Periodic_3_arrays.
template <class Index>
struct Simplices_in_box
{
  Simplices_view<Index> simplices;
  const std::int16_t* offsets; // 12 for each
  const Points_in_box& points;

  // A corner of a copy: how many periods it is away from where its point is wrapped to.
  Number_of_periods shift(const Simplex_copy<Index>& s, std::size_t k) const
  {
    const auto c = std::size_t(s.simplex);
    Number_of_periods shift = points.wraps(simplices.vertex(c, k));
    for (std::size_t a = 0; a < 3; ++a)
      shift[a] += offsets[12 * c + 3 * k + a] + s.offset[a];
    return shift;
  }
  Copy_place<false> corner(const Simplex_copy<Index>& s, std::size_t k) const
  {
    return points.place(points[simplices.vertex(std::size_t(s.simplex), k)], shift(s, k));
  }
};

// Finds copies for one thread.
template <class Index>
class Find_in_box
{
  using Copy = Simplex_copy<Index>;

public:
  // Keeps a copy.
  explicit Find_in_box(const Simplices_in_box<Index>& in_box)
    : m_in_box(in_box)
  {
  }

  // Returns the copy that contains a wrapped point q, its facets included: of several that of the
  // simplex with the smallest number, and of copies of this the one that is moved least, in
  // lexicographical order. Starts at the last simplex found.
  Copy operator()(const double* q)
  {
    if (m_in_box.simplices.number == 0)
      return none();
    Copy copy = near(q);
    int entry = -1;
    for (std::size_t steps = 0; steps < most_steps(); ++steps) {
      const int k = look(copy, q, entry);
      if (k < 0) {
        m_last = copy.simplex;
        return m_facets == 0 ? copy : least_around(copy, q);
      }
      copy = neighbor(copy, unsigned(k), entry);
      if (copy.simplex < 0)
        return copy; // beyond the hull
    }
    refuse();
  }

private:
  // The corners of a facet, sorted, from the first one on: the same for all copies.
  struct Facet
  {
    std::array<std::pair<std::size_t, Number_of_periods>, 3> corners;
    Number_of_periods first;
  };

  static Copy none() { return {Index(-1), {0, 0, 0}}; }
  [[noreturn]] static void refuse()
  {
    throw std::invalid_argument("the simplices are not a triangulation of the points in the box");
  }
  // A long and thin box may have few simplices and many copies.
  std::size_t most_steps() const { return (std::size_t(1) << 20) + 64 * m_in_box.simplices.number; }

  // The last simplex, with its first corner near q.
  Copy near(const double* q) const
  {
    Copy copy = {m_last, {0, 0, 0}};
    const double* const p = m_in_box.points[m_in_box.simplices.vertex(std::size_t(m_last), 0)];
    const Number_of_periods shift = m_in_box.shift(copy, 0);
    for (std::size_t a = 0; a < 3; ++a) {
      const double length = m_in_box.points.periods().lengths[a];
      if (length > 0) // both are wrapped
        copy.offset[a] = std::int32_t(std::round(q[a] / length - p[a] / length)) - shift[a];
    }
    return copy;
  }

  Facet facet(const Copy& s, unsigned k) const
  {
    Facet facet;
    std::size_t n = 0;
    for (unsigned j = 0; j < 4; ++j)
      if (j != k)
        facet.corners[n++] = {m_in_box.simplices.vertex(std::size_t(s.simplex), j),
                              m_in_box.shift(s, j)};
    std::sort(facet.corners.begin(), facet.corners.end());
    facet.first = facet.corners[0].second;
    for (auto& corner : facet.corners)
      for (std::size_t a = 0; a < 3; ++a)
        corner.second[a] -= facet.first[a];
    return facet;
  }

  // Returns the copy beyond facet k, and the number that it has there.
  Copy neighbor(const Copy& s, unsigned k, int& entry) const
  {
    const Index d = m_in_box.simplices.neighbor(std::size_t(s.simplex), k);
    if (d < 0)
      return none();
    const Facet from = facet(s, k);
    Copy copy = {d, {0, 0, 0}};
    for (unsigned j = 0; j < 4; ++j) {
      if (d == s.simplex && j == k)
        continue;
      const Facet to = facet(copy, j);
      if (from.corners == to.corners) {
        for (std::size_t a = 0; a < 3; ++a)
          copy.offset[a] = from.first[a] - to.first[a];
        entry = int(j);
        return copy;
      }
    }
    refuse();
  }

  // Returns the first facet with q beyond it, or -1: then bit k of m_facets tells whether q lies in
  // facet k. The facet `entry` is not tested: q is on its inner side.
  int look(const Copy& s, const double* q, int entry)
  {
    const Copy_place<false> place_of_q = m_in_box.points.place(q);
    Copy_place<false> corners[4];
    Row<double> rows[4];
    bool are_exact = m_has_filter;
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = m_in_box.corner(s, k);
      const Periodic_difference x(corners[k], place_of_q, 0), y(corners[k], place_of_q, 1),
          z(corners[k], place_of_q, 2);
      rows[k] = {x.high, y.high, z.high};
      are_exact = are_exact && x.is_exact && y.is_exact && z.is_exact;
    }
    m_facets = 0;
    for (unsigned k = 0; k < 4; ++k) {
      if (int(k) == entry)
        continue;
      const unsigned char* const f = facet_corners[k];
      const double m = largest_square(rows[f[0]], rows[f[1]], rows[f[2]]);
      int side = are_exact && m < 1e100
                     ? certified_sign(determinant_of(rows[f[0]], rows[f[1]], rows[f[2]]),
                                      Filter_bounds::three_rows(m))
                     : 0;
      if (side == 0)
        side = orientation(place_of_q, corners[f[0]], corners[f[1]], corners[f[2]]);
      if (side < 0)
        return int(k);
      m_facets |= unsigned(side == 0) << k;
    }
    return -1;
  }

  // Returns the least of all copies that have q in a facet, as this one has: they are reached through
  // such facets.
  Copy least_around(const Copy& copy, const double* q)
  {
    std::set<Copy> met = {copy};
    std::vector<Copy> open = {copy};
    while (!open.empty()) {
      const Copy s = open.back();
      open.pop_back();
      look(s, q, -1);
      const unsigned facets = m_facets;
      for (unsigned k = 0; k < 4; ++k)
        if ((facets >> k & 1u) != 0) {
          int entry;
          const Copy t = neighbor(s, k, entry);
          if (t.simplex >= 0 && met.insert(t).second)
            open.push_back(t);
        }
    }
    return *met.begin();
  }

  const Simplices_in_box<Index> m_in_box;
  const bool m_has_filter = obstacle_of_compiler() == nullptr;
  Index m_last = 0;
  unsigned m_facets = 0;
};

// Finds the copies that contain many points: `found` is told the number of each, and its copy.
template <class Index, class Found>
void find_in_box(const Simplices_in_box<Index>& in_box, const Point_array& queries,
                 std::size_t first_number, const Executor& executor, const Found& found)
{
  std::vector<double> wrapped;
  std::vector<Number_of_periods> wraps;
  wrapped.reserve(3 * queries.size());
  wraps.reserve(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    wrapped.insert(wrapped.end(), queries[i], queries[i] + 3);
    wraps.push_back(wrap(in_box.points.periods(), &wrapped[3 * i],
                         "xi: point " + std::to_string(first_number + i)));
  }
  const Point_array points(wrapped.data(), queries.size());
  const std::size_t blocks = number_of_blocks(executor, queries.size(), 1024);
  for_each_block(executor, queries.size(), blocks,
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   std::vector<std::size_t> order(last - first);
                   std::iota(order.begin(), order.end(), first);
                   Sort_by_halves()(points, order.data(), order.data() + order.size());
                   Find_in_box<Index> find(in_box);
                   Steps step(executor);
                   for (const std::size_t i : order) {
                     step(64); // about as many cells are on the way
                     Simplex_copy<Index> copy = find(points[i]);
                     for (std::size_t a = 0; copy.simplex >= 0 && a < 3; ++a)
                       copy.offset[a] += wraps[i][a];
                     found(i, copy);
                   }
                 });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_IN_BOX_H
