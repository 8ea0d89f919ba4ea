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

#include <array>
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

// Calls visit(i, j, k) with the points of the triangles of faces; a polygon is a fan at its first
// point. Throws Surface_input_error if a face has an index that is not less than n.
template <class FaceRange, class Visit>
void for_each_triangle(const FaceRange& faces, std::size_t n, const Visit& visit)
{
  std::size_t f = 0;
  for (const auto& face : faces) {
    check_face(face, f++, n);
    std::array<std::size_t, 3> triangle = {0, 0, 0};
    std::size_t k = 0;
    for (const auto& index : face) {
      triangle[k < 2 ? k : 2] = std::size_t(index);
      if (++k > 2) {
        visit(triangle[0], triangle[1], triangle[2]);
        triangle[1] = triangle[2];
      }
    }
  }
}

// The triangles of faces in the frame.
template <class FaceRange>
std::vector<Triangle_3d> triangles_in(const Unit_frame& frame, const FaceRange& faces,
                                      const Point_array& points)
{
  std::vector<Triangle_3d> triangles;
  const auto at = [&](std::size_t i) { return frame(vector_of(points[i])); };
  for_each_triangle(faces, points.size(), [&](std::size_t i, std::size_t j, std::size_t k) {
    triangles.push_back({at(i), at(j), at(k)});
  });
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
