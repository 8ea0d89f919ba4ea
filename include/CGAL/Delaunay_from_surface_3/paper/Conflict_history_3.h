// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_HISTORY_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_HISTORY_3_H

// Implements the location structure Q of Choi 2002, §2: "We start at the root and traverse all the
// intermediate Delaunay tetrahedra whose circumspheres contain s_i" (Boissonnat and Teillaud's
// Delaunay tree; Clarkson, Mehlhorn and Seidel's history).
//
// Invariant: if a point is in conflict with a new cell on the facet f, it is in conflict with the
// cell's father, the destroyed cell behind f, or its stepfather, the surviving cell across f. For
// the sphere of the new cell goes through the circle of f, between the spheres of these two. So all
// cells of one triangulation in conflict with a point lead to all later ones by sons and stepsons.
// The stepsons of a facet stood on it one after the other, each the son of the one before, and
// their spheres turn about its circle towards the stepfather's. If a point is on the stepfather's
// side of the facet, the stepsons in conflict with it are the youngest; otherwise they are sons of
// cells in conflict. So they are tested from the youngest on until one is not in conflict.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/iterator.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Gives access to CGAL's perturbed predicates, protected members of a triangulation that use only
// its traits: so they can be asked about cells that are destroyed.
template <class Geom_traits>
struct Exposed_predicates : Delaunay_triangulation_3<Geom_traits>
{
  using Base = Delaunay_triangulation_3<Geom_traits>;
  using Base::Base;
  using Base::coplanar_side_of_bounded_circle;
  using Base::side_of_oriented_sphere;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Hints

is the paper's location structure (\cgalCite{choi-dtsm-02}): the history of a Delaunay triangulation
in dimension 3 during the insertion of points, as a graph of conflicts (\cgalCite{bt-rcdt-93},
\cgalCite{cms-frric-93}). Every cell that ever existed, including infinite ones, is a node. A new
cell is linked to its father and its stepfather: the destroyed and the surviving cell at the facet
on which it is created. A point in conflict with a cell is in conflict with one of these two.

`find_conflicts()` visits the nodes in conflict with a point, each once, and reports those that are
current cells. It starts either from the root, all cells that existed when the history began or the
triangulation became 3-dimensional; or from the point's *conflict set* at some earlier time, all
cells then in conflict with it. One of these is not enough: current cells may descend from others.

<b>Complexity</b>: let points be inserted in random order, and let \f$c_j\f$ be the expected number
of cells in conflict with a point p in the triangulation of j points. Each of these was created by
the j-th insertion with probability \f$4/j\f$, or \f$3/j\f$ if it is infinite. So from the
triangulation of k points to that of i points, at most \f$\sum_{k < j \le i} 4 c_j / j\f$ nodes are
visited in expectation, which is \f$O(\log(i/k))\f$ if \f$c_j\f$ is \f$O(1)\f$
(\cgalCite{choi-dtsm-02}, Lemma 4). At each node at most eight tests fail, four of sons and one for
each facet, whatever the degrees of the vertices. So the work is proportional to the nodes.

<b>Memory</b>: 104 bytes per cell that ever existed (with 64-bit handles), 24 per current cell.

\pre Points are only inserted, never removed; all conflict zones are reported; predicates are exact.

\tparam Triangulation a `CGAL::Delaunay_triangulation_3`, not with `Fast_location`
*/
template <class Triangulation>
class Conflict_history_3
{
  using Vertex = typename Triangulation::Vertex_handle;
  using Cell = typename Triangulation::Cell_handle;
  using Point = typename Triangulation::Point;
  using Vertices = std::array<Vertex, 4>; // in the orientation of the cell

public:
  /// the number of a node; nodes are numbered in the order of their creation.
  using Node = std::size_t;

  /// stands for no node.
  static constexpr Node none = (std::numeric_limits<Node>::max)();

  /// the result of a search.
  struct Search
  {
    Vertex vertex;             ///< the vertex at the point, if there is one.
    std::size_t nodes_visited; ///< nodes in conflict with the point, except those given at first.
    std::size_t nodes_tested;  ///< nodes that were tested.
  };

  /// `true`: the conflict zone becomes history.
  static constexpr bool observes_conflict_zone = true;

