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

private:
  const double* m_coordinates;
  std::size_t m_size;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H
