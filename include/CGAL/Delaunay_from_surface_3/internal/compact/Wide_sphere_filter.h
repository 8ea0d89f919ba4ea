// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_WIDE_SPHERE_FILTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_WIDE_SPHERE_FILTER_H

// Sphere_filter.h in vectors of four doubles: one lane per facet of the cell. The other three
// vertices of lane i are i^1, i^2 and i^3: an even permutation, and three cheap shuffles.
//
// Only code marked with its target uses the wide instructions, so that the user need not compile
// for them; the caller asks the machine first. The target has no fma.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Sphere_filter.h>

#include <CGAL/Delaunay_from_surface_3/internal/support/vectors.h>

#include <algorithm>

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// A coordinate of the four rows, and the three permutations of it.
struct Wide_column
{
  __m256d v, a, b, c;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS explicit Wide_column(__m256d value)
    : v(value)
    , a(_mm256_permute_pd(value, 5))
    , b(_mm256_permute2f128_pd(value, value, 1))
    , c(_mm256_permute_pd(b, 5))
  {
  }
};

// (x, y, z) - p of four points, by coordinate, and the squared lengths.
struct Wide_rows
{
  __m256d x, y, z, w;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Wide_rows(const double* const* points,
                                                           const double* p)
  {
    const __m256d r0 = _mm256_loadu_pd(points[0]), r1 = _mm256_loadu_pd(points[1]);
    const __m256d r2 = _mm256_loadu_pd(points[2]), r3 = _mm256_loadu_pd(points[3]);
    const __m256d xz01 = _mm256_unpacklo_pd(r0, r1), xz23 = _mm256_unpacklo_pd(r2, r3);
    const __m256d y01 = _mm256_unpackhi_pd(r0, r1), y23 = _mm256_unpackhi_pd(r2, r3);
    x = _mm256_sub_pd(_mm256_permute2f128_pd(xz01, xz23, 0x20), _mm256_broadcast_sd(p));
    y = _mm256_sub_pd(_mm256_permute2f128_pd(y01, y23, 0x20), _mm256_broadcast_sd(p + 1));
    z = _mm256_sub_pd(_mm256_permute2f128_pd(xz01, xz23, 0x31), _mm256_broadcast_sd(p + 2));
    w = _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(x, x), _mm256_mul_pd(y, y)), _mm256_mul_pd(z, z));
  }
};

// The minors of two columns, and what a third makes of them.
struct Wide_minors
{
  __m256d bc, ca, ab;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Wide_minors(const Wide_column& r,
                                                             const Wide_column& s)
    : bc(_mm256_sub_pd(_mm256_mul_pd(r.b, s.c), _mm256_mul_pd(s.b, r.c)))
    , ca(_mm256_sub_pd(_mm256_mul_pd(r.c, s.a), _mm256_mul_pd(s.c, r.a)))
    , ab(_mm256_sub_pd(_mm256_mul_pd(r.a, s.b), _mm256_mul_pd(s.a, r.b)))
  {
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS __m256d times(const Wide_column& t) const
  {
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(t.a, bc), _mm256_mul_pd(t.b, ca)),
                         _mm256_mul_pd(t.c, ab));
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
    const __m256d value = _mm256_add_pd(
        _mm256_sub_pd(_mm256_mul_pd(e.x, zw.times(y)), _mm256_mul_pd(e.y, zw.times(x))),
        _mm256_sub_pd(_mm256_mul_pd(e.z, xy.times(w)), _mm256_mul_pd(e.w, xy.times(z))));
    const __m256d m = _mm256_max_pd(_mm256_max_pd(e.w, w.a), _mm256_max_pd(w.b, w.c));
    const __m256d m52 = _mm256_mul_pd(_mm256_mul_pd(m, m), _mm256_sqrt_pd(m));
    const __m256d bound =
        _mm256_add_pd(_mm256_mul_pd(m52, _mm256_set1_pd(80 * Filter_bounds::unit)),
                      _mm256_set1_pd(Filter_bounds::tiny));
    const __m256d minus = _mm256_sub_pd(_mm256_setzero_pd(), bound);
    return {unsigned(_mm256_movemask_pd(_mm256_cmp_pd(value, bound, _CMP_GT_OQ))),
            unsigned(_mm256_movemask_pd(_mm256_cmp_pd(value, minus, _CMP_LT_OQ)))};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Cell_view view(const double* const* vertices,
                                                                const double* p)
  {
    const Wide_rows rows(vertices, p);
    const Wide_column x(rows.x), y(rows.y), z(rows.z);
    const __m256d facets = Wide_minors(x, y).times(z);
    const __m256d products = _mm256_mul_pd(facets, rows.w);
    Cell_view view;
    double value[4], w[4];
    _mm256_storeu_pd(view.facets, facets);
    _mm256_storeu_pd(value, products);
    _mm256_storeu_pd(w, rows.w);
    const double m = (std::max)((std::max)(w[0], w[1]), (std::max)(w[2], w[3]));
    view.sphere =
        certified_sign((value[0] + value[1]) + (value[2] + value[3]), Filter_bounds::four_rows(m));
    view.facet_bound = Filter_bounds::three_rows(m);
    return view;
  }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_WIDE_SPHERE_FILTER_H
