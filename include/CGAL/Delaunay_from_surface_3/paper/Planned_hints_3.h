// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PLANNED_HINTS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PLANNED_HINTS_3_H

// Goes beyond the paper: the plan already knows where a point starts, so that nothing need be
// searched or stored while points are inserted.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PLANNED_HINTS_3_H
