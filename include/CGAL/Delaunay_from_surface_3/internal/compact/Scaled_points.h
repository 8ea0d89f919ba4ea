// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SCALED_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SCALED_POINTS_H

#include <CGAL/Delaunay_from_surface_3/internal/compact/power_of_scale.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/double_coordinates.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The coordinates of points as doubles, multiplied by a power of 2; or why there are none.
template <class Point>
class Scaled_points
{
public:
  // Keeps a reference. Linear.
  explicit Scaled_points(const std::vector<Point>& points)
    : m_points(points)
    , m_not_double(first_not_double(points))
    , m_scale(m_not_double == points.size() ? power_of_scale(points) : Power_of_scale{1, true})
  {
  }

  std::optional<std::string> obstacle() const
  {
    if (m_not_double < m_points.size())
      return "a coordinate of point " + std::to_string(m_not_double) + " is not a double";
    return std::nullopt;
  }

  // Of the i-th point, if there is no obstacle.
  std::array<double, 3> operator()(std::size_t i) const
  {
    const std::array<double, 3> p = *double_coordinates(m_points[i]);
    return {p[0] * m_scale.factor, p[1] * m_scale.factor, p[2] * m_scale.factor};
  }

  // Those of all points as they are, if the product has rounded any; else nothing.
  std::vector<std::array<double, 3>> own_coordinates() const
  {
    std::vector<std::array<double, 3>> own;
    own.reserve(m_scale.is_exact ? 0 : m_points.size());
    for (std::size_t i = 0; !m_scale.is_exact && i < m_points.size(); ++i)
      own.push_back(*double_coordinates(m_points[i]));
    return own;
  }

private:
  const std::vector<Point>& m_points;
  std::size_t m_not_double; // the first such point, or the number of points
  Power_of_scale m_scale;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SCALED_POINTS_H
