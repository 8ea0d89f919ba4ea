// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H

// The core: the Delaunay triangulation of points that are doubles, in an order that is made from
// them or given. It knows no mesh and no triangulation of CGAL's; adapters lead into it and out.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Returns what keeps the core from being exact or fast: what its compiler does to operations on
// doubles, or a mode without denormal numbers that Rounding_to_nearest cannot switch off; null if
// nothing is known. It is to be asked while that lives.
const char* obstacle_of_core();

// Returns the Delaunay triangulation of the points, whose coordinates are finite. The numbers in it
// are places in its order. It is exact, with CGAL's symbolic perturbation. Expected O(n log n) for n
// points on surfaces like those measured, the order included; no more than what the budgets allow
// and an order without one takes. As many threads insert as the executor has workers: whoever calls
// this header-only includes core/build_by_threads.h.
std::unique_ptr<Built> build(Point_source& points, const Build_options& options, Observer& observer,
                             const Executor& executor);

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
// Does the same with one thread, so that a program without threads does not compile their code.
std::unique_ptr<Built> build(Point_source& points, const Build_options& options, Observer& observer,
                             const Alone& executor);
#endif

// Returns whether it is an order of n points: a permutation, rounds that end later and later, the
// last with the last point, and no starting places or one before each. Linear.
inline bool is_order(const Insertion_order& order, std::size_t n)
{
  std::vector<char> is_there(n);
  for (const std::size_t i : order.order)
    if (i >= n || is_there[i]++ != 0)
      return false;
  for (std::size_t h = 0; h < order.round_ends.size(); ++h)
    if (order.round_ends[h] <= (h == 0 ? 0 : order.round_ends[h - 1]))
      return false;
  for (std::size_t k = 1; k < order.starting_places.size(); ++k)
    if (order.starting_places[k] >= k)
      return false;
  return order.order.size() == n && (order.round_ends.empty() ? 0 : order.round_ends.back()) == n &&
         (order.starting_places.empty() || order.starting_places.size() == n);
}

// Builds in the order of the last call, for points that have moved a little since. If it has fewer
// or more points, or costs too much by now, the core's own order takes its place in `kept`, which is
// empty meanwhile, and stays empty after an exception or if the points lie on a line.
template <class Source, class Executor>
std::unique_ptr<Built> build_again(Insertion_order& kept, Source& points, Build_options options,
                                   Observer& observer, const Executor& executor)
{
  if (kept.order.size() == points.points().size()) {
    if (!is_order(kept, kept.order.size()))
      throw Surface_input_error("order: not a permutation of the points, or its ends of rounds do "
                                "not ascend, or a starting place is not before its point");
    observer.phase_begins(Surface_insertion_phase::PLAN, 0);
    const Order_view view = view_of(kept);
    options.given = &view;
    options.is_spread = true;
    auto built = build(points, options, observer, executor);
    if (built->outcome != Insertion_outcome::OVER_BUDGET)
      return built;
    options.given = nullptr;
  }
  kept = Insertion_order();
  auto built = build(points, options, observer, executor);
  if (built->dimension > 1)
    kept = copy_of(built->order);
  return built;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#endif

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H
