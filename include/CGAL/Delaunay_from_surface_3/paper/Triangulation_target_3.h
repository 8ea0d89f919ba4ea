// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRIANGULATION_TARGET_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRIANGULATION_TARGET_3_H

// Implements Choi 2002, Fig. 1, line 2c: "Insert s_i and update D(S_i)", through CGAL's own
// insertion, and the walk that replaces Q in lines 2a and 2b.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Triangulation_hierarchy_3.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A user's plan may be wrong; inserting by it would lose points or read out of bounds.

[[noreturn]] inline void refuse_plan(const std::string& what)
{
  throw std::invalid_argument("insertion plan: " + what);
}

// Throws unless the rounds end in ascending order, and the last one at n.
inline void check_round_ends(const std::vector<std::size_t>& ends, std::size_t n)
{
  for (std::size_t h = 0; h < ends.size(); ++h)
    if (ends[h] <= (h == 0 ? 0 : ends[h - 1]))
      refuse_plan("round " + std::to_string(h) + " ends at " + std::to_string(ends[h]) +
                  ", not after the round before it");
  const std::size_t last = ends.empty() ? 0 : ends.back();
  if (last != n)
    refuse_plan("the last round ends at " + std::to_string(last) + ", but there are " +
                std::to_string(n) + " points");
}

// Throws unless there are no starting places, or n, of which all but the first precede their point.
inline void check_starting_places(const std::vector<std::size_t>& places, std::size_t n)
{
  if (!places.empty() && places.size() != n)
    refuse_plan("there are " + std::to_string(places.size()) + " starting places for " +
                std::to_string(n) + " points");
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k] >= k)
      refuse_plan("the starting place of place " + std::to_string(k) + " is " +
                  std::to_string(places[k]) + ", which is not before it");
}

// Returns the place of each point in the order; throws unless this is a permutation of 0, …, n-1.
inline std::vector<std::size_t> places_in_order(const std::vector<std::size_t>& order,
                                                std::size_t n)
{
  if (order.size() != n)
    refuse_plan("the order has " + std::to_string(order.size()) + " places for " +
                std::to_string(n) + " points");
  std::vector<std::size_t> places(n, n);
  for (std::size_t k = 0; k < n; ++k) {
    if (order[k] >= n)
      refuse_plan("at place " + std::to_string(k) + " there is point " + std::to_string(order[k]) +
                  ", but there are " + std::to_string(n) + " points");
    if (places[order[k]] != n)
      refuse_plan("point " + std::to_string(order[k]) + " is at the places " +
                  std::to_string(places[order[k]]) + " and " + std::to_string(k));
    places[order[k]] = k;
  }
  return places;
}

