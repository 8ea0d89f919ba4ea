// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FLAT_BEYOND_SIGN_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FLAT_BEYOND_SIGN_H

// The flat sides of parts are parallel to the axes more often than not, and have a great many
// points. There the test against an infinite cell is that against a circle in a plane, in two
// coordinates.
//
// A determinant of rows (s, t, w) is a sum of 6 products s t w; each goes through at most 11
// roundings, 1 + 1 + 4 of them in its factors. Where m bounds all w the products sum up to at most
// 3 m^2 in absolute value, so the error is at most 33 u m^2, and a bit: less than 40 u m^2 with
// u = 2^-53. In the same way that of the area is less than 20 u m.
//
// Where that leaves something open in a thin box, there are the bounds by columns: with S, T and W
// their largest, 66 u S T W and a bit, less than 80 u S T W; the area has 6 products of 6
// roundings, less than 40 u S T. Underflow: as in Sphere_filter.h and Column_sizes.h.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Column_sizes.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The axis to which the plane of p and three vertices is orthogonal; 3 if there is none.
inline int axis_across(const double* const* vertices, const double* p)
{
  int axis = 0;
  while (axis < 3 && !(vertices[0][axis] == p[axis] && vertices[1][axis] == p[axis] &&
                       vertices[2][axis] == p[axis]))
    ++axis;
  return axis;
}

inline constexpr double Row<double>::*columns_of_row[3] = {&Row<double>::x, &Row<double>::y,
                                                           &Row<double>::z};

// Where the points lie in a long and thin box.
CGAL_DELAUNAY_FROM_SURFACE_3_APART int circle_sign_by_columns(const double* const* vertices,
                                                              const double* p, int axis)
{
  const Row<double> rows[3] = {row(vertices[0], p), row(vertices[1], p), row(vertices[2], p)};
  const Column_sizes sizes(rows[0], rows[1], rows[2]);
  const double edges[3] = {sizes.x, sizes.y, sizes.z};
  const double box = edges[(axis + 1) % 3] * edges[(axis + 2) % 3];
  const double m = largest_square(rows[0], rows[1], rows[2]);
  if (box > 0x1p-10 * m)
    return 0;
  const Circle_cofactors<double> cofactors(rows, columns_of_row[(axis + 1) % 3],
                                           columns_of_row[(axis + 2) % 3]);
  return certified_sign(cofactors.area, 40 * Filter_bounds::unit * box + Column_sizes::tiny) *
         certified_sign(cofactors.lifted(rows),
                        80 * Filter_bounds::unit * box * m + Column_sizes::tiny);
}

// If p and the facet (a, b, c) of the convex hull lie in a plane orthogonal to an axis: 1 if p is
// inside the facet's circle, -1 if it is outside. 0: not decided.
inline int flat_beyond_sign(const double* const* vertices, const double* p)
{
  const int axis = axis_across(vertices, p);
  if (axis == 3)
    return 0;
  const Row<double> rows[3] = {row(vertices[0], p), row(vertices[1], p), row(vertices[2], p)};
  const Circle_cofactors<double> cofactors(rows, columns_of_row[(axis + 1) % 3],
                                           columns_of_row[(axis + 2) % 3]);
  const double m = largest_square(rows[0], rows[1], rows[2]), value = cofactors.lifted(rows);
  const int sign =
      certified_sign(cofactors.area, 20 * Filter_bounds::unit * m + Filter_bounds::tiny) *
      certified_sign(value, 40 * Filter_bounds::unit * m * m + Filter_bounds::tiny);
  return sign != 0 || value == 0 ? sign : circle_sign_by_columns(vertices, p, axis);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FLAT_BEYOND_SIGN_H
