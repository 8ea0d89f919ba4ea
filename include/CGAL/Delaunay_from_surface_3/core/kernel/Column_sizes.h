// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COLUMN_SIZES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COLUMN_SIZES_H

// Another bound on the error of the determinants of Sphere_filter.h: by columns. It is the
// smaller one where a coordinate differs much less than another: sheets that are nearly flat and
// parallel to two axes, wires along one.
//
// A determinant of 4 rows is a sum of 24 products x y z w of at most 17 roundings each (see
// Sphere_filter.h). Let X, Y, Z, W be the largest of the columns in absolute value, as computed:
// with 3 + 5 roundings. Then the error is at most 24 ((1 + u)^17 - 1) (1 - u)^-8 X Y Z W < 409 u X
// Y Z W; the bound has 4 roundings of its own: 450 u X Y Z W is on the safe side. Of 3 rows it is 6
// products of at most 8 roundings: less than 55 u X Y Z.
//
// Coordinates are at most 2^58 in absolute value, so differences are at most 2^59 and w at most 3
// 2^118. What underflows, 2^-1075 each time and less than 2^7 times, meets factors of less than
// 2^181: less than `tiny` altogether. Where coordinates themselves were rounded, by at most 2^-1075
// (Compact_complex.h), that is nothing beside columns of at least `least`.

#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

constexpr double unit_of_double = 1. / 9007199254740992.; // 2^-53

struct Column_sizes
{
  static constexpr double tiny = 1e-264; // more than 2^-880
  static constexpr double least = 0x1p-1000;
  static constexpr double four = 450, three = 55;

  double x = least, y = least, z = least;

  template <class... Rows>
  explicit Column_sizes(const Rows&... rows)
  {
    (add(rows), ...);
  }

  // Whether the box with these edges is so flat that these bounds decide much that the others do
  // not.
  bool are_flat() const
  {
    const double m = (std::max)((std::max)(x, y), z);
    return x * y * z < 0x1p-20 * (m * m * m);
  }

  void add(const Row<double>& r) { add(std::abs(r.x), std::abs(r.y), std::abs(r.z)); }
  void add(double dx, double dy, double dz) // none negative
  {
    x = (std::max)(x, dx);
    y = (std::max)(y, dy);
    z = (std::max)(z, dz);
  }

  // w: at least the largest in that column.
  double bound_of_four(double w) const
  {
    return four * unit_of_double * ((x * y) * (z * w)) + tiny;
  }
  double bound_of_three() const { return three * unit_of_double * (x * y * z) + tiny; }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COLUMN_SIZES_H
