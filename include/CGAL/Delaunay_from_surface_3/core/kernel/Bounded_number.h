// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BOUNDED_NUMBER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BOUNDED_NUMBER_H

// Numbers that carry the bound of their own error: the sum of the absolute values of the products
// that they are made of. Let S be that sum, exactly. Where each product went through at most n
// roundings by a share of at most e, so that the value is wrong by at most ((1 + e)^n - 1) S, the
// size went through at most 17 of u = 2^-53, and is at least (1 - u)^17 S.

#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cmath>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Number>
struct Bounded_number
{
  Number value;
  double size;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Bounded_number
  operator+(const Bounded_number& s, const Bounded_number& t)
  {
    return {s.value + t.value, s.size + t.size};
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Bounded_number
  operator-(const Bounded_number& s, const Bounded_number& t)
  {
    return {s.value - t.value, s.size + t.size};
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Bounded_number
  operator*(const Bounded_number& s, const Bounded_number& t)
  {
    return {s.value * t.value, s.size * t.size};
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BOUNDED_NUMBER_H
