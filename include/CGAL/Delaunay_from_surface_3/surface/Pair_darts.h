// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PAIR_DARTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PAIR_DARTS_H

// Links the two darts of every edge. The subgraph itself never needs this; to tell an orientable
// surface from another, and to walk over the triangles in any order, it is the simplest way.
//
// Result: mate[dart] is the other dart of the same edge, for darts numbered as in the rotation
// system.
// Cost: O(n), two passes; 24 bytes per vertex and twice that again while it runs.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
std::vector<Index> pair_darts(const Rotation_system<Index>& surface)
{
  const Index n = surface.number_of_vertices();
  struct Incoming
  {
    Index source;
    Index dart;
  };
  // Grouped by target, as the lists are by source.
  std::vector<Incoming> incoming(surface.number_of_darts());
  std::vector<Index> next(surface.first);
  for (Index v = 0; v < n; ++v)
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      incoming[next[surface.neighbor[dart]]++] = {v, dart};
  std::vector<Index> mate(surface.number_of_darts());
  std::vector<Index>& dart_to = next; // for each u the dart from v to u, while v is looked at
  for (Index v = 0; v < n; ++v) {
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      dart_to[surface.neighbor[dart]] = dart;
    for (Index i = surface.first[v]; i < surface.first[v + 1]; ++i)
      mate[incoming[i].dart] = dart_to[incoming[i].source];
  }
  return mate;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PAIR_DARTS_H
