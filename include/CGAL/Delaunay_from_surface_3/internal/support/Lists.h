// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_LISTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_LISTS_H

#include <CGAL/Delaunay_from_surface_3/internal/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/prefetch.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Lists of numbers, one after the other: that of i is items[first[i]], …, items[first[i+1] - 1].
template <class Index>
struct Lists
{
  Large_vector<Index> first;
  Large_vector<Index> items;

  std::size_t size() const { return first.size() - 1; }
  const Index* begin(std::size_t i) const { return items.data() + first[i]; }
  const Index* end(std::size_t i) const { return items.data() + first[i + 1]; }
};

// Puts item_of(k) into the list list_of(k), k = 0, …, m-1, of n lists: a counting sort.
template <class Index, class ListOf, class ItemOf>
Lists<Index> in_lists(std::size_t n, std::size_t m, const ListOf& list_of, const ItemOf& item_of)
{
  Lists<Index> lists;
  lists.first.assign(n + 2, 0);
  for (std::size_t k = 0; k < m; ++k)
    ++lists.first[list_of(k) + 2];
  for (std::size_t i = 2; i < lists.first.size(); ++i)
    lists.first[i] += lists.first[i - 1];
  lists.items.resize(m);
  // first[i + 1] runs from the begin to the end of the list i
  for (std::size_t k = 0; k < m; ++k) {
    prefetch(lists.items.data() +
             lists.first[list_of((std::min)(k + prefetch_distance, m - 1)) + 1]);
    lists.items[lists.first[list_of(k) + 1]++] = item_of(k);
  }
  lists.first.pop_back();
  return lists;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_LISTS_H
