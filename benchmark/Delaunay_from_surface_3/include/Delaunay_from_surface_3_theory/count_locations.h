// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_COUNT_LOCATIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_COUNT_LOCATIONS_H

// The laboratory: points are inserted once, in the paper's random order, and each of them is
// located in every way that can start from the same triangulation. What is counted does not depend
// on the machine.

#include <Delaunay_from_surface_3_comparison/triangulations.h>
#include <Delaunay_from_surface_3_theory/crossings.h>
#include <Delaunay_from_surface_3_theory/trees.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <Delaunay_from_surface_3_meters/History_dag_3.h>
#include <Delaunay_from_surface_3_meters/History_hints_3.h>
#include <Delaunay_from_surface_3_meters/Predicate_counting_traits_3.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace theory {

using comparison::Counted_triangulation;

// What it took to locate some points.
struct Location_cost
{
  std::size_t points = 0, cells_entered = 0, calls = 0;

  Location_cost& operator+=(const Location_cost& other)
  {
    points += other.points;
    cells_entered += other.cells_entered;
    calls += other.calls;
    return *this;
  }
};

// The ways to locate that are compared in the laboratory.
enum Way {
  HISTORY_FROM_ROOT,
  HISTORY_FROM_TRACE,
  CONFLICTS_FROM_ROOT,
  CONFLICTS_FROM_TRACE,
  WALK_FROM_NEIGHBOR,
  WALK_FROM_RANDOM,
  NUMBER_OF_WAYS
};

struct Round_cost
{
  std::size_t end = 0; // N_h
  std::array<Location_cost, NUMBER_OF_WAYS> ways;
  Location_cost trace;          // at the end of the round; no points after the last
  Location_cost conflict_trace; // the same where conflict sets are recorded
  std::size_t crossings = 0;    // of T with the triangles of D(S_{N_h})
};

class Laboratory
{
  using Target = CGAL::Delaunay_from_surface_3::Triangulation_target_3<Counted_triangulation>;
  using Cell = Target::Cell;
  using Vertex = Target::Vertex;

public:
  // Point v of `points` is vertex v of the surface and the subgraph. The history of all conflicts,
  // which takes 3 kB per point, is kept up to 2^17 points.
  Laboratory(const std::vector<comparison::Kernel::Point_3>& points, const Edges& surface,
             const Edges& subgraph, unsigned int seed)
    : m_plan(CGAL::Delaunay_from_surface_3::Log_star_rounds(
          seed, CGAL::Delaunay_from_surface_3::Log_star_rounds::NO_ROUND)(
          points, comparison::Kernel(), surface, 0))
    , m_numbers(CGAL::Delaunay_from_surface_3::internal::inverse(m_plan.order))
    , m_points(CGAL::Delaunay_from_surface_3::internal::permuted(points, m_plan.order))
    , m_surface(graph_of(surface, m_numbers))
    , m_subgraph(graph_of(subgraph, m_numbers))
    , m_target(m_tr, m_points)
    , m_history(m_target, m_subgraph)
    , m_neighbors(m_target, m_surface)
    , m_random(seed)
    , m_stride(1 + points.size() / 65536)
  {
    if (points.size() <= 140000)
      m_conflicts.emplace(m_target, m_subgraph);
  }
  Laboratory(const Laboratory&) = delete;
  Laboratory& operator=(const Laboratory&) = delete;

  // The loop of Fig. 1. To be called once.
  std::vector<Round_cost> run()
  {
    std::vector<Round_cost> rounds;
    std::size_t i = 0;
    for (const std::size_t end : m_plan.round_ends) {
      rounds.emplace_back();
      rounds.back().end = end;
      for (; i < end; ++i)
        locate_and_insert(i, rounds.back());
      if (end < m_points.size())
        trace(rounds.back());
    }
    return rounds;
  }

  const Counted_triangulation& triangulation() const { return m_tr; }
  const meters::History_dag_3<Counted_triangulation>& history() const
  {
    return m_history.history();
  }

  bool keeps_conflicts() const { return m_conflicts.has_value(); }

  // The vertices, in the order of the points given. To be called last.
  std::vector<Vertex> take_vertices()
  {
    return CGAL::Delaunay_from_surface_3::internal::permuted(m_target.take_vertices(), m_numbers);
  }

private:
  // Where a walk starts, and how many nodes of the history were entered to find that cell.
  struct Start
  {
    Cell cell;
    std::size_t nodes_entered;
  };

  using Conflicts = CGAL::Delaunay_from_surface_3::Conflict_history_hints_3<Target, Index_graph>;

