// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_OBSTACLE_OF_COMPILER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_OBSTACLE_OF_COMPILER_H

// The bounds and error terms of the filters assume that each operation on doubles is done as
// written, and rounded to a double.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cfloat>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Not on x87. (Methods 1 and 16 evaluate only narrower types in wider ones.)
constexpr bool rounds_every_operation =
    FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 16;

// The macros by which compilers announce -ffast-math or its parts. g++ defines the one in the
// middle for each part.
#if defined(__FAST_MATH__) || (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0) ||                    \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || defined(_M_FP_FAST)
constexpr bool is_fast_math = true;
#else
constexpr bool is_fast_math = false;
#endif

// Returns true if the error of a difference is right, for numbers that the compiler does not know:
// clang has no macro for when it may compute in another order, and then does so here.
inline bool has_error_terms()
{
  const volatile double one = 1, small = 0x1p-60;
  const double a = one, b = small, difference = a - b;
  return difference == 1 && error_of_difference(a, b, difference) == -small;
}

// Returns true if denormal numbers survive in this thread's mode. No macro tells: any library that
// a program loads may have changed it.
[[gnu::cold]] inline bool keeps_denormals()
{
  const volatile double least = (std::numeric_limits<double>::min)(), two = 2;
  const volatile double half = least / two;
  return half != 0;
}

// Returns what the compiler does otherwise; null if nothing is known.
inline const char* obstacle_of_compiler()
{
  if (!rounds_every_operation)
    return "operations on doubles are not rounded to doubles";
  if (is_fast_math || !has_error_terms())
    return "the compiler may change operations on doubles (-ffast-math, -Ofast)";
  return nullptr;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_OBSTACLE_OF_COMPILER_H
