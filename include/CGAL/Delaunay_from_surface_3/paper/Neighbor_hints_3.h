// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_NEIGHBOR_HINTS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_NEIGHBOR_HINTS_3_H

// Beyond the paper: no trace at all. When a point's turn comes, its neighbours on the surface are
// asked which of them are in the triangulation by now; late in the insertion nearly always some
// are.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Null_update_observer.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {

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
class Neighbor_hints_3 : public Null_update_observer
{
  using Vertex = typename Target::Vertex;

public:
  /// `true`: the neighbours are those in the subgraph.
  static constexpr bool uses_subgraph = true;

  /// keeps references to target and subgraph. The plan is not used.
  Neighbor_hints_3(const Target& target, const Subgraph& subgraph,
                   const Insertion_order& = Insertion_order())
    : m_target(target)
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
    return m_target.cell(nearest == Vertex() ? m_previous : nearest);
  }

  /// remembers `v`.
  void after_update(std::size_t, Vertex v) { m_previous = v; }

  /// does nothing, and returns 0: no point is located.
  std::size_t trace() { return 0; }

private:
  const Target& m_target;
  const Subgraph& m_subgraph;
  Vertex m_previous = {};
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_NEIGHBOR_HINTS_3_H
