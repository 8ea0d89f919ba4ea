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
// Cost: O(n log n).

#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Sort_by_halves
{
  struct Item
  {
    double coordinates[3];
    std::size_t index;
  };

public:
  // Sorts the indices [first, last) of points.
  void operator()(const Point_array& points, std::size_t* first, std::size_t* last)
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
    std::copy(box.low, box.low + 3, m_before); // begin in a corner
    sort(m_items.data(), m_items.data() + m_items.size(), box, nullptr);
    for (const Item& item : m_items)
      *first++ = item.index;
  }

private:
  static constexpr std::ptrdiff_t few = 4; // are left as they are

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
    // How far beyond the middle a coordinate is, at most where the box ends.
    double beyond(int k, double x) const
    {
      return (std::max)(low[k], (std::min)(high[k], x)) - middle(k);
    }
    double low[3], high[3];
  };

  // After the point m_before, and before a box that is `next`, if there is one.
  void sort(Item* first, Item* last, Box box, const Box* next)
  {
    while (last - first > few) {
      int axis = 0;
      for (int k = 1; k < 3; ++k)
        if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis])
          axis = k;
      Item* const middle = first + (last - first) / 2;
      if (box.beyond(axis, m_before[axis]) <=
          (next != nullptr ? box.beyond(axis, next->middle(axis)) : 0))
        std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
          return a.coordinates[axis] < b.coordinates[axis];
        });
      else
        std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
          return a.coordinates[axis] > b.coordinates[axis];
        });
      const Box second(middle, last);
      sort(first, middle, Box(first, middle), &second);
      first = middle;
      box = second;
    }
    std::copy(last[-1].coordinates, last[-1].coordinates + 3, m_before);
  }

  std::vector<Item> m_items;
  double m_before[3] = {};
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SORT_BY_HALVES_H
