// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_DEGREE_WITNESS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_DEGREE_WITNESS_H

// This header needs the standard library only.

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

proves that no spanning tree of a component has a much smaller degree than that of
`near_minimum_degree_spanning_tree()`. Removing some vertices X leaves so many components that every
spanning tree has many edges at one of these vertices.
*/
struct Minimum_degree_witness
{
  std::vector<std::size_t> vertices;    ///< the indices of the vertices X, in no particular order
  std::size_t number_of_components = 0; ///< the number left without X, counted in the surface
  std::size_t tree_degree = 0;          ///< the largest degree of the tree that was found

  /// returns a degree that every spanning tree of the component has or exceeds at some vertex of X.
  /// If c components are left without x vertices, a tree has at least c + x − 1 edges at these.
  std::size_t least_degree() const
  {
    const std::size_t x = vertices.size();
    return x == 0 ? 0 : (number_of_components + x - 1 + x - 1) / x;
  }

  /// returns whether the witness proves that no tree has a degree smaller by more than one.
  bool is_within_one() const { return tree_degree <= least_degree() + 1; }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_DEGREE_WITNESS_H
