// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CHECK_PLAN_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CHECK_PLAN_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A user's plan may be wrong; an insertion by it would lose points or read out of bounds.

[[noreturn]] inline void refuse_plan(const std::string& what)
{
  throw std::invalid_argument("insertion plan: " + what);
}

// Throws unless the rounds end in ascending order and the last at n.
inline void check_round_ends(const std::vector<std::size_t>& ends, std::size_t n)
{
  for (std::size_t h = 0; h < ends.size(); ++h)
    if (ends[h] <= (h == 0 ? 0 : ends[h - 1]))
      refuse_plan("round " + std::to_string(h) + " ends at " + std::to_string(ends[h]) +
                  ", not after the round before it");
  const std::size_t last = ends.empty() ? 0 : ends.back();
  if (last != n)
    refuse_plan("the last round ends at " + std::to_string(last) + ", but there are " +
                std::to_string(n) + " points");
}

// Throws unless there are none, or each but the first comes before its point.
inline void check_starting_places(const std::vector<std::size_t>& places, std::size_t n)
{
  if (!places.empty() && places.size() != n)
    refuse_plan("there are " + std::to_string(places.size()) + " starting places for " +
                std::to_string(n) + " points");
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k] >= k)
      refuse_plan("the starting place of place " + std::to_string(k) + " is " +
                  std::to_string(places[k]) + ", which is not before it");
}

// The place of each of n points in the order; throws unless it is a permutation of 0, …, n-1.
inline std::vector<std::size_t> places_in_order(const std::vector<std::size_t>& order,
                                                std::size_t n)
{
  if (order.size() != n)
    refuse_plan("the order has " + std::to_string(order.size()) + " places for " +
                std::to_string(n) + " points");
  std::vector<std::size_t> places(n, n);
  for (std::size_t k = 0; k < n; ++k) {
    if (order[k] >= n)
      refuse_plan("at place " + std::to_string(k) + " there is point " + std::to_string(order[k]) +
                  ", but there are " + std::to_string(n) + " points");
    if (places[order[k]] != n)
      refuse_plan("point " + std::to_string(order[k]) + " is at the places " +
                  std::to_string(places[order[k]]) + " and " + std::to_string(k));
    places[order[k]] = k;
  }
  return places;
}

// Throws a std::invalid_argument that says what is wrong with the plan for n points and where.
// Returns the place of each point. Linear.
inline std::vector<std::size_t> check_plan(const Insertion_order& plan, std::size_t n)
{
  check_round_ends(plan.round_ends, n);
  check_starting_places(plan.starting_places, n);
  return places_in_order(plan.order, n);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CHECK_PLAN_H
