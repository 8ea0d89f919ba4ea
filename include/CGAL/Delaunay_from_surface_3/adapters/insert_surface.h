// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_INSERT_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_INSERT_SURFACE_H

// All functions that insert come this way: it reads the parameters, builds an empty triangulation
// aside (through the core, as the paper does, or by CGAL if there are few points), and hands the
// vertices over.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Visitor_observer.h>
#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/adapters/export_complex.h>
#include <CGAL/Delaunay_from_surface_3/adapters/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class Gt, class Tds, class Lds>
class Regular_triangulation_3;

namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A type that is not derived from a Delaunay_triangulation_3 gets a message of one line.
template <class Gt, class Tds, class Lp, class Slds>
std::true_type is_delaunay_triangulation(const Delaunay_triangulation_3<Gt, Tds, Lp, Slds>*);
std::false_type is_delaunay_triangulation(const void*);

template <class Gt, class Tds, class Lds>
std::true_type is_regular_triangulation(const Regular_triangulation_3<Gt, Tds, Lds>*);
std::false_type is_regular_triangulation(const void*);

template <class Triangulation>
constexpr bool is_regular =
    decltype(is_regular_triangulation(std::declval<Triangulation*>()))::value;

template <class Triangulation>
using If_refused =
    std::enable_if_t<!decltype(is_delaunay_triangulation(std::declval<Triangulation*>()))::value,
                     std::ptrdiff_t>;

template <class Triangulation>
std::ptrdiff_t refuse_triangulation()
{
  static_assert(!is_regular<Triangulation>,
                "points with weights are inserted by insert_points_3() of "
                "CGAL/insert_weighted_points_3.h, without faces, graph or mesh");
  static_assert(
      is_regular<Triangulation> ||
          decltype(is_delaunay_triangulation(std::declval<Triangulation*>()))::value,
      "the triangulation is a CGAL::Delaunay_triangulation_3; points in a periodic box are "
      "for periodic_delaunay_3_arrays()");
  return 0;
}

// Reads the coordinates of a caller's points as doubles. They are exact if all of them are doubles,
// and else rounded, which is enough to make an order. Those with weights: insert_weighted_points_3.h.
template <class Point, bool has_weights = has_weight<Point>>
class Doubles_of_points final : public Point_source
{
public:
  // Keeps a reference. Linear.
  explicit Doubles_of_points(const std::vector<Point>& points)
    : m_points(points)
    , m_not_double(points.size())
  {
    read();
  }

  Point_array points() override
  {
    if (m_coordinates.empty())
      read();
    return Point_array(m_coordinates.data(), m_points.size());
  }
  void give_up() override { Large_vector<double>().swap(m_coordinates); }

  // Why they are not exact; empty if they are.
  std::string obstacle() const
  {
    return m_not_double < m_points.size()
               ? "a coordinate of point " + std::to_string(m_not_double) + " is not a double"
               : std::string();
  }

private:
  void read()
  {
    m_coordinates.reserve(3 * m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const Point& p = m_points[i];
      std::array<double, 3> c;
      if (const auto exact = double_coordinates(p)) {
        c = *exact;
      } else {
        m_not_double = (std::min)(m_not_double, i);
        c = {to_double(p.x()), to_double(p.y()), to_double(p.z())};
      }
      m_coordinates.insert(m_coordinates.end(), c.begin(), c.end());
    }
  }

  const std::vector<Point>& m_points;
  Large_vector<double> m_coordinates;
  std::size_t
      m_not_double; // the first point with a coordinate that is none, or the number of points
};

// The following tells what keeps a call from going through the core, so that CGAL inserts.

// Returns true if all predicates that the filters decide without asking are the kernel's. The
// objects count, since the triangulation calls these.
template <class GeomTraits, class Kernel>
constexpr bool has_predicates_of_kernel()
{
  using Gt = const GeomTraits&;
  using K = const Kernel&;
  return std::is_same<decltype(std::declval<Gt>().orientation_3_object()),
                      decltype(std::declval<K>().orientation_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().side_of_oriented_sphere_3_object()),
                      decltype(std::declval<K>().side_of_oriented_sphere_3_object())>::value &&
         std::is_same<
             decltype(std::declval<Gt>().coplanar_side_of_bounded_circle_3_object()),
             decltype(std::declval<K>().coplanar_side_of_bounded_circle_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().coplanar_orientation_3_object()),
                      decltype(std::declval<K>().coplanar_orientation_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().compare_xyz_3_object()),
                      decltype(std::declval<K>().compare_xyz_3_object())>::value;
}

