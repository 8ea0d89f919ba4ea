// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_HILBERT_SORTED_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_HILBERT_SORTED_ROUNDS_H

// The rounds of another plan, each made coherent: what a plan costs on a machine with caches is
// decided by the order inside its rounds, what it costs in theory by the rounds.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_of_indices.h>

#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

takes the rounds of `Plan` and sorts each along a Hilbert curve. The sets of points that are
inserted by the end of a round stay the same. Starting places that `Plan` names are dropped: they
belong to its order. `Neighbor_started_rounds<Hilbert_sorted_rounds<Plan>>` names others.

The cost of `Plan`, plus expected \f$O(n \log n)\f$ for n points.

\tparam Plan a model of `InsertionPlan`, constructible from a seed

\cgalModels{InsertionPlan}
*/
template <class Plan>
class Hilbert_sorted_rounds
{
public:
  /// hands `seed` to `Plan`.
  explicit Hilbert_sorted_rounds(unsigned int seed = 0)
    : m_plan(seed)
  {
  }

  /// returns order and rounds of `points`.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                             const Graph& graph, VertexIndexMap index_map) const
  {
    Insertion_order plan = m_plan(points, gt, graph, index_map);
    internal::hilbert_sort_rounds(points, gt, plan, plan.round_ends.size());
    plan.starting_places.clear(); // they came before their points in an order that is gone
    return plan;
  }

private:
  Plan m_plan;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_HILBERT_SORTED_ROUNDS_H
