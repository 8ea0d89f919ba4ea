// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ASSERTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ASSERTIONS_H

// Checks invariants of the core, which does not know CGAL's assertions but obeys the same macros:
// checks are off with NDEBUG, if CGAL_DEBUG is not defined, and with CGAL_NO_ASSERTIONS; expensive
// ones, which look at more than what was just written, are on with CGAL_CHECK_EXPENSIVE.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <stdexcept>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Reports a broken invariant. It throws even if assertions are off.
[[noreturn]] inline void fail(const char* invariant)
{
  throw std::logic_error(invariant);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#if defined(CGAL_NO_ASSERTIONS) || defined(CGAL_NDEBUG) || (defined(NDEBUG) && !defined(CGAL_DEBUG))
#define CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(invariant) static_cast<void>(0)
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(invariant)                                             \
  ((invariant) ? static_cast<void>(0) : ::CGAL::Delaunay_from_surface_3::core::fail(#invariant))
#endif

#if defined(CGAL_CHECK_EXPENSIVE)
#define CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(invariant)                                   \
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(invariant)
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(invariant) static_cast<void>(0)
#endif

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ASSERTIONS_H
