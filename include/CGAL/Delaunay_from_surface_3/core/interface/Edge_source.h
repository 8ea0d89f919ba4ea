// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_EDGE_SOURCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_EDGE_SOURCE_H

#include <CGAL/Delaunay_from_surface_3/support/Lists_view.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Where the edges of a surface come from.
class Edge_source
{
public:
  virtual ~Edge_source() = default;

  // Of each point those of its neighbours that have smaller numbers, every edge once; or no list at
  // all, if there are no edges or too many for numbers of 32 bits.
  virtual Lists_view<std::uint32_t> edges() = 0;

  // The edges are no longer needed, unless for another order, which can then do without them.
  virtual void give_up() {}
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_EDGE_SOURCE_H
