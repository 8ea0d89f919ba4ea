// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H

// The faces of a soup as triangles in a box of size 1, and their winding numbers.

#include <CGAL/Delaunay_from_surface_3/core/order/soup_edges.h>
#include <CGAL/Delaunay_from_surface_3/inside/Box_3d.h>
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

// Calls visit(i, j, k, f) with the points of the triangles of faces, f = 0, 1, …; a polygon is a fan
// at its first point. Throws Surface_input_error if a face has an index that is not less than n.
template <class FaceRange, class Visit>
void for_each_triangle(const FaceRange& faces, std::size_t n, const Visit& visit)
{
  std::size_t f = 0;
  for (const auto& face : faces) {
    check_face(face, f, n);
    std::array<std::size_t, 3> triangle = {0, 0, 0};
    std::size_t k = 0;
    for (const auto& index : face) {
      triangle[k < 2 ? k : 2] = std::size_t(index);
      if (++k > 2) {
        visit(triangle[0], triangle[1], triangle[2], f);
        triangle[1] = triangle[2];
      }
    }
    ++f;
  }
}

// The frame of the points of the triangles of faces: others must not make these small. A triangle
// that has a point twice adds nothing, nor do its points.
template <class FaceRange>
Unit_frame frame_of(const FaceRange& faces, const Point_array& points)
{
  Box_3d box;
  for_each_triangle(
      faces, points.size(), [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
        const Triangle_3d t = {vector_of(points[i]), vector_of(points[j]), vector_of(points[k])};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
          for (const Vector_3d& p : t)
            box.add(p);
      });
  return Unit_frame(box);
}

// Throws Surface_input_error if a face has an index out of range.
template <class FaceRange>
Winding_field winding_field(const Point_array& points, const FaceRange& faces)
{
  const Unit_frame frame = frame_of(faces, points);
  std::vector<Triangle_3d> triangles;
  const auto at = [&](std::size_t i) { return frame(vector_of(points[i])); };
  for_each_triangle(faces, points.size(),
                    [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
                      triangles.push_back({at(i), at(j), at(k)});
                    });
  return {frame, Winding_tree(std::move(triangles))};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H