// Returns the same about the predicates of regular triangulations.
template <class GeomTraits, class Kernel>
constexpr bool has_power_predicates_of_kernel()
{
  using Gt = const GeomTraits&;
  using K = const Kernel&;
  return std::is_same<decltype(std::declval<Gt>().orientation_3_object()),
                      decltype(std::declval<K>().orientation_3_object())>::value &&
         std::is_same<
             decltype(std::declval<Gt>().power_side_of_oriented_power_sphere_3_object()),
             decltype(std::declval<K>().power_side_of_oriented_power_sphere_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().coplanar_orientation_3_object()),
                      decltype(std::declval<K>().coplanar_orientation_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().construct_point_3_object()),
                      decltype(std::declval<K>().construct_point_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().compare_xyz_3_object()),
                      decltype(std::declval<K>().compare_xyz_3_object())>::value;
}

// Predicates are exact if they are filtered, or compute with exact numbers.
template <class GeomTraits>
using Says_of_filters = typename GeomTraits::Has_filtered_predicates_tag;

template <class GeomTraits>
constexpr bool has_filtered_predicates =
    detected_or_t<std::false_type, Says_of_filters, GeomTraits>::value;

template <class GeomTraits>
constexpr bool has_exact_predicates()
{
  using Is_exact = typename Algebraic_structure_traits<typename GeomTraits::FT>::Is_exact;
  return has_filtered_predicates<GeomTraits> || std::is_same<Is_exact, Tag_true>::value;
}

template <class Kernel>
using Orientation_of_kernel = decltype(std::declval<const Kernel&>().orientation_3_object());

// Returns true if the core knows the numbers and predicates of the triangulation. Traits that bring
// predicates of their own are not served: its filters would go past them.
template <class Triangulation>
constexpr bool serves_geom_traits()
{
  using Geom_traits = typename Triangulation::Geom_traits;
  using Point = typename Triangulation::Point;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  if constexpr (!is_detected<Orientation_of_kernel, Kernel>) // a point of the user's own
    return false;
  else if constexpr (has_weight<Point>)
    return std::is_same<typename Geom_traits::Weighted_point_3, Point>::value &&
           has_power_predicates_of_kernel<Geom_traits, Kernel>() &&
           has_exact_predicates<Geom_traits>();
  else
    return std::is_same<typename Geom_traits::Point_3, Point>::value &&
           has_predicates_of_kernel<Geom_traits, Kernel>() && has_exact_predicates<Geom_traits>();
}

// Returns what is in the way before anything is done; empty if nothing is.
template <class Triangulation>
std::string obstacle_to_core(const Triangulation& tr,
                             const Doubles_of_points<typename Triangulation::Point>& points)
{
  if (!serves_geom_traits<Triangulation>())
    return "the predicates of the geometric traits are not the exact ones of a kernel";
  if (const char* const obstacle = obstacle_of_core())
    return obstacle;
  if (tr.number_of_vertices() > 0)
    return "the triangulation is not empty";
  return points.obstacle();
}

// Returns what the core found to be in the way.
inline std::string obstacle_found(const Built& built)
{
  switch (built.outcome) {
  case Insertion_outcome::FLAT:
    return "the points lie in one plane";
  case Insertion_outcome::TOO_MANY_CELLS:
    return Too_many_cells().what();
  default:
    return "";
  }
}

[[noreturn]] inline void refuse_input_order(const std::string& obstacle)
{
  throw Surface_input_error("the vertices cannot be created in the order of the input: " +
                            obstacle);
}

// True if a plan names a budget, and a plan to fall back to when it is exceeded.
template <class Plan>
using Budget = std::void_t<decltype(Plan::cells_per_point),
                           decltype(std::declval<const Plan&>().fallback_plan())>;

template <class Plan>
constexpr bool has_budget = is_detected<Budget, Plan>;

template <class Plan>
constexpr std::size_t budget_of()
{
  if constexpr (has_budget<Plan>)
    return Plan::cells_per_point;
  else
    return Build_options::any_number;
}

// True if the core can carry the plan out; it cannot if a caller has derived it from one of the
// core's.
template <class Plan>
using Plan_of_core = typename Plan::Plan_of_core;

template <class Plan>
constexpr bool is_plan_of_core = std::is_same<Plan, detected_or_t<void, Plan_of_core, Plan>>::value;

// A triangulation built aside takes the place of an empty one, with its traits, its lock structure
// and the content of its infinite vertex. That is moved, not copied: the content of a vertex base
// need not be copyable, even where its type claims to be (as std::vector does for any element).

// A vertex with constant members can be copied, but not assigned to another.
template <class Vertex>
constexpr bool is_only_copied =
    std::is_copy_constructible<Vertex>::value && !std::is_move_assignable<Vertex>::value;

