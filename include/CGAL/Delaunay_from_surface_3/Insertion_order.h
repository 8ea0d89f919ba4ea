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

is what an `InsertionPlan` returns: the order in which n points are inserted, and where its rounds
end: in \cgalCite{choi-dtsm-02}, §2, the random order \f$s_1, \ldots, s_n\f$ and the \f$N_h\f$.

Round h, counted from 0, inserts the points `order[k]` with `round_ends[h-1] <= k < round_ends[h]`;
the first begins at `k = 0`.
*/
struct Insertion_order
{
  /// a permutation of 0, …, n-1.
  std::vector<std::size_t> order;

  /// strictly increasing; the last is n. Empty if and only if n is 0.
  std::vector<std::size_t> round_ends;

  /// for every `k > 0` a `starting_places[k] < k`: the insertion of the point `order[k]` may start
  /// at the point `order[starting_places[k]]`, which is near. There are n, of which the first is
  /// not looked at; or none, if the plan knows of none.
  std::vector<std::size_t> starting_places;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_ORDER_H
