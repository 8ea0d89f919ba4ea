// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_PERMUTATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_PERMUTATION_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// result[k] = items[order[k]]
template <class T>
std::vector<T> permuted(const std::vector<T>& items, const std::vector<std::size_t>& order)
{
  std::vector<T> result;
  result.reserve(order.size());
  for (const std::size_t i : order)
    result.push_back(items[i]);
  return result;
}

// result[order[k]] = k
inline std::vector<std::size_t> inverse(const std::vector<std::size_t>& order)
{
  std::vector<std::size_t> result(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    result[order[k]] = k;
  return result;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_PERMUTATION_H
