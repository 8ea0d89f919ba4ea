// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_VECTORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_VECTORS_H

// Functions in vector instructions that the user need not compile for: they are marked with their
// target, and called where the machine has it. The target has no fma, so that no product is fused.

#if defined(__GNUC__) && defined(__x86_64__)

#include <immintrin.h>

#define CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
#define CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS __attribute__((target("avx2,popcnt")))
#define CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS                                             \
  __attribute__((target("avx2,popcnt"), always_inline)) inline

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

inline bool machine_has_vectors()
{
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt");
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_VECTORS_H
