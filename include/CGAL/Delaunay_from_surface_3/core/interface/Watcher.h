// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_WATCHER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_WATCHER_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Is told what the core does, and can stop it. All functions are called by the thread that called
// the core.
class Watcher
{
public:
  virtual ~Watcher() = default;

  virtual void phase_begins(Surface_insertion_phase) {}
  virtual void order_is_replaced(const char* /* reason */) {}
  virtual void insertion_begins(std::size_t /* number_of_threads */) {}
  virtual void round_begins(std::size_t /* round */, std::size_t /* number_of_points */) {}
  virtual void insertion_ends(const Insertion_counts&) {}

  // Is asked every 256 points, with the number inserted so far; `false` stops the work.
  virtual bool go_further(std::size_t /* inserted */) { return true; }

  // Whether it is told of the phases LOCATION and UPDATE, point by point. Not with many threads.
  virtual bool follows_points() const { return false; }

  // Whether it is asked which points are inserted, and looks at the corners then.
  virtual bool leaves_points_out() const { return false; }
  virtual bool looks_at_corners() const { return false; }

  // Whether point i may be inserted. The vertex nearest to it is that of point `nearest`, and
  // `corners` are those of a cell that contains it (none if it lies beyond the facet of the others,
  // or if there is no cell yet). All are the caller's numbers. Not asked of a point that has a
  // vertex at its place.
  using Corners = std::array<std::size_t, 4>;
  static constexpr std::size_t none = std::size_t(-1);
  virtual bool accepts(std::size_t /* i */, std::size_t /* nearest */, const Corners&)
  {
    return true;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_WATCHER_H
