// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PLANNED_HINTS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PLANNED_HINTS_3_H

// Beyond the paper: the plan already knows where a point starts, so that nothing need be searched
// or stored while points are inserted.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Null_update_observer.h>
#include <CGAL/Delaunay_from_surface_3/paper/Starts_in_core.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion from a cell of the point that the plan names in
`Insertion_order::starting_places`. If that point was left out, and so has no vertex, the point that
the plan names for it is used instead, and so on. If the plan names no point, the start is a cell of
the vertex inserted last. Traits with this policy go through the core, which starts in the same way.

<b>Complexity</b>: \f$O(1)\f$ per point if all points are inserted. It needs no trace, no subgraph,
and no memory of its own.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph is not used

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Planned_hints_3 : public Null_update_observer
{
  using Vertex = typename Target::Vertex;

public:
  /// `false`: no subgraph is needed.
  static constexpr bool uses_subgraph = false;

  /// keeps references to `target` and `plan`.
  Planned_hints_3(const Target& target, const Subgraph&, const Insertion_order& plan)
    : m_target(target)
    , m_places(plan.starting_places)
  {
  }

  /// returns a cell of the starting point that the plan names for point `i`, or of the vertex
  /// inserted last.
  typename Target::Cell start(std::size_t i) const
  {
    if (i == 0 || m_places.empty())
      return m_target.cell(m_previous);
    std::size_t place = m_places[i];
    Vertex v = m_target.vertex(place);
    while (v == Vertex() && place != 0) // left out
      v = m_target.vertex(place = m_places[place]);
    return m_target.cell(v == Vertex() ? m_previous : v);
  }

  /// remembers `v`.
  void after_update(std::size_t, Vertex v) { m_previous = v; }

  /// does nothing, and returns 0: no point is located.
  std::size_t trace() { return 0; }

private:
  const Target& m_target;
  const std::vector<std::size_t>& m_places;
  Vertex m_previous = {};
};

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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
