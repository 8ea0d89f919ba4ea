// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PREVIOUS_HINT_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PREVIOUS_HINT_3_H

// The control: every point starts from the point inserted before it, as in CGAL's own range
// insertion.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Null_update_observer.h>
#include <CGAL/Delaunay_from_surface_3/paper/Starts_in_core.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Hints

starts every insertion from a cell of the vertex inserted last, as
`Delaunay_triangulation_3::insert(first, last)` does. The surface is not used. Traits with this
policy go through the core, which starts in the same way.

<b>Complexity</b>: \f$O(1)\f$ per point. It needs no trace, no subgraph, and no memory of its own.

\tparam Target a `Triangulation_target_3`
\tparam Subgraph is not used

\cgalModels{InsertionHints_3}
*/
template <class Target, class Subgraph>
class Previous_hint_3 : public Null_update_observer
{
public:
  /// `false`: no subgraph is needed.
  static constexpr bool uses_subgraph = false;

  /// keeps a reference to `target`.
  explicit Previous_hint_3(const Target& target, const Subgraph& = Subgraph(),
                           const Insertion_order& = Insertion_order())
    : m_target(target)
  {
  }

  /// returns a cell of the vertex inserted last.
  typename Target::Cell start(std::size_t) const { return m_target.cell(m_previous); }

  /// remembers `v`.
  void after_update(std::size_t, typename Target::Vertex v) { m_previous = v; }

  /// does nothing, and returns 0: no point is located.
  std::size_t trace() { return 0; }

private:
  const Target& m_target;
  typename Target::Vertex m_previous = {};
};

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <>
struct Starts_in_core<Previous_hint_3> : std::true_type
{
  static constexpr bool uses_starting_places = false;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_PREVIOUS_HINT_3_H