// Checks the plan for n points and returns the place of each point. Throws a std::invalid_argument
// that tells what is wrong and where. Linear.
inline std::vector<std::size_t> check_plan(const Insertion_order& plan, std::size_t n)
{
  check_round_ends(plan.round_ends, n);
  check_starting_places(plan.starting_places, n);
  return places_in_order(plan.order, n);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Insertion

inserts points into a `CGAL::Delaunay_triangulation_3` by its own member functions: `locate()` with
a starting cell, then `insert()` at the location found. The triangulation may be of any dimension,
may contain points already, and may have any vertex and cell base.

If the hints observe conflict zones, an insertion in dimension 3 uses `find_conflicts()` and
`insert_in_hole()` instead. With `Fast_location` it does not, since `insert()` must also fill the
upper levels. No conflict zone is reported then, nor if the dimension is below 3.

<b>Memory</b>: a vertex handle per point.

\tparam Triangulation a `CGAL::Delaunay_triangulation_3`
*/
template <class Triangulation>
class Triangulation_target_3
{
  template <class Tr>
  static std::true_type has_hierarchy(const Triangulation_hierarchy_3<Tr>*);
  static std::false_type has_hierarchy(...);

public:
  using Point = typename Triangulation::Point;          ///< the points inserted.
  using Vertex = typename Triangulation::Vertex_handle; ///< `Vertex()` stands for none.
  using Cell = typename Triangulation::Cell_handle;     ///< where a walk starts.

  /// the location of a point in the triangulation, as `Triangulation_3::locate()` gives it.
  struct Location
  {
    Cell cell; ///< the cell that contains the point, or an infinite cell that sees it.
    typename Triangulation::Locate_type type; ///< on which kind of face of the cell the point lies.
    int li;                                   ///< which vertex, edge or facet of the cell that is.
    int lj;                                   ///< the second vertex of an edge.
  };

  /// says whether hints are told of every conflict zone in dimension 3: `false` with
  /// `Fast_location`.
  static constexpr bool reports_conflict_zones =
      !decltype(has_hierarchy(static_cast<Triangulation*>(nullptr)))::value;

  /// prepares the insertion of `points` into `tr`; keeps references to both.
  Triangulation_target_3(Triangulation& tr, const std::vector<Point>& points)
    : m_tr(tr)
    , m_points(points)
    , m_vertices(points.size())
  {
  }

  /// returns the number of points.
  std::size_t size() const { return m_points.size(); }

  /// returns the triangulation.
  const Triangulation& triangulation() const { return m_tr; }

  /// returns all points, in the order of their insertion.
  const std::vector<Point>& points() const { return m_points; }

  /// returns point `i`.
  const Point& point(std::size_t i) const { return m_points[i]; }

  /// returns the vertex at point `i`, or none if the point is not inserted yet.
  Vertex vertex(std::size_t i) const { return m_vertices[i]; }

  /// returns a cell of `v`, or any cell if `v` is none.
  Cell cell(Vertex v) const { return v == Vertex() ? m_tr.infinite_cell() : v->cell(); }

  /// locates point `i` by a walk from `start`. Outside the affine hull there is no walk.
  Location locate(std::size_t i, Cell start) const
  {
    Location location = {start, Triangulation::OUTSIDE_AFFINE_HULL, 0, 0};
    const Cell found = m_tr.locate(m_points[i], location.type, location.li, location.lj, start);
    if (found != Cell()) // otherwise the next walk may start where this one did
      location.cell = found;
    return location;
  }

  /// returns the vertex of the located cell that is nearest to point `i`; finite.
  /// \pre The triangulation has a finite vertex, and `location` is that of point `i` in it.
  Vertex nearest_vertex(std::size_t i, const Location& location) const
  {
    // In dimension 0 a cell is a single vertex, perhaps the infinite one.
    return m_tr.dimension() < 1 ? Vertex(m_tr.finite_vertices_begin())
                                : m_tr.nearest_vertex_in_cell(m_points[i], location.cell);
  }

  /// returns whether `v` is closer to point `i` than `w`.
  bool is_closer(std::size_t i, Vertex v, Vertex w) const
  {
    return m_tr.geom_traits().compare_distance_3_object()(m_points[i], v->point(), w->point()) ==
           SMALLER;
  }

  /// inserts point `i` where it was just located, and tells `hints`: any object with the members
  /// `observes_conflict_zone`, `before_update()` and `after_update()` of `InsertionHints_3`. If
  /// there is already a vertex at the point, the point gets this vertex.
  /// The time is linear in the number of cells destroyed and created, plus the time for the upper
  /// levels of `Fast_location`. After an exception of CGAL's insertion the triangulation may only
  /// be cleared or destroyed.
  template <class Hints>
  void insert(std::size_t i, const Location& location, Hints& hints)
  {
    m_vertices[i] = insert_at(i, location, hints);
    hints.after_update(i, m_vertices[i]);
  }

  /// returns only zeros: CGAL's insertion does not count.
  Delaunay_from_surface_3::Insertion_counts counts() const { return {}; }

  /// moves out the vertices of the points, none for points not inserted; must be called last.
  std::vector<Vertex> take_vertices() { return std::move(m_vertices); }

private:
  template <class Hints>
  Vertex insert_at(std::size_t i, const Location& location, Hints& hints)
  {
    if constexpr (Hints::observes_conflict_zone && reports_conflict_zones) {
      if (m_tr.dimension() == 3 && location.type != Triangulation::VERTEX)
        return insert_in_conflict_zone(i, location, hints);
    }
    return m_tr.insert(m_points[i], location.type, location.cell, location.li, location.lj);
  }

  // Inserts point i. The cell where it is located is in conflict with it, also outside the hull.
  template <class Hints>
  Vertex insert_in_conflict_zone(std::size_t i, const Location& location, Hints& hints)
  {
    m_conflict_zone.clear();
    m_boundary.clear();
    m_tr.find_conflicts(m_points[i], location.cell, std::back_inserter(m_boundary),
                        std::back_inserter(m_conflict_zone));
    hints.before_update(i, m_conflict_zone.begin(), m_conflict_zone.end());
    return m_tr.insert_in_hole(m_points[i], m_conflict_zone.begin(), m_conflict_zone.end(),
                               m_boundary.front().first, m_boundary.front().second);
  }

  Triangulation& m_tr;
  const std::vector<Point>& m_points;
  std::vector<Vertex> m_vertices;
  std::vector<Cell> m_conflict_zone;
  std::vector<typename Triangulation::Facet> m_boundary;
};

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The following is the loop of Choi 2002, Fig. 1, on CGAL's own triangulation.

// Round h ends with the paper's s_{N_h}, N_h = round_ends[h]; i counts from 0. Returns false if the
// visitor stopped it.
template <class Target, class Hints, class Observer>
bool insert_in_traced_rounds(const Insertion_order& plan, Target& target, Hints& hints,
                             Observer& observer)
{
  using Phase = Surface_insertion_phase;
  observer.phase_begins(Phase::INSERTION, 1);
  std::size_t i = 0;
  for (std::size_t h = 0; h < plan.round_ends.size(); ++h) {
    const std::size_t N_h = plan.round_ends[h];
    observer.phase_begins(Phase::ROUND, N_h - i);
    for (; i < N_h; ++i) {
      if (!observer.go_further(i))
        return false;
      observer.phase_begins(Phase::LOCATION);
      const typename Target::Location d_i = target.locate(i, hints.start(i)); // 2b
      observer.phase_begins(Phase::UPDATE);
      target.insert(i, d_i, hints); // 2c
    }
    if (N_h < target.size()) {
      observer.phase_begins(Phase::TRACE, Hints::uses_subgraph ? plan.round_ends[h + 1] - N_h : 0);
      hints.trace(); // 2a
    }
  }
  observer.insertion_ends(target, hints);
  observer.phase_begins(Phase::FINISH);
  return true;
}

// Holds the vertex of each point, or a null handle if the work ended before.
template <class Vertex_handle>
struct Inserted_points
{
  std::vector<Vertex_handle> vertices;
  bool is_complete = false;
};

// Inserts the points in the order of the plan. T, `subgraph`, is a graph on the places in the
// order. The points are copied in this order: in the order of the mesh nearly every access would
// miss the cache.
template <template <class, class> class Hints, class Triangulation, class Observer>
Inserted_points<typename Triangulation::Vertex_handle>
insert_through_cgal(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                    const Insertion_order& plan, const Index_graph& subgraph, Observer& observer)
{
  using Target = Triangulation_target_3<Triangulation>;
  const auto ordered = permuted(points, plan.order);
  Target target(tr, ordered);
  Hints<Target, Index_graph> hints(target, subgraph, plan);
  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  inserted.is_complete = insert_in_traced_rounds(plan, target, hints, observer);
  inserted.vertices = permuted(target.take_vertices(), inverse(plan.order));
  return inserted;
}

// The number of points at which the core is as fast as CGAL.
constexpr std::size_t few_points = 30;

// Inserts a few points, in their own order, into an empty triangulation: ordering and exporting
// them would take longer than inserting them. The first of equal points provides the vertex.
template <class Triangulation>
Inserted_points<typename Triangulation::Vertex_handle>
insert_few_points(Triangulation& tr, const std::vector<typename Triangulation::Point>& points)
{
  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  inserted.vertices.reserve(points.size());
  typename Triangulation::Vertex_handle v;
  for (const auto& p : points)
    inserted.vertices.push_back(v = tr.insert(p, v));
  inserted.is_complete = true;
  return inserted;
}

// Follows the paper: takes order and T from the surface, then runs Fig. 1 on CGAL's triangulation.

template <class Traits, class Triangulation, class Input, class Observer>
Inserted_points<typename Triangulation::Vertex_handle>
insert_with_traces(Triangulation& tr, const Input& input, const Traits& traits, unsigned int seed,
                   Observer& observer)
{
  using Phase = Surface_insertion_phase;
  using Target = Triangulation_target_3<Triangulation>;
  using Hints = typename Traits::template Insertion_hints_3<Target, Index_graph>;
  observer.phase_begins(Phase::PLAN);
  const Insertion_order plan = traits.insertion_plan_object(seed)(input.points, tr.geom_traits(),
                                                                  input.graph, input.index_map);
  const std::vector<std::size_t> places = check_plan(plan, input.points.size());
  observer.phase_begins(Phase::SUBGRAPH);
  Index_graph subgraph;
  if constexpr (Hints::uses_subgraph)
    subgraph = spanning_subgraph(traits.surface_subgraph_object(), input.graph, input.index_map,
                                 places, observer);
  return insert_through_cgal<Traits::template Insertion_hints_3>(tr, input.points, plan, subgraph,
                                                                 observer);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_TRIANGULATION_TARGET_3_H
