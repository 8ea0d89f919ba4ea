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

#include <CGAL/Delaunay_from_surface_3/core/order/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Array_target_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Has_budget.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_in_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/double_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/support/fail.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
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

// Points on a line, or at one place: they are sorted, at once.
template <class Hints, class Target, class Index, class Visitor>
Insertion_outcome insert_on_line(Target& target, const Budgeted_order& order, Visitor& visitor,
                                 Delaunay_3_arrays<Index>& arrays)
{
  visitor.insertion_begins(1);
  if (!order.plan.order.empty() && !visitor.go_further())
    return Insertion_outcome::STOPPED;
  const std::vector<std::size_t> places = inverse(order.plan.order);
  arrays = arrays_on_line<Index>(places.size(), [&](std::size_t i) {
    const double* const p = target.coordinates_of_place(places[i]);
    return std::array<double, 3>{p[0], p[1], p[2]};
  });
  const Index_graph no_subgraph;
  visitor.insertion_ends(target, Hints(target, no_subgraph, order.plan));
  visitor.phase_begins(Surface_insertion_phase::FINISH);
  return Insertion_outcome::COMPLETE;
}

// For points in a plane, of which three are the simplex: the apex off it (flat_arrays.h).
inline Array_point apex_of(const Starting_simplex& simplex, const std::vector<Array_point>& points)
{
  std::array<double, 3> p[3];
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = *double_coordinates(points[simplex.points[k]]);
  const auto apex = apex_of_plane(p[0].data(), p[1].data(), p[2].data());
  return Array_point(apex[0], apex[1], apex[2]);
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
    const Starting_simplex simplex = target.simplex();
    if (points.size() > order.plan.order.size())
      fail("the apex lies off the plane of the points");
    if (simplex.dimension < 2)
      return insert_on_line<Hints>(target, order, visitor, arrays);
    points.push_back(apex_of(simplex, points));
    return insert_into_arrays<Traits, Executor>(std::move(points), order, visitor, arrays);
  }
  const bool has_apex = points.size() > order.plan.order.size();
  std::vector<Array_point>().swap(points);
  const Insertion_outcome outcome = insert_by_order<Hints>(target, order, visitor);
  if (outcome == Insertion_outcome::COMPLETE)
    arrays = has_apex ? target.take_arrays_at_apex(order.plan.order)
                      : target.take_arrays(order.plan.order);
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
