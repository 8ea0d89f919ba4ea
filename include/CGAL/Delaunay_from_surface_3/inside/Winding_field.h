// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H

// The faces of a soup as triangles in a box of size 1, and their winding numbers.

#include <CGAL/Delaunay_from_surface_3/core/order/soup_edges.h>
#include <CGAL/Delaunay_from_surface_3/inside/Unit_frame.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_tree.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Winding_field
{
  Unit_frame frame;
  Winding_tree tree;
};

// The triangles of faces, polygons as fans, in the frame.
template <class FaceRange>
std::vector<Triangle_3d> triangles_in(const Unit_frame& frame, const FaceRange& faces,
                                      const Point_array& points)
{
  std::vector<Triangle_3d> triangles;
  std::size_t f = 0;
  for (const auto& face : faces) {
    check_face(face, f++, points.size());
    Triangle_3d triangle;
    std::size_t k = 0;
    for (const auto& index : face) {
      triangle[k < 2 ? k : 2] = frame(vector_of(points[std::size_t(index)]));
      if (++k > 2) {
        triangles.push_back(triangle);
        triangle[1] = triangle[2];
      }
    }
  }
  return triangles;
}

// Throws Surface_input_error if a face has an index out of range.
template <class FaceRange>
Winding_field winding_field(const Point_array& points, const FaceRange& faces)
{
  const Unit_frame frame(points);
  return {frame, Winding_tree(triangles_in(frame, faces, points))};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H
