// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_HISTORY_HINTS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_HISTORY_HINTS_3_H

// Choi 2002, Fig. 1, lines 2a and 2b, with the paper's Q: s_i is located by a search through all
// cells in conflict with it, from those of D(S_{N_h}), which a trace has recorded.
//
// Invariant: the record of a point is its whole conflict set in the triangulation of the last
// trace, or its vertex if there was one there. Cost: see Conflict_history_3 for s_i; O(n) expected
// cells per trace (Theorem 3), and the sizes of all conflict sets, which is O(n) expected too where
// an insertion destroys O(1) cells.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Traced_hints_3.h>

#include <CGAL/iterator.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion in a cell in conflict with the point, found in the history of all conflicts,
the paper's own location structure (\cgalCite{choi-dtsm-02}, Fig.\ 1, lines 2a and 2b). The search
starts at the conflict set that the last trace recorded for the point, or at the root if there was
no trace. A root of more than 256 cells is not searched, but the point is located by a walk from the
vertex inserted last: the history began with a triangulation that had vertices, or with many points
in a plane. A trace is that of `Traced_hints_3`, but records sets of nodes instead of vertices. The
paper records only the cell that contains the point; a search from that cell alone can miss cells
(`Conflict_history_3`).

This policy serves the study of the theory: it takes several times the memory of the triangulation,
and is slower than a walk on all surfaces measured.

<b>Complexity</b>, under the assumptions of the paper: a trace takes expected \f$O(n)\f$ time. The
search for point i after a trace in the triangulation of k points takes expected
\f$O(\log(i/k))\f$ time (Theorem 3 and Lemma 4). Walks that replace a large root have no such bound.

<b>Memory</b> besides the history: 25 bytes per point, and 8 bytes for each cell of a record. During
a trace, in addition, the previous records, and at most 16 bytes per point.

\tparam Target `Triangulation_target_3`, not of a triangulation with `Fast_location`
\tparam Subgraph a model of `boost::AdjacencyGraph` on the numbers of the points: T

\cgalModels{InsertionHints_3}

*/
template <class Target, class Subgraph>
class Conflict_history_hints_3
{
  static_assert(Target::reports_conflict_zones,
                "a history of cells needs to be told of every conflict zone");
  using Triangulation = std::decay_t<decltype(std::declval<const Target&>().triangulation())>;
  using Cell = typename Target::Cell;
  using Vertex = typename Target::Vertex;

public:
  /// the location structure Q.
  using History = Conflict_history_3<Triangulation>;

  /// a node of it.
  using Node = typename History::Node;

  /// `true`: the subgraph is traced.
  static constexpr bool uses_subgraph = true;

  /// `true`: the conflict zone becomes history.
  static constexpr bool observes_conflict_zone = true;

  /// keeps references to target and subgraph. The plan is not used.
  Conflict_history_hints_3(const Target& target, const Subgraph& subgraph,
                           const Insertion_order& = Insertion_order())
    : m_target(target)
    , m_history(target.triangulation())
    , m_trace(target, subgraph)
    , m_record(target.size())
  {
  }

  /// returns a cell in conflict with point `i`, a finite one if possible, or a cell of the vertex
  /// at the point; below dimension 3, and in place of a search from a large root, a cell of the
  /// vertex inserted last.
  Cell start(std::size_t i)
  {
    const Record& record = m_record[i];
    if (m_history.is_empty())
      return m_target.cell(m_previous);
    if (record.vertex != Vertex())
      return m_target.cell(record.vertex);
    if (record.first == record.last)
      return m_history.root_size() > largest_root ? m_target.cell(m_previous) : start_from_root(i);
    return found_start([&](const auto out) {
      return m_history.find_conflicts(m_target.point(i), m_recorded.begin() + record.first,
                                      m_recorded.begin() + record.last, m_number_of_nodes_at_trace,
                                      out);
    });
  }

  /// returns the same, found from the root of the history, as if there had been no trace, however
  /// large the root is.
  Cell start_from_root(std::size_t i)
  {
    if (m_history.is_empty())
      return m_target.cell(m_previous);
    return found_start(
        [&](const auto out) { return m_history.find_conflicts(m_target.point(i), out); });
  }

  /// passes the conflict zone to the history.
  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last)
  {
    m_history.before_update(i, first, last);
  }

  /// passes the update to the history.
  void after_update(std::size_t i, Vertex v)
  {
    m_previous = v;
    m_history.after_update(i, v);
  }

  /// locates every point that is not yet inserted, records its conflict set and returns the number
  /// of these points.
  /// \pre A point is inserted.
  std::size_t trace()
  {
    std::vector<Node> recorded; // the old records may still start a component
    const std::size_t located =
        m_trace([this](std::size_t i) { return start(i); },
                [this, &recorded](std::size_t i, const typename Target::Location& location) {
                  if (!m_history.is_empty())
                    m_record[i] = record(i, location, recorded);
                });
    m_recorded.swap(recorded);
    m_number_of_nodes_at_trace = m_history.number_of_nodes();
    return located;
  }

  /// returns the history.
  const History& history() const { return m_history; }

  /// returns the conflict set recorded for point `i`, as nodes; empty if there is none.
  std::vector<Node> recorded_conflicts(std::size_t i) const
  {
    return {m_recorded.begin() + m_record[i].first, m_recorded.begin() + m_record[i].last};
  }

  /// returns how many nodes all searches together have visited.
  std::size_t nodes_visited() const { return m_nodes_visited; }

  /// returns how many nodes all searches together have tested.
  std::size_t nodes_tested() const { return m_nodes_tested; }

private:
  // A search from the root tests every cell of it: from here on a walk is shorter.
  static constexpr std::size_t largest_root = 256;

  struct Record
  {
    std::ptrdiff_t first = 0,
                   last = 0; // in the list of nodes; there is none before the first trace
    Vertex vertex = {};      // that stood at the point at the last trace
  };

  Record record(std::size_t i, const typename Target::Location& location,
                std::vector<Node>& recorded) const
  {
    Record result;
    if (location.type == Triangulation::VERTEX) {
      result.vertex = location.cell->vertex(location.li);
      return result;
    }
    result.first = std::ptrdiff_t(recorded.size());
    m_target.triangulation().find_conflicts(m_target.point(i), location.cell, Emptyset_iterator(),
                                            boost::make_function_output_iterator([&](Cell c) {
                                              recorded.push_back(m_history.node(c));
                                            }));
    result.last = std::ptrdiff_t(recorded.size());
    return result;
  }

  // What search(out) finds.
  template <class Search>
  Cell found_start(const Search& search)
  {
    m_conflicts.clear();
    const auto result = search(std::back_inserter(m_conflicts));
    m_nodes_visited += result.nodes_visited;
    m_nodes_tested += result.nodes_tested;
    return result.vertex != Vertex() ? m_target.cell(result.vertex) : finite_conflict();
  }

  Cell finite_conflict() const
  {
    for (const Node n : m_conflicts)
      if (!m_target.triangulation().is_infinite(m_history.cell(n)))
        return m_history.cell(n);
    // Inexact predicates may have found nothing.
    return m_conflicts.empty() ? m_target.cell(m_previous) : m_history.cell(m_conflicts.front());
  }

  const Target& m_target;
  History m_history;
  Trace_subgraph<Target, Subgraph> m_trace;
  std::vector<Record> m_record;
  std::vector<Node> m_recorded;
  std::size_t m_number_of_nodes_at_trace = 0;
  std::vector<Node> m_conflicts;
  Vertex m_previous = {};
  std::size_t m_nodes_visited = 0, m_nodes_tested = 0;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_HISTORY_HINTS_3_H
