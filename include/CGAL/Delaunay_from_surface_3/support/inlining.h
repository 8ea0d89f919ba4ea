// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_INLINING_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_INLINING_H

// Code shared by functions for several instruction sets must be inlined into each.
#if defined(__GNUC__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE __attribute__((always_inline)) inline
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE inline
#endif

// Code that is rarely reached must not take registers from code that often is.
#if defined(__GNUC__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_APART __attribute__((noinline)) inline
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_APART inline
#endif

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_INLINING_H
