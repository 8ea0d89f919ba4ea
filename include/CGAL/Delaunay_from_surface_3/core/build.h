// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H

// The core: the Delaunay triangulation of points that are doubles, in an order that is made from
// them or given. It knows no mesh and no triangulation of CGAL's; adapters lead
// into it (a triangulation's, that of arrays).

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// What a caller asks of the core besides points and order.
struct Request
{
  // Whether points in one plane get an apex off it. The cells at it are then their triangles, with
  // the same perturbation. Otherwise such points are not triangulated.
  bool adds_apex;

  // Whether points start where the order says. Otherwise each starts from the one before.
  bool uses_starting_places;

  // How many cells there may be, dead ones included, before the outcome is TOO_MANY_CELLS.
  std::size_t most_cells = std::size_t(1) << 30;
};

// The order that the core makes itself: spaced rounds, within a budget, and then random rounds; or
// these at once.
std::unique_ptr<Order_source> order_of_core(const Order_request& request);

// What keeps the core from being exact or fast: what its compiler does to operations on doubles, or a
// mode without denormal numbers that Rounding_to_nearest cannot switch off; null if nothing is known.
// Asked where that lives.
const char* obstacle_of_core();

// The Delaunay triangulation of the points, whose coordinates are finite. The numbers in it are
// places in its order. Exact, with CGAL's symbolic perturbation. Expected O(n log n) for n points
// on surfaces like those measured, the order included; no more than what the budgets allow and an
// order without one takes.
//
// Crew: who inserts.
template <class Crew>
std::unique_ptr<Built> build(Point_source& points, Order_source& orders, const Request& request,
                             Watcher& watcher, const Executor& executor);

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#endif

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H
