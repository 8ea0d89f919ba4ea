// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXACT_PREDICATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXACT_PREDICATES_H

// What the kernel rarely asks besides its tests of conflict (Compact_predicates.h): orientations
// and distances of points given by their coordinates. Each is asked in doubles first, with a bound
// on the error; integers of fewer bits decide what these leave open, and those of any width the
// rest. The coordinates may be any finite numbers: where products might overflow, or the compiler
// is free to change operations, doubles decide nothing.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Wide_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether products of three numbers up to this one, a squared length, are rounded and nothing
// worse.
inline bool is_safe(double square)
{
  return square < 1e100 && obstacle_of_compiler() == nullptr;
}

// The sign of an integer determinant of differences, whatever their size.
template <class Determinant>
int exact_sign_of_any(const double* const* vertices, const double* p)
{
  return (obstacle_of_compiler() == nullptr ? exact_sign<Determinant>(vertices, p, false)
                                            : wide_sign<Determinant>(vertices, p))
      .sign;
}

// The orientation alone, of rows; never perturbed.
struct Exact_orientation
{
  static constexpr int size = 3;

  template <class Number>
  static Exact_sign sign(const Row<Number>* r, Exact_stage stage, const double* const*,
                         const double*)
  {
    return {sign_of(determinant_of(r[0], r[1], r[2])), false, stage};
  }
  static Exact_sign rounded(const Exact_differences<3>&, const double* const*, const double*, bool)
  {
    return {0, false, DOUBLE_DOUBLE};
  }
};

// Whether a triangle has an area: 0 if not. Of the rows of two corners relative to the third.
struct Exact_area
{
  static constexpr int size = 2;

  template <class Number>
  static Exact_sign sign(const Row<Number>* r, Exact_stage stage, const double* const*,
                         const double*)
  {
    const Row<Number>&a = r[0], &b = r[1];
    const bool has_area = sign_of(carried(a.x * b.y - a.y * b.x)) != 0 ||
                          sign_of(carried(a.y * b.z - a.z * b.y)) != 0 ||
                          sign_of(carried(a.z * b.x - a.x * b.z)) != 0;
    return {int(has_area), false, stage};
  }
  static Exact_sign rounded(const Exact_differences<2>&, const double* const*, const double*, bool)
  {
    return {0, false, DOUBLE_DOUBLE};
  }
};

// 1 if the cell (a, b, c, d) is positively oriented, -1 if negatively, 0 if the points lie in one
// plane.
inline int orientation(const double* a, const double* b, const double* c, const double* d)
{
  const double* const vertices[3] = {b, c, d};
  const Row<double> rows[3] = {row(b, a), row(c, a), row(d, a)};
  const double m = largest_square(rows[0], rows[1], rows[2]);
  const int sign = is_safe(m) ? certified_sign(determinant_of(rows[0], rows[1], rows[2]),
                                               Filter_bounds::three_rows(m))
                              : 0;
  return sign != 0 ? sign : exact_sign_of_any<Exact_orientation>(vertices, a);
}

inline bool are_collinear(const double* a, const double* b, const double* c)
{
  // A minor is a difference of two products, with two roundings in the factors of each, and two
  // more: less than 8 u m where m bounds the squared lengths.
  const Row<double> s = row(b, a), t = row(c, a);
  const double m = (std::max)(s.w, t.w);
  const double bound = 8 * Filter_bounds::unit * m + Filter_bounds::tiny;
  if (is_safe(m) && (certified_sign(s.x * t.y - s.y * t.x, bound) != 0 ||
                     certified_sign(s.y * t.z - s.z * t.y, bound) != 0 ||
                     certified_sign(s.z * t.x - s.x * t.z, bound) != 0))
    return false;
  const double* const vertices[2] = {b, c};
  return exact_sign_of_any<Exact_area>(vertices, a) == 0;
}

// -1 if a is nearer to p than b, 1 if it is farther.
inline int compare_distance(const double* p, const double* a, const double* b)
{
  // A sum of three squares of differences: 5 roundings, and what is lost where squares underflow.
  const double v = row(a, p).w, w = row(b, p).w;
  const double bound = 8 * Filter_bounds::unit * (v + w) + Filter_bounds::tiny;
  const int sign = is_safe(v + w) ? certified_sign(v - w, bound) : 0;
  if (sign != 0)
    return sign;
  const double* const vertices[2] = {a, b};
  const Wide_differences<2> differences(vertices, p);
  return sign_of(differences.rows[0].w - differences.rows[1].w);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXACT_PREDICATES_H
