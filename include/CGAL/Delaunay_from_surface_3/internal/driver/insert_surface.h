// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H

// What all public functions share, from the named parameters to the loop of Choi 2002, Fig. 1:
//   insert_surface        reads the parameters
//   insert_and_give       builds aside what is empty, and hands the vertices over
//   insert_by_plan        makes the order and T, and begins anew in another order if that one is too dear
//   insert_into_target    chooses the target (insert_into_target.h)
//   insert_in_rounds      is the loop (insert_in_rounds.h)

#include <CGAL/Delaunay_from_surface_3/core/order/Insertion_budget.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Asking_visitor.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Has_budget.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Visitor_in_mode_of_caller.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/build_aside.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/check_plan.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_into_target.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/make_order.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/points_on_line.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/visitor_of_caller.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/with_concurrency.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/double_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/iterator.h>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// What a public function hands over: the points, checked; a graph on them; what the caller calls
// them, as a function of their indices; and the infos that came with them.
template <class Point, class Graph, class VertexIndexMap, class NameOf, class Infos>
struct Insertion_input
{
  const std::vector<Point>& points;
  const Graph& graph;
  VertexIndexMap index_map;
  std::optional<std::string> irregularity;
  NameOf name_of;
  Infos infos;
};

template <class Point, class Graph, class VertexIndexMap, class NameOf, class Infos>
Insertion_input(const std::vector<Point>&, const Graph&, VertexIndexMap, std::optional<std::string>,
                NameOf, Infos) -> Insertion_input<Point, Graph, VertexIndexMap, NameOf, Infos>;

// Points that need not be a surface are not irregular.
inline const std::optional<std::string> no_irregularity = std::nullopt;

// What the caller asks of the order.
struct Order_options
{
  unsigned int seed;
  bool creates_in_input_order;
};

// Is the target one for exact numbers that may turn out to be doubles?
template <class Target, class Geom_traits>
constexpr bool looks_for_doubles()
{
  if constexpr (Target::serves_everything || std::is_same<typename Geom_traits::FT, double>::value)
    return false;
  else
    return Target::serves_geom_traits();
}

// The order. If exact numbers are doubles it is made of doubles: that is faster, and it is the
// same. If one of them is not, says which in `obstacle`.
template <class Target, class Plan, class Triangulation, class Graph, class VertexIndexMap>
Insertion_order order_of(const Plan& make_plan, const Triangulation& tr,
                         const std::vector<typename Triangulation::Point>& points,
                         const Graph& graph, VertexIndexMap index_map, std::string& obstacle)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Points = std::vector<Kernel::Point_3>;
  const typename Executor_of<Target>::type executor{};
  if constexpr (looks_for_doubles<Target, typename Triangulation::Geom_traits>()) {
    const std::size_t i = first_not_double(points);
    if (i < points.size())
      obstacle = "a coordinate of point " + std::to_string(i) + " is not a double";
    else if constexpr (std::is_invocable<const Plan&, const Points&, const Kernel&, const Graph&,
                                         VertexIndexMap>::value) {
      Points doubles;
      doubles.reserve(points.size());
      for (const auto& p : points) {
        const auto c = *double_coordinates(p);
        doubles.emplace_back(c[0], c[1], c[2]);
      }
      return make_order(executor, make_plan, doubles, Kernel(), graph, index_map);
    }
  }
  (void)obstacle;
  return make_order(executor, make_plan, points, tr.geom_traits(), graph, index_map);
}

// Are the points such that no order need be made for CGAL's insertion? Not where a visitor is asked
// in that order.
template <class Target, class Triangulation, class Visitor>
bool is_left_to_cgal(const Triangulation& tr,
                     const std::vector<typename Triangulation::Point>& points,
                     const Visitor_in_mode_of_caller<Visitor>&)
{
  using Point = typename Triangulation::Point;
  if constexpr (!Target::serves_everything && !accepts_points<Visitor, Point>())
    if constexpr (Target::serves_geom_traits())
      return tr.number_of_vertices() == 0 && are_on_one_line(tr.geom_traits(), points);
  (void)tr, (void)points;
  return false;
}

// Order, T, and the points in that order.
template <class Target, class Hints, class Traits, class Triangulation, class Plan, class Input,
          class Visitor>
Planned_points<typename Triangulation::Point>
plan_insertion(const Triangulation& tr, const Input& input, const Traits& traits,
               const Plan& make_plan, Visitor& visitor)
{
  using Phase = Surface_insertion_phase;
  Planned_points<typename Triangulation::Point> planned;
  visitor.phase_begins(Phase::PLAN);
  if (is_left_to_cgal<Target>(tr, input.points, visitor)) {
    planned.obstacle = "the points lie in one plane";
    planned.plan = order_along_line(input.points);
  } else
    planned.plan = order_of<Target>(make_plan, tr, input.points, input.graph, input.index_map,
                                    planned.obstacle);
  planned.places = check_plan(planned.plan, input.points.size());
  planned.points = permuted(input.points, planned.plan.order, typename Executor_of<Target>::type());
  if constexpr (Has_budget<Plan>::value)
    planned.budget = Insertion_budget(Plan::cells_per_point);
  visitor.phase_begins(Phase::SUBGRAPH);
  if constexpr (Hints::uses_subgraph)
    planned.subgraph = spanning_subgraph(traits.surface_subgraph_object(), input.graph,
                                         input.index_map, planned.places, visitor);
  return planned;
}