  /// begins the history with the current state of `tr`; keeps a reference to it.
  explicit Conflict_history_3(const Triangulation& tr)
    : m_tr(tr)
    , m_predicates(tr.geom_traits())
  {
    if (tr.dimension() == 3)
      make_root();
  }

  /// \name Observing
  /// @{

  /// notes that the cells in `[first, last)` are destroyed by the next insertion.
  template <class CellIterator>
  void before_update(std::size_t, CellIterator first, CellIterator last)
  {
    m_zone.assign(first, last);
    for (const Cell c : m_zone)
      m_records[node(c)].cell = Cell();
    m_boundary.clear();
    for (const Cell c : m_zone)
      for (int i = 0; i < 4; ++i) {
        const Cell across = c->neighbor(i);
        if (is_leaf(node(across)))
          m_boundary.push_back({node(across), Node(across->index(c)), node(c)});
      }
    std::sort(m_boundary.begin(), m_boundary.end());
  }

  /// adds the star of `v`, or the root if the triangulation has just become 3-dimensional. A
  /// duplicate point changes nothing.
  void after_update(std::size_t, Vertex v)
  {
    if (!m_zone.empty()) {
      m_zone.clear();
      m_tr.incident_cells(v, std::back_inserter(m_zone));
      for (const Cell c : m_zone)
        add_node(c);
      for (const Cell c : m_zone) {
        const Cell across = c->neighbor(c->index(v));
        link(node(c), node(across), Node(across->index(c)));
      }
      m_zone.clear();
    } else if (is_empty() && m_tr.dimension() == 3)
      make_root();
  }

  /// @}

  /// \name Location
  /// @{

  /// writes the current cells that are in conflict with `p`, as nodes, found from the root. If `p`
  /// is a vertex, the search ends with this vertex, and the nodes written have no meaning.
  /// \pre `!is_empty()`
  template <class NodeOutputIterator>
  Search find_conflicts(const Point& p, NodeOutputIterator out)
  {
    CGAL_precondition(!is_empty());
    Search search = begin_search();
    for (Node n = 0; n < m_root_end && search.vertex == Vertex(); ++n)
      is_visited(n, p, search);
    return finish_search(p, 0, out, search);
  }

  /// does the same from the nodes in `[first, last)`, which are the conflict set of `p` at the time
  /// when there were `number_of_nodes_then` nodes.
  /// \pre `p` was no vertex then.
  template <class NodeIterator, class NodeOutputIterator>
  Search find_conflicts(const Point& p, NodeIterator first, NodeIterator last,
                        std::size_t number_of_nodes_then, NodeOutputIterator out)
  {
    const Search search = begin_search();
    for (; first != last; ++first) {
      m_marks[*first] = 2 * m_search + 1;
      m_stack.push_back(*first);
    }
    return finish_search(p, number_of_nodes_then, out, search);
  }

  /// returns whether `p` is in conflict with node `n`: inside its circumscribing sphere, or beyond
  /// the finite facet of an infinite cell. If `p` is on one of these, %CGAL's perturbation decides.
  bool is_in_conflict(Node n, const Point& p) const
  {
    return side_of_sphere(m_records[n].vertices, p) == POSITIVE;
  }

  /// @}

  /// \name Access
  /// @{

  /// returns whether there is no node, because the triangulation is not 3-dimensional yet.
  bool is_empty() const { return m_records.empty(); }

  /// returns the number of nodes, which is the number of all cells that ever existed.
  std::size_t number_of_nodes() const { return m_records.size(); }

  /// returns the number of nodes of the root, all of which a search from the root tests.
  std::size_t root_size() const { return m_root_end; }

  /// returns whether `n` is a current cell.
  bool is_leaf(Node n) const { return m_records[n].cell != Cell(); }

  /// returns the vertices of `n`.
  const std::array<Vertex, 4>& vertices(Node n) const { return m_records[n].vertices; }

  /// returns the current cell of leaf `n`.
  Cell cell(Node n) const { return m_records[n].cell; }

  /// returns the node of `c`, a current cell.
  Node node(Cell c) const { return m_node_of_cell[c]; }

  /// @}

private:
  struct Record
  {
    Vertices vertices;
    Cell cell; // Cell() once it is destroyed
    Node first_son = none;
    Node next_son = none; // the next of its father's sons
    std::array<Node, 4> youngest_stepson = {none, none, none, none};
    Node next_older_stepson = none; // the one before it on the same facet of its stepfather
  };

