// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_SOURCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_SOURCE_H

#include <CGAL/Delaunay_from_surface_3/core/interface/Order_view.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Where the order of insertion comes from: from a surface, from the points alone, from a caller's
// own plan. It is asked when it is needed, and need not do anything before.
class Order_source
{
public:
  virtual ~Order_source() = default;

  // Of the points, by as many threads as it can use. What is returned is valid until the next call
  // of make() or go_on().
  virtual Order_view make(const Point_array& points, const Executor& executor) = 0;

  // What that order may cost: the number of destroyed cells per point (Insertion_budget), or any
  // number.
  static constexpr std::size_t any_number = std::size_t(-1);
  virtual std::size_t cells_per_point() const = 0;

  // Whether the first points are spread over all at any time, so that of the cells which are then many
  // most must stay. Of an order by edges, which may begin with hubs, nobody knows.
  virtual bool is_spread() const { return false; }

  // Goes on to the order that takes its place if that was exceeded; false if there is none, as there
  // may be where there is no budget.
  virtual bool go_on() = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_SOURCE_H
