// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ORDER_OF_INDICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ORDER_OF_INDICES_H

#include <CGAL/Random.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/algorithm.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The plans sort indices by the points behind them. Sorting (point, index) pairs keeps the points
// beside each other in memory; sorting bare indices would miss the cache at every comparison.
template <class Point, class GeomTraits, class Sort>
void sort_indices(const std::vector<Point>& points, const GeomTraits& gt,
                  std::vector<std::size_t>::iterator first, std::vector<std::size_t>::iterator last,
                  const Sort& sort)
{
  using Item = std::pair<Point, std::size_t>;
  using Adapter = Spatial_sort_traits_adapter_3<GeomTraits, First_of_pair_property_map<Item>>;

  std::vector<Item> items;
  items.reserve(static_cast<std::size_t>(last - first));
  for (auto it = first; it != last; ++it)
    items.emplace_back(points[*it], *it);

  sort(items.begin(), items.end(), Adapter(First_of_pair_property_map<Item>(), gt));

  for (const Item& item : items)
    *first++ = item.second;
}

// Sorts the first `number_of_rounds` rounds, each along a Hilbert curve through its points.
template <class Point, class GeomTraits>
void hilbert_sort_rounds(const std::vector<Point>& points, const GeomTraits& gt,
                         Insertion_order& plan, std::size_t number_of_rounds)
{
  auto first = plan.order.begin();
  for (std::size_t h = 0; h < number_of_rounds; ++h) {
    const auto last = plan.order.begin() + std::ptrdiff_t(plan.round_ends[h]);
    sort_indices(points, gt, first, last,
                 [](auto b, auto e, const auto& traits) { hilbert_sort(b, e, traits); });
    first = last;
  }
}

inline std::vector<std::size_t> identity_order(std::size_t n)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  return order;
}

// A uniformly random permutation of 0, …, n-1, the same for the same seed everywhere.
inline std::vector<std::size_t> random_order(std::size_t n, unsigned int seed)
{
  std::vector<std::size_t> order = identity_order(n);
  Random random(seed);
  cpp98::random_shuffle(order.begin(), order.end(), random);
  return order;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ORDER_OF_INDICES_H
