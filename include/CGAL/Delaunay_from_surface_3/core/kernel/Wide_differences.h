// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_DIFFERENCES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_DIFFERENCES_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Wide_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The differences of N vertices and p, row by row, divided by the greatest power of 2, 2^unit, that
// leaves them integers. Any finite doubles will do.
template <int N>
struct Wide_differences
{
  Row<Wide_integer> rows[N];
  int unit;

  Wide_differences(const double* const* vertices, const double* p)
    : unit(unit_of(p))
  {
    for (int k = 0; k < N; ++k)
      unit = (std::min)(unit, unit_of(vertices[k]));
    const Wide_integer x(p[0], unit), y(p[1], unit), z(p[2], unit);
    for (int k = 0; k < N; ++k) {
      const double* const v = vertices[k];
      rows[k] = {Wide_integer(v[0], unit) - x, Wide_integer(v[1], unit) - y,
                 Wide_integer(v[2], unit) - z};
    }
  }

private:
  static int unit_of(const double* p)
  {
    int unit = std::numeric_limits<double>::max_exponent; // of 0
    for (int k = 0; k < 3; ++k)
      if (p[k] != 0)
        unit = (std::min)(unit, Bits_of_double(p[k]).exponent);
    return unit;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_DIFFERENCES_H
