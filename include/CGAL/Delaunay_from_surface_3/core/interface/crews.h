// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_CREWS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_CREWS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Who inserts.
struct One_thread;
struct Many_threads;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The header of each crew names the class.
template <class Crew>
struct Inserter_of;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_CREWS_H
