// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_HISTORY_HINTS_3_H
#define DELAUNAY_FROM_SURFACE_3_METERS_HISTORY_HINTS_3_H

// Choi 2002, Fig. 1, lines 2a and 2b, with a history by containment for Q: a trace records
// d_{N_h}(s_k) as nodes, and s_i is located by a descent from its record.
//
// Invariant: the record of a point is a node that contains it. A node never dies. Cost: O(log(i/k))
// expected nodes for s_i if the last trace was in D(S_k), each of which takes tests in proportion
// to a star.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <Delaunay_from_surface_3_meters/History_dag_3.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace meters {

// starts every insertion in the very cell that contains the point, found by a descent in the history
// of all cells ({choi-dtsm-02}, Fig.\ 1, lines 2a and 2b). The descent starts at the node
// that the last trace recorded for the point, and at the root if there was no trace. A trace is that
// of `Traced_hints_3`; it records nodes instead of vertices.
//
// This is the practical variant of the paper's location structure, which is that of
// `Conflict_history_hints_3`. It takes several times the memory of the triangulation (see
// `History_dag_3`) and is slower than a walk on all surfaces measured: it is here for comparison.
//
// Under the assumptions of the paper a trace enters O(n) expected cells (Theorem 3). For any
// surface and a random order a descent enters O(\log(i/k)) expected nodes for point i after a
// trace in the triangulation of k points; each takes tests in proportion to the size of a star.
//
// Target: `Triangulation_target_3`, not of a triangulation with `Fast_location`
// Subgraph: a model of `boost::AdjacencyGraph` on the numbers of the points: T
template <class Target, class Subgraph>
class History_hints_3 : public CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>
{
  using Base = CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>;
  using Base::m_target;
  static_assert(Target::reports_conflict_zones,
                "a history of cells needs to be told of every conflict zone");
  using Dag = History_dag_3<std::decay_t<decltype(std::declval<const Target&>().triangulation())>>;

public:
  // the location structure Q.
  using History_dag = Dag;

  // `true`: the subgraph is what is traced.
  static constexpr bool uses_subgraph = true;

  // `true`: the conflict zone is what becomes history.
  static constexpr bool observes_conflict_zone = true;

  // keeps references to target and subgraph. The plan is not looked at.
  History_hints_3(const Target& target, const Subgraph& subgraph,
                  const CGAL::Delaunay_from_surface_3::Insertion_order& =
                      CGAL::Delaunay_from_surface_3::Insertion_order())
    : Base(target, subgraph)
    , m_dag(target.triangulation())
    , m_trace(target, subgraph)
    , m_record(target.size(), Dag::none)
  {
  }

  // returns the cell that contains point `i`; below dimension 3, a cell of the vertex inserted
  // last.
  typename Target::Cell start(std::size_t i)
  {
    if (m_dag.is_empty())
      return Base::start(i);
    const auto descent = m_record[i] == Dag::none ? m_dag.locate(m_target.point(i))
                                                  : m_dag.locate(m_target.point(i), m_record[i]);
    m_nodes_entered += descent.nodes_entered;
    return m_dag.cell(descent.node);
  }

  // hands the conflict zone to the history.
  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last)
  {
    m_dag.before_update(i, first, last);
  }

  // hands the update to the history.
  void after_update(std::size_t i, typename Target::Vertex v)
  {
    Base::after_update(i, v);
    m_dag.after_update(i, v);
  }

  // locates every point that is not yet inserted, records its node and returns the number of these
  // points.
  // \pre A point is inserted.
  std::size_t trace()
  {
    return m_trace([this](std::size_t i) { return start(i); },
                   [this](std::size_t i, const typename Target::Location& location) {
                     if (!m_dag.is_empty())
                       m_record[i] = m_dag.node(location.cell);
                   });
  }

  // returns the history.
  const History_dag& history() const { return m_dag; }

  // returns the node recorded for point `i`, or `History_dag::none`.
  typename History_dag::Node recorded_node(std::size_t i) const { return m_record[i]; }

  // returns how many nodes all descents together have entered.
  std::size_t nodes_entered() const { return m_nodes_entered; }

private:
  Dag m_dag;
  CGAL::Delaunay_from_surface_3::Trace_subgraph<Target, Subgraph> m_trace;
  std::vector<typename Dag::Node> m_record;
  std::size_t m_nodes_entered = 0;
};

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_HISTORY_HINTS_3_H
