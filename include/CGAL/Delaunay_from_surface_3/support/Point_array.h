// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// n points as n × 3 doubles, which are somebody else's.
class Point_array
{
public:
  Point_array(const double* coordinates, std::size_t size)
    : m_coordinates(coordinates)
    , m_size(size)
  {
  }

  std::size_t size() const { return m_size; }
  const double* operator[](std::size_t i) const { return m_coordinates + 3 * i; }

  // Up to rounding, and infinite where it overflows.
  double squared_distance(std::size_t i, std::size_t j) const
  {
    const double *const p = (*this)[i], *const q = (*this)[j];
    const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
    return x * x + y * y + z * z;
  }

private:
  const double* m_coordinates;
  std::size_t m_size;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H
