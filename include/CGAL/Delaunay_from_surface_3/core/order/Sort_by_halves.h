// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H

// Puts points in an order in which successive points are near each other. A set is halved at the
// median of its longest extent; the half that is nearer to the point before, and farther from the
// box after, comes first; and so on. A Hilbert curve halves along x, y and z in turn; in a box of 1
// : 1/100 : 1/100 it would follow cells that are as long and thin as the box.
//
// Many points are halved six times at once, at the medians of a sample of them, so that each point
// moves once for six halvings. Each part is then sorted by itself, starting from where the box
// before comes nearest, so that the order does not depend on the number of threads.
//
// Cost: O(n log n).

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
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
  void operator()(const Point_array& points, std::size_t* first, const std::size_t* last,
                  const Executor& executor = Alone())
  {
    if (first == last)
      return;
    const std::size_t n = std::size_t(last - first);
    const Given given = {points, first, n, executor};
    const Box box = box_of(given);
    begin_after(box.low); // starts in a corner
    m_items.deallocate();
    m_items.reserve(n, 0);
    std::ptrdiff_t ends[parts + 1];
    if (n > std::size_t(many) && put_in_parts(given, box, ends)) {
      sort_parts(m_items.data(), ends, nullptr, executor);
    } else {
      m_items.touch(0, n);
      for (std::size_t i = 0; i < n; ++i)
        m_items[i] = item(points, first[i]);
      sort(m_items.data(), m_items.data() + n, box, nullptr);
    }
    given.in_blocks([&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i)
        first[i] = m_items[i].index;
    });
  }

  // Returns the points that were sorted last, in order.
  const Item* items() const { return m_items.data(); }

