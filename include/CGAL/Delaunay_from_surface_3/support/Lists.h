// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_H

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Lists of numbers, one after the other, owned elsewhere: list i is items[first[i]], …,
// items[first[i+1] - 1].
template <class Index>
struct Lists_view
{
  const Index* first;
  const Index* items;
  std::size_t number_of_lists, number_of_items;

  std::size_t size() const { return number_of_lists; }
  const Index* begin(std::size_t i) const { return items + first[i]; }
  const Index* end(std::size_t i) const { return items + first[i + 1]; }
};

// Lists of numbers, one after the other: list i is items[first[i]], …, items[first[i+1] - 1].
template <class Index>
struct Lists
{
  Large_vector<Index> first;
  Large_vector<Index> items;

  std::size_t size() const { return first.size() - 1; }
  const Index* begin(std::size_t i) const { return items.data() + first[i]; }
  const Index* end(std::size_t i) const { return items.data() + first[i + 1]; }

  // Works also if there is no list.
  operator Lists_view<Index>() const
  {
    return {first.data(), items.data(), first.empty() ? 0 : size(), items.size()};
  }
};

// The least number of items that is worth a thread.
constexpr std::size_t many_items = std::size_t(1) << 14;

// Items given by functions: item(k) goes into list(k), k = 0, …, size() - 1.
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

// The items first, …, last - 1 of others. Keeps a reference.
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

// Turns the numbers of items that each block has for n lists into the places of the first of these
// items: lists come one after the other, and in each list its blocks. Returns the number of items.
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

// Puts items that come in blocks into n lists: a counting sort, which keeps their order. One thread
// does each block, with n numbers of its own.
template <class Index>
class Sort_into_lists
{
public:
  // Keeps a reference to the executor.
  Sort_into_lists(std::size_t n, std::size_t blocks, const Executor& executor)
    : m_executor(executor)
    , m_numbers(blocks - 1)
    , m_places(blocks)
  {
    m_lists.first.assign(n + 1, 0);
    m_places.back() = m_lists.first.data() + 1; // becomes the array of the ends of lists
  }

  // Before place(): count(b, numbers) must add 1 to numbers[list] for each item of block b.
  template <class Count>
  void count(const Count& count)
  {
    for_each_block(m_executor, m_places.size(), m_places.size(),
                   [&](std::size_t, std::size_t, std::size_t b) {
                     if (b < m_numbers.size()) {
                       m_numbers[b].assign(m_lists.size(), 0);
                       m_places[b] = m_numbers[b].data();
                     }
                     count(b, m_places[b]);
                   });
  }

  // place(b, places, items) puts each item of block b, in order, to items[places[list]++].
  template <class Place>
  Lists<Index> place(const Place& place)
  {
    m_lists.items.resize(numbers_to_places(m_lists.size(), m_places, m_executor));
    for_each_block(m_executor, m_places.size(), m_places.size(),
                   [&](std::size_t, std::size_t, std::size_t b) {
                     place(b, m_places[b], m_lists.items.data());
                   });
    return std::move(m_lists);
  }

private:
  const Executor& m_executor;
  Lists<Index> m_lists;
  std::vector<Large_vector<Index>> m_numbers;
  std::vector<Index*> m_places;
};

// Puts each item of a block at the next free place of its list.
template <class Index, class Items>
void place_items(const Items& items, Index* places, Index* all)
{
  for (std::size_t k = 0, m = items.size(); k < m; ++k) {
    prefetch(all + places[items.list((std::min)(k + prefetch_distance, m - 1))]);
    all[places[items.list(k)]++] = items.item(k);
  }
}

// Returns lists of all items of these blocks. Throws if an Index cannot number them.
template <class Index, class Items>
Lists<Index> in_lists(std::size_t n, const std::vector<Items>& blocks,
                      const Executor& executor = Alone())
{
  std::size_t size = 0;
  for (const Items& block : blocks)
    size += block.size();
  if (size > (std::numeric_limits<Index>::max)())
    throw std::length_error("lists have more items than an index can number");
  Sort_into_lists<Index> sort(n, blocks.size(), executor);
  sort.count([&](std::size_t b, Index* numbers) {
    for (std::size_t k = 0; k < blocks[b].size(); ++k)
      ++numbers[blocks[b].list(k)];
  });
  return sort.place(
      [&](std::size_t b, Index* places, Index* items) { place_items(blocks[b], places, items); });
}

// Does the same for items in one piece, which is cut into blocks if there are many.
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
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_H
