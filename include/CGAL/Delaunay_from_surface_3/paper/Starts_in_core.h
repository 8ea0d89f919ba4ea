// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_STARTS_IN_CORE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_STARTS_IN_CORE_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether a hint policy needs no trace and is built into the core. The header of such a policy says
// so.
template <template <class Target, class Subgraph> class InsertionHints>
struct Starts_in_core : std::false_type
{
  static constexpr bool uses_starting_places = true;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_STARTS_IN_CORE_H
