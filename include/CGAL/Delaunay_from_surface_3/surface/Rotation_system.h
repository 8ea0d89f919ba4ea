// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H

// A triangulated surface as flat arrays: what every step of the subgraphs works on.
//
// Invariant: darts first[v] .. first[v+1]-1 are the edges at v in the order in which they stand
// around v, in either direction; neighbor[dart] is the other end. The list of an interior vertex is
// cyclic, that of a vertex on the boundary starts and ends with its boundary edges. The graph is
// simple, so an edge is known by its two ends and the darts of an edge need no link to each other.
// Cost: 4 bytes per dart and per vertex; 28 bytes per vertex on a closed surface.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Dart_marks = std::vector<bool>; // one bit per dart

// The edges around one vertex, in order.
template <class Index>
struct Star
{
  const Index* first;
  const Index* last;

  const Index* begin() const { return first; }
  const Index* end() const { return last; }
  Index size() const { return static_cast<Index>(last - first); }
  Index operator[](Index position) const { return first[position]; }
};

template <class Index_>
struct Rotation_system
{
  using Index = Index_;

  std::vector<Index> first;      // number_of_vertices() + 1 entries
  std::vector<Index> neighbor;   // one per dart
  std::vector<bool> on_boundary; // one bit per vertex

  Index number_of_vertices() const { return static_cast<Index>(on_boundary.size()); }
  std::size_t number_of_darts() const { return neighbor.size(); }
  Index degree(Index v) const { return first[v + 1] - first[v]; }

  Star<Index> star(Index v) const
  {
    return {neighbor.data() + first[v], neighbor.data() + first[v + 1]};
  }

  // Corners of triangles at v: one less than edges where the list is not cyclic.
  Index number_of_corners(Index v) const
  {
    return degree(v) == 0 ? 0 : degree(v) - (on_boundary[v] ? 1 : 0);
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H
