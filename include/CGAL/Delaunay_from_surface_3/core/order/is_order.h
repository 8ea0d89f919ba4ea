// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_IS_ORDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_IS_ORDER_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether it is an order of n points: a permutation, rounds that end later and later, the last with
// the last point, and no starting places or one before each. Linear.
inline bool is_order(const Insertion_order& order, std::size_t n)
{
  std::vector<char> is_there(n);
  for (const std::size_t i : order.order)
    if (i >= n || is_there[i]++ != 0)
      return false;
  for (std::size_t h = 0; h < order.round_ends.size(); ++h)
    if (order.round_ends[h] <= (h == 0 ? 0 : order.round_ends[h - 1]))
      return false;
  for (std::size_t k = 1; k < order.starting_places.size(); ++k)
    if (order.starting_places[k] >= k)
      return false;
  return order.order.size() == n && (order.round_ends.empty() ? 0 : order.round_ends.back()) == n &&
         (order.starting_places.empty() || order.starting_places.size() == n);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_IS_ORDER_H
