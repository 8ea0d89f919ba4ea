// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_APEX_OF_PLANE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_APEX_OF_PLANE_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A point off the plane of a, b and c, which are not collinear: a, moved by about the size of the
// triangle, along the axis to which the plane seems most nearly orthogonal.
inline std::array<double, 3> apex_of_plane(const double* a, const double* b, const double* c)
{
  std::array<double, 3> areas; // across the axes, rounded: any that is not 0 exactly will do
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t s = (k + 1) % 3, t = (k + 2) % 3;
    const double p[3] = {a[s], a[t], 0}, q[3] = {b[s], b[t], 0}, r[3] = {c[s], c[t], 0};
    const Row<double> u = row(q, p), v = row(r, p);
    const double area = std::abs(u.x * v.y - u.y * v.x);
    areas[k] = are_collinear(p, q, r) ? -1 : area >= 0 ? area : 0; // NaN if it overflows
    size = (std::max)({size, std::abs(b[k] / 2 - a[k] / 2), std::abs(c[k] / 2 - a[k] / 2)});
  }
  std::array<double, 3> apex = {a[0], a[1], a[2]};
  double& x = apex[std::size_t(std::max_element(areas.begin(), areas.end()) - areas.begin())];
  const double moved = x < 0 ? x + size : x - size; // towards 0: it stays finite
  x = moved != x ? moved : x != 0 ? x / 2 : 1;
  return apex;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_APEX_OF_PLANE_H
