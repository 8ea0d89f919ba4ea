// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERTION_BUDGET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERTION_BUDGET_H

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// How much work an order may make before another takes its place. No order that only looks at the
// surface bounds the cells that insertions destroy; a random one does (Amenta, Choi, Rote 2003). So
// the whole costs no more than the budget and one insertion in that order.
class Insertion_budget
{
public:
  // Without bound.
  Insertion_budget() = default;

  // Of so many destroyed cells for each point inserted, and for the first points together those of
  // a thousand: there are too few of them to tell a good order from a bad one.
  explicit Insertion_budget(std::size_t cells_per_point)
    : m_cells_per_point(double(cells_per_point))
  {
  }

  bool is_exceeded(const Insertion_counts& counts, std::size_t inserted) const
  {
    return work(counts) > m_cells_per_point * (double(inserted) + 1000);
  }

private:
  // In destroyed cells. That three steps of a walk count as one is an estimate: a step makes one
  // test, a destroyed cell two or three, and it is replaced as well.
  static double work(const Insertion_counts& counts)
  {
    return double(counts.cells_destroyed) + double(counts.cells_tested_to_start) / 3;
  }

  double m_cells_per_point = std::numeric_limits<double>::infinity();
};

// Does a plan name a budget, and another plan for when it is exceeded?
template <class Plan, class = void>
struct Has_budget : std::false_type
{
};
template <class Plan>
struct Has_budget<Plan, std::void_t<decltype(Plan::cells_per_point),
                                    decltype(std::declval<const Plan&>().fallback_plan())>>
  : std::true_type
{
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERTION_BUDGET_H
