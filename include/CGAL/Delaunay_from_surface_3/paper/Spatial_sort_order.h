// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPATIAL_SORT_ORDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPATIAL_SORT_ORDER_H

// The control: the order of CGAL's own insert(first, last), in one round.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_of_indices.h>

#include <CGAL/spatial_sort.h>

#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

orders the points by `CGAL::spatial_sort()`, all in one round. This is the order in which
`Delaunay_triangulation_3::insert(first, last)` inserts; with `Previous_hint_3` it reproduces that
function insertion by insertion. The seed is not used: `spatial_sort()` has its own.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Spatial_sort_order
{
public:
  /// is the same for every seed.
  explicit Spatial_sort_order(unsigned int /* seed */ = 0) {}

  /// returns the order of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph&,
                             VertexIndexMap) const
  {
    using namespace Delaunay_from_surface_3::internal;
    Insertion_order plan;
    plan.order = identity_order(points.size());
    sort_indices(points, gt, plan.order.begin(), plan.order.end(),
                 [](auto b, auto e, const auto& traits) { spatial_sort(b, e, traits); });
    if (!points.empty())
      plan.round_ends.push_back(points.size());
    return plan;
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPATIAL_SORT_ORDER_H
