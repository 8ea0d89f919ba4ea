// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_HISTORY_HINTS_3_H
#define DELAUNAY_FROM_SURFACE_3_METERS_HISTORY_HINTS_3_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

// In the place of the location structure Q of Choi 2002, §2: a history too, but by containment.
//
// Invariant: the star of an event covers all cells that the event destroyed. So a point in a
// destroyed cell is in a cell of that star, and a descent loses no point. Links from a destroyed
// cell to the new cells that share a facet with it would not do: the point may lie in none of
// these.
namespace meters {

// is the history of a Delaunay triangulation in dimension 3 while points are inserted, by containment:
// every cell that ever was, infinite ones too, is a node. Each insertion is
// an event that owns the cells which it created, its star, as a contiguous range of nodes. A destroyed
// cell knows the event that destroyed it. To locate a point is to descend from a node that contains it
// to the node in the star of the next event that does, until a cell of today is reached. The descent
// may start at the root or at any node that is known to contain the point.
//
// The first event is the root. Its star consists of all cells that there are when the triangulation is
// handed over or becomes 3-dimensional; no history is kept before.
//
// Let points be inserted in random order. The cell that contains a point p is made by the j-th
// insertion with probability 4/j if it is finite, since any of its four vertices may be the
// last, and 3/j if it is not. So a descent from the triangulation of k points to that of i
// enters at most about 4 \ln(i/k) nodes in expectation, and 4 \ln i from the root. To
// enter a node takes tests in proportion to the size of the star. So nodes are few, but tests need not
// be: where one vertex is in a constant share of all cells, a descent through its star, and through
// those of its neighbours, takes tests without bound. It is the practical variant, whose records are
// single nodes; the paper's is `Conflict_history_3`.
//
// Memory: 48 bytes per cell that ever was, where handles have 8 bytes, and about 24 bytes per cell of
// today. That is several times what the triangulation itself takes. Nothing is freed before the end,
// and then all at once.
//
// Points may only be inserted, every conflict zone must be reported, and the predicates must be exact.
//
// Triangulation: a `CGAL::Delaunay_triangulation_3`, not with `Fast_location`
//
// //
// \sa `Conflict_history_3`
template <class Triangulation>
class History_dag_3
{
  using Vertex = typename Triangulation::Vertex_handle;
  using Cell = typename Triangulation::Cell_handle;
  using Point = typename Triangulation::Point;

public:
  // the number of a node; nodes are numbered in the order of their creation.
  using Node = std::size_t;

  // stands for no node.
  static constexpr Node none = (std::numeric_limits<Node>::max)();

  // the end of a descent.
  struct Descent
  {
    Node node;                 // a leaf that contains the point.
    std::size_t nodes_entered; // how many nodes were entered; a given first node does not count.
  };

  // `true`: the conflict zone is what becomes history.
  static constexpr bool observes_conflict_zone = true;

  // begins the history of `tr` with what it is now; keeps a reference to it.
  explicit History_dag_3(const Triangulation& tr)
    : m_tr(tr)
  {
    if (tr.dimension() == 3)
      make_root();
  }

  // \name Observing
  // @{

  // notes that the cells in `[first, last)` are destroyed by the next event.
  template <class CellIterator>
  void before_update(std::size_t, CellIterator first, CellIterator last)
  {
    m_is_update_under_way = true;
    for (; first != last; ++first) {
      Record& record = m_records[node(*first)];
      record.cell = Cell();
      record.event = number_of_events();
    }
  }

  // adds the star of `v` as an event, or the root if the triangulation has just become
  // 3-dimensional. A point that was there already changes nothing.
  void after_update(std::size_t, Vertex v)
  {
    if (m_is_update_under_way) {
      m_is_update_under_way = false;
      m_star.clear();
      m_tr.incident_cells(v, std::back_inserter(m_star));
      for (const Cell c : m_star)
        add_node(c);
      m_star_ends.push_back(m_records.size());
    } else if (is_empty() && m_tr.dimension() == 3)
      make_root();
  }

  // @}

  // \name Location
  // @{

  // descends from the root.
  // \pre `!is_empty()`
  Descent locate(const Point& p) const
  {
    CGAL_precondition(!is_empty());
    return descend(p, {node_in_star(p, 0), 1});
  }

