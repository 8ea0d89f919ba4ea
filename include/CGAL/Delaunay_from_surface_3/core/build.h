// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H

// The core: the Delaunay triangulation of points that are doubles, in an order that comes from a
// surface or from the points alone. It knows no mesh and no triangulation of CGAL's; doors lead into
// it (a triangulation's, that of arrays).
//
// This is the loop of rounds of Choi 2002, Fig. 1, in which nothing is traced: the order itself names
// a point to start from.

#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Watcher.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/apex_of_plane.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Order_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/order_along_line.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/fail.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

enum class Insertion_outcome {
  COMPLETE,
  STOPPED,     // by the watcher
  OVER_BUDGET, // only on the way: whoever has a budget has another order
  FLAT,        // nothing is inserted: the points lie in one plane
  TOO_FEW_IDS  // to number all cells
};

// What build() makes.
template <class Id>
struct Built : Ordered_complex<Id>
{
  using Ordered_complex<Id>::Ordered_complex;

  Insertion_outcome outcome = Insertion_outcome::FLAT;
  Starting_simplex simplex; // of the points as they came; of those accepted nothing is known
  bool has_apex = false;    // as the last vertex, off the plane of all others
  Insertion_counts counts;
};

// The points in rounds, the rounds in pieces, between which watcher and budget are asked; not when all
// are inserted, since what is done is kept.
template <class Insert>
Insertion_outcome insert_in_rounds(Insert& insert, const std::vector<std::size_t>& round_ends,
                                   Watcher& watcher, const Insertion_budget& budget)
{
  watcher.insertion_begins(insert.number_of_threads());
  const std::size_t n = round_ends.empty() ? 0 : round_ends.back();
  std::size_t first = 0;
  for (std::size_t h = 0; h < round_ends.size(); ++h) {
    const std::size_t N_h = round_ends[h];
    watcher.round_begins(h, N_h - first);
    while (first < N_h) {
      const std::size_t next = (std::min)(N_h, first + insert.size_of_piece(first));
      if (!insert(first, next)) // 2b, 2c
        return Insertion_outcome::STOPPED;
      if (next < n && budget.is_exceeded(insert.counts(), next))
        return Insertion_outcome::OVER_BUDGET;
      first = next;
    }
  }
  return Insertion_outcome::COMPLETE;
}

// What is asked of the core beyond points and order.
struct Request
{
  // Shall points in one plane get an apex off it? The cells at it are then their triangles, with the
  // same perturbation. Else nothing is done with them.
  bool adds_apex = false;

  // Do points start where the order says? Else each starts from the one before.
  bool uses_starting_places = true;
};

// The points in the order of `orders`: the order and the four points that come first.
template <class Id>
Built<Id> begin_to_build(Point_source& source, Order_source& orders, const Request& request,
                         Watcher& watcher, const Executor& executor)
{
  using Phase = Surface_insertion_phase;
  watcher.phase_begins(Phase::PLAN);
  const Point_array points = source.points();
  const Starting_simplex simplex =
      starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
  Insertion_order order = simplex.dimension < 2 && !watcher.leaves_points_out()
                              ? order_along_line(points)
                              : orders.make(points, executor);
  if (!request.uses_starting_places)
    order.starting_places.clear();
  watcher.phase_begins(Phase::SUBGRAPH);
  Built<Id> built;
  if (simplex.dimension == 3) {
    built = Built<Id>(points, std::move(order), nullptr, watcher);
  } else if (simplex.dimension == 2 && request.adds_apex) {
    const auto apex = apex_of_plane(points[simplex.points[0]], points[simplex.points[1]],
                                    points[simplex.points[2]]);
    built = Built<Id>(points, std::move(order), apex.data(), watcher);
    built.has_apex = true;
  } else {
    built.order = std::move(order);
  }
  built.simplex = simplex;
  if (built.has_started())
    source.give_up();
  return built;
}

// The Delaunay triangulation of the points, whose coordinates are finite. The numbers in it are places
// in built.order. Exact, with CGAL's symbolic perturbation. Expected O(n log n) for n points on
// surfaces like those measured, the order included; no more than what the budgets allow and an order
// without one takes.
//
// Crew: who inserts: One_thread or Many_threads.
template <class Id, class Crew = One_thread>
Built<Id> build(Point_source& points, Order_source& orders, const Request& request,
                Watcher& watcher, const Executor& executor)
{
  Built<Id> built;
  try {
    for (;;) {
      built = begin_to_build<Id>(points, orders, request, watcher, executor);
      if (!built.has_started())
        return built;
      {
        typename Crew::template Insert<Id> insert(built, executor, watcher);
        built.outcome = insert_in_rounds(insert, built.order.round_ends, watcher, orders.budget());
        built.counts = insert.counts();
        if (built.outcome == Insertion_outcome::COMPLETE) {
          watcher.insertion_ends(built.counts);
          watcher.phase_begins(Surface_insertion_phase::FINISH);
          insert.finish();
          CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(
              is_valid(built.complex, Delaunay_validity_level::DELAUNAY));
        }
      }
      if (built.outcome != Insertion_outcome::OVER_BUDGET)
        return built;
      if (!orders.go_on())
        fail("an order with a budget has another behind it");
      watcher.order_is_replaced("its insertions destroy or enter too many cells");
      built = Built<Id>(); // before there is another
    }
  } catch (const Too_few_ids&) {
    built.outcome = Insertion_outcome::TOO_FEW_IDS;
    return built;
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_H
