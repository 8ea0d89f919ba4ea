// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_THROUGH_CGAL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_THROUGH_CGAL_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insert_in_traced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The vertices of the points, none where the work ended before; by point.
template <class Vertex_handle>
struct Inserted_points
{
  std::vector<Vertex_handle> vertices;
  bool is_complete = false;
};

// Inserts the points in the order of the plan. T, `subgraph`, is a graph on the places in the
// order. The points are copied in this order: in that of the mesh nearly every point would miss the
// cache.
template <template <class, class> class Hints, class Triangulation, class Watcher>
Inserted_points<typename Triangulation::Vertex_handle>
insert_through_cgal(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                    const Insertion_order& plan, const Index_graph& subgraph, Watcher& watcher)
{
  using Target = Triangulation_target_3<Triangulation>;
  const auto ordered = permuted(points, plan.order);
  Target target(tr, ordered);
  Hints<Target, Index_graph> hints(target, subgraph, plan);
  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  inserted.is_complete = insert_in_traced_rounds(plan, target, hints, watcher);
  inserted.vertices = permuted(target.take_vertices(), inverse(plan.order));
  return inserted;
}

// The number of points at which the core is as fast as CGAL.
constexpr std::size_t few_points = 30;

// Inserts a few points, in their own order, into an empty triangulation: to order and export them
// would take longer than to insert them. Of equal points the first one gives the vertex.
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERT_THROUGH_CGAL_H