  // Tells both of an update.
  struct Both_histories
  {
    static constexpr bool observes_conflict_zone = true;
    template <class CellIterator>
    void before_update(std::size_t i, CellIterator first, CellIterator last)
    {
      by_containment.before_update(i, first, last);
      if (by_conflict != nullptr)
        by_conflict->before_update(i, first, last);
    }
    void after_update(std::size_t i, Vertex v)
    {
      by_containment.after_update(i, v);
      if (by_conflict != nullptr)
        by_conflict->after_update(i, v);
    }
    meters::History_hints_3<Target, Index_graph>& by_containment;
    Conflicts* by_conflict;
  };

  Start start_by_conflicts(std::size_t i, bool is_from_root)
  {
    const std::size_t before = m_conflicts->nodes_visited();
    const Cell cell = is_from_root ? m_conflicts->start_from_root(i) : m_conflicts->start(i);
    return {cell, m_conflicts->nodes_visited() - before};
  }

  const meters::Predicate_counts& counts() const { return m_tr.geom_traits().counts(); }

  void locate_and_insert(std::size_t i, Round_cost& round)
  {
    if (i % m_stride == 0) {
      count(i, round.ways[HISTORY_FROM_ROOT], [&]() -> Start {
        if (history().is_empty())
          return {m_history.start(i), 0};
        const auto descent = history().locate(m_points[i]);
        return {history().cell(descent.node), descent.nodes_entered};
      });
      count(i, round.ways[WALK_FROM_RANDOM], [&] {
        return Start{m_target.cell(i == 0 ? Vertex() : m_target.vertex(m_random.below(i))), 0};
      });
    }
    count(i, round.ways[WALK_FROM_NEIGHBOR], [&] { return Start{m_neighbors.start(i), 0}; });
    const auto location = count(i, round.ways[HISTORY_FROM_TRACE], [&] {
      const std::size_t before = m_history.nodes_entered();
      const Cell cell = m_history.start(i);
      return Start{cell, m_history.nodes_entered() - before};
    });
    if (m_conflicts) {
      if (i % m_stride == 0)
        count(i, round.ways[CONFLICTS_FROM_ROOT], [&] { return start_by_conflicts(i, true); });
      count(i, round.ways[CONFLICTS_FROM_TRACE], [&] { return start_by_conflicts(i, false); });
    }
    Both_histories histories = {m_history, m_conflicts ? &*m_conflicts : nullptr};
    m_target.insert(i, location, histories);
    m_neighbors.after_update(i, m_target.vertex(i));
  }

  // A walk enters a cell with every negative orientation; the tests of a descent are other tests.
  template <class MakeStart>
  Target::Location count(std::size_t i, Location_cost& cost, const MakeStart& make_start)
  {
    const meters::Predicate_counts before = counts();
    const Start start = make_start();
    const meters::Predicate_counts at_start = counts();
    const Target::Location location = m_target.locate(i, start.cell);
    ++cost.points;
    cost.cells_entered += start.nodes_entered + (counts() - at_start).cells_entered();
    cost.calls += (counts() - before).all();
    return location;
  }

  void trace(Round_cost& round)
  {
    const meters::Predicate_counts before = counts();
    round.trace.points = m_history.trace();
    round.trace.cells_entered = (counts() - before).cells_entered();
    round.trace.calls = (counts() - before).all();
    if (m_conflicts) {
      const meters::Predicate_counts then = counts();
      round.conflict_trace.points = m_conflicts->trace();
      round.conflict_trace.cells_entered = round.trace.cells_entered;
      round.conflict_trace.calls = (counts() - then).all();
    }
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (auto [j, end] = adjacent_vertices(i, m_subgraph); j != end; ++j)
        if (i < *j)
          round.crossings += crossings(i, *j);
  }

  // Of the edge from s_i to s_j, i < j. An edge of the triangulation crosses nothing.
  std::size_t crossings(std::size_t i, std::size_t j) const
  {
    const Vertex u = m_target.vertex(i), v = m_target.vertex(j);
    Cell c;
    int k, l;
    if (u != Vertex() && v != Vertex() && m_tr.is_edge(u, v, c, k, l))
      return 0;
    const bool is_recorded = u == Vertex() && !history().is_empty();
    return number_of_crossings(m_tr, m_points[i], m_points[j],
                               is_recorded ? history().cell(m_history.recorded_node(i))
                                           : m_target.cell(u));
  }

  CGAL::Delaunay_from_surface_3::Insertion_order m_plan;
  std::vector<std::size_t> m_numbers;
  std::vector<comparison::Kernel::Point_3> m_points;
  Index_graph m_surface, m_subgraph;
  Counted_triangulation m_tr;
  Target m_target;
  meters::History_hints_3<Target, Index_graph> m_history;
  std::optional<Conflicts> m_conflicts;
  CGAL::Delaunay_from_surface_3::Neighbor_hints_3<Target, Index_graph> m_neighbors;
  surfaces::Random m_random;
  std::size_t m_stride; // the two long ways are taken by a sample of the points, if they are many
};

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_COUNT_LOCATIONS_H
