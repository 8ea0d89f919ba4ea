// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_ORDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_ORDER_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

is the order in which n points are inserted, and the ends of its rounds, as returned by an
`InsertionPlan`. In \cgalCite{choi-dtsm-02}, §2, these are the random order \f$s_1, \ldots, s_n\f$
and the \f$N_h\f$.

Round h, counted from 0, inserts the points `order[k]` with `round_ends[h-1] <= k < round_ends[h]`;
the first round begins at `k = 0`.
*/
struct Insertion_order
{
  /// a permutation of 0, …, n-1.
  std::vector<std::size_t> order;

  /// strictly increasing; the last is n. Empty if and only if n is 0.
  std::vector<std::size_t> round_ends;

  /// for every `k > 0` a place `starting_places[k] < k`: the location of the point `order[k]`
  /// starts at the nearby point `order[starting_places[k]]`. There are n elements, of which the
  /// first is not used, or none, if the plan names no starting points.
  std::vector<std::size_t> starting_places;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_ORDER_H
