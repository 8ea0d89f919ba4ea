// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_H

#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists_view.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Lists of numbers, one after the other: that of i is items[first[i]], …, items[first[i+1] - 1].
template <class Index>
struct Lists
{
  Large_vector<Index> first;
  Large_vector<Index> items;

  std::size_t size() const { return first.size() - 1; }
  const Index* begin(std::size_t i) const { return items.data() + first[i]; }
  const Index* end(std::size_t i) const { return items.data() + first[i + 1]; }

  // Also of no list at all.
  operator Lists_view<Index>() const
  {
    return {first.data(), items.data(), first.empty() ? 0 : size(), items.size()};
  }
};

// So many items are worth a thread.
constexpr std::size_t many_items = std::size_t(1) << 14;

// Items item(k) that go into lists list(k), k = 0, …, size() - 1, as functions.
template <class ListOf, class ItemOf>
class Listed_items
{
public:
  Listed_items(std::size_t size, const ListOf& list_of, const ItemOf& item_of)
    : m_size(size)
    , m_list_of(list_of)
    , m_item_of(item_of)
  {
  }

  std::size_t size() const { return m_size; }
  std::size_t list(std::size_t k) const { return m_list_of(k); }
  auto item(std::size_t k) const { return m_item_of(k); }

private:
  std::size_t m_size;
  ListOf m_list_of;
  ItemOf m_item_of;
};

// A part of other items: first, …, last - 1. Keeps a reference.
template <class Items>
class Part_of_items
{
public:
  Part_of_items(const Items& items, std::size_t first, std::size_t last)
    : m_items(&items)
    , m_first(first)
    , m_size(last - first)
  {
  }

  std::size_t size() const { return m_size; }
  std::size_t list(std::size_t k) const { return m_items->list(m_first + k); }
  auto item(std::size_t k) const { return m_items->item(m_first + k); }

private:
  const Items* m_items;
  std::size_t m_first, m_size;
};

// The numbers of items of n lists, by block of items, become the places of the first of them:
// those of a list come one after the other, and in it those of a block. Returns how many items
// there are.
template <class Index>
std::size_t numbers_to_places(std::size_t n, const std::vector<Index*>& blocks,
                              const Executor& executor)
{
  const std::size_t ranges = number_of_blocks(executor, n, 4096);
  std::vector<std::size_t> begin(ranges + 1, 0);
  for_each_block(executor, n, ranges, [&](std::size_t first, std::size_t last, std::size_t r) {
    std::size_t sum = 0;
    for (const Index* const numbers : blocks)
      sum = std::accumulate(numbers + first, numbers + last, sum);
    begin[r + 1] = sum;
  });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for_each_block(executor, n, ranges, [&](std::size_t first, std::size_t last, std::size_t r) {
    Index next = Index(begin[r]);
    for (std::size_t i = first; i < last; ++i)
      for (Index* const numbers : blocks)
        next += std::exchange(numbers[i], next);
  });
  return begin[ranges];
}

// Puts the items of all blocks into n lists: a counting sort, which keeps their order. Every block
// is the work of one thread, which has n numbers of its own.
template <class Index, class Items>
Lists<Index> in_lists(std::size_t n, const std::vector<Items>& blocks,
                      const Executor& executor = Alone())
{
  Lists<Index> lists;
  lists.first.assign(n + 1, 0);
  std::vector<Large_vector<Index>> numbers(blocks.size() - 1);
  std::vector<Index*> places(blocks.size());
  places.back() = lists.first.data() + 1; // where its lists end in the end
  for_each_block(executor, blocks.size(), blocks.size(),
                 [&](std::size_t, std::size_t, std::size_t b) {
                   if (b < numbers.size()) {
                     numbers[b].assign(n, 0);
                     places[b] = numbers[b].data();
                   }
                   for (std::size_t k = 0; k < blocks[b].size(); ++k)
                     ++places[b][blocks[b].list(k)];
                 });
  lists.items.resize(numbers_to_places(n, places, executor));
  for_each_block(executor, blocks.size(), blocks.size(),
                 [&](std::size_t, std::size_t, std::size_t b) {
                   const Items& block = blocks[b];
                   Index *const items = lists.items.data(), *const place = places[b];
                   for (std::size_t k = 0, m = block.size(); k < m; ++k) {
                     prefetch(items + place[block.list((std::min)(k + prefetch_distance, m - 1))]);
                     items[place[block.list(k)]++] = block.item(k);
                   }
                 });
  return lists;
}

// The same for items in one piece, which is cut into blocks where there are many.
template <class Index, class Items>
Lists<Index> in_lists(std::size_t n, const Items& items, const Executor& executor = Alone())
{
  const std::size_t m = items.size(), number = number_of_blocks(executor, m, many_items);
  std::vector<Part_of_items<Items>> blocks;
  for (std::size_t b = 0; b < number; ++b)
    blocks.emplace_back(items, m * b / number, m * (b + 1) / number);
  return in_lists<Index>(n, blocks, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_H
