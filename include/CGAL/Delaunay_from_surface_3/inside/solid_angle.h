// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_SOLID_ANGLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_SOLID_ANGLE_H

// The solid angle of a triangle (van Oosterom, Strackee 1983): its tangent of a half is a quotient,
// positive where the triangle is seen from behind.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vector_products.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Vector_3d = std::array<double, 3>;

// A vector of the same direction whose largest coordinate is at least 1/2 and less than 1; 0 of 0.
inline Vector_3d over_power_of_2(const Vector_3d& v)
{
  int exponent = 0;
  std::frexp((std::max)((std::max)(std::abs(v[0]), std::abs(v[1])), std::abs(v[2])), &exponent);
  return {std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), std::ldexp(v[2], -exponent)};
}

// Half of that of the triangle with these corners as seen from q. On the triangle itself it is π or
// -π, at its corners 0.
inline double half_solid_angle(const Vector_3d* corners, const Vector_3d& q)
{
  Vector_3d a = minus(corners[0], q), b = minus(corners[1], q), c = minus(corners[2], q);
  double aa = std::sqrt(dot(a, a)), bb = std::sqrt(dot(b, b)), cc = std::sqrt(dot(c, c));
  if (aa * bb * cc < 0x1p-400) { // products may vanish; lengths do not matter
    a = over_power_of_2(a), b = over_power_of_2(b), c = over_power_of_2(c);
    aa = std::sqrt(dot(a, a)), bb = std::sqrt(dot(b, b)), cc = std::sqrt(dot(c, c));
  }
  const double y = dot(a, cross(b, c));
  const double x = aa * bb * cc + dot(a, b) * cc + dot(b, c) * aa + dot(c, a) * bb;
  const double t = y / x;
  if (x > 0 && t * t < 0.0004) // the series is as good, and most triangles are far away
    return t * (1 - t * t * (1. / 3 - t * t * (1. / 5 - t * t / 7)));
  return std::atan2(y, x);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_SOLID_ANGLE_H
