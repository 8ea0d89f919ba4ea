// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERTION_HINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERTION_HINTS_H

// Provides the policies that say where the location of a point starts: at the point before, at a
// neighbour, where the plan says, or, as in Choi 2002, where a trace has found the point. The one
// that asks a history is in Conflict_history_3.h.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

// Previous_hint_3 is the control: every point starts from the point inserted before it, as in
// CGAL's own range insertion. The other policies are derived from it: they differ in what they know
// of a point, and most do as it does where they know nothing.

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion from a cell of the vertex inserted last, as
`Delaunay_triangulation_3::insert(first, last)` does. The surface is not used. Traits with this
policy go through the core, which starts in the same way. Your own policy may be derived from this
one, and then needs only the members in which it differs.

<b>Complexity</b>: \f$O(1)\f$ per point. It needs no trace, no subgraph, and no memory of its own.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph is not used

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Previous_hint_3
{
public:
  /// `false`: no subgraph is needed.
  static constexpr bool uses_subgraph = false;

  /// `false`: the conflict zone is not needed, and the target may insert in the fastest way.
  static constexpr bool observes_conflict_zone = false;

  /// keeps a reference to `target`.
  explicit Previous_hint_3(const Target& target, const Subgraph& = Subgraph(),
                           const Insertion_order& = Insertion_order())
    : m_target(target)
  {
  }

  /// returns a cell of the vertex inserted last.
  typename Target::Cell start(std::size_t) const { return m_target.cell(m_previous); }

  /// does nothing.
  template <class CellIterator>
  void before_update(std::size_t, CellIterator, CellIterator)
  {
  }

  /// remembers `v`.
  void after_update(std::size_t, typename Target::Vertex v) { m_previous = v; }

  /// does nothing, and returns 0: no point is located.
  std::size_t trace() { return 0; }

protected:
  const Target& m_target;                  ///< what the points are inserted into.
  typename Target::Vertex m_previous = {}; ///< the vertex inserted last; none before the first.
};

// Neighbor_hints_3 goes beyond the paper: it needs no trace at all. When a point's turn comes, some
// of its neighbours on the surface are nearly always in the triangulation, except early on.

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion from a cell of the nearest already inserted neighbour in T, the subgraph of
the traits. With `Full_graph` these are all neighbours on the surface. If no neighbour of a point is
inserted yet, the start is a cell of the vertex inserted last. Early rounds are that sparse, so a
plan should keep them coherent.

<b>Complexity</b>: per point as many distance comparisons as it has neighbours in T. It needs no
trace and no memory of its own.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph a model of `boost::AdjacencyGraph` on the numbers of the points

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Neighbor_hints_3 : public Previous_hint_3<Target, Subgraph>
{
  using Base = Previous_hint_3<Target, Subgraph>;
  using Base::m_target;
  using Vertex = typename Target::Vertex;

public:
  /// `true`: the neighbours are those in the subgraph.
  static constexpr bool uses_subgraph = true;

  /// keeps references to target and subgraph. The plan is not used.
  Neighbor_hints_3(const Target& target, const Subgraph& subgraph,
                   const Insertion_order& = Insertion_order())
    : Base(target, subgraph)
    , m_subgraph(subgraph)
  {
  }

  /// returns a cell of the nearest inserted neighbour of point `i`, or of the vertex inserted last.
  typename Target::Cell start(std::size_t i) const
  {
    Vertex nearest = {};
    for (auto [u, end] = adjacent_vertices(i, m_subgraph); u != end; ++u) {
      const Vertex v = m_target.vertex(*u);
      if (v != Vertex() && (nearest == Vertex() || m_target.is_closer(i, v, nearest)))
        nearest = v;
    }
    return nearest == Vertex() ? Base::start(i) : m_target.cell(nearest);
  }

private:
  const Subgraph& m_subgraph;
};

