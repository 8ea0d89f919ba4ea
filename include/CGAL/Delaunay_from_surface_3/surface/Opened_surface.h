// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_OPENED_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_OPENED_SURFACE_H

// The surface cut open into discs: the rotation system, plus copies of the vertices on the cut.
//
// Invariant: vertices 0 .. n-1 are the surface's own; n, n+1, … are the copies. A vertex that has
// copies is dead itself: no list names it any more. Around a vertex on the rim of a disc (a copy, a
// vertex with one sector on the boundary, a corner of an opened face) the live part of its list
// lies between its two rim neighbours.
// Cost: no memory where nothing is cut; 4 bytes per dart of a copy and 16 per copy.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
struct Opened_surface
{
  Rotation_system<Index>& surface;
  std::vector<Index> copy_first = {0}; // as Rotation_system::first, for the copies
  std::vector<Index> copy_neighbor;    // as Rotation_system::neighbor
  std::vector<Index> copy_origin;      // the surface vertex a copy was made of
  std::vector<Index> copy_start;       // where in its origin's list the copy's list starts
  std::vector<Index> rim;              // every vertex on the rim of a disc, each once

  explicit Opened_surface(Rotation_system<Index>& s)
    : surface(s)
  {
  }

  Index number_of_surface_vertices() const { return surface.number_of_vertices(); }
  Index number_of_copies() const { return static_cast<Index>(copy_origin.size()); }
  Index number_of_vertices() const { return number_of_surface_vertices() + number_of_copies(); }
  bool is_copy(Index v) const { return v >= number_of_surface_vertices(); }

  Index origin(Index v) const
  {
    return is_copy(v) ? copy_origin[v - number_of_surface_vertices()] : v;
  }

  Star<Index> star(Index v) const
  {
    if (!is_copy(v))
      return surface.star(v);
    const Index c = v - number_of_surface_vertices();
    return {copy_neighbor.data() + copy_first[c], copy_neighbor.data() + copy_first[c + 1]};
  }

  // The surface's dart that stands at a position of v's list.
  std::size_t dart(Index v, Index position) const
  {
    if (!is_copy(v))
      return std::size_t(surface.first[v]) + position;
    const Index c = v - number_of_surface_vertices();
    const Index o = copy_origin[c];
    const Index p = copy_start[c] + position;
    const Index degree = surface.degree(o);
    return std::size_t(surface.first[o]) + (p < degree ? p : p - degree);
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_OPENED_SURFACE_H
