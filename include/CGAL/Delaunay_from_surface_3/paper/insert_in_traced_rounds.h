// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_IN_TRACED_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_IN_TRACED_ROUNDS_H

// Choi 2002, Fig. 1: the loop, on CGAL's own triangulation.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Points are numbered by their places in the order; the watcher gets the caller's numbers. A vertex
// that belongs to none of them has no place.
template <class Watcher, class Point>
bool may_insert(Watcher& watcher, const Insertion_order& plan, std::size_t i, std::size_t nearest,
                const Point& point, std::array<std::size_t, 4> corners)
{
  const auto name_of = [&](std::size_t place) {
    return place < plan.order.size() ? plan.order[place] : place;
  };
  for (std::size_t& corner : corners)
    corner = name_of(corner);
  return watcher.accepts(name_of(i), name_of(nearest), point, corners);
}

// Round h ends before s_{N_h}, N_h = round_ends[h]. Returns false if the watcher stopped it.
template <class Target, class Hints, class Watcher>
bool insert_in_traced_rounds(const Insertion_order& plan, Target& target, Hints& hints,
                             Watcher& watcher)
{
  using Phase = Surface_insertion_phase;
  watcher.insertion_begins(1);
  std::size_t i = 0;
  for (std::size_t h = 0; h < plan.round_ends.size(); ++h) {
    const std::size_t N_h = plan.round_ends[h];
    watcher.round_begins(h, N_h - i);
    for (; i < N_h; ++i) {
      if (!watcher.go_further())
        return false;
      watcher.phase_begins(Phase::LOCATION);
      const typename Target::Location d_i = target.locate(i, hints.start(i)); // 2b
      watcher.phase_begins(Phase::UPDATE);
      if constexpr (Watcher::is_asked)
        target.insert_if(i, d_i, hints,
                         [&](std::size_t nearest, const auto& point, const auto& corners) {
                           return may_insert(watcher, plan, i, nearest, point, corners);
                         });
      else
        target.insert(i, d_i, hints); // 2c
    }
    if (N_h < target.size()) {
      watcher.phase_begins(Phase::TRACE);
      watcher.trace_ends(hints.trace()); // 2a
    }
  }
  watcher.insertion_ends(target, hints);
  watcher.phase_begins(Phase::FINISH);
  return true;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_IN_TRACED_ROUNDS_H
