// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_IMPL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_IMPL_H

// This is the loop of rounds of Choi 2002, Fig. 1, in which nothing is traced: the order itself names
// a point to start from.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Order_of_core.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The core's side of what build() makes.
template <class Vertex>
class Built_complex final : public Built
{
public:
  // Keeps an order that has no other owner.
  Order_view keep(Insertion_order&& order)
  {
    m_order = std::move(order);
    return view_of(m_order);
  }

  // The complex of the points in the order, and its first four.
  void start(const Point_array& points, const double* apex, const Executor& executor,
             std::size_t most_cells)
  {
    m_points = Ordered_complex<Vertex>(points, this->order, apex, executor, most_cells);
    this->has_apex = apex != nullptr;
    show();
  }

  Ordered_complex<Vertex>& points() { return m_points; }

  // To be called when cells have come.
  void show()
  {
    this->vertex_of = m_points.vertex_of.data();
    this->number_of_places = m_points.vertex_of.size();
    this->cells = m_points.complex.cells();
    this->cells_end = m_points.complex.cells_end();
    this->vertices_end = m_points.complex.vertices_end();
  }

  void release_cells(std::size_t first, std::size_t last) override
  {
    m_points.complex.memory_of_cells().release_before_end(first, last);
  }
  void give_up_cells() override { m_points.complex.memory_of_cells().deallocate(); }
  void give_up_vertices() override { m_points.complex.memory_of_vertices().deallocate(); }
  Id cell_of(std::size_t v) const override { return m_points.complex.vertex(v).cell; }
  Compact_cell* take_cells(std::size_t& capacity) override
  {
    return m_points.complex.memory_of_cells().give_away(capacity);
  }

private:
  Ordered_complex<Vertex> m_points;
  Insertion_order m_order;
};

// The points in rounds, the rounds in pieces, between which watcher and budget are asked; not when all
// are inserted, since what is done is kept.
template <class Insert>
Insertion_outcome insert_in_rounds(Insert& insert, const Order_view& order, Watcher& watcher,
                                   const Insertion_budget& budget)
{
  watcher.insertion_begins(insert.number_of_threads());
  std::size_t first = 0;
  for (std::size_t h = 0; h < order.number_of_rounds; ++h) {
    const std::size_t N_h = order.round_ends[h];
    watcher.round_begins(h, N_h - first);
    while (first < N_h) {
      const std::size_t next = (std::min)(N_h, first + insert.size_of_piece(first));
      if (!insert(first, next)) // 2b, 2c
        return Insertion_outcome::STOPPED;
      if (next < order.size && budget.is_exceeded(insert.counts(), next))
        return Insertion_outcome::OVER_BUDGET;
      first = next;
    }
  }
  return Insertion_outcome::COMPLETE;
}

// The points in the order of `orders`: the order and the four points that come first.
template <class Vertex>
void begin_to_build(Built_complex<Vertex>& built, Point_source& source, Order_source& orders,
                    const Request& request, Watcher& watcher, const Executor& executor)
{
  using Phase = Surface_insertion_phase;
  watcher.phase_begins(Phase::PLAN);
  const Point_array points = source.points();
  const Starting_simplex simplex =
      starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
  built.dimension = simplex.dimension;
  built.order =
      simplex.dimension < 2 ? built.keep(order_along_line(points)) : orders.make(points, executor);
  if (!request.uses_starting_places)
    built.order.starting_places = nullptr;
  watcher.phase_begins(Phase::SUBGRAPH);
  if (simplex.dimension == 3) {
    built.start(points, nullptr, executor, request.most_cells);
  } else if (simplex.dimension == 2 && request.adds_apex) {
    const auto apex = apex_of_plane(points[simplex.points[0]], points[simplex.points[1]],
                                    points[simplex.points[2]]);
    built.start(points, apex.data(), executor, request.most_cells);
  }
  if (built.has_started())
    source.give_up();
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE std::unique_ptr<Order_source>
order_of_core(const Order_request& request)
{
  return std::make_unique<Order_of_core>(request);
}

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE const char* obstacle_of_core()
{
  if (!keeps_denormals())
    return "denormal numbers become zero, in a mode that cannot be left";
  return obstacle_of_compiler();
}

template <class Crew>
std::unique_ptr<Built> build(Point_source& points, Order_source& orders, const Request& request,
                             Watcher& watcher, const Executor& executor)
{
  for (;;) {
    auto built = std::make_unique<Built_complex<Compact_vertex>>();
    try {
      begin_to_build(*built, points, orders, request, watcher, executor);
      if (!built->has_started())
        return built;
      const Insertion_budget budget(orders.cells_per_point(), orders.is_spread());
      typename Inserter_of<Crew>::template type<Compact_vertex> insert(built->points(), executor,
                                                                       watcher);
      built->outcome = insert_in_rounds(insert, built->order, watcher, budget);
      built->counts = insert.counts();
      if (built->outcome == Insertion_outcome::COMPLETE) {
        watcher.insertion_ends(built->counts);
        watcher.phase_begins(Surface_insertion_phase::FINISH);
        insert.finish();
        CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(
            is_valid(built->points().complex, Delaunay_validity_level::DELAUNAY));
      }
    } catch (const Too_many_cells&) {
      built->outcome = Insertion_outcome::TOO_MANY_CELLS;
    }
    if (built->outcome != Insertion_outcome::OVER_BUDGET) {
      built->show();
      return built;
    }
    if (!orders.go_on())
      fail("an order with a budget has another behind it");
    watcher.order_is_replaced("its insertions destroy or enter too many cells");
  }
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_IMPL_H
