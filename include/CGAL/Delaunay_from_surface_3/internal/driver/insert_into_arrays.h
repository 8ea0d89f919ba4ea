// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_INTO_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_INTO_ARRAYS_H

// What insert_surface.h is for a triangulation, for arrays: plan, target, the loop of Choi 2002,
// Fig. 1.
//
// Memory: while cells are made, the copies of the points and the graph are gone. What lives beside
// the cells is order and starting places, and 36 bytes for each vertex.

#include <CGAL/Delaunay_from_surface_3/internal/driver/Array_target_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/arrays_of_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_in_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

using Array_triangulation = Delaunay_triangulation_3<Exact_predicates_inexact_constructions_kernel>;
using Array_point = Array_triangulation::Point;

// An order, and what it may cost.
struct Budgeted_order
{
  Insertion_order plan;
  Insertion_budget budget;
};

template <class Hints, class Target, class Visitor>
Insertion_outcome insert_by_order(Target& target, const Budgeted_order& order, Visitor& visitor)
{
  const Index_graph no_subgraph;
  Hints hints(target, no_subgraph, order.plan);
  return insert_in_rounds(order.plan.round_ends, target, hints, visitor, order.budget);
}

// Into CGAL's triangulation, and from there.
template <class Traits, class Index, class Visitor>
Insertion_outcome insert_into_arrays_by_cgal(const std::vector<Array_point>& points,
                                             const Budgeted_order& order, Visitor& visitor,
                                             Delaunay_3_arrays<Index>& arrays)
{
  using Target = Triangulation_target_3<Array_triangulation>;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;
  Array_triangulation tr;
  Target target(tr, points);
  const Insertion_outcome outcome = insert_by_order<Hints>(target, order, visitor);
  if (outcome == Insertion_outcome::COMPLETE)
    arrays = arrays_of_triangulation<Index>(
        tr, permuted(target.take_vertices(), inverse(order.plan.order)));
  return outcome;
}

// `points` in the order of insertion. Says in `arrays` what it made, if it is complete.
template <class Traits, class Executor, class Index, class Visitor>
Insertion_outcome insert_into_arrays(std::vector<Array_point> points, const Budgeted_order& order,
                                     Visitor& visitor, Delaunay_3_arrays<Index>& arrays)
{
  using Target = Array_target_3<Array_triangulation, Index, Executor>;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;
  Array_triangulation empty;
  Target target(empty, points);
  if (target.obstacle()) {
    visitor.target_is_replaced(*target.obstacle());
    return insert_into_arrays_by_cgal<Traits>(points, order, visitor, arrays);
  }
  std::vector<Array_point>().swap(points);
  const Insertion_outcome outcome = insert_by_order<Hints>(target, order, visitor);
  if (outcome == Insertion_outcome::COMPLETE)
    arrays = target.take_arrays(order.plan.order);
  return outcome;
}

// One try by one plan. make_order(points, plan) applies it to them and to what is known of their
// neighbours.
template <class Traits, class Executor, class Plan, class Index, class MakeOrder, class Visitor>
Insertion_outcome try_plan(std::vector<Array_point> points, const Plan& plan,
                           const MakeOrder& make_order, Visitor& visitor,
                           Delaunay_3_arrays<Index>& arrays)
{
  visitor.phase_begins(Surface_insertion_phase::PLAN);
  Budgeted_order order = {make_order(points, plan), {}};
  if constexpr (Has_budget<Plan>::value)
    order.budget = Insertion_budget(Plan::cells_per_point);
  points = permuted(points, order.plan.order);
  return insert_into_arrays<Traits, Executor>(std::move(points), order, visitor, arrays);
}

// read_points() returns the points; it may be called twice. After a stop the arrays are empty.
template <class Traits, class Executor, class Index, class ReadPoints, class Plan, class MakeOrder,
          class Visitor>
Delaunay_3_arrays<Index> arrays_by_plan(const ReadPoints& read_points, const Plan& plan,
                                        const MakeOrder& make_order, Visitor& visitor)
{
  Delaunay_3_arrays<Index> arrays;
  const Insertion_outcome outcome =
      try_plan<Traits, Executor>(read_points(), plan, make_order, visitor, arrays);
  if constexpr (Has_budget<Plan>::value)
    if (outcome == Insertion_outcome::OVER_BUDGET) {
      visitor.order_is_replaced("its insertions destroy or enter too many cells");
      return arrays_by_plan<Traits, Executor, Index>(read_points, plan.fallback_plan(), make_order,
                                                     visitor);
    }
  visitor.phase_begins(Surface_insertion_phase::DONE);
  return arrays;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_INTO_ARRAYS_H