  void make_root()
  {
    for (auto c = m_tr.all_cells_begin(); c != m_tr.all_cells_end(); ++c)
      add_node(c);
    m_root_end = m_records.size();
  }

  // Adds a node for c. Its memory may have held a destroyed cell; from now on its address stands
  // for the new one.
  void add_node(Cell c)
  {
    m_node_of_cell[c] = m_records.size();
    m_records.push_back(Record{{c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)}, c});
    m_marks.push_back(0);
  }

  // Links node n, which stands on facet `index` of its stepfather. Its father is found in O(log m)
  // if the zone had m facets.
  void link(Node n, Node stepfather, Node index)
  {
    const auto facet =
        std::lower_bound(m_boundary.begin(), m_boundary.end(), Facet{stepfather, index, 0});
    CGAL_assertion(facet != m_boundary.end() && (*facet)[0] == stepfather && (*facet)[1] == index);
    Node& first_son = m_records[(*facet)[2]].first_son;
    Node& youngest = m_records[stepfather].youngest_stepson[index];
    m_records[n].next_son = first_son;
    m_records[n].next_older_stepson = youngest;
    first_son = youngest = n;
  }

  Search begin_search()
  {
    ++m_search;
    m_stack.clear();
    return {Vertex(), 0, 0};
  }

  // Returns whether n is in conflict with p. If it is, pushes it on the stack, but only once.
  bool is_visited(Node n, const Point& p, Search& search)
  {
    if (m_marks[n] / 2 == m_search)
      return m_marks[n] % 2 == 1;
    ++search.nodes_tested;
    const Sign side = side_of_sphere(m_records[n].vertices, p);
    if (side == ZERO)
      search.vertex = vertex_at(m_records[n].vertices, p);
    m_marks[n] = 2 * m_search + std::size_t(side == POSITIVE);
    if (side != POSITIVE)
      return false;
    ++search.nodes_visited;
    m_stack.push_back(n);
    return true;
  }

  template <class NodeOutputIterator>
  Search finish_search(const Point& p, Node first_of_later, NodeOutputIterator out, Search search)
  {
    while (!m_stack.empty() && search.vertex == Vertex()) {
      const Node n = m_stack.back();
      m_stack.pop_back();
      if (is_leaf(n))
        *out++ = n;
      for (Node son = m_records[n].first_son; son != none; son = m_records[son].next_son)
        is_visited(son, p, search);
      for (Node stepson : m_records[n].youngest_stepson)
        while (stepson != none && stepson >= first_of_later && is_visited(stepson, p, search))
          stepson = m_records[stepson].next_older_stepson;
    }
    return search;
  }

  // Returns POSITIVE if p is in conflict with a cell, ZERO if it is at a vertex of the cell, and
  // NEGATIVE otherwise, as CGAL's find_conflicts() does, perturbation included. The cell may be
  // destroyed: only its vertices are needed. A finite cell is in conflict with the points inside
  // its sphere, an infinite one with those beyond its finite facet, or in the plane of this facet
  // and inside its circle.
  Sign side_of_sphere(const Vertices& v, const Point& p) const
  {
    std::array<const Point*, 4> q; // the points of the cell, with p in place of the infinite vertex
    std::size_t infinite = 4;
    for (std::size_t i = 0; i < 4; ++i)
      if (m_tr.is_infinite(v[i]))
        q[infinite = i] = &p;
      else
        q[i] = &v[i]->point();
    const auto& gt = m_tr.geom_traits();
    const bool is_finite = infinite == 4;
    const Sign side = is_finite
                          ? gt.side_of_oriented_sphere_3_object()(*q[0], *q[1], *q[2], *q[3], p)
                          : gt.orientation_3_object()(*q[0], *q[1], *q[2], *q[3]);
    if (side != ZERO || vertex_at(v, p) != Vertex())
      return side;
    if (is_finite)
      return m_predicates.side_of_oriented_sphere(*q[0], *q[1], *q[2], *q[3], p, true);
    std::swap(q[infinite], q[3]);
    return enum_cast<Sign>(
        m_predicates.coplanar_side_of_bounded_circle(*q[0], *q[1], *q[2], p, true));
  }