// Planned_hints_3 goes beyond the paper: the plan already knows where a point starts, so that
// nothing need be searched or stored while points are inserted.

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion from a cell of the point that the plan names in
`Insertion_order::starting_places`. If the plan names no point, the start is a cell of the vertex
inserted last. Traits with this policy go through the core, which starts in the same way.

<b>Complexity</b>: \f$O(1)\f$ per point. It needs no trace, no subgraph,
and no memory of its own.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph is not used

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Planned_hints_3 : public Previous_hint_3<Target, Subgraph>
{
  using Base = Previous_hint_3<Target, Subgraph>;
  using Base::m_target;

public:
  /// keeps references to `target` and `plan`.
  Planned_hints_3(const Target& target, const Subgraph& subgraph, const Insertion_order& plan)
    : Base(target, subgraph)
    , m_places(plan.starting_places)
  {
  }

  /// returns a cell of the starting point that the plan names for point `i`, or of the vertex
  /// inserted last.
  typename Target::Cell start(std::size_t i) const
  {
    return i == 0 || m_places.empty() ? Base::start(i)
                                      : m_target.cell(m_target.vertex(m_places[i]));
  }

private:
  const std::vector<std::size_t>& m_places;
};

// The following implements Choi 2002, Fig. 1, line 2a: "trace T through D(S_{N_h}) to determine
// d_{N_h}(s_k) for all k > N_h", and line 2b: s_i is then located "starting from d_{N_{h-1}}(s_i)".
//
// Invariant: after a trace, the record of every point of the next round is a finite vertex of the
// cell that contains it. While points are only inserted, a vertex is never destroyed, but the cell
// can be.
// Cost: one walk per point located. If all points are located, each walk follows an edge of T, so
// that a trace crosses expected O(n) cells if T consists of Delaunay edges and has bounded degree
// (Lemma 2, Theorem 3); a walk may enter cells off the edge, too.

/*!
\ingroup PkgDelaunayFromSurface3Hints

is the trace (\cgalCite{choi-dtsm-02}, Fig.\ 1, line 2a), independent of what is recorded. It
traverses T depth first from inserted vertices outwards, to find for each point not yet inserted the
neighbour that leads to it. Then it locates the points in the order of their numbers, each from the
cell of that neighbour, which is located before. In a sorted round, successive points are near each
other in memory, too. Your own hint policy may use it as `Traced_hints_3` does.

If only the points up to some number are located, as those of the next round, the traversal passes
over the others, and a point is located from the last point before them.

<b>Complexity</b>: \f$O(n)\f$ time for the traversal, plus the cells that the locations enter. There
is no recursion: T may be a path of millions of vertices.

<b>Memory</b>: at most two indices and a cell handle per point, which are kept for the next trace.

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
  locates the points with numbers less than `end` that are not yet inserted.

  \param start `start(i)` returns the cell from which point `i` is located, if it is the first of a
  component of T without an inserted vertex
  \param record `record(i, location)` is called for every point `i` that is located
  \param end by default all points are located

  \return how many points were located
  */
  template <class Start, class Record>
  std::size_t operator()(const Start& start, const Record& record,
                         std::size_t end = (std::numeric_limits<std::size_t>::max)())
  {
    end = (std::min)(end, m_target.size());
    find_leaders(end);
    m_cells.assign(end, Cell());
    std::size_t located = 0;
    for (std::size_t k = 0; k < end; ++k) {
      for (std::size_t i = k; !is_known(i); i = m_leaders[i]) {
        m_stack.push_back(i);
        if (m_leaders[i] == i)
          break;
      }
      for (; !m_stack.empty(); m_stack.pop_back(), ++located) {
        const std::size_t i = m_stack.back(), leader = m_leaders[i];
        const typename Target::Location d_i =
            m_target.locate(i, leader == i ? start(i) : cell(leader));
        record(i, d_i);
        m_cells[i] = d_i.cell;
      }
    }
    return located;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  bool is_inserted(std::size_t i) const { return m_target.vertex(i) != Vertex(); }

  bool is_known(std::size_t i) const { return is_inserted(i) || m_cells[i] != Cell(); }

  // Returns the cell of an inserted vertex, or the one in which the point was just located.
  Cell cell(std::size_t i) const
  {
    return is_inserted(i) ? m_target.cell(m_target.vertex(i)) : m_cells[i];
  }

  // The leader of a point is the last point before it on the way of the traversal that is inserted
  // or less than `end`; the point itself if it is inserted, or if there is none before it.
  void find_leaders(std::size_t end)
  {
    m_leaders.assign(m_target.size(), none);
    for (std::size_t i = 0; i < m_target.size(); ++i)
      if (is_inserted(i))
        m_leaders[i] = i;
    for (std::size_t i = 0; i < m_target.size(); ++i) // components that touch the triangulation
      if (is_inserted(i))
        lead_from(i, end);
    for (std::size_t i = 0; i < end; ++i) // the others
      if (m_leaders[i] == none) {
        m_leaders[i] = i;
        lead_from(i, end);
      }
  }

  // Traverses T depth first, without recursion, up to points that have a leader.
  void lead_from(std::size_t root, std::size_t end)
  {
    m_stack.push_back(root);
    while (!m_stack.empty()) {
      const std::size_t i = m_stack.back(), leader = i < end ? i : m_leaders[i];
      m_stack.pop_back();
      for (auto [u, last] = adjacent_vertices(i, m_subgraph); u != last; ++u)
        if (m_leaders[*u] == none) {
          m_leaders[*u] = leader;
          m_stack.push_back(*u);
        }
    }
  }

  const Target& m_target;
  const Subgraph& m_subgraph;
  std::vector<std::size_t> m_leaders, m_stack;
  std::vector<Cell> m_cells;
};

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion where the last trace found the point (\cgalCite{choi-dtsm-02}, Fig.\ 1, lines
2a and 2b), with a walk in place of the paper's location structure Q. A trace follows T from
inserted vertices outwards (`Trace_subgraph`). It locates and records the points of the next round:
records of later ones, which the paper determines as well, would be replaced before they are used. In
a component without an inserted vertex, the first point is located from the cell of the point that
was located before it.

