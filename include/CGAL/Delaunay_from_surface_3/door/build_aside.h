// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_BUILD_ASIDE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_BUILD_ASIDE_H

// What is built aside takes the place of an empty triangulation: with its traits, its lock
// structure and what its infinite vertex holds. That is moved, not copied: what a vertex base holds
// need not be copyable, even where its type claims to be (as std::vector does for any element).

#include <CGAL/Delaunay_from_surface_3/door/export_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A vertex with constant members can be copied, but not assigned to another.
template <class Vertex>
constexpr bool is_only_copied =
    std::is_copy_constructible<Vertex>::value && !std::is_move_assignable<Vertex>::value;

// An empty triangulation with the traits and the lock structure of `tr`, which is empty.
template <class Triangulation>
Triangulation empty_like(const Triangulation& tr)
{
  if constexpr (is_only_copied<typename Triangulation::Vertex>) {
    return Triangulation(tr);
  } else {
    Triangulation aside(tr.geom_traits()); // Fast_location has no constructor that takes both
    aside.set_lock_data_structure(tr.get_lock_data_structure());
    return aside;
  }
}

// All that the vertex holds but its cell and its time stamp, which belong to its container.
template <class Vertex>
void move_content(Vertex& from, Vertex& to)
{
  const auto cell = to.cell();
  if constexpr (has_time_stamp<Vertex>) {
    const auto time_stamp = to.time_stamp();
    to = std::move(from);
    to.set_time_stamp(time_stamp);
  } else {
    to = std::move(from);
  }
  to.set_cell(cell);
}

// Both change places. `aside` came from empty_like(tr).
template <class Triangulation>
void take_place(Triangulation& aside, Triangulation& tr)
{
  if constexpr (std::is_move_assignable<typename Triangulation::Vertex>::value)
    move_content(*tr.infinite_vertex(), *aside.infinite_vertex());
  tr.swap(aside);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_BUILD_ASIDE_H
