// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_PERMUTATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_PERMUTATION_H

#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// result[k] = items[order[k]]
template <class T>
std::vector<T> permuted(const std::vector<T>& items, const std::vector<std::size_t>& order,
                        const Executor& executor = Alone())
{
  std::vector<T> result;
  if constexpr (std::is_default_constructible<T>::value) {
    const std::size_t blocks = number_of_blocks(executor, order.size(), 4096);
    if (blocks > 1) {
      result.resize(order.size());
      for_each_block(executor, order.size(), blocks,
                     [&](std::size_t first, std::size_t last, std::size_t) {
                       for (std::size_t k = first; k < last; ++k)
                         result[k] = items[order[k]];
                     });
      return result;
    }
  }
  result.reserve(order.size());
  for (const std::size_t i : order)
    result.push_back(items[i]);
  return result;
}

// result[order[k]] = k
inline std::vector<std::size_t> inverse(const std::size_t* order, std::size_t n)
{
  std::vector<std::size_t> result(n);
  for (std::size_t k = 0; k < n; ++k)
    result[order[k]] = k;
  return result;
}
inline std::vector<std::size_t> inverse(const std::vector<std::size_t>& order)
{
  return inverse(order.data(), order.size());
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_PERMUTATION_H
