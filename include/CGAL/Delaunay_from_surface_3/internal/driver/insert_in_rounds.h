// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H

// Choi 2002, Fig. 1, for points that are numbered s_0, s_1, … in the order of insertion.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Round h ends before s_{N_h}, N_h = round_ends[h]. Returns false if the visitor stopped it.
template <class Target, class Hints, class Visitor>
bool insert_in_rounds(const std::vector<std::size_t>& round_ends, Target& target, Hints& hints,
                      Visitor& visitor)
{
  using Phase = Surface_insertion_phase;
  std::size_t first = 0;
  for (std::size_t h = 0; h < round_ends.size(); ++h) {
    const std::size_t N_h = round_ends[h];
    visitor.round_begins(h, N_h - first);
    if (!target.insert_round(first, N_h, hints, visitor)) // 2b, 2c
      return false;
    if (N_h < target.size()) {
      visitor.phase_begins(Phase::TRACE);
      visitor.trace_ends(hints.trace()); // 2a
    }
    first = N_h;
  }
  visitor.insertion_ends(target, hints);
  visitor.phase_begins(Phase::FINISH);
  target.finish();
  return true;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_IN_ROUNDS_H
