// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_MAKE_ORDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_MAKE_ORDER_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// What runs threads for a target: its executor, if it names one.
template <class Target, class = void>
struct Executor_of
{
  using type = Alone;
};
template <class Target>
struct Executor_of<Target, std::void_t<typename Target::Threads>>
{
  using type = typename Target::Threads;
};

// By several threads if the plan can.
template <class Executor, class Plan, class... Arguments>
Insertion_order make_order(const Executor& executor, const Plan& make_plan,
                           const Arguments&... arguments)
{
  if constexpr (!std::is_same<Executor, Alone>::value &&
                std::is_invocable<const Plan&, const Arguments&..., const Executor&>::value) {
    return make_plan(arguments..., executor);
  } else {
    (void)executor;
    return make_plan(arguments...);
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_MAKE_ORDER_H
