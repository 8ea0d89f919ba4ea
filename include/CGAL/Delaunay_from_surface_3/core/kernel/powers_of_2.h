// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_POWERS_OF_2_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_POWERS_OF_2_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// 2^(biased_exponent - 1023), between 1 and 2046.
inline double power_of_2(std::uint64_t biased_exponent)
{
  const std::uint64_t bits = biased_exponent << 52;
  double power;
  std::memcpy(&power, &bits, sizeof(power));
  return power;
}

// The biased exponent e of a number that is not negative: the number is less than 2^(e - 1022) and,
// if e is not 0, at least half of that.
inline std::uint64_t biased_exponent(double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof(number));
  return bits >> 52;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_POWERS_OF_2_H
