// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_PREFETCH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_PREFETCH_H

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Tells the processor that *address will be read soon; only a hint, and any address will do.
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_PREFETCH_H