// An empty triangulation with the traits and the lock structure of `tr`, which is empty.
template <class Triangulation>
Triangulation empty_like(const Triangulation& tr)
{
  if constexpr (is_only_copied<typename Triangulation::Vertex>) {
    return Triangulation(tr);
  } else {
    Triangulation aside(tr.geom_traits()); // Fast_location has no constructor that takes both
    aside.set_lock_data_structure(tr.get_lock_data_structure());
    return aside;
  }
}

// All that the vertex holds but its cell and its time stamp, which belong to its container.
template <class Vertex>
void move_content(Vertex& from, Vertex& to)
{
  const auto cell = to.cell();
  if constexpr (has_time_stamp<Vertex>) {
    const auto time_stamp = to.time_stamp();
    to = std::move(from);
    to.set_time_stamp(time_stamp);
  } else {
    to = std::move(from);
  }
  to.set_cell(cell);
}

// Both change places. `aside` came from empty_like(tr).
template <class Triangulation>
void take_place(Triangulation& aside, Triangulation& tr)
{
  if constexpr (std::is_move_assignable<typename Triangulation::Vertex>::value)
    move_content(*tr.infinite_vertex(), *aside.infinite_vertex());
  tr.swap(aside);
}

// The following leads from the points of a call to the vertices of an empty triangulation: through
// the core, or by CGAL's insertion, in the same order, where the core cannot serve.

template <class Traits>
using Says_of_starting_places = decltype(Traits::uses_starting_places);

template <class Traits>
constexpr bool uses_starting_places()
{
  if constexpr (is_detected<Says_of_starting_places, Traits>)
    return Traits::uses_starting_places;
  else
    return true;
}

// A caller asks this of the order.
struct Order_options
{
  unsigned int seed;
  bool creates_in_input_order;
  std::size_t most_cells = Compact_numbers::max_cells; // in the core; beyond, CGAL inserts
};

// Inserts through the core if it serves, else by CGAL, in the same order, and tells the observer the
// reason. A plan that is not the core's own gets the points as the caller knows them; an order that
// no insertion could use is refused with a std::invalid_argument. Returns the vertices by point.
template <class Traits, class Triangulation, class Input, class Plan, class Observer,
          class Executor>
Inserted_points<typename Triangulation::Vertex_handle>
insert_through_core(Triangulation& tr, const Input& input, const Plan& plan,
                    const Order_options& asked, Observer& observer, const Executor& executor)
{
  using Phase = Surface_insertion_phase;
  Doubles_of_points<typename Triangulation::Point> doubles(input.points);
  std::string obstacle = obstacle_to_core(tr, doubles);
  if (asked.creates_in_input_order && !obstacle.empty())
    refuse_input_order(obstacle);
  Build_options options;
  options.uses_starting_places = uses_starting_places<Traits>();
  options.most_cells = asked.most_cells;
  options.inserts = obstacle.empty();
  options.locates_hidden = has_weight<typename Triangulation::Point>;
  Insertion_order order;
  Order_view view = {};
  if constexpr (is_plan_of_core<Plan>) {
    plan.ask(options);
  } else {
    observer.phase_begins(Phase::PLAN);
    order = plan(input.points, tr.geom_traits(), input.graph, input.index_map);
    check_plan(order, input.points.size());
    view = view_of(order);
    options.given = &view;
    options.cells_per_point = budget_of<Plan>();
  }
  auto built = build(doubles, options, observer, executor);
  if (built->outcome == Insertion_outcome::STOPPED)
    return {};
  if constexpr (serves_geom_traits<Triangulation>())
    if (built->outcome == Insertion_outcome::COMPLETE)
      return {export_built(*built, input.points, asked.creates_in_input_order, tr, executor), true};
  if constexpr (has_budget<Plan> && !is_plan_of_core<Plan>)
    if (built->outcome == Insertion_outcome::OVER_BUDGET) {
      built.reset();
      order = Insertion_order(); // frees the memory before another is made
      return insert_through_core<Traits>(tr, input, plan.fallback_plan(), asked, observer,
                                         executor);
    }
  if (options.inserts) {
    obstacle = obstacle_found(*built);
    if (asked.creates_in_input_order)
      refuse_input_order(obstacle);
  }
  if (!options.inserts)
    observer.phase_begins(Phase::SUBGRAPH);
  built->give_up_cells();
  built->give_up_vertices();
  order = copy_of(built->order);
  built.reset();
  doubles.give_up();
  observer.notice(Surface_insertion_notice::CORE_IS_REPLACED, obstacle);
  if constexpr (has_weight<typename Triangulation::Point>)
    return insert_with_weights(tr, input.points, order, observer);
  else
    return insert_through_cgal<Planned_hints_3>(tr, input.points, order, Index_graph(), observer);
}

