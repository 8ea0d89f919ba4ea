// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_TOTAL_WORK_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_TOTAL_WORK_H

// Theorem 5: all that the algorithm of the paper does with its Q, the history of all conflicts, in
// calls of predicates, and in nodes and cells beside them.

#include <Delaunay_from_surface_3_theory/count_locations.h>
#include <Delaunay_from_surface_3_theory/report.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <cstddef>
#include <vector>

namespace theory {

class Total_work
{
  using Target = CGAL::Delaunay_from_surface_3::Triangulation_target_3<Counted_triangulation>;
  using Hints = CGAL::Delaunay_from_surface_3::Conflict_history_hints_3<Target, Index_graph>;
  using Log_star_rounds = CGAL::Delaunay_from_surface_3::Log_star_rounds;

public:
  // Point v of `points` is vertex v of T.
  Total_work(const std::vector<comparison::Kernel::Point_3>& points, const Edges& T,
             unsigned int seed)
    : m_plan(Log_star_rounds(seed, Log_star_rounds::NO_ROUND)(points, comparison::Kernel(), T, 0))
    , m_numbers(CGAL::Delaunay_from_surface_3::internal::inverse(m_plan.order))
    , m_points(CGAL::Delaunay_from_surface_3::internal::permuted(points, m_plan.order))
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
        {"location_from_root", root_as_json()}};
  }

private:
  meters::Predicate_counts counts() const { return m_tr.geom_traits().counts(); }

  double share(std::size_t count) const
  {
    return rounded(double(count) / double(m_points.size()), 1e4);
  }

  Json root_as_json() const
  {
    const double n = double(m_root.points);
    return {{"nodes", rounded(double(m_root.cells_entered) / n, 1e4)},
            {"calls", rounded(double(m_root.calls) / n, 1e4)}};
  }

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

  CGAL::Delaunay_from_surface_3::Insertion_order m_plan;
  std::vector<std::size_t> m_numbers;
  std::vector<comparison::Kernel::Point_3> m_points;
  Index_graph m_subgraph;
  Counted_triangulation m_tr;
  Target m_target;
  Hints m_hints;
  CGAL::Delaunay_from_surface_3::Trace_subgraph<Target, Index_graph> m_walk;
  meters::Predicate_counts m_location, m_trace, m_update;
  Location_cost m_root; // of a sample
  std::size_t m_nodes = 0, m_recorded = 0, m_record_calls = 0;
};

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_TOTAL_WORK_H
