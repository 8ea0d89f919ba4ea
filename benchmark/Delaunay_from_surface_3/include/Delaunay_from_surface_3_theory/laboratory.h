// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_LABORATORY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_LABORATORY_H

// The laboratory: points are inserted once, in the paper's random order, and each of them is located in
// every way that can start from the same triangulation. What is counted does not depend on the machine.
// Then Theorem 5: all that the algorithm of the paper does with its Q, the history of all conflicts, in
// calls of predicates, and in nodes and cells beside them.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_meters/History_hints_3.h>
#include <Delaunay_from_surface_3_meters/meters.h>
#include <Delaunay_from_surface_3_theory/trees.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace theory {

// Whether the triangle between two cells is finite and has neither p nor q for a vertex. The
// traverser also steps through others: outside the convex hull, and from a vertex of the hull to
// the outside.
template <class Triangulation>
bool is_crossed(const Triangulation& tr, typename Triangulation::Cell_handle from,
                typename Triangulation::Cell_handle to, const typename Triangulation::Point& p,
                const typename Triangulation::Point& q)
{
  for (int k = 0; k < 4; ++k) {
    const auto v = from->vertex(k);
    if (to->has_vertex(v) && (tr.is_infinite(v) || v->point() == p || v->point() == q))
      return false;
  }
  return true;
}

// How many finite triangles of the triangulation the segment from p to q goes through (Choi 2002,
// Lemma 2). The search for p begins at `hint`.
template <class Triangulation>
std::size_t number_of_crossings(const Triangulation& tr, const typename Triangulation::Point& p,
                                const typename Triangulation::Point& q,
                                typename Triangulation::Cell_handle hint)
{
  if (p == q || tr.dimension() < 3)
    return 0;
  std::size_t crossings = 0;
  auto cell = tr.segment_traverser_cells_begin(p, q, hint);
  const auto end = tr.segment_traverser_cells_end();
  for (auto last = cell.handle(); ++cell != end; last = cell.handle())
    crossings += is_crossed(tr, last, cell.handle(), p, q);
  return crossings;
}

namespace DFS = CGAL::Delaunay_from_surface_3;
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
  using Target = DFS::Triangulation_target_3<Counted_triangulation>;
  using Cell = Target::Cell;
  using Vertex = Target::Vertex;

public:
  // Point v of `points` is vertex v of the surface and the subgraph. The history of all conflicts,
  // which takes 3 kB per point, is kept up to 2^17 points.
  Laboratory(const std::vector<comparison::Kernel::Point_3>& points, const Edges& surface,
             const Edges& subgraph, unsigned int seed)
    : m_plan(DFS::Log_star_rounds(seed, DFS::Log_star_rounds::NO_ROUND)(
          points, comparison::Kernel(), surface, 0))
    , m_numbers(DFS::internal::inverse(m_plan.order))
    , m_points(DFS::internal::permuted(points, m_plan.order))
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

  // The vertices, in the order of the points given. To be called last.
  std::vector<Vertex> take_vertices()
  {
    return DFS::internal::permuted(m_target.take_vertices(), m_numbers);
  }

private:
  // Where a walk starts, and how many nodes of the history were entered to find that cell.
  struct Start
  {
    Cell cell;
    std::size_t nodes_entered;
  };

  using Conflicts = DFS::Conflict_history_hints_3<Target, Index_graph>;

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

  DFS::Insertion_order m_plan;
  std::vector<std::size_t> m_numbers;
  std::vector<comparison::Kernel::Point_3> m_points;
  Index_graph m_surface, m_subgraph;
  Counted_triangulation m_tr;
  Target m_target;
  meters::History_hints_3<Target, Index_graph> m_history;
  std::optional<Conflicts> m_conflicts;
  DFS::Neighbor_hints_3<Target, Index_graph> m_neighbors;
  surfaces::Random m_random;
  std::size_t m_stride; // the two long ways are taken by a sample of the points, if they are many
};

using comparison::Json;
using comparison::per_point;
using comparison::rounded;

inline const char* name_of(std::size_t way)
{
  static const char* const names[NUMBER_OF_WAYS] = {"history-root",   "history-trace",
                                                    "conflicts-root", "conflicts-trace",
                                                    "walk-neighbor",  "walk-random"};
  return names[way];
}

inline Json cost_per_point(const Location_cost& cost, std::size_t points)
{
  const std::size_t n = (std::max)(points, std::size_t(1));
  return {{"cells_entered", per_point(cost.cells_entered, n)}, {"calls", per_point(cost.calls, n)}};
}

