// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRACED_HINTS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRACED_HINTS_3_H

// Choi 2002, Fig. 1, line 2a: "trace T through D(S_{N_h}) to determine d_{N_h}(s_k) for all k >
// N_h", and line 2b: s_i is then located "starting from d_{N_{h-1}}(s_i)".
//
// Invariant: after a trace, the record of every point not yet inserted is a finite vertex of the
// cell that contains it. A vertex never dies while points are only inserted; the cell would.
// Cost: one walk per edge of a spanning forest of T; expected O(n) cells per trace if T consists of
// Delaunay edges and has bounded degree (Lemma 2, Theorem 3).

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Null_update_observer.h>
#include <CGAL/Delaunay_from_surface_3/paper/Trace_subgraph.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

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
class Traced_hints_3 : public Null_update_observer
{
  using Vertex = typename Target::Vertex;
  using Cell = typename Target::Cell;

public:
  /// `true`: the subgraph is traced.
  static constexpr bool uses_subgraph = true;

  /// keeps references to target and subgraph. The plan is not used.
  Traced_hints_3(const Target& target, const Subgraph& subgraph,
                 const Insertion_order& = Insertion_order())
    : m_target(target)
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
    return m_record[i] == Vertex() ? m_previous : m_record[i];
  }

  /// remembers `v`.
  void after_update(std::size_t, Vertex v) { m_previous = v; }

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
  const Target& m_target;
  Trace_subgraph<Target, Subgraph> m_trace;
  Vertex m_previous = {};
  std::vector<Vertex> m_record;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRACED_HINTS_3_H
