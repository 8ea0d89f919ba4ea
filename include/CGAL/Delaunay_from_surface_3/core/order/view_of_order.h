// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_VIEW_OF_ORDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_VIEW_OF_ORDER_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_view.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A view of an order that is kept elsewhere.
inline Order_view view_of(const Insertion_order& order)
{
  return {order.order.data(), order.order.size(), order.round_ends.data(), order.round_ends.size(),
          order.starting_places.empty() ? nullptr : order.starting_places.data()};
}

// A copy, which owns its arrays.
inline Insertion_order copy_of(const Order_view& view)
{
  Insertion_order order;
  order.order.assign(view.order, view.order + view.size);
  order.round_ends.assign(view.round_ends, view.round_ends + view.number_of_rounds);
  if (view.starting_places != nullptr)
    order.starting_places.assign(view.starting_places, view.starting_places + view.size);
  return order;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_VIEW_OF_ORDER_H