  // descends from `from`.
  // \pre `contains(from, p)`
  Descent locate(const Point& p, Node from) const
  {
    CGAL_precondition(contains(from, p));
    return descend(p, {from, 0});
  }

  // returns whether `p` is in the closed cell of node `n`; for an infinite cell, whether `p` is
  // strictly beyond its finite facet. A point outside the convex hull may be in several of these.
  bool contains(Node n, const Point& p) const
  {
    const std::array<Vertex, 4>& vertices = m_records[n].vertices;
    for (int i = 0; i < 4; ++i)
      if (m_tr.is_infinite(vertices[std::size_t(i)]))
        return orientation_with_point_at(i, vertices, p) == CGAL::POSITIVE;
    for (int i = 0; i < 4; ++i)
      if (orientation_with_point_at(i, vertices, p) == CGAL::NEGATIVE)
        return false;
    return true;
  }

  // @}

  // \name Access
  // @{

  // returns whether there is no node, since the triangulation has not become 3-dimensional yet.
  bool is_empty() const { return m_records.empty(); }

  // returns the number of nodes: of all cells that ever were.
  std::size_t number_of_nodes() const { return m_records.size(); }

  // returns the number of events, the root counted.
  std::size_t number_of_events() const { return m_star_ends.size(); }

  // returns the first node of the star of event `e`.
  Node star_begin(std::size_t e) const { return e == 0 ? 0 : m_star_ends[e - 1]; }

  // returns the node past the last of the star of event `e`.
  Node star_end(std::size_t e) const { return m_star_ends[e]; }

  // returns whether `n` is a cell of today.
  bool is_leaf(Node n) const { return m_records[n].cell != Cell(); }

  // returns the event that destroyed `n`.
  // \pre `!is_leaf(n)`
  std::size_t destroying_event(Node n) const { return m_records[n].event; }

  // returns the vertices of `n`, in the order that they had in the cell.
  const std::array<Vertex, 4>& vertices(Node n) const { return m_records[n].vertices; }

  // returns the cell of today that `n` is.
  // \pre `is_leaf(n)`
  Cell cell(Node n) const { return m_records[n].cell; }

  // returns the node of `c`.
  // \pre `c` is a cell of today, and `!is_empty()`
  Node node(Cell c) const { return m_node_of_cell[c]; }

  // @}

private:
  struct Record
  {
    std::array<Vertex, 4> vertices;
    Cell cell;         // none once it is destroyed
    std::size_t event; // that destroyed it
  };

  void make_root()
  {
    for (auto c = m_tr.all_cells_begin(); c != m_tr.all_cells_end(); ++c)
      add_node(c);
    m_star_ends.push_back(m_records.size());
  }

  // The memory of a destroyed cell may hold a new one: that is then what its address stands for.
  void add_node(Cell c)
  {
    m_node_of_cell[c] = m_records.size();
    m_records.push_back({{c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)}, c, 0});
  }

  Descent descend(const Point& p, Descent descent) const
  {
    for (; !is_leaf(descent.node); ++descent.nodes_entered)
      descent.node = node_in_star(p, destroying_event(descent.node));
    return descent;
  }

  Node node_in_star(const Point& p, std::size_t event) const
  {
    Node n = star_begin(event);
    while (!contains(n, p)) {
      ++n;
      CGAL_assertion(n != star_end(event));
    }
    return n;
  }

  // Positive if p is on the side of the facet opposite to vertex i on which that vertex is.
  CGAL::Orientation orientation_with_point_at(int i, const std::array<Vertex, 4>& v,
                                              const Point& p) const
  {
    const auto q = [&](int j) -> const Point& { return i == j ? p : v[std::size_t(j)]->point(); };
    return m_tr.geom_traits().orientation_3_object()(q(0), q(1), q(2), q(3));
  }

  const Triangulation& m_tr;
  std::vector<Record> m_records;
  std::vector<Node> m_star_ends;
  CGAL::Unique_hash_map<Cell, Node> m_node_of_cell;
  std::vector<Cell> m_star;
  bool m_is_update_under_way = false;
};

// Choi 2002, Fig. 1, lines 2a and 2b, with a history by containment for Q: a trace records
// d_{N_h}(s_k) as nodes, and s_i is located by a descent from its record.
//
// Invariant: the record of a point is a node that contains it. A node never dies. Cost: O(log(i/k))
// expected nodes for s_i if the last trace was in D(S_k), each of which takes tests in proportion
// to a star.

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
