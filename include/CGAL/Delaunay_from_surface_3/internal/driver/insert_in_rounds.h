// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H

// Choi 2002, Fig. 1, for points that are numbered s_0, s_1, … in the order of insertion.

#include <CGAL/Delaunay_from_surface_3/core/order/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

enum class Insertion_outcome { COMPLETE, STOPPED, OVER_BUDGET };

// The points of a round. The target gets them in pieces, between which the budget is looked at; not
// when all are inserted, since what is done is kept.
template <class Target, class Hints, class Visitor>
Insertion_outcome insert_round(std::size_t first, std::size_t last, Target& target, Hints& hints,
                               Visitor& visitor, const Insertion_budget& budget)
{
  while (first < last) {
    const std::size_t next = (std::min)(last, first + target.size_of_piece(first));
    if (!target.insert_round(first, next, hints, visitor)) // 2b, 2c
      return Insertion_outcome::STOPPED;
    if (next < target.size() && budget.is_exceeded(target.counts(), next))
      return Insertion_outcome::OVER_BUDGET;
    first = next;
  }
  return Insertion_outcome::COMPLETE;
}

// Round h ends before s_{N_h}, N_h = round_ends[h].
template <class Target, class Hints, class Visitor>
Insertion_outcome insert_in_rounds(const std::vector<std::size_t>& round_ends, Target& target,
                                   Hints& hints, Visitor& visitor, const Insertion_budget& budget)
{
  using Phase = Surface_insertion_phase;
  visitor.insertion_begins(target.number_of_threads());
  std::size_t first = 0;
  for (std::size_t h = 0; h < round_ends.size(); ++h) {
    const std::size_t N_h = round_ends[h];
    visitor.round_begins(h, N_h - first);
    const Insertion_outcome outcome = insert_round(first, N_h, target, hints, visitor, budget);
    if (outcome != Insertion_outcome::COMPLETE)
      return outcome;
    if (N_h < target.size()) {
      visitor.phase_begins(Phase::TRACE);
      visitor.trace_ends(hints.trace()); // 2a
    }
    first = N_h;
  }
  visitor.insertion_ends(target, hints);
  visitor.phase_begins(Phase::FINISH);
  target.finish();
  return Insertion_outcome::COMPLETE;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H
