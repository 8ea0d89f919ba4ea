// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_DOUBLES_OF_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_DOUBLES_OF_POINTS_H

#include <CGAL/Delaunay_from_surface_3/door/double_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The coordinates of a caller's points as doubles: exact if all of them are doubles, else rounded,
// which is enough to make an order.
template <class Point>
class Doubles_of_points final : public Point_source
{
public:
  // Keeps a reference. Linear.
  explicit Doubles_of_points(const std::vector<Point>& points)
    : m_points(points)
    , m_not_double(points.size())
  {
    read();
  }

  Point_array points() override
  {
    if (m_coordinates.empty())
      read();
    return Point_array(m_coordinates.data(), m_points.size());
  }
  void give_up() override { Large_vector<double>().swap(m_coordinates); }

  // Why they are not exact; empty if they are.
  std::string obstacle() const
  {
    return m_not_double < m_points.size()
               ? "a coordinate of point " + std::to_string(m_not_double) + " is not a double"
               : std::string();
  }

private:
  void read()
  {
    m_coordinates.reserve(3 * m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const Point& p = m_points[i];
      std::array<double, 3> c;
      if (const auto exact = double_coordinates(p)) {
        c = *exact;
      } else {
        m_not_double = (std::min)(m_not_double, i);
        c = {to_double(p.x()), to_double(p.y()), to_double(p.z())};
      }
      m_coordinates.insert(m_coordinates.end(), c.begin(), c.end());
    }
  }

  const std::vector<Point>& m_points;
  Large_vector<double> m_coordinates;
  std::size_t
      m_not_double; // the first point with a coordinate that is none, or the number of points
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_DOUBLES_OF_POINTS_H