// Cells entered and calls per located point, by way; the trace's share of `history-trace` apart,
// per point.
inline Json locations_as_json(const std::vector<Round_cost>& rounds)
{
  Json result;
  for (std::size_t way = 0; way < NUMBER_OF_WAYS; ++way) {
    Location_cost sum;
    for (const Round_cost& round : rounds)
      sum += round.ways[way];
    if (sum.points > 0)
      result[name_of(way)] = cost_per_point(sum, sum.points);
  }
  const auto add_traces = [&](Way way, Location_cost Round_cost::*part) {
    Location_cost trace;
    for (const Round_cost& round : rounds)
      trace += round.*part;
    const Json traces = cost_per_point(trace, rounds.back().end);
    if (result.contains(name_of(way))) {
      result[name_of(way)]["trace_cells_entered"] = traces["cells_entered"];
      result[name_of(way)]["trace_calls"] = traces["calls"];
    }
  };
  add_traces(HISTORY_FROM_TRACE, &Round_cost::trace);
  add_traces(CONFLICTS_FROM_TRACE, &Round_cost::conflict_trace);
  return result;
}

// Theorem 3: the crossings of T with D(S_{N_h}), by the number of all points.
inline Json traces_as_json(const std::vector<Round_cost>& rounds)
{
  Json traces = Json::array();
  const std::size_t n = rounds.back().end;
  for (std::size_t h = 0; h + 1 < rounds.size(); ++h) {
    const Location_cost& trace = rounds[h].trace;
    Json result = {{"after", rounds[h].end},
                   {"crossings_per_point", per_point(rounds[h].crossings, n)},
                   {"located", trace.points}};
    result.update(cost_per_point(trace, trace.points));
    traces.push_back(result);
  }
  return traces;
}

// Theorem 5: in round h a descent from the last trace, or from the root before there is one, takes
// O(log^(h) n). `lemma_4` is the mean of 4 ln(i/k) for the points s_i of the round and a trace
// after s_k: what is expected if no point is ever outside the convex hull.
inline Json rounds_as_json(const std::vector<Round_cost>& rounds)
{
  Json result = Json::array();
  std::size_t k = 0;
  double log_h = double(rounds.back().end);
  for (const Round_cost& round : rounds) {
    log_h = std::log2(log_h);
    double logarithms = 0;
    for (std::size_t i = k + 1; i <= round.end; ++i)
      logarithms += 4 * std::log(double(i) / double((std::max)(k, std::size_t(1))));
    Json row = {{"points", round.end - k},
                {"iterated_log", rounded(log_h, 1e4)},
                {"lemma_4", per_point(logarithms, round.end - k)}};
    for (const Way way : {HISTORY_FROM_ROOT, HISTORY_FROM_TRACE})
      row[name_of(way)] = per_point(round.ways[way].cells_entered, round.ways[way].points);
    result.push_back(row);
    k = round.end;
  }
  return result;
}

// How far the assumptions hold, when all points are in. Sorts T.
inline Json assumptions_as_json(Laboratory& laboratory, const Indexed_surface& surface,
                                const Edges& edges_of_surface, Edges subgraph)
{
  const auto& tr = laboratory.triangulation();
  const auto vertices = laboratory.take_vertices();
  std::sort(subgraph.begin(), subgraph.end());
  const Edges delaunay = delaunay_edges(tr, vertices);
  const Edges emst = euclidean_minimum_spanning_tree(surface.points, delaunay, edges_of_surface);
  const auto share_in = [](const Edges& edges, const Edges& sorted) {
    return rounded(fraction(edges, [&](const Edge& e) { return contains(sorted, e); }));
  };
  std::vector<std::size_t> degrees(surface.points.size(), 0);
  for (const Edge& e : subgraph)
    ++degrees[e[0]], ++degrees[e[1]];
  const std::size_t n = surface.points.size();
  return {{"subgraph_edges_delaunay", share_in(subgraph, delaunay)},
          {"surface_edges_delaunay", share_in(edges_of_surface, delaunay)},
          {"surface_triangles_delaunay", rounded(delaunay_triangles(tr, vertices, surface.faces))},
          {"emst_edges_in_surface", share_in(emst, edges_of_surface)},
          {"emst_edges_in_subgraph", share_in(emst, subgraph)},
          {"subgraph_edges_per_point", per_point(subgraph.size(), n)},
          {"subgraph_degree", *std::max_element(degrees.begin(), degrees.end())},
          {"delaunay_cells_per_point", per_point(tr.number_of_cells(), n)},
          {"cells_created_per_point", per_point(laboratory.history().number_of_nodes(), n)}};
}

