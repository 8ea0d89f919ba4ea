// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_CORNERS_IN_BOX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_CORNERS_IN_BOX_H

// The corners of simplices in a periodic box, as the core measures them.

#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/arrays/Find_in_box.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace python {

namespace core = CGAL::Delaunay_from_surface_3::core;

// Points that are copied, with weights if they have any, and moved by whole numbers of periods.
template <bool has_weight>
class Copies_of_points
{
public:
  Copies_of_points(const Points& points, const double* weights, const double* box)
    : m_periods(core::periods_of(box))
  {
    const Point_of point_of = {Points_view(points)};
    const auto n = std::size_t(points.shape(0));
    m_points.reserve(size * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (const double x : point_of(i)) {
        m_points.push_back(x);
        m_periods.are_scaled = m_periods.are_scaled && std::fabs(x) < 0x1p1000;
      }
      if (has_weight)
        m_points.push_back(weights[i]);
    }
  }

  // Returns point i, moved; keeps pointers to what is here.
  template <class Integer>
  core::Copy_place<has_weight> operator()(std::size_t i, const Integer* offset) const
  {
    return {m_points.data() + size * i,
            &m_periods,
            {std::int16_t(offset[0]), std::int16_t(offset[1]), std::int16_t(offset[2])}};
  }

private:
  static constexpr std::size_t size = has_weight ? 4 : 3;
  std::vector<double> m_points;
  core::Periods m_periods;
};

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

  // Returns what finds corner k of simplex c, which is point i. Keeps a reference.
  template <bool has_weight>
  auto corners(const Copies_of_points<has_weight>& copies) const
  {
    return [&copies, all = offsets()](std::size_t c, std::size_t k, std::size_t i) {
      return copies(i, all + 12 * c + 3 * k);
    };
  }

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

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_CORNERS_IN_BOX_H
