// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_CORNERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_CORNERS_H

// The corners of tetrahedra in NumPy's arrays, as measures_of_simplices.h takes them: coordinates, with
// a weight or without, or copies of points in a periodic box.

#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/arrays/Find_in_box.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace python {

namespace core = CGAL::Delaunay_from_surface_3::core;

// What a triangulation has in a periodic box beside points and simplices: the periods, infinite ones
// where there are none, and the offsets of the corners.
class In_box
{
public:
  explicit In_box(const py::object& pair, const Rows& rows)
    : In_box(pair.cast<std::pair<Lengths, Offsets>>(), rows)
  {
  }

  const double* box() const { return m_box.data(); }
  const std::int16_t* offsets() const { return m_offsets.data(); }

private:
  using Lengths = py::array_t<double, py::array::c_style | py::array::forcecast>;
  using Offsets = py::array_t<std::int16_t, py::array::c_style | py::array::forcecast>;

  In_box(std::pair<Lengths, Offsets>&& pair, const Rows& rows)
    : m_box(std::move(pair.first))
    , m_offsets(std::move(pair.second))
  {
    if (m_box.ndim() != 1 || m_box.shape(0) != 3)
      throw py::value_error("box: expected three periods");
    if (m_offsets.ndim() != 3 || std::size_t(m_offsets.shape(0)) != rows.size() ||
        std::size_t(m_offsets.shape(1)) != rows.corners() || m_offsets.shape(2) != 3)
      throw py::value_error("offsets: expected three for each corner of the simplices");
  }

  Lengths m_box;
  Offsets m_offsets;
};

// Corners of simplices in a box, whose points are copied, with weights if there are any: all at once, or
// one by one when they are used, for one thread that uses few.
template <bool has_weight>
class Corners_in_box
{
public:
  // Keeps pointers.
  Corners_in_box(const Points& points, const double* weights, const In_box& in_box,
                 bool are_all_used = true)
    : m_point_of{python::Points_view(points)}
    , m_weights(weights)
    , m_are_all_used(are_all_used)
    , m_points(are_all_used ? std::size_t(points.shape(0)) : 0)
    , m_periods(core::periods_of(in_box.box()))
    , m_offsets(in_box.offsets())
  {
    for (std::size_t i = 0; i < m_points.size(); ++i)
      m_points[i] = read(i);
  }

  // Corner k of simplex c, which is point i.
  core::Copy_place<has_weight> operator()(std::size_t c, std::size_t k, std::size_t i) const
  {
    return copy(i, m_offsets + 12 * c + 3 * k);
  }

  // Point i, moved by these numbers of periods.
  template <class Integer>
  core::Copy_place<has_weight> copy(std::size_t i, const Integer* offset) const
  {
    return {point(i),
            &m_periods,
            {std::int16_t(offset[0]), std::int16_t(offset[1]), std::int16_t(offset[2])}};
  }

  // Three for each corner.
  const std::int16_t* offsets() const { return m_offsets; }

  // The largest of all numbers but weights, in absolute value, where all points are used.
  double largest() const
  {
    double largest = *std::max_element(m_periods.lengths, m_periods.lengths + 3);
    for (const Point& p : m_points)
      for (std::size_t a = 0; a < 3; ++a)
        largest = (std::max)(largest, std::fabs(p[a]));
    return largest;
  }

private:
  using Point = std::array<double, has_weight ? 4 : 3>;

  Point read(std::size_t i) const
  {
    const std::array<double, 3> p = m_point_of(i);
    for (const double x : p)
      m_periods.are_scaled = m_periods.are_scaled && std::fabs(x) < 0x1p1000;
    if constexpr (has_weight)
      return {p[0], p[1], p[2], m_weights[i]};
    else
      return p;
  }

  const double* point(std::size_t i) const
  {
    if (m_are_all_used)
      return m_points[i].data();
    const auto used = m_used_points.find(i);
    return (used != m_used_points.end() ? used : m_used_points.emplace(i, read(i)).first)
        ->second.data();
  }

  const Point_of m_point_of;
  const double* m_weights;
  const bool m_are_all_used;
  std::vector<Point> m_points;
  mutable std::unordered_map<std::size_t, Point> m_used_points;
  mutable core::Periods m_periods;
  const std::int16_t* m_offsets;
};

inline double coordinate(const std::array<double, 3>& p, std::size_t axis)
{
  return p[axis];
}
inline double coordinate(const std::array<double, 4>& p, std::size_t axis)
{
  return p[axis];
}
template <bool has_weight>
double coordinate(const core::Copy_place<has_weight>& p, std::size_t axis)
{
  return p.shift[axis] == 0 ? p.point[axis]
                            : std::fma(p.shift[axis], p.periods->lengths[axis], p.point[axis]);
}

// Corners of simplices without a box.
template <bool has_weight>
class Corners_of_points
{
public:
  Corners_of_points(const Points& points, const double* weights)
    : m_point_of{Points_view(points)}
    , m_size(std::size_t(points.shape(0)))
    , m_weights(weights)
  {
  }

  auto operator()(std::size_t, std::size_t, std::size_t i) const
  {
    const std::array<double, 3> p = m_point_of(i);
    if constexpr (has_weight)
      return std::array<double, 4>{p[0], p[1], p[2], m_weights[i]};
    else
      return p;
  }

  const std::int16_t* offsets() const { return nullptr; }

  double largest() const
  {
    double largest = 0;
    for (std::size_t i = 0; i < m_size; ++i)
      for (const double x : m_point_of(i))
        largest = (std::max)(largest, std::fabs(x));
    return largest;
  }

private:
  const Point_of m_point_of;
  const std::size_t m_size;
  const double* m_weights;
};

// Calls f(corner_of), where corner_of(c, k, i) is corner k of tetrahedron c, which is point i. The box
// may be None.
template <bool has_weight, class F>
auto with_corners_of(const Points& points, const py::object& weights, const Rows& rows,
                     const py::object& in_box, const F& f, bool are_all_used = true)
{
  if (rows.corners() != 4)
    throw py::value_error("simplices: expected tetrahedra");
  using Weights = py::array_t<double, py::array::c_style>;
  const auto of_points = has_weight ? weights.cast<Weights>() : Weights();
  if (has_weight && (of_points.ndim() != 1 || of_points.shape(0) != points.shape(0)))
    throw py::value_error("weights: expected one for each point");
  if (in_box.is_none())
    return f(Corners_of_points<has_weight>(points, of_points.data()));
  const In_box of_simplices(in_box, rows);
  return f(Corners_in_box<has_weight>(points, of_points.data(), of_simplices, are_all_used));
}

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_CORNERS_H
