// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_IMPL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_IMPL_H

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED) && !defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY)
#error "the core is compiled: include core/build.h"
#endif

// This is the loop of rounds of Choi 2002, Fig. 1, in which nothing is traced: the order itself
// names a point to start from.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Limits the work that an order may cause before another takes its place. Only a random order bounds
// the cells that insertions destroy (Amenta, Choi, Rote 2003). So the whole costs no more than the
// budget, the work between two looks at it, and one insertion in random order. An order is not to
// blame for what every order does: where many cells must stay, perhaps a quadratic number, about as
// many are destroyed. An order that is spread over the points may destroy these, too.
class Insertion_budget
{
public:
  // Gives each inserted point a budget of destroyed cells. The first points share the budget of a
  // thousand, since few points do not tell a good order from a bad one. The largest number is never
  // exceeded.
  explicit Insertion_budget(std::size_t cells_per_point, bool is_spread = false)
    : m_cells_per_point(double(cells_per_point))
    , m_is_spread(is_spread)
  {
  }

  // Walks have a threshold of their own, since either may be exceeded without the other.
  // A step of a walk makes one test; a destroyed cell makes two or three, and is replaced as well.
  bool is_exceeded(const Insertion_counts& counts, std::size_t inserted) const
  {
    const double stay =
        m_is_spread ? double(counts.cells_created) - double(counts.cells_destroyed) : 0;
    const double most =
        cells_per_point(inserted) * (double(inserted) + 1000) + (std::max)(stay, 0.);
    return double(counts.cells_destroyed) > most ||
           double(counts.cells_tested_to_start) > steps_per_cell * most;
  }

private:
  static constexpr double steps_per_cell = 2, many_points = 1e6;

  // On smooth tori orders destroy a number of cells that grows with the logarithm of that of the
  // points. Where there are many, another sixteenth is allowed for each doubling. Asked rarely, so
  // nothing of it goes into the loop that asks.
  [[gnu::cold]] double cells_per_point(std::size_t inserted) const
  {
    const double doublings = std::log2((std::max)(double(inserted) / many_points, 1.));
    return m_cells_per_point * (1 + doublings / 16);
  }

  double m_cells_per_point;
  bool m_is_spread;
};

// Makes the order that the core inserts in. Rounds are random where there are too many points for
// numbers of 32 bits.
inline Insertion_order order_of_points(const Point_array& points, const Build_options& options,
                                       const Executor& executor)
{
  const bool are_few = points.size() < (std::numeric_limits<std::uint32_t>::max)();
  Insertion_order order =
      options.rounds == Build_options::SPACED && are_few
          ? spaced_rounds(points, executor)
          : geometric_rounds(points, options.seed, options.ratio, options.first_round);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(is_order(order, points.size()));
  return order;
}

// Inserts the points in rounds, and the rounds in chunks, between which observer and budget are
// asked; not when all are inserted, since what is done is kept.
template <class Insert>
Insertion_outcome insert_in_rounds(Insert& insert, const Order_view& order, Observer& observer,
                                   const Insertion_budget& budget)
{
  observer.phase_begins(Surface_insertion_phase::INSERTION, insert.number_of_threads());
  std::size_t first = 0;
  for (std::size_t h = 0; h < order.number_of_rounds; ++h) {
    const std::size_t N_h = order.round_ends[h];
    observer.phase_begins(Surface_insertion_phase::ROUND, N_h - first);
    while (first < N_h) {
      const std::size_t next = (std::min)(N_h, first + insert.size_of_chunk(first));
      if (!insert(first, next)) // 2b, 2c
        return Insertion_outcome::STOPPED;
      if (next < order.size && budget.is_exceeded(insert.counts(), next))
        return Insertion_outcome::OVER_BUDGET;
      first = next;
    }
  }
  return Insertion_outcome::COMPLETE;
}

