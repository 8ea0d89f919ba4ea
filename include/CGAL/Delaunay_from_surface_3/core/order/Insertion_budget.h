// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_INSERTION_BUDGET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_INSERTION_BUDGET_H

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// How much work an order may cause before another takes its place. No order that only looks at the
// surface bounds the cells that insertions destroy; a random one does (Amenta, Choi, Rote 2003). So
// the whole costs no more than the budget, what is done between two looks at it, and one insertion
// in that order. No order is to blame for what all do: where many cells must stay, as a quadratic
// number does, about as many are destroyed. Of an order that is spread over the points this is allowed.
class Insertion_budget
{
public:
  // A budget of destroyed cells for each point inserted; the first points share that of a thousand,
  // since few points do not tell a good order from a bad one. The largest number is never exceeded.
  explicit Insertion_budget(std::size_t cells_per_point, bool is_spread = false)
    : m_cells_per_point(double(cells_per_point))
    , m_is_spread(is_spread)
  {
  }

  // Walks have a threshold of their own: each may be exceeded for reasons that are none of the other's.
  // A step of a walk makes one test; a destroyed cell makes two or three, and is replaced as well.
  bool is_exceeded(const Insertion_counts& counts, std::size_t inserted) const
  {
    const double stay =
        m_is_spread ? double(counts.cells_created) - double(counts.cells_destroyed) : 0;
    const double most =
        cells_per_point(inserted) * (double(inserted) + 1000) + (std::max)(stay, 0.);
    return double(counts.cells_destroyed) > most ||
           double(counts.cells_tested_to_start) > steps_per_cell * most;
  }

private:
  static constexpr double steps_per_cell = 2, many_points = 1e6;

  // On smooth tori orders destroy a number of cells that grows with the logarithm of that of the
  // points. Where there are many, another sixteenth is allowed for each doubling. Asked rarely, so
  // nothing of it goes into the loop that asks.
  [[gnu::cold]] double cells_per_point(std::size_t inserted) const
  {
    const double doublings = std::log2((std::max)(double(inserted) / many_points, 1.));
    return m_cells_per_point * (1 + doublings / 16);
  }

  double m_cells_per_point;
  bool m_is_spread;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_INSERTION_BUDGET_H
