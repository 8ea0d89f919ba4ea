// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_SPHERE_FILTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_SPHERE_FILTER_H

// Sphere_filter.h in vectors of four doubles: one lane per facet of the cell. The other three
// vertices of lane i are i^1, i^2 and i^3: an even permutation, and three cheap shuffles.
//
// Only code marked with its target uses the wide instructions, so that the user need not compile
// for them; the caller asks the machine first. The target has no fma.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <algorithm>

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

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

// The largest of each column in absolute value, with e in the place of the lane's own row.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Four_doubles largest_of(const Wide_column& column,
                                                                       Four_doubles e)
{
  return max_of(max_of(max_of(e, -e), max_of(column.a, -column.a)),
                max_of(max_of(column.b, -column.b), max_of(column.c, -column.c)));
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

// Four sphere tests: the rows, and the determinants.
struct Wide_sphere_test
{
  Wide_rows e;
  Wide_column x, y, z, w;
  Four_doubles value, largest_w;

  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS
  Wide_sphere_test(const Wide_rows& rows, const Wide_rows& opposite)
    : e(opposite)
    , x(rows.x)
    , y(rows.y)
    , z(rows.z)
    , w(rows.w)
  {
    const Wide_minors xy(x, y), zw(z, w);
    value = (e.x * zw.times(y) - e.y * zw.times(x)) + (e.z * xy.times(w) - e.w * xy.times(z));
    largest_w = max_of(max_of(e.w, w.a), max_of(w.b, w.c));
  }
};

struct Wide_sphere_filter
{
  // signs() asks the bound by rows alone.
  static constexpr bool leaves_flat_cells_open = true;

  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Sphere_signs
  signs(const double* const* vertices, const double* const* opposite, const double* p)
  {
    const Wide_sphere_test test(Wide_rows(vertices, p), Wide_rows(opposite, p));
    const Four_doubles m = test.largest_w;
    return signs_of(test.value,
                    m * m * sqrt_of(m) * (80 * Filter_bounds::unit) + Filter_bounds::tiny);
  }

  // The same by the bound by columns.
  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Sphere_signs
  flat_signs(const double* const* vertices, const double* const* opposite, const double* p)
  {
    const Wide_sphere_test test(Wide_rows(vertices, p), Wide_rows(opposite, p));
    const Four_doubles xy = largest_of(test.x, test.e.x) * largest_of(test.y, test.e.y),
                       zw = largest_of(test.z, test.e.z) * test.largest_w;
    return signs_of(test.value,
                    xy * zw * (Column_sizes::four * unit_of_double) + Column_sizes::tiny);
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

private:
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Sphere_signs signs_of(Four_doubles value,
                                                                              Four_doubles bound)
  {
    return {bits_of(value > bound), bits_of(value < -bound)};
  }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_SPHERE_FILTER_H