// Makes the order, unless one is given, and the complex with the four points that come first.
template <class Vertex, class Source>
void begin_to_build(Ordered_complex<Vertex>& built, Source& source, const Build_options& options,
                    Observer& observer, const Executor& executor)
{
  using Phase = Surface_insertion_phase;
  if (options.given == nullptr)
    observer.phase_begins(Phase::PLAN, 0);
  const Point_array points = source.points();
  Starting_simplex simplex = {};
  if (options.inserts) {
    if constexpr (is_rounded<typename Vertex::Place>) // the exact places will tell
      simplex.dimension = points.size() < 4 ? -1 : 3;
    else
      simplex = starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
    built.dimension = simplex.dimension;
  }
  if (options.inserts && simplex.dimension < 2)
    built.keep(order_along_line(points));
  else if (options.given == nullptr)
    built.keep(order_of_points(points, options, executor));
  else
    built.order = *options.given;
  if (!options.uses_starting_places)
    built.order.starting_places = nullptr;
  if (!options.inserts)
    return;
  observer.phase_begins(Phase::SUBGRAPH, 0);
  if constexpr (is_rounded<typename Vertex::Place>) {
    if (simplex.dimension == 3)
      built.start_copies(source, executor, options.most_cells);
  } else if (simplex.dimension == 3) {
    built.start(points, nullptr, executor, options.most_cells, weights_of(source));
  } else if (simplex.dimension == 2 && options.adds_apex) {
    const auto apex = apex_of_plane(points[simplex.points[0]], points[simplex.points[1]],
                                    points[simplex.points[2]]);
    built.start(points, apex.data(), executor, options.most_cells, weights_of(source));
  }
  if (built.has_started())
    source.give_up();
}

// Gives the hidden points the vertex 0. Their own vertices get no cell, or one that contains them. To
// be called when all points are inserted: what is hidden once is hidden for ever, but vertices do
// not learn that others took their last cell.
template <class Vertex>
void leave_out_hidden_vertices(Ordered_complex<Vertex>& built, bool locates)
{
  auto& complex = built.complex;
  Inserter<Alone_with_complex<Vertex>> inserter(complex);
  Id near = complex.vertex(Compact_numbers::infinite).cell;
  for (std::size_t k = 0; k < built.vertices.size(); ++k) {
    if (complex.is_in_cell(built.vertices[k])) {
      near = complex.vertex(built.vertices[k]).cell;
      continue;
    }
    built.vertices[k] = 0;
    const Id v = Compact_numbers::vertex_of_point(k);
    Id& cell = complex.vertex(v).cell; // it may be dead, or another one by now
    if (locates)
      near = inserter.walk(v, near, Read_alone()).cell;
    cell = locates ? near : 0;
  }
}

// Is build() with the type of the vertices and the class that inserts them, and part of it.
template <class Vertex, template <class> class Insert, class Source>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE std::unique_ptr<Built>
build_by(Source& points, Build_options options, Observer& observer, const Executor& executor)
{
  const bool is_given = options.given != nullptr;
  for (;;) {
    const bool is_spaced = options.rounds == Build_options::SPACED;
    auto built = std::make_unique<Ordered_complex<Vertex>>();
    try {
      begin_to_build(*built, points, options, observer, executor);
      if (!built->has_started())
        return built;
      const bool is_spread = is_given ? options.is_spread : is_spaced;
      const Insertion_budget budget(
          is_given || is_spaced ? options.cells_per_point : Build_options::any_number, is_spread);
      Insert<Vertex> insert(*built, executor, observer);
      built->outcome = insert_in_rounds(insert, built->order, observer, budget);
      built->counts = insert.counts();
      if (built->outcome == Insertion_outcome::COMPLETE) {
        if (!is_rounded<typename Vertex::Place>) { // other copies follow
          observer.insertion_ends(built->counts);
          observer.phase_begins(Surface_insertion_phase::FINISH, 0);
        }
        insert.finish();
        if constexpr (Vertex::has_weight)
          leave_out_hidden_vertices(*built, options.locates_hidden);
        CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(
            is_valid(built->complex, Delaunay_validity_level::DELAUNAY));
      }
    } catch (const Too_many_cells&) {
      built->outcome = Insertion_outcome::TOO_MANY_CELLS;
    }
    const bool is_over_budget = built->outcome == Insertion_outcome::OVER_BUDGET;
    if (is_over_budget)
      observer.notice(Surface_insertion_notice::ORDER_IS_REPLACED,
                      "its insertions destroy or enter too many cells");
    if (!is_over_budget || is_given) {
      built->show();
      return built;
    }
    options.rounds = Build_options::RANDOM;
  }
}

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
inline std::unique_ptr<Built> build(Point_source& points, const Build_options& options,
                                    Observer& observer, const Alone& executor)
{
  return build_by<Compact_vertex, Insert_alone>(points, options, observer, executor);
}
#endif

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

// The compiled core has this in one object file.
#if !defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY) ||                                              \
    defined(CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H)
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE const char* obstacle_of_core()
{
  if (!keeps_denormals())
    return "denormal numbers become zero, in a mode that cannot be left";
  return obstacle_of_compiler();
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
#endif
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_IMPL_H
