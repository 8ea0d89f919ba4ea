// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_FAIL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_FAIL_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <stdexcept>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Reports a broken invariant: throws, also where assertions are off.
[[noreturn]] inline void fail(const char* invariant)
{
  throw std::logic_error(invariant);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_FAIL_H
