// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_UNIT_FRAME_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_UNIT_FRAME_H

#include <CGAL/Delaunay_from_surface_3/inside/Box_3d.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

inline Vector_3d vector_of(const double* p)
{
  return {p[0], p[1], p[2]};
}

// Moves a box to 0, and shrinks it to about 1: no product of coordinates overflows. That is the box
// of a surface: points that it does not use may lie anywhere, so what is extremely far from the box
// is drawn nearer, in its direction.
class Unit_frame
{
  static constexpr double farthest = 0x1p200;

public:
  explicit Unit_frame(const Box_3d& box)
  {
    if (box.high[0] < box.low[0])
      return;
    double half = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      m_half_middle[j] = box.low[j] / 4 + box.high[j] / 4; // halves do not overflow
      half = (std::max)(half, box.high[j] / 2 - box.low[j] / 2);
    }
    int exponent = 0;
    std::frexp(half, &exponent);
    m_factors[0] = std::ldexp(1., (1 - exponent) / 2);
    m_factors[1] = std::ldexp(1., 1 - exponent - (1 - exponent) / 2);
  }

  Vector_3d operator()(const Vector_3d& p) const
  {
    Vector_3d q;
    double most = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      q[j] = p[j] / 2 - m_half_middle[j];
      most = (std::max)(most, std::abs(q[j]));
    }
    const bool is_near = most * m_factors[0] * m_factors[1] <= farthest;
    for (double& x : q)
      x = is_near ? x * m_factors[0] * m_factors[1] : x / most * farthest;
    return q;
  }

private:
  Vector_3d m_half_middle = {0, 0, 0};
  double m_factors[2] = {1, 1}; // powers of 2; their product may be too large for one
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_UNIT_FRAME_H