template <class NamedParameters>
Order_options order_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return {
      static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0)),
      choose_parameter(get_parameter(np, internal_np::preserve_order), false)};
}

// Names the constant through_core, if traits have it.
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

template <class Traits>
using Plan_of = std::decay_t<decltype(std::declval<const Traits&>().insertion_plan_object(0u))>;

// Returns true if the traits look at the graph, for a subgraph to trace or a plan of their own.
template <class Traits>
constexpr bool asks_for_graph()
{
  if constexpr (goes_through_core<Traits>())
    return !is_plan_of_core<Plan_of<Traits>>;
  else
    return true;
}

// With fewer points than this CGAL inserts them at once, where the caller cannot tell the
// difference: not if there is a plan of the caller's or a visitor, nor if the order of the input is
// preserved.
template <class Traits, class Triangulation, class NamedParameters>
std::size_t least_points_for_core(const Triangulation& tr, const NamedParameters& np)
{
  const bool is_seen = is_given<NamedParameters, internal_np::visitor_t> ||
                       asks_for_graph<Traits>() || order_options(np).creates_in_input_order;
  return is_seen || tr.number_of_vertices() > 0 ? 0 : few_points;
}

// Hands the vertices over, by point. A vertex of several points gets that of the first.
template <class Vertex_handle, class Input, class Infos, class Output>
void give(const std::vector<Vertex_handle>& vertices, std::size_t number_of_new_vertices,
          const Input& input, const Infos& infos, Output& out, const Rounding_to_nearest& rounding)
{
  constexpr bool may_hide = has_weight<typename std::decay_t<decltype(input.points)>::value_type>;
  if (may_hide || number_of_new_vertices < input.points.size())
    give_points(vertices, input.points);
  rounding.in_mode_of_caller([&] {
    give_infos(vertices, infos);
    write_vertices<may_hide>(vertices, input.name_of, out);
  });
}

// Reads the parameters that all forms share: for the order, the visitor, and the vertices. `Known`
// are the tags of the parameters that only this form has. An empty triangulation changes when
// nothing can fail any more.
template <class ExecutorOfCall, class... Known, class Triangulation, class Input, class Traits,
          class NamedParameters>
std::ptrdiff_t insert_surface(Triangulation& tr, const Input& input, const Traits& traits,
                              const NamedParameters& np)
{
  using namespace internal_np;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  check_named_parameters<Known..., visitor_t, random_seed_t, preserve_order_t,
                         vertex_to_vertex_output_iterator_t, Vertex_info_map_tag,
                         Vertex_info_range_tag>(np);
  Order_options options = order_options(np);
  options.creates_in_input_order &= input.points.size() > 1; // else every order is that
  const auto infos = infos_of_caller(np, input.name_of, input.infos, input.points.size());
  auto out = choose_parameter(get_parameter(np, internal_np::vertex_to_vertex_output_iterator),
                              Emptyset_iterator());
  auto&& visitor = visitor_of_caller(choose_parameter<Default_surface_insertion_visitor_3>(
                                         get_parameter(np, internal_np::visitor)),
                                     input.points.size());
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  const Rounding_to_nearest rounding;
  Visitor_observer<Visitor> observer(visitor, rounding);
  if (input.irregularity)
    observer.notice(Surface_insertion_notice::SURFACE_IS_IRREGULAR, *input.irregularity);

  const std::size_t before = tr.number_of_vertices();
  const std::unique_ptr<Triangulation> aside(before > 0 ? nullptr
                                                        : new Triangulation(empty_like(tr)));
  Triangulation& into = aside ? *aside : tr;
  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  if constexpr (goes_through_core<Traits>()) {
    if (input.points.size() < least_points_for_core<Traits>(tr, np)) {
      if constexpr (has_weight<typename Triangulation::Point>)
        inserted = insert_with_weights(into, input.points, Insertion_order(), observer);
      else
        inserted = insert_few_points(into, input.points);
    } else {
      inserted =
          insert_through_core<Traits>(into, input, traits.insertion_plan_object(options.seed),
                                      options, observer, ExecutorOfCall());
    }
  } else {
    if (options.creates_in_input_order)
      refuse_input_order("that needs traits that go through the core");
    inserted = insert_with_traces(into, input, traits, options.seed, observer);
  }

  if (inserted.is_complete || !aside)
    give(inserted.vertices, into.number_of_vertices() - before, input, infos, out, rounding);
  observer.phase_begins(Surface_insertion_phase::DONE);
  if (inserted.is_complete && aside)
    take_place(*aside, tr);
  return static_cast<std::ptrdiff_t>(tr.number_of_vertices()) - static_cast<std::ptrdiff_t>(before);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_INSERT_SURFACE_H
