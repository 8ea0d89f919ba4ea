// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERT_FEW_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERT_FEW_POINTS_H

// A few points by CGAL, in their own order: to order them, to build aside and to export takes longer
// than to insert them.

#include <CGAL/Delaunay_from_surface_3/paper/insert_through_cgal.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// So many points take the core as long as CGAL.
constexpr std::size_t few_points = 30;

// Into an empty triangulation. Of equal points the first one gives the vertex.
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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERT_FEW_POINTS_H
