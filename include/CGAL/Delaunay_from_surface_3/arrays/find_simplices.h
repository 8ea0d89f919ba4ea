// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_SIMPLICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_SIMPLICES_H

// Finds the simplices of many points: each thread sorts a part of them by space, and walks from one
// to the next.

#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Writes to found[i] what contains queries[i].
template <class Index, class PointOf>
void find_simplices(const Simplices_view<Index>& simplices, const PointOf& point_of,
                    const Point_array& queries, Index* found, const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, queries.size(), 1024);
  for_each_block(executor, queries.size(), blocks,
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   std::vector<std::size_t> order(last - first);
                   std::iota(order.begin(), order.end(), first);
                   Sort_by_halves()(queries, order.data(), order.data() + order.size());
                   Find_simplex<Index, PointOf> find(simplices, point_of);
                   Steps step(executor);
                   for (const std::size_t i : order) {
                     step(64); // cells on the way, about
                     found[i] = find({queries[i][0], queries[i][1], queries[i][2]});
                   }
                 });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_SIMPLICES_H
