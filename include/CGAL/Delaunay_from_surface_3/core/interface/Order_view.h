// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_VIEW_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_VIEW_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// An order of insertion owned elsewhere: see Insertion_order.
struct Order_view
{
  const std::size_t* order;
  std::size_t size;
  const std::size_t* round_ends;
  std::size_t number_of_rounds;
  const std::size_t* starting_places; // null if there are none
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_VIEW_H
