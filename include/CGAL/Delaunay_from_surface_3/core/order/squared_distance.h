// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SQUARED_DISTANCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SQUARED_DISTANCE_H

#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The squared distance of points i and j, up to rounding; infinite where it overflows.
inline double squared_distance(const Point_array& points, std::size_t i, std::size_t j)
{
  const double *const p = points[i], *const q = points[j];
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SQUARED_DISTANCE_H
