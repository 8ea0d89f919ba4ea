// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRACED_HINTS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRACED_HINTS_3_H

// Implements Choi 2002, Fig. 1, line 2a: "trace T through D(S_{N_h}) to determine d_{N_h}(s_k) for
// all k > N_h", and line 2b: s_i is then located "starting from d_{N_{h-1}}(s_i)".
//
// Invariant: after a trace, the record of every point not yet inserted is a finite vertex of the
// cell that contains it. While points are only inserted, a vertex is never destroyed, but the cell
// can be.
// Cost: one walk per edge of a spanning forest of T; expected O(n) cells per trace if T consists of
// Delaunay edges and has bounded degree (Lemma 2, Theorem 3).

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Hints

is the trace (\cgalCite{choi-dtsm-02}, Fig.\ 1, line 2a), independent of what is recorded. It
traverses T depth first from inserted vertices outwards, and locates every point not yet inserted
from the cell of the neighbour that led to it. Your own hint policy may use it as `Traced_hints_3`
does.

<b>Complexity</b>: \f$O(n)\f$ time for the traversal, plus the cells that the locations enter. There
is no recursion: T may be a path of millions of vertices.

<b>Memory</b>: a byte per point, and during a trace at most an index and a cell handle per point.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph a model of `boost::AdjacencyGraph` on the numbers of the points: T
*/
template <class Target, class Subgraph>
class Trace_subgraph
{
  using Vertex = typename Target::Vertex;
  using Cell = typename Target::Cell;

public:
  /// keeps references to target and subgraph.
  Trace_subgraph(const Target& target, const Subgraph& subgraph)
    : m_target(target)
    , m_subgraph(subgraph)
  {
  }

  /*!
  locates the points that are not yet inserted.

  \param start `start(i)` returns the cell from which point `i` is located, if it is the first of a
  component of T without an inserted vertex
  \param record `record(i, location)` is called for every point `i` that is located

  \return how many points were located
  */
  template <class Start, class Record>
  std::size_t operator()(const Start& start, const Record& record)
  {
    m_is_traced.assign(m_target.size(), false);
    std::size_t located = 0;
    for (std::size_t i = 0; i < m_target.size(); ++i) // components that touch the triangulation
      if (m_target.vertex(i) != Vertex())
        located += trace_component(i, Cell(), record);
    for (std::size_t i = 0; i < m_target.size(); ++i) // the others
      if (!m_is_traced[i])
        located += trace_component(i, start(i), record);
    return located;
  }

private:
  // Traces a component depth first, without recursion.
  template <class Record>
  std::size_t trace_component(std::size_t root, Cell start, const Record& record)
  {
    std::size_t located = 0;
    reach(root, start);
    while (!m_stack.empty()) {
      const auto [i, neighbor_cell] = m_stack.back();
      m_stack.pop_back();
      Cell cell;
      if (const Vertex v = m_target.vertex(i); v != Vertex()) {
        cell = m_target.cell(v);
      } else {
        const typename Target::Location d_i = m_target.locate(i, neighbor_cell);
        record(i, d_i);
        cell = d_i.cell;
        ++located;
      }
      for (auto [u, end] = adjacent_vertices(i, m_subgraph); u != end; ++u)
        reach(*u, cell);
    }
    return located;
  }

  void reach(std::size_t i, Cell start)
  {
    if (!m_is_traced[i])
      m_stack.emplace_back(i, start);
    m_is_traced[i] = true;
  }

  const Target& m_target;
  const Subgraph& m_subgraph;
  std::vector<char> m_is_traced;
  std::vector<std::pair<std::size_t, Cell>> m_stack;
};

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion where the last trace found the point (\cgalCite{choi-dtsm-02}, Fig.\ 1, lines
2a and 2b), with a walk in place of the paper's location structure Q. A trace traverses T depth
first from inserted vertices outwards. It locates every point not yet inserted from the cell of the
neighbour in T that led to it. In a component without an inserted vertex, the first point is located
from its last record, or, if it has none, from the vertex inserted last.

After a trace the record of a point is a finite vertex of the cell that contains it. While points
are only inserted, a vertex is never destroyed, but the cell can be.

<b>Complexity</b>: the traversal of a trace takes \f$O(n)\f$ time. The whole trace takes expected
\f$O(n)\f$ time if T has bounded degree and consists of Delaunay edges, and the triangulation has
linear expected size (Theorem 3).

<b>Memory</b>: a vertex handle and a byte per point, and during a trace at most an index and a cell
handle per point.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph a model of `boost::AdjacencyGraph` on the numbers of the points: T

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Traced_hints_3 : public Previous_hint_3<Target, Subgraph>
{
  using Base = Previous_hint_3<Target, Subgraph>;
  using Base::m_target;
  using Vertex = typename Target::Vertex;
  using Cell = typename Target::Cell;

public:
  /// `true`: the subgraph is traced.
  static constexpr bool uses_subgraph = true;

  /// keeps references to target and subgraph. The plan is not used.
  Traced_hints_3(const Target& target, const Subgraph& subgraph,
                 const Insertion_order& = Insertion_order())
    : Base(target, subgraph)
    , m_trace(target, subgraph)
    , m_record(target.size())
  {
  }

  /// returns a cell of the vertex recorded for point `i`; before the first trace, of the vertex
  /// inserted last.
  Cell start(std::size_t i) const { return m_target.cell(recorded_vertex(i)); }

  /// returns the vertex from which point `i` would start: finite, or none before the first
  /// insertion.
  Vertex recorded_vertex(std::size_t i) const
  {
    return m_record[i] == Vertex() ? this->m_previous : m_record[i];
  }

  /// locates every point that is not yet inserted and returns their number.
  /// \pre A point is inserted.
  std::size_t trace()
  {
    return m_trace([this](std::size_t i) { return start(i); },
                   [this](std::size_t i, const typename Target::Location& location) {
                     m_record[i] = m_target.nearest_vertex(i, location);
                   });
  }

private:
  Trace_subgraph<Target, Subgraph> m_trace;
  std::vector<Vertex> m_record;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRACED_HINTS_3_H
