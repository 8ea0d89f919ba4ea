// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_SPHERE_FILTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_SPHERE_FILTER_H

// Sphere_filter.h in vectors of four doubles: one lane per facet of the cell. The other three
// vertices of lane i are i^1, i^2 and i^3: an even permutation, and three cheap shuffles.
//
// Only code marked with its target uses the wide instructions, so that the user need not compile
// for them; the caller asks the machine first.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Column_sizes.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <algorithm>

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A coordinate of the four rows, and the three permutations of it.
struct Wide_column
{
  Four_doubles v, a, b, c;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS explicit Wide_column(Four_doubles value)
    : v(value)
    , a(lanes_of<1, 0, 3, 2>(value))
    , b(lanes_of<2, 3, 0, 1>(value))
    , c(lanes_of<1, 0, 3, 2>(b))
  {
  }
};

// The largest absolute value of a lane.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS double largest_of(Four_doubles v)
{
  const Four_doubles size = max_of(v, -v), two = max_of(size, lanes_of<2, 3, 0, 1>(size));
  return (std::max)(two[0], two[1]);
}

// (x, y, z) - p of four points, by coordinate, and the squared lengths.
struct Wide_rows
{
  Four_doubles x, y, z, w;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Wide_rows(const double* const* points,
                                                           const double* p)
  {
    const Four_doubles r0 = load_four(points[0]), r1 = load_four(points[1]);
    const Four_doubles r2 = load_four(points[2]), r3 = load_four(points[3]);
    const Four_doubles xz01 = lanes_of<0, 4, 2, 6>(r0, r1), xz23 = lanes_of<0, 4, 2, 6>(r2, r3);
    const Four_doubles y01 = lanes_of<1, 5, 3, 7>(r0, r1), y23 = lanes_of<1, 5, 3, 7>(r2, r3);
    x = lanes_of<0, 1, 4, 5>(xz01, xz23) - p[0];
    y = lanes_of<0, 1, 4, 5>(y01, y23) - p[1];
    z = lanes_of<2, 3, 6, 7>(xz01, xz23) - p[2];
    w = x * x + y * y + z * z;
  }
};

// The minors of two columns, and what a third makes of them.
struct Wide_minors
{
  Four_doubles bc, ca, ab;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Wide_minors(const Wide_column& r,
                                                             const Wide_column& s)
    : bc(r.b * s.c - s.b * r.c)
    , ca(r.c * s.a - s.c * r.a)
    , ab(r.a * s.b - s.a * r.b)
  {
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Four_doubles times(const Wide_column& t) const
  {
    return t.a * bc + t.b * ca + t.c * ab;
  }
};

struct Wide_sphere_filter
{
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Sphere_signs
  signs(const double* const* vertices, const double* const* opposite, const double* p)
  {
    const Wide_rows rows(vertices, p), e(opposite, p);
    const Wide_column x(rows.x), y(rows.y), z(rows.z), w(rows.w);
    const Wide_minors xy(x, y), zw(z, w);
    const Four_doubles value =
        (e.x * zw.times(y) - e.y * zw.times(x)) + (e.z * xy.times(w) - e.w * xy.times(z));
    const Four_doubles m = max_of(max_of(e.w, w.a), max_of(w.b, w.c));
    const Four_doubles bound =
        m * m * sqrt_of(m) * (80 * Filter_bounds::unit) + Filter_bounds::tiny;
    return {bits_of(value > bound), bits_of(value < -bound)};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Cell_view view(const double* const* vertices,
                                                                const double* p)
  {
    const Wide_rows rows(vertices, p);
    const Wide_column x(rows.x), y(rows.y), z(rows.z);
    const Four_doubles facets = Wide_minors(x, y).times(z);
    Cell_view view;
    double value[4], w[4];
    store_four(view.facets, facets);
    const Four_doubles lifted = facets * rows.w;
    store_four(value, lifted);
    store_four(view.pushes, lifted * rows.w);
    store_four(w, rows.w);
    const double m = (std::max)((std::max)(w[0], w[1]), (std::max)(w[2], w[3]));
    view.sphere =
        certified_sign((value[0] + value[1]) + (value[2] + value[3]), Filter_bounds::four_rows(m));
    view.facet_bound = Filter_bounds::three_rows(m);
    return view;
  }
};

// sphere_sign_by_columns() in vectors.
CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS inline int
wide_sphere_sign_by_columns(const double* const* vertices, const double* p)
{
  const Wide_rows rows(vertices, p);
  const Wide_column x(rows.x), y(rows.y), z(rows.z);
  const Four_doubles value = Wide_minors(x, y).times(z) * rows.w;
  Column_sizes sizes;
  sizes.add(largest_of(rows.x), largest_of(rows.y), largest_of(rows.z));
  return certified_sign((value[0] + value[1]) + (value[2] + value[3]),
                        sizes.bound_of_four(largest_of(rows.w)));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_SPHERE_FILTER_H
