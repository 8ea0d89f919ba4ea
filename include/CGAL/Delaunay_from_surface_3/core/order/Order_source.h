// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_SOURCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_SOURCE_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Where the order of insertion comes from: from a surface, from the points alone, from a caller's
// own plan. It is asked when it is needed, and need not do anything before.
class Order_source
{
public:
  virtual ~Order_source() = default;

  // Of the points, by as many threads as it can use.
  virtual Insertion_order make(const Point_array& points, const Executor& executor) = 0;

  // What that order may cost.
  virtual Insertion_budget budget() const = 0;

  // Goes on to the order that takes its place if that was exceeded; false if there is none, as there
  // may be where there is no budget.
  virtual bool go_on() = 0;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_SOURCE_H