After a trace the record of a point of the next round is a finite vertex of the cell that contains
it. While points are only inserted, a vertex is never destroyed, but the cell can be.

<b>Complexity</b>: the traversal of a trace takes \f$O(n)\f$ time. For its walks, which are not
along T, nothing is claimed; the cells that they enter are measured in
\ref delaunay_from_surface_3_the_paper "the page on the paper".

<b>Memory</b>: per point a vertex handle, and at most two indices and a cell handle.

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

  /// keeps references to target, subgraph and plan, whose rounds it traces.
  Traced_hints_3(const Target& target, const Subgraph& subgraph, const Insertion_order& plan)
    : Base(target, subgraph)
    , m_trace(target, subgraph)
    , m_record(target.size())
    , m_round_ends(plan.round_ends)
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

  /// locates the points of the next round and returns their number.
  /// \pre A point is inserted, and a round follows.
  std::size_t trace()
  {
    Cell last = m_target.cell(this->m_previous);
    return m_trace([&](std::size_t) { return last; },
                   [&](std::size_t i, const typename Target::Location& location) {
                     m_record[i] = m_target.nearest_vertex(i, location);
                     last = location.cell;
                   },
                   m_round_ends[++m_round]);
  }

private:
  Trace_subgraph<Target, Subgraph> m_trace;
  std::vector<Vertex> m_record;
  const std::vector<std::size_t>& m_round_ends;
  std::size_t m_round = 0;
};

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Tells whether a hint policy needs no trace and is built into the core.
template <template <class Target, class Subgraph> class InsertionHints>
struct Starts_in_core : std::false_type
{
  static constexpr bool uses_starting_places = true;
};

template <>
struct Starts_in_core<Previous_hint_3> : std::true_type
{
  static constexpr bool uses_starting_places = false;
};

template <>
struct Starts_in_core<Planned_hints_3> : std::true_type
{
  static constexpr bool uses_starting_places = true;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERTION_HINTS_H
