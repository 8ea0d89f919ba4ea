// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_INTO_TARGET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_INTO_TARGET_H

// The choice of the target for points whose order is known, between the plan (insert_surface.h) and
// the loop of Fig. 1 (insert_in_rounds.h).

#include <CGAL/Delaunay_from_surface_3/core/order/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Null_update_observer.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/insertion/insert_one_by_one.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_in_rounds.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The points in the order of insertion, the plan that says so and what it may cost, and T on their
// places. What is inserted one after the other lies side by side; with the numbers of the mesh
// nearly every point and record would miss the cache.
template <class Point>
struct Planned_points
{
  std::vector<Point> points;
  std::vector<std::size_t> places; // of the points as they came
  Insertion_order plan;
  Insertion_budget budget;
  Index_graph subgraph;
  std::string obstacle;                // what is known to stand against the target of the traits
  bool creates_in_input_order = false; // the vertices
};

// The vertices of the points, none where the work ended before; by place.
template <class Vertex_handle>
struct Inserted_points
{
  std::vector<Vertex_handle> vertices;
  Insertion_outcome outcome;
};

template <class Target, class Traits, class Triangulation, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_into_target(Triangulation& tr, Planned_points<typename Triangulation::Point>& planned,
                   Visitor& visitor);

// The target that begins anew where `Target` has too few ids; void if there is none.
template <class Target, class = void>
struct Wider_target_of
{
  using type = void;
};
template <class Target>
struct Wider_target_of<Target, std::void_t<typename Target::Wider_target>>
{
  using type = typename Target::Wider_target;
};

template <class Target, class Traits, class Triangulation, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_into_wider_target(Triangulation& tr, Planned_points<typename Triangulation::Point>& planned,
                         const Too_few_ids& shortage, Visitor& visitor)
{
  using Wider_target = typename Wider_target_of<Target>::type;
  if constexpr (std::is_void<Wider_target>::value) {
    throw shortage;
  } else {
    visitor.target_is_replaced(shortage.what());
    return insert_into_target<Wider_target, Traits>(tr, planned, visitor);
  }
}

[[noreturn]] inline void refuse_input_order(const std::string& obstacle)
{
  throw Surface_input_error("the vertices cannot be created in the order of the input: " +
                            obstacle);
}

// Can the target create vertices in a given order?
template <class Target, class = void>
struct Creates_in_order : std::false_type
{
};
template <class Target>
struct Creates_in_order<Target,
                        std::void_t<decltype(std::declval<Target&>().create_vertices_in_order(
                            std::declval<const std::vector<std::size_t>&>()))>> : std::true_type
{
};

// Can the target leave points out?
template <class Target, class Point, class = void>
struct Inserts_if : std::false_type
{
};
template <class Target, class Point>
struct Inserts_if<Target, Point,
                  std::void_t<decltype(std::declval<Target&>().insert_if(
                      std::size_t(), std::declval<const typename Target::Location&>(),
                      std::declval<Null_update_observer&>(),
                      std::declval<bool (&)(std::size_t, const Point&)>()))>> : std::true_type
{
};

template <class Traits, class Triangulation, class Target, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_planned(Target& target, const Planned_points<typename Triangulation::Point>& planned,
               Visitor& visitor)
{
  static_assert(
      !Is_asked<Visitor>::value || Inserts_if<Target, typename Triangulation::Point>::value,
      "the insertion target of the traits cannot leave points out: it has no insert_if()");
  if (planned.creates_in_input_order) {
    if constexpr (Creates_in_order<Target>::value)
      target.create_vertices_in_order(planned.places);
    else
      refuse_input_order("that needs the compact triangulation, which the traits do not name");
  }
  typename Traits::template Insertion_hints_3<Target, Index_graph> hints(target, planned.subgraph,
                                                                         planned.plan);
  const Insertion_outcome outcome =
      insert_in_rounds(planned.plan.round_ends, target, hints, visitor, planned.budget);
  return {target.take_vertices(), outcome};
}

// What stands against a target that begins with four of the points, before it is there.
template <class Triangulation, class Visitor>
std::string obstacle_of_answers(const Triangulation& tr,
                                Planned_points<typename Triangulation::Point>& planned,
                                Visitor& visitor)
{
  if constexpr (Is_asked<Visitor>::value)
    if (planned.obstacle.empty() && tr.number_of_vertices() == 0 &&
        !visitor.ask_first(tr.geom_traits(), planned.points))
      return "the points that are accepted first lie in one plane";
  (void)tr, (void)visitor;
  return planned.obstacle;
}

// Inserts into `Target` if it can serve, else through CGAL's own insertion.
template <class Target, class Traits, class Triangulation, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_into_target(Triangulation& tr, Planned_points<typename Triangulation::Point>& planned,
                   Visitor& visitor)
{
  if constexpr (Target::serves_everything) {
    Target target(tr, planned.points);
    return insert_planned<Traits, Triangulation>(target, planned, visitor);
  } else {
    std::string obstacle = obstacle_of_answers(tr, planned, visitor);
    if constexpr (!Target::serves_geom_traits()) { // it need not compile
      obstacle = "the predicates of the geometric traits are not the exact ones of a kernel";
    } else if (obstacle.empty() && obstacle_of_compiler() != nullptr) {
      obstacle = obstacle_of_compiler();
    } else if (obstacle.empty()) {
      try {
        Target target(tr, planned.points);
        if (!target.obstacle())
          return insert_planned<Traits, Triangulation>(target, planned, visitor);
        obstacle = *target.obstacle();
      } catch (const Too_few_ids& shortage) {
        return insert_into_wider_target<Target, Traits>(tr, planned, shortage, visitor);
      }
    }
    if (planned.creates_in_input_order)
      refuse_input_order(obstacle);
    visitor.target_is_replaced(obstacle);
    return insert_into_target<Triangulation_target_3<Triangulation>, Traits>(tr, planned, visitor);
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_INTO_TARGET_H
