// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_POWER_OF_SCALE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_POWER_OF_SCALE_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The power of 2 that makes the largest coordinate in absolute value at least 2^57 and less than
// 2^58, as near as the range of numbers allows: as large as it can be for differences to be less
// than 2^59 (Integer_differences.h, balanced_signs.h), so that few cells are so small that products
// of their coordinates underflow. Linear.
class Power_of_scale
{
public:
  // Of the points, and one more if there is one.
  Power_of_scale(const Point_array& points, const double* one_more)
  {
    if (obstacle_of_compiler() != nullptr)
      return;
    for (std::size_t i = 0; i < points.size(); ++i)
      look_at(points[i]);
    if (one_more != nullptr)
      look_at(one_more);
    choose();
  }

  // Of points whose coordinates are at most `largest` in absolute value, and 0 or at least `least`.
  Power_of_scale(double largest, double least)
    : m_largest(largest)
    , m_least(least)
  {
    if (obstacle_of_compiler() == nullptr)
      choose();
  }

  // No coordinate becomes so small that it is rounded; one that is made larger never does.
  bool is_exact() const { return m_is_exact; }

  std::array<double, 3> operator()(const double* p) const
  {
    return {p[0] * m_factor, p[1] * m_factor, p[2] * m_factor};
  }

  // What was scaled, if that is exact: the inverse of the power is one, too.
  std::array<double, 3> before(const double* p) const
  {
    return {p[0] / m_factor, p[1] / m_factor, p[2] / m_factor};
  }

private:
  void look_at(const double* p)
  {
    for (int k = 0; k < 3; ++k) {
      const double size = std::abs(p[k]);
      m_largest = (std::max)(m_largest, size);
      m_least = size == 0 ? m_least : (std::min)(m_least, size);
    }
  }

  void choose()
  {
    int exponent = 0;
    std::frexp(m_largest, &exponent);
    m_factor = std::ldexp(1., (std::min)(58 - exponent, 1000));
    m_is_exact = m_factor >= 1 || m_least * m_factor > (std::numeric_limits<double>::min)();
  }

  double m_largest = 0, m_least = (std::numeric_limits<double>::max)();
  double m_factor = 0; // if doubles cannot be trusted: then no filter decides anything
  bool m_is_exact = false;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_POWER_OF_SCALE_H