  // Returns the finite vertex at p, or Vertex() if there is none.
  Vertex vertex_at(const Vertices& v, const Point& p) const
  {
    for (const Vertex u : v)
      if (!m_tr.is_infinite(u) && m_tr.geom_traits().compare_xyz_3_object()(u->point(), p) == EQUAL)
        return u;
    return Vertex();
  }

  // Holds a facet of the boundary of a zone: the cell across, which survives, the number of the
  // facet in it, and the cell behind, which does not.
  using Facet = std::array<Node, 3>;

  const Triangulation& m_tr;
  internal::Exposed_predicates<typename Triangulation::Geom_traits> m_predicates;
  std::vector<Record> m_records;
  Unique_hash_map<Cell, Node> m_node_of_cell;
  Node m_root_end = 0;
  std::vector<Cell> m_zone;         // not empty while an update is under way
  std::vector<Facet> m_boundary;    // the boundary of the zone, sorted
  std::vector<std::size_t> m_marks; // twice the last search that tested the node, plus the answer
  std::size_t m_search = 0;
  std::vector<Node> m_stack;
};

// Conflict_history_hints_3 implements Choi 2002, Fig. 1, lines 2a and 2b, with the paper's Q: s_i
// is located by a search through all cells in conflict with it, from the conflicting cells of
// D(S_{N_h}), which a trace has recorded.
//
// Invariant: the record of a point is its whole conflict set in the triangulation of the last
// trace, or the vertex that was at the point. Cost: see Conflict_history_3 for s_i; a trace takes
// O(n) expected cells (Theorem 3) and the sizes of all conflict sets, which add up to O(n) expected
// if an insertion destroys O(1) cells.

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion in a cell in conflict with the point, found in the history of all conflicts,
the paper's own location structure (\cgalCite{choi-dtsm-02}, Fig.\ 1, lines 2a and 2b). The search
starts at the conflict set that the last trace recorded for the point, or at the root if there was
no trace. If the root has more than 256 cells, because the history began with a triangulation that
had vertices, or with many points in a plane, the point is located by a walk from the vertex
inserted last instead. A trace works as in `Traced_hints_3`, but records sets of nodes instead of
vertices, and locates all points not yet inserted, as the paper does. The paper records only the
cell that contains the point; a search from that cell alone can miss cells (`Conflict_history_3`).

This policy serves the study of the theory: it takes several times the memory of the triangulation,
and is slower than a walk on all surfaces measured.

<b>Complexity</b>, under the assumptions of the paper: a trace takes expected \f$O(n)\f$ time. The
search for point i after a trace in the triangulation of k points takes expected
\f$O(\log(i/k))\f$ time (Theorem 3 and Lemma 4). Walks that replace a large root have no such bound.

<b>Memory</b> besides the history: 25 bytes per point, and 8 bytes for each cell of a record. During
a trace, in addition, the previous records, and at most 24 bytes per point.

\tparam Target `Triangulation_target_3`, not of a triangulation with `Fast_location`
\tparam Subgraph a model of `boost::AdjacencyGraph` on the numbers of the points: T

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Conflict_history_hints_3 : public Previous_hint_3<Target, Subgraph>
{
  using Base = Previous_hint_3<Target, Subgraph>;
  using Base::m_target;
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
    : Base(target, subgraph)
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
      return Base::start(i);
    if (record.vertex != Vertex())
      return m_target.cell(record.vertex);
    if (record.first == record.last)
      return m_history.root_size() > largest_root ? Base::start(i) : start_from_root(i);
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
      return Base::start(i);
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
    Base::after_update(i, v);
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
  // A search from the root tests all its cells: if there are more than these, a walk is shorter.
  static constexpr std::size_t largest_root = 256;

  struct Record
  {
    std::ptrdiff_t first = 0, last = 0; // in the list of nodes; equal before the first trace
    Vertex vertex = {};                 // the vertex at the point at the last trace
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

  // Returns the start that search(out) finds.
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
    return m_conflicts.empty() ? m_target.cell(this->m_previous)
                               : m_history.cell(m_conflicts.front());
  }

  History m_history;
  Trace_subgraph<Target, Subgraph> m_trace;
  std::vector<Record> m_record;
  std::vector<Node> m_recorded;
  std::size_t m_number_of_nodes_at_trace = 0;
  std::vector<Node> m_conflicts;
  std::size_t m_nodes_visited = 0, m_nodes_tested = 0;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_CONFLICT_HISTORY_3_H
