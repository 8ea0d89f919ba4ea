// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_LISTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUPPORT_LISTS_H

#include <CGAL/Delaunay_from_surface_3/internal/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

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

// Numbers of items become places where lists begin: at[i] those of list i - 1 before, at[i + 1] the
// begin of list i afterwards.
template <class Index>
void add_up(Large_vector<Index>& at)
{
  for (std::size_t i = 2; i < at.size(); ++i)
    at[i] += at[i - 1];
}

// in_lists() by several threads. Each has lists of its own, and looks at all items; what belongs to
// the lists of others goes where nobody reads it, without a branch.
template <class Index, class ListOf, class ItemOf, class Executor>
Lists<Index> in_lists_by_many(std::size_t n, std::size_t m, const ListOf& list_of,
                              const ItemOf& item_of, const Executor& executor)
{
  Lists<Index> lists;
  lists.first.assign(n + 2, 0);
  lists.items.resize(m);
  Index* const at = lists.first.data();
  Index* const items = lists.items.data();
  const std::size_t blocks = executor.number_of_workers();
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t) {
    Index others = 0;
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t i = list_of(k);
      Index& number = i - first < last - first ? at[i + 2] : others;
      ++number;
    }
  });
  add_up(lists.first);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t) {
    Index nobody, nowhere = 0;
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t ahead = list_of((std::min)(k + prefetch_distance, m - 1));
      prefetch(items + (ahead - first < last - first ? at[ahead + 1] : nowhere));
      const std::size_t i = list_of(k);
      const bool is_own = i - first < last - first;
      Index& place = is_own ? at[i + 1] : nowhere;
      (is_own ? items[place] : nobody) = item_of(k);
      place = Index(place + is_own);
    }
  });
  lists.first.pop_back();
  return lists;
}

// Puts item_of(k) into the list list_of(k), k = 0, …, m-1, of n lists: a counting sort.
template <class Index, class ListOf, class ItemOf, class Executor = Alone>
Lists<Index> in_lists(std::size_t n, std::size_t m, const ListOf& list_of, const ItemOf& item_of,
                      const Executor& executor = Executor())
{
  constexpr std::size_t many = std::size_t(1) << 15;
  if constexpr (!std::is_same<Executor, Alone>::value)
    if (executor.number_of_workers() > 1 && m >= many)
      return in_lists_by_many<Index>(n, m, list_of, item_of, executor);
  (void)executor, (void)many;
  Lists<Index> lists;
  lists.first.assign(n + 2, 0);
  for (std::size_t k = 0; k < m; ++k)
    ++lists.first[list_of(k) + 2];
  add_up(lists.first);
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
