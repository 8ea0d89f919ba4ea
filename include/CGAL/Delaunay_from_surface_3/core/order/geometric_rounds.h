// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H

// A biased randomised insertion order (Amenta, Choi, Rote 2003): rounds that grow geometrically,
// each in a spatially coherent order.
//
// Cost: O(n log n) expected.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_round_ends.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <numeric>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A random order, in these rounds, each sorted by halves.
inline Insertion_order geometric_rounds(const Point_array& points, unsigned int seed, double ratio,
                                        std::size_t first_round)
{
  Insertion_order result;
  result.order.resize(points.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t(0));
  Split_mix(seed).shuffle(result.order.begin(), result.order.end());
  result.round_ends = geometric_round_ends(points.size(), ratio, first_round);
  Sort_by_halves sort;
  std::size_t first = 0;
  for (const std::size_t end : result.round_ends) {
    sort(points, result.order.data() + first, result.order.data() + end);
    first = end;
  }
  return result;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUNDS_H