private:
  static constexpr std::ptrdiff_t few = 4; // so few are left as they are
  static constexpr std::ptrdiff_t many = 2048, size_of_sample = 512;
  static constexpr std::size_t parts = 64; // each has 8 points of the sample

  // The points that are sorted.
  struct Given
  {
    const Point_array& points;
    const std::size_t* indices;
    std::size_t size;
    const Executor& executor;

    const double* point(std::size_t i) const { return points[indices[i]]; }
    std::size_t blocks() const { return number_of_blocks(executor, size, 4096); }
    template <class Body>
    void in_blocks(const Body& body) const
    {
      for_each_block(executor, size, blocks(), body);
    }
  };

  static Item item(const Point_array& points, std::size_t index)
  {
    const double* const p = points[index];
    return {{p[0], p[1], p[2]}, index};
  }

  struct Box : Bounds
  {
    Box() = default;
    Box(const Item* first, const Item* last)
    {
      for (; first != last; ++first)
        add(first->coordinates);
    }
    double middle(int k) const { return low[k] / 2 + high[k] / 2; }
    double nearest(int k, double x) const { return (std::max)(low[k], (std::min)(high[k], x)); }
    // Returns how far x is beyond the middle, or the end of the box if x is beyond that.
    double beyond(int k, double x) const { return nearest(k, x) - middle(k); }
    // Returns the point of this box that is nearest to the middle of another box.
    std::array<double, 3> point_near(const Box& box) const
    {
      return {nearest(0, box.middle(0)), nearest(1, box.middle(1)), nearest(2, box.middle(2))};
    }
  };

  static Box box_of(const Given& given)
  {
    std::vector<Box> boxes(given.blocks());
    given.in_blocks([&](std::size_t begin, std::size_t end, std::size_t b) {
      Box box;
      for (std::size_t i = begin; i < end; ++i)
        box.add(given.point(i));
      boxes[b] = box;
    });
    for (const Box& box : boxes)
      if (!box.is_empty()) {
        boxes[0].add(box.low);
        boxes[0].add(box.high);
      }
    return boxes[0];
  }

  // Says where a set is halved: points beyond go into the second half.
  struct Cut
  {
    int axis;
    double sign, at;
    bool is_before(const double* p) const { return sign * p[axis] < at; }
  };

  // Sorts items after the point m_before, and before the box `next`, if there is one. It is not
  // inlined, because several functions call it and copies would make nothing faster.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART void sort(Item* first, Item* last, Box box, const Box* next)
  {
    while (last - first > few) {
      if (last - first > many && sort_in_parts(first, last, box, next))
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

  // Finds the cuts of a sample. The cut of set k, counted from 1, makes the sets 2 k and 2 k + 1.
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

  // Finds the cuts by a sample of n points, which are drawn evenly from all of them. item_of(i) returns
  // the i-th.
  template <class ItemOf>
  void cut_by_sample(std::size_t n, const ItemOf& item_of, const Box& box, const Box* next,
                     Cut* cuts)
  {
    Item sample[size_of_sample];
    const std::size_t stratum = n / size_of_sample;
    Split_mix random(0);
    for (std::size_t k = 0; k < size_of_sample; ++k)
      sample[k] = item_of(stratum * k + std::size_t(random.below(stratum)));
    double before[3];
    std::copy(m_before, m_before + 3, before);
    cut_sample(1, sample, sample + size_of_sample, box, next, cuts);
    begin_after(before);
  }

  // Makes the numbers of points in parts the ends of these: the p-th then ends at ends[p + 1]. Returns
  // false if the sample is not like the points.
  static bool make_ends(std::ptrdiff_t* ends)
  {
    const std::ptrdiff_t largest = *std::max_element(ends, ends + parts + 1);
    std::partial_sum(ends, ends + parts + 1, ends);
    return largest <= ends[parts] / 4;
  }

  // Puts the points into parts of m_items, in their order. Returns false if the sample is not like them.
  bool put_in_parts(const Given& given, const Box& box, std::ptrdiff_t* ends)
  {
    Cut cuts[parts];
    cut_by_sample(
        given.size, [&](std::size_t i) { return item(given.points, given.indices[i]); }, box,
        nullptr, cuts);
    std::vector<unsigned char> part(given.size);
    std::vector<std::array<std::size_t, parts>> next(given.blocks());
    given.in_blocks([&](std::size_t begin, std::size_t end, std::size_t b) {
      m_items.touch(begin, end);
      std::array<std::size_t, parts> numbers = {};
      for (std::size_t i = begin; i < end; ++i)
        ++numbers[part[i] = part_of(given.point(i), cuts)];
      next[b] = numbers;
    });
    std::size_t number = 0;
    ends[0] = 0;
    for (std::size_t p = 0; p < parts; ++p) {
      const std::size_t first = number;
      for (auto& of_block : next)
        number += std::exchange(of_block[p], number);
      ends[p + 1] = std::ptrdiff_t(number - first);
    }
    if (!make_ends(ends))
      return false;
    given.in_blocks([&](std::size_t begin, std::size_t end, std::size_t b) {
      std::array<std::size_t, parts> places = next[b];
      for (std::size_t i = begin; i < end; ++i)
        m_items[places[part[i]]++] = item(given.points, given.indices[i]);
    });
    return true;
  }

  // Returns false, and leaves the items alone, if the sample is not like them. Not inlined: samples would
  // fill the recursion's stack.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART bool sort_in_parts(Item* first, Item* last, const Box& box,
                                                        const Box* next)
  {
    std::ptrdiff_t ends[parts + 1] = {};
    Cut cuts[parts];
    const auto n = std::size_t(last - first);
    cut_by_sample(
        n, [first](std::size_t i) { return first[i]; }, box, next, cuts);
    std::vector<unsigned char> part(n);
    for (std::size_t i = 0; i < n; ++i)
      ++ends[1 + (part[i] = part_of(first[i].coordinates, cuts))];
    if (!make_ends(ends))
      return false;
    move_to_parts(first, part.data(), ends);
    sort_parts(first, ends, next, Alone());
    return true;
  }

  static unsigned char part_of(const double* p, const Cut* cuts)
  {
    std::size_t set = 1;
    while (set < parts)
      set = 2 * set + !cuts[set].is_before(p);
    return static_cast<unsigned char>(set - parts);
  }

  // Works in place: an item that is not in its part is swapped with one that is there.
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

  void sort_parts(Item* items, const std::ptrdiff_t* ends, const Box* next,
                  const Executor& executor)
  {
    std::vector<std::size_t> filled;
    for (std::size_t p = 0; p < parts; ++p)
      if (ends[p] < ends[p + 1])
        filled.push_back(p);
    const auto for_each_filled = [&](const auto& body) {
      for_each_block(executor, filled.size(), filled.size(),
                     [&](std::size_t begin, std::size_t end, std::size_t) {
                       for (std::size_t k = begin; k < end; ++k)
                         body(k, items + ends[filled[k]], items + ends[filled[k] + 1]);
                     });
    };
    std::vector<Box> boxes(filled.size());
    for_each_filled([&](std::size_t k, Item* first, Item* last) { boxes[k] = Box(first, last); });
    for_each_filled([&](std::size_t k, Item* first, Item* last) {
      Sort_by_halves part;
      part.begin_after(k > 0 ? boxes[k - 1].point_near(boxes[k]).data() : m_before);
      part.sort(first, last, boxes[k], k + 1 < filled.size() ? &boxes[k + 1] : next);
    });
    begin_after(items[ends[parts] - 1].coordinates);
  }

  void begin_after(const double* point) { std::copy(point, point + 3, m_before); }

  Page_array<Item> m_items;
  double m_before[3] = {};
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H
