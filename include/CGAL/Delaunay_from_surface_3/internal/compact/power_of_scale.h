// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_POWER_OF_SCALE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_POWER_OF_SCALE_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/double_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The power of 2 that makes the largest coordinate in absolute value at least 2^57 and less than
// 2^58, as near as the range of numbers allows: as large as it can be for differences to be less
// than 2^59 (Integer_differences.h, balanced_signs.h), so that few cells are so small that products
// of their coordinates underflow. All coordinates must be doubles. Linear.
struct Power_of_scale
{
  double factor; // 0 where doubles are not to be trusted: then no filter decides anything
  bool is_exact; // no coordinate becomes so small that it is rounded
};

template <class Point>
Power_of_scale power_of_scale(const std::vector<Point>& points)
{
  if (obstacle_of_compiler() != nullptr)
    return {0, false};
  double largest = 0, least = (std::numeric_limits<double>::max)();
  for (const Point& p : points) {
    const std::array<double, 3> coordinates = *double_coordinates(p);
    for (const double c : coordinates) {
      const double size = std::abs(c);
      largest = (std::max)(largest, size);
      least = size == 0 ? least : (std::min)(least, size);
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1., (std::min)(58 - exponent, 1000));
  return {scale, least * scale > (std::numeric_limits<double>::min)()};
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_POWER_OF_SCALE_H