class Total_work
{
  using Target = DFS::Triangulation_target_3<Counted_triangulation>;
  using Hints = DFS::Conflict_history_hints_3<Target, Index_graph>;
  using Log_star_rounds = DFS::Log_star_rounds;

public:
  // Point v of `points` is vertex v of T.
  Total_work(const std::vector<comparison::Kernel::Point_3>& points, const Edges& T,
             unsigned int seed)
    : m_plan(Log_star_rounds(seed, Log_star_rounds::NO_ROUND)(points, comparison::Kernel(), T, 0))
    , m_numbers(DFS::internal::inverse(m_plan.order))
    , m_points(DFS::internal::permuted(points, m_plan.order))
    , m_subgraph(graph_of(T, m_numbers))
    , m_target(m_tr, m_points)
    , m_hints(m_target, m_subgraph)
    , m_walk(m_target, m_subgraph)
  {
  }
  Total_work(const Total_work&) = delete;
  Total_work& operator=(const Total_work&) = delete;

  // The loop of Fig. 1. To be called once.
  Json operator()()
  {
    std::size_t i = 0;
    for (const std::size_t end : m_plan.round_ends) {
      for (; i < end; ++i)
        insert(i);
      if (end < m_points.size())
        trace();
    }
    const std::size_t all = m_location.all() + m_trace.all() + m_record_calls + m_update.all();
    const std::size_t created = m_hints.history().number_of_nodes();
    return {
        {"location", {{"nodes", share(m_nodes)}, {"calls", share(m_location.all())}}},
        {"traces", {{"cells", share(m_trace.cells_entered())}, {"calls", share(m_trace.all())}}},
        {"records", {{"nodes", share(m_recorded)}, {"calls", share(m_record_calls)}}},
        {"updates", {{"cells_created", share(created)}, {"calls", share(m_update.all())}}},
        {"calls", share(all)},
        {"location_from_root",
         {{"nodes", per_point(m_root.cells_entered, m_root.points)},
          {"calls", per_point(m_root.calls, m_root.points)}}}};
  }

private:
  meters::Predicate_counts counts() const { return m_tr.geom_traits().counts(); }

  double share(std::size_t count) const { return per_point(count, m_points.size()); }

  void insert(std::size_t i)
  {
    if (i % 16 == 0) {
      const std::size_t visited = m_hints.nodes_visited();
      const meters::Predicate_counts before = counts();
      m_target.locate(i, m_hints.start_from_root(i));
      ++m_root.points;
      m_root.cells_entered += m_hints.nodes_visited() - visited;
      m_root.calls += (counts() - before).all();
    }
    const std::size_t visited = m_hints.nodes_visited();
    const meters::Predicate_counts before = counts();
    const Target::Location location = m_target.locate(i, m_hints.start(i));
    m_nodes += m_hints.nodes_visited() - visited;
    const meters::Predicate_counts located = counts();
    m_target.insert(i, location, m_hints);
    m_location += located - before;
    m_update += counts() - located;
  }

  // First the walks alone, then the trace: what it takes more is what the records take.
  void trace()
  {
    const meters::Predicate_counts before = counts();
    m_walk([this](std::size_t i) { return m_hints.start(i); },
           [](std::size_t, const Target::Location&) {});
    const meters::Predicate_counts walked = counts();
    m_hints.trace();
    m_trace += walked - before;
    m_record_calls += (counts() - walked).all() - (walked - before).all();
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_target.vertex(i) == Target::Vertex())
        m_recorded += m_hints.recorded_conflicts(i).size();
  }

  DFS::Insertion_order m_plan;
  std::vector<std::size_t> m_numbers;
  std::vector<comparison::Kernel::Point_3> m_points;
  Index_graph m_subgraph;
  Counted_triangulation m_tr;
  Target m_target;
  Hints m_hints;
  DFS::Trace_subgraph<Target, Index_graph> m_walk;
  meters::Predicate_counts m_location, m_trace, m_update;
  Location_cost m_root; // of a sample
  std::size_t m_nodes = 0, m_recorded = 0, m_record_calls = 0;
};

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_LABORATORY_H
