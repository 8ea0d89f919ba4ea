// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H

// Puts points in an order in which those that follow each other are near each other. A set is halved
// at the median across its longest extent; first comes the half that is nearer to the point before
// and farther from the box that comes after; and so on. A Hilbert curve halves along x, y and z in
// turn: in a box 1 : 1/100 : 1/100 it follows cells that are as long and thin as the box.
//
// Many points are halved six times at once, where a sample of them is halved. Each point then moves
// once for six halvings. The parts are sorted by themselves, each after the place where the box before
// comes nearest: so the order does not depend on how many threads do it.
//
// Cost: O(n log n).

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Sort_by_halves
{
public:
  struct Item
  {
    double coordinates[3];
    std::size_t index;
  };

  // Sorts the indices [first, last) of points.
  void operator()(const Point_array& points, std::size_t* first, std::size_t* last,
                  const Executor& executor = Alone())
  {
    if (first == last)
      return;
    m_items.clear();
    m_items.reserve(std::size_t(last - first));
    for (const std::size_t* i = first; i != last; ++i) {
      const double* const p = points[*i];
      m_items.push_back({{p[0], p[1], p[2]}, *i});
    }
    const Box box(m_items.data(), m_items.data() + m_items.size());
    begin_after(box.low); // in a corner
    Item* const begin = m_items.data();
    Item* const end = begin + m_items.size();
    if (!sort_in_parts(begin, end, box, nullptr, executor))
      sort(begin, end, box, nullptr);
    for (const Item& item : m_items)
      *first++ = item.index;
  }

  // The points sorted last.
  const std::vector<Item>& items() const { return m_items; }

private:
  static constexpr std::ptrdiff_t few = 4; // are left as they are
  static constexpr std::ptrdiff_t many = 2048, size_of_sample = 512;
  static constexpr std::size_t parts = 64; // of 8 points of a sample

  struct Box
  {
    Box(const Item* first, const Item* last)
    {
      std::copy(first->coordinates, first->coordinates + 3, low);
      std::copy(first->coordinates, first->coordinates + 3, high);
      for (const Item* i = first + 1; i != last; ++i)
        for (int k = 0; k < 3; ++k) {
          low[k] = (std::min)(low[k], i->coordinates[k]);
          high[k] = (std::max)(high[k], i->coordinates[k]);
        }
    }
    double middle(int k) const { return low[k] / 2 + high[k] / 2; }
    double nearest(int k, double x) const { return (std::max)(low[k], (std::min)(high[k], x)); }
    // How far beyond the middle a coordinate is, at most where the box ends.
    double beyond(int k, double x) const { return nearest(k, x) - middle(k); }
    // Where it comes nearest to the middle of another box.
    std::array<double, 3> point_near(const Box& box) const
    {
      return {nearest(0, box.middle(0)), nearest(1, box.middle(1)), nearest(2, box.middle(2))};
    }
    double low[3], high[3];
  };

  // Where a set is halved: what is beyond goes into the second half.
  struct Cut
  {
    int axis;
    double sign, at;
    bool is_before(const Item& item) const { return sign * item.coordinates[axis] < at; }
  };

  // After the point m_before, and before a box that is `next`, if there is one. Apart, as several
  // functions call it, and a copy in each would make nothing faster.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART void sort(Item* first, Item* last, Box box, const Box* next)
  {
    while (last - first > few) {
      if (sort_in_parts(first, last, box, next, Alone()))
        return;
      Cut cut;
      Item* const middle = halve(first, last, box, next, cut);
      const Box second(middle, last);
      sort(first, middle, Box(first, middle), &second);
      first = middle;
      box = second;
    }
    begin_after(last[-1].coordinates);
  }

  Item* halve(Item* first, Item* last, const Box& box, const Box* next, Cut& cut) const
  {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis])
        axis = k;
    Item* const middle = first + (last - first) / 2;
    const bool up = box.beyond(axis, m_before[axis]) <=
                    (next != nullptr ? box.beyond(axis, next->middle(axis)) : 0);
    if (up)
      std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
        return a.coordinates[axis] < b.coordinates[axis];
      });
    else
      std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
        return a.coordinates[axis] > b.coordinates[axis];
      });
    const double sign = up ? 1 : -1;
    cut = {axis, sign, sign * middle->coordinates[axis]};
    return middle;
  }

  // The cuts of a sample: that of set k, from 1 on, makes sets 2 k and 2 k + 1.
  void cut_sample(std::size_t k, Item* first, Item* last, const Box& box, const Box* next,
                  Cut* cuts)
  {
    if (k >= parts) {
      begin_after(last[-1].coordinates);
      return;
    }
    Item* const middle = halve(first, last, box, next, cuts[k]);
    const Box second(middle, last);
    cut_sample(2 * k, first, middle, Box(first, middle), &second, cuts);
    cut_sample(2 * k + 1, middle, last, second, next, cuts);
  }

  // The same for some of the points, which are drawn from all over them.
  void cut_by_sample(const Item* first, const Item* last, const Box& box, const Box* next,
                     Cut* cuts)
  {
    Item sample[size_of_sample];
    const std::ptrdiff_t stratum = (last - first) / size_of_sample;
    Split_mix random(0);
    for (std::ptrdiff_t k = 0; k < size_of_sample; ++k)
      sample[k] = first[stratum * k + std::ptrdiff_t(random.below(std::uint64_t(stratum)))];
    double before[3];
    std::copy(m_before, m_before + 3, before);
    cut_sample(1, sample, sample + size_of_sample, box, next, cuts);
    begin_after(before);
  }

  // Puts the points into parts, of which the p-th then ends at ends[p + 1]. Returns false if the
  // sample tells too little, and nothing has changed. Not part of the recursion, which has no room on
  // the stack for samples.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART bool put_in_parts(Item* first, Item* last, const Box& box,
                                                       const Box* next, std::ptrdiff_t* ends,
                                                       const Executor& executor)
  {
    Cut cuts[parts];
    cut_by_sample(first, last, box, next, cuts);
    const auto n = std::size_t(last - first);
    std::vector<unsigned char> part(n);
    for_each_block(executor, n, number_of_blocks(executor, n, 4096),
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (std::size_t i = begin; i < end; ++i)
                       part[i] = part_of(first[i], cuts);
                   });
    std::fill(ends, ends + parts + 1, 0);
    for (const unsigned char p : part)
      ++ends[p + 1];
    if (*std::max_element(ends, ends + parts + 1) > (last - first) / 4)
      return false;
    std::partial_sum(ends, ends + parts + 1, ends);
    move_to_parts(first, part.data(), ends);
    return true;
  }

  static unsigned char part_of(const Item& item, const Cut* cuts)
  {
    std::size_t set = 1;
    while (set < parts)
      set = 2 * set + !cuts[set].is_before(item);
    return static_cast<unsigned char>(set - parts);
  }

  // In place: what is not in its part changes places with what is there.
  static void move_to_parts(Item* items, unsigned char* part, const std::ptrdiff_t* ends)
  {
    std::ptrdiff_t next[parts];
    std::copy(ends, ends + parts, next);
    for (std::size_t p = 0; p < parts; ++p)
      for (std::ptrdiff_t k = next[p]; k < ends[p + 1]; ++k)
        while (part[k] != p) {
          const std::ptrdiff_t there = next[part[k]]++;
          std::swap(items[k], items[there]);
          std::swap(part[k], part[there]);
        }
  }

  bool sort_in_parts(Item* first, Item* last, const Box& box, const Box* next,
                     const Executor& executor)
  {
    if (last - first <= many)
      return false;
    std::ptrdiff_t ends[parts + 1];
    if (!put_in_parts(first, last, box, next, ends, executor))
      return false;
    sort_parts(first, ends, next, executor);
    return true;
  }

  void sort_parts(Item* items, const std::ptrdiff_t* ends, const Box* next,
                  const Executor& executor)
  {
    std::vector<Box> boxes;
    std::vector<std::size_t> filled;
    for (std::size_t p = 0; p < parts; ++p)
      if (ends[p] < ends[p + 1]) {
        filled.push_back(p);
        boxes.emplace_back(items + ends[p], items + ends[p + 1]);
      }
    for_each_block(executor, filled.size(), filled.size(),
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (std::size_t k = begin; k < end; ++k) {
                       Sort_by_halves part;
                       part.begin_after(k > 0 ? boxes[k - 1].point_near(boxes[k]).data()
                                              : m_before);
                       part.sort(items + ends[filled[k]], items + ends[filled[k] + 1], boxes[k],
                                 k + 1 < filled.size() ? &boxes[k + 1] : next);
                     }
                   });
    begin_after(items[ends[parts] - 1].coordinates);
  }

  void begin_after(const double* point) { std::copy(point, point + 3, m_before); }

  std::vector<Item> m_items;
  double m_before[3] = {};
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H