// The visitor, or what asks it which points are inserted.
template <class Point, class Visitor>
decltype(auto) asked(Visitor_in_mode_of_caller<Visitor>& visitor,
                     const std::vector<std::size_t>& order)
{
  if constexpr (accepts_points<Visitor, Point>())
    return Asking_visitor<Visitor>(visitor, order);
  else
    return (visitor);
}

// Inserts by the plan; if that exceeds its budget, anew by the one that it names for this case.
// Returns the vertices by point.
template <class Traits, class Triangulation, class Plan, class Input, class Visitor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_by_plan(Triangulation& tr, const Input& input, const Traits& traits, const Plan& make_plan,
               bool creates_in_input_order, Visitor& visitor)
{
  using Target = typename Traits::template Insertion_target_3<Triangulation>;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;

  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  {
    auto planned = plan_insertion<Target, Hints>(tr, input, traits, make_plan, visitor);
    planned.creates_in_input_order = creates_in_input_order;
    auto&& asking = asked<typename Triangulation::Point>(visitor, planned.plan.order);
    inserted = insert_into_target<Target, Traits>(tr, planned, asking);
    inserted.vertices =
        permuted(inserted.vertices, planned.places, typename Executor_of<Target>::type());
  }
  if constexpr (Has_budget<Plan>::value)
    if (inserted.outcome == Insertion_outcome::OVER_BUDGET) {
      visitor.order_is_replaced("its insertions destroy or enter too many cells");
      return insert_by_plan(tr, input, traits, make_plan.fallback_plan(), creates_in_input_order,
                            visitor);
    }
  return inserted;
}

// Inserts the points; at last `give` is given their vertices, by point. An empty triangulation is
// built aside: it changes when nothing can fail any more.
template <class Traits, class Triangulation, class Input, class Visitor, class Give>
void insert_and_give(Triangulation& tr, const Input& input, const Traits& traits,
                     const Order_options& options, Visitor& visitor, const Give& give)
{
  const Rounding_to_nearest rounding;
  Visitor_in_mode_of_caller<Visitor> observer(visitor, rounding);
  const auto insert_into = [&](Triangulation& into, bool gives_after_stop) {
    const std::size_t before = into.number_of_vertices();
    const auto inserted =
        insert_by_plan(into, input, traits, traits.insertion_plan_object(options.seed),
                       options.creates_in_input_order, observer);
    const bool is_complete = inserted.outcome == Insertion_outcome::COMPLETE;
    if (is_complete || gives_after_stop) {
      if (into.number_of_vertices() - before < input.points.size())
        give_points(inserted.vertices, input.points);
      rounding.in_mode_of_caller([&] { give(inserted.vertices); });
    }
    observer.phase_begins(Surface_insertion_phase::DONE);
    return is_complete;
  };
  if (tr.number_of_vertices() > 0) {
    insert_into(tr, true);
  } else {
    Triangulation aside = empty_like(tr);
    if (insert_into(aside, false))
      take_place(aside, tr);
  }
}

// The parameters that all forms share: those of the order, the visitor, and what is done with the
// vertices. `Known` are the tags of those that only this form has.
template <class... Known, class Triangulation, class Input, class Traits, class NamedParameters>
std::ptrdiff_t insert_surface(Triangulation& tr, const Input& input, const Traits& traits,
                              const NamedParameters& np)
{
  using namespace internal_np;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  check_named_parameters<Known..., visitor_t, random_seed_t, preserve_order_t,
                         vertex_to_vertex_output_iterator_t, Vertex_info_map_tag,
                         Vertex_info_range_tag>(np);

  const Order_options options = {
      static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0)),
      choose_parameter(get_parameter(np, internal_np::preserve_order), false)};
  const auto infos = infos_of_caller(np, input.name_of, input.infos, input.points.size());
  auto out = choose_parameter(get_parameter(np, internal_np::vertex_to_vertex_output_iterator),
                              Emptyset_iterator());
  auto&& visitor = visitor_of_caller(choose_parameter<Default_surface_insertion_visitor_3>(
                                         get_parameter(np, internal_np::visitor)),
                                     input.points.size());

  if (input.irregularity)
    visitor.surface_is_irregular(*input.irregularity);
  const auto before = static_cast<std::ptrdiff_t>(tr.number_of_vertices());
  const auto give = [&](const auto& vertices) {
    give_infos(vertices, infos);
    write_vertices(vertices, input.name_of, out);
  };
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  if constexpr (accepts_points<Visitor, typename Triangulation::Point>()) // in their order
    insert_and_give(tr, input, of_one_thread(traits), options, visitor, give);
  else
    insert_and_give(tr, input, traits, options, visitor, give);
  return static_cast<std::ptrdiff_t>(tr.number_of_vertices()) - before;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_SURFACE_H
