// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERT_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERT_SURFACE_H

// The door into a triangulation, which all functions that insert share: it reads the parameters,
// builds aside what is empty, through the core, as the paper does, or by CGAL if that are few points,
// and hands the vertices over.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/door/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/door/Insertion_input.h>
#include <CGAL/Delaunay_from_surface_3/door/Visitor_watcher.h>
#include <CGAL/Delaunay_from_surface_3/door/Way_through_core.h>
#include <CGAL/Delaunay_from_surface_3/door/build_aside.h>
#include <CGAL/Delaunay_from_surface_3/door/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/door/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/door/visitor_of_caller.h>
#include <CGAL/Delaunay_from_surface_3/paper/insert_through_cgal.h>
#include <CGAL/Delaunay_from_surface_3/paper/insert_with_traces.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/iterator.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class NamedParameters>
Order_options order_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return {
      static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0)),
      choose_parameter(get_parameter(np, internal_np::preserve_order), false)};
}

// Whether traits have the constant through_core.
template <class Traits>
using Through_core = decltype(Traits::through_core);

template <class Traits>
constexpr bool names_way = is_detected<Through_core, Traits>;

template <class Traits>
constexpr bool goes_through_core()
{
  static_assert(
      names_way<Traits>,
      "traits say by through_core who inserts: the core, in which nothing is traced, or CGAL");
  if constexpr (names_way<Traits>)
    return Traits::through_core;
  else
    return false;
}

// With fewer points than this CGAL inserts them at once, where the caller cannot tell the
// difference: not if there is a plan of the caller's or a visitor, nor if the order of the input is
// preserved.
template <class Traits, class Triangulation, class NamedParameters>
std::size_t least_points_for_core(const Triangulation& tr, const NamedParameters& np)
{
  if constexpr (goes_through_core<Traits>() && !is_given<NamedParameters, internal_np::visitor_t>) {
    using Plan = std::decay_t<decltype(std::declval<const Traits&>().insertion_plan_object(0u))>;
    if (is_plan_of_core<Plan> && tr.number_of_vertices() == 0)
      return order_options(np).creates_in_input_order ? 0 : few_points;
  }
  (void)tr, (void)np;
  return 0;
}

// Hands the vertices over, by point. A vertex of several points gets that of the first.
template <class Vertex_handle, class Input, class Infos, class Output>
void give(const std::vector<Vertex_handle>& vertices, std::size_t number_of_new_vertices,
          const Input& input, const Infos& infos, Output& out, const Rounding_to_nearest& rounding)
{
  if (number_of_new_vertices < input.points.size())
    give_points(vertices, input.points);
  rounding.in_mode_of_caller([&] {
    give_infos(vertices, infos);
    write_vertices(vertices, input.name_of, out);
  });
}

// The parameters that all forms share: those of the order, the visitor, and what is done with the
// vertices. `Known` are the tags of those that only this form has. An empty triangulation changes
// when nothing can fail any more.
template <class ExecutorOfCall, class... Known, class Triangulation, class Input, class Traits,
          class NamedParameters>
std::ptrdiff_t insert_surface(Triangulation& tr, const Input& input, const Traits& traits,
                              const NamedParameters& np)
{
  using namespace internal_np;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Point = typename Triangulation::Point;
  check_named_parameters<Known..., visitor_t, random_seed_t, preserve_order_t,
                         vertex_to_vertex_output_iterator_t, Vertex_info_map_tag,
                         Vertex_info_range_tag>(np);
  const Order_options options = order_options(np);
  const auto infos = infos_of_caller(np, input.name_of, input.infos, input.points.size());
  auto out = choose_parameter(get_parameter(np, internal_np::vertex_to_vertex_output_iterator),
                              Emptyset_iterator());
  auto&& visitor = visitor_of_caller(choose_parameter<Default_surface_insertion_visitor_3>(
                                         get_parameter(np, internal_np::visitor)),
                                     input.points.size());
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  const Rounding_to_nearest rounding;
  Visitor_watcher<Visitor, Point> watcher(visitor, rounding, input.points);
  if (input.irregularity)
    watcher.surface_is_irregular(*input.irregularity);

  const std::size_t before = tr.number_of_vertices();
  const std::unique_ptr<Triangulation> aside(before > 0 ? nullptr
                                                        : new Triangulation(empty_like(tr)));
  Triangulation& into = aside ? *aside : tr;
  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  if constexpr (goes_through_core<Traits>()) {
    if (input.points.size() < least_points_for_core<Traits>(tr, np)) {
      inserted = insert_few_points(into, input.points);
    } else {
      // One thread if a visitor is asked about each point, in their order.
      using Executor = std::conditional_t<accepts_points<Visitor, Point>(), Alone, ExecutorOfCall>;
      using Way = Way_through_core<Traits, Triangulation, Input, decltype(watcher)>;
      const Executor executor{};
      Way way(into, input, traits, options, watcher, executor);
      if constexpr (serves_geom_traits<Triangulation>())
        if (way.is_open())
          way.take(*build<typename Way::Id, typename Crew<Executor>::type>(
              way.points(), way.orders(), way.request(), watcher, executor));
      inserted = way.finish();
    }
  } else {
    if (options.creates_in_input_order)
      refuse_input_order("that needs traits that go through the core");
    inserted = insert_with_traces(into, input, traits, options.seed, watcher);
  }

  if (inserted.is_complete || !aside)
    give(inserted.vertices, into.number_of_vertices() - before, input, infos, out, rounding);
  watcher.phase_begins(Surface_insertion_phase::DONE);
  if (inserted.is_complete && aside)
    take_place(*aside, tr);
  return static_cast<std::ptrdiff_t>(tr.number_of_vertices()) - static_cast<std::ptrdiff_t>(before);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERT_SURFACE_H
