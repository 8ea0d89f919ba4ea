// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_COPIED_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_COPIED_POINTS_H

#include "Unlocked.h"
#include "numpy_ranges.h"

#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <cstddef>
#include <vector>

namespace python {

// Points of an array, copied for as long as the core reads them in its input order: 24 bytes per
// point before the insertion begins, but none at the peak of memory. If another thread writes into
// the array meanwhile, the result may be of other points, but these are checked like the first.
class Copied_points final : public CGAL::Delaunay_from_surface_3::core::Point_source
{
  using Point_array = CGAL::Delaunay_from_surface_3::core::Point_array;

public:
  // Keeps a reference; the first copy is made with the interpreter's lock.
  explicit Copied_points(const py::array& array)
    : m_view(array)
    , m_size(std::size_t(array.shape(0)))
  {
    copy_points(m_view, m_size, "points: point", m_copy);
  }

  std::size_t size() const { return m_size; }

  Point_array points() override
  {
    if (m_copy.empty() && m_size > 0) {
      const Locked lock;
      copy_points(m_view, m_size, "points: point", m_copy);
    }
    return Point_array(m_copy.data(), m_size);
  }
  void give_up() override { Vector().swap(m_copy); }

private:
  using Vector = CGAL::Delaunay_from_surface_3::core::Large_vector<double>;

  const Points_view m_view;
  const std::size_t m_size;
  Vector m_copy;
};

// The same with weights, which are copied once.
class Copied_weighted_points final
  : public CGAL::Delaunay_from_surface_3::core::Weighted_point_source
{
public:
  // Keeps a reference to `array`.
  Copied_weighted_points(const py::array& array, const py::array_t<double>& weights)
    : m_points(array)
    , m_weights(weights.data(), weights.data() + weights.size())
  {
  }

  std::size_t size() const { return m_points.size(); }

  CGAL::Delaunay_from_surface_3::core::Point_array points() override { return m_points.points(); }
  void give_up() override { m_points.give_up(); }
  const double* weights() override { return m_weights.data(); }

private:
  Copied_points m_points;
  const std::vector<double> m_weights;
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_COPIED_POINTS_H
