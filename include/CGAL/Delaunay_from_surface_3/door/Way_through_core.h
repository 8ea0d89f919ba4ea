// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_WAY_THROUGH_CORE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_WAY_THROUGH_CORE_H

// The fast way from the points of a call to the vertices of an empty triangulation: what the core is
// given, what comes of it, and CGAL's insertion, in the same order, where it cannot serve.

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/order/view_of_order.h>
#include <CGAL/Delaunay_from_surface_3/door/Doubles_of_points.h>
#include <CGAL/Delaunay_from_surface_3/door/export_built.h>
#include <CGAL/Delaunay_from_surface_3/door/obstacles.h>
#include <CGAL/Delaunay_from_surface_3/door/order_source.h>
#include <CGAL/Delaunay_from_surface_3/paper/Edges_of_graph.h>
#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insert_through_cgal.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The type of the core's ids where a traits class is used; tests use others.
template <class Traits>
struct Id_of_core
{
  using type = std::uint32_t;
};

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

// What a caller asks of the order.
struct Order_options
{
  unsigned int seed;
  bool creates_in_input_order;
};

template <class Traits, class Triangulation, class Input, class Watcher>
class Way_through_core
{
  using Point = typename Triangulation::Point;
  using Inserted = Inserted_points<typename Triangulation::Vertex_handle>;

public:
  using Id = typename Id_of_core<Traits>::type;

  // Keeps references to all but the options.
  Way_through_core(Triangulation& tr, const Input& input, const Traits& traits,
                   const Order_options& options, Watcher& watcher, const Executor& executor)
    : m_tr(tr)
    , m_input(input)
    , m_options(options)
    , m_watcher(watcher)
    , m_executor(executor)
    , m_doubles(input.points)
    , m_planned{input.points, tr.geom_traits(), input.graph, input.index_map}
    , m_edges(input.graph, input.index_map, input.points.size())
    , m_orders(order_source(traits.insertion_plan_object(options.seed), m_planned, m_edges))
    , m_obstacle(obstacle_to_core(tr, m_doubles))
  {
  }

  // Whether build() may be called.
  bool is_open() const { return m_obstacle.empty(); }
  Point_source& points() { return m_doubles; }
  Order_source& orders() { return *m_orders; }
  Request request() const { return {false, uses_starting_places<Traits>()}; }

  // What build() made becomes the triangulation, or leads round the core.
  void take(Built<Id>& built)
  {
    m_obstacle = obstacle_found(built);
    m_inserted.is_complete = built.outcome == Insertion_outcome::COMPLETE;
    if (m_inserted.is_complete) {
      m_inserted.vertices =
          export_built(built, m_input.points, m_options.creates_in_input_order, m_tr, m_executor);
    } else if (built.outcome == Insertion_outcome::FLAT) {
      m_order = copy_of(built.order);
    }
  }

  // The vertices by point.
  Inserted finish()
  {
    if (!m_obstacle.empty())
      insert_round_the_core();
    return std::move(m_inserted);
  }

private:
  using Graph = std::decay_t<decltype(std::declval<const Input&>().graph)>;
  using Index_map = decltype(std::declval<const Input&>().index_map);
  using Planned = Planned_points<Point, typename Triangulation::Geom_traits, Graph, Index_map>;

  void insert_round_the_core()
  {
    using Phase = Surface_insertion_phase;
    if (m_options.creates_in_input_order)
      refuse_input_order(m_obstacle);
    if (!m_order) {
      m_watcher.phase_begins(Phase::PLAN);
      m_order = copy_of(m_orders->make(m_doubles.points(), m_executor));
      if (!uses_starting_places<Traits>())
        m_order->starting_places.clear();
      m_watcher.phase_begins(Phase::SUBGRAPH);
    }
    m_doubles.give_up();
    m_watcher.target_is_replaced(m_obstacle);
    m_inserted = insert_through_cgal<Planned_hints_3>(m_tr, m_input.points, *m_order, Index_graph(),
                                                      m_watcher);
  }

  Triangulation& m_tr;
  const Input& m_input;
  const Order_options m_options;
  Watcher& m_watcher;
  const Executor& m_executor;
  Doubles_of_points<Point> m_doubles;
  const Planned m_planned;
  Edges_of_graph<Graph, Index_map> m_edges;
  const std::unique_ptr<Order_source> m_orders;
  std::string m_obstacle; // empty as long as there is none
  std::optional<Insertion_order> m_order;
  Inserted m_inserted;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_WAY_THROUGH_CORE_H
