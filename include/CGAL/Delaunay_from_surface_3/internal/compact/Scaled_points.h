// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SCALED_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SCALED_POINTS_H

#include <CGAL/Delaunay_from_surface_3/internal/compact/exact_scale.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/double_coordinates.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The coordinates of points as doubles, multiplied by a power of 2, exactly; or why there are none.
template <class Point>
class Scaled_points
{
public:
  // Keeps a reference. Linear.
  explicit Scaled_points(const std::vector<Point>& points)
    : m_points(points)
    , m_not_double(first_not_double(points))
    , m_scale(m_not_double == points.size() ? exact_scale(points) : 0)
  {
  }

  std::optional<std::string> obstacle() const
  {
    if (m_not_double < m_points.size())
      return "a coordinate of point " + std::to_string(m_not_double) + " is not a double";
    if (m_scale == 0)
      return "the coordinates are of too different size";
    return std::nullopt;
  }

  // Of the i-th point, if there is no obstacle.
  std::array<double, 3> operator()(std::size_t i) const
  {
    const std::array<double, 3> p = *double_coordinates(m_points[i]);
    return {p[0] * m_scale, p[1] * m_scale, p[2] * m_scale};
  }

private:
  const std::vector<Point>& m_points;
  std::size_t m_not_double; // the first such point, or the number of points
  double m_scale;           // 0: there is none
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SCALED_POINTS_H
