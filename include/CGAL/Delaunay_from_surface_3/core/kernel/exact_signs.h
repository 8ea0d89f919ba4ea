// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXACT_SIGNS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXACT_SIGNS_H

// The exact stages: signs of the determinants in integers, and CGAL's perturbation where they are 0.
//
// The differences v - p are integers times a power of 2. Where these have few bits (30, 60 or 120,
// see Fixed_integer.h) the signs follow from products of integers of fixed width; what has
// more, and all on machines without integers of 128 bits, from integers of any width. On a lattice
// doubles do for points close together (lattice_sign()).

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Fixed_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Big_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/balanced_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// sign: 1 or -1, perturbed where the determinant is 0; 0 from stages that round and leave it open,
// and where nothing is perturbed.
struct Exact_sign
{
  int sign;
  bool is_perturbed;
  Exact_stage stage;
  bool is_flat = false; // decided by columns
};

inline int sign_of(double number)
{
  return (number > 0) - (number < 0);
}

template <class Place>
bool is_lexicographically_less(Place a, Place b)
{
  return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

// Returns true if two vertices have the same coordinates, and the same weight, if they have any.
template <class Place>
bool are_equal(Place a, Place b)
{
  const double* const p = coordinates_of(a);
  return std::equal(p, p + (is_weighted<Place> ? 4 : 3), coordinates_of(b));
}

// A place without its weight.
template <class Place>
const double* position_of(Place v)
{
  return coordinates_of(v);
}

// CGAL's symbolic perturbation (Devillers, Teillaud 2003): the paraboloid is raised at the
// lexicographically greatest of the points, and so on down. Raising it at a vertex has the sign of
// the vertex's cofactor; raising it at p moves p out. Weights do not matter, since two points at
// one place are on no sphere together unless their weights are equal.
template <int N, class Place, class Sign_of_cofactor>
int perturbed_sign(const Place* vertices, Place p, const Sign_of_cofactor& sign_of)
{
  for (unsigned left = (1u << N) - 1;;) {
    int greatest = -1;
    Place point = p;
    for (int k = 0; k < N; ++k)
      if ((left >> k & 1) && is_lexicographically_less(point, vertices[k])) {
        greatest = k;
        point = vertices[k];
      }
    if (greatest < 0)
      return -1;
    if (const int sign = sign_of(greatest))
      return sign;
    left &= ~(1u << greatest);
  }
}

// How large the differences are. Where distances between the points, or the edges of their box,
// differ by more than `least_share`, the bound of close_sphere_sign() is of little use.
template <int N>
struct Difference_sizes
{
  static constexpr double least_share = 1. / 1024;

  Column_sizes columns;
  double longest, shortest = std::numeric_limits<double>::infinity();

  template <class Place>
  explicit Difference_sizes(const Exact_differences<N, Place>& differences)
  {
    for (int k = 0; k < N; ++k) {
      const double* const d = differences.high + 3 * k;
      const double x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
      columns.add(x, y, z);
      shortest = (std::min)(shortest, (std::max)((std::max)(x, y), z));
    }
    longest = (std::max)((std::max)(columns.x, columns.y), columns.z);
  }

  // Returns true if distances from p or edges differ so, or all are so small that products
  // underflow.
  bool are_unbalanced() const
  {
    constexpr double tiny = 0x1p-170;
    const double least = (std::min)((std::min)(columns.x, columns.y), columns.z);
    return longest < tiny || (std::min)(shortest, least) < least_share * longest;
  }

  // Returns true if distances between the other points do, which is rare and takes longer to find
  // out.
  template <class Place>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART bool
  has_close_pair(const Exact_differences<N, Place>& differences) const
  {
    const double* const d = differences.high;
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < j; ++k) {
        const double *const a = d + 3 * j, *const b = d + 3 * k;
        least = (std::min)(least, Row<double>(a[0] - b[0], a[1] - b[1], a[2] - b[2]).w);
      }
    return least < least_share * least_share * longest * longest;
  }
};

// The stages in numbers that are rounded.
template <int N, class Place>
Exact_sign balanced_sign(const Place* vertices, Place p)
{
  const Balanced_signs<N, Place> signs(vertices, p);
  if (const int sign = signs.template sign<Bounded_doubles>())
    return {sign, false, BALANCED};
  return {signs.in_double_doubles(), false, DOUBLE_DOUBLE};
}

struct Exact_sphere
{
  static constexpr int size = 4;

  template <class Number, class Place>
  static Exact_sign sign(const Row<Number>* r, Exact_stage stage, const Place* vertices, Place p)
  {
    const Sphere_cofactors<Number> cofactors(r[0], r[1], r[2], r[3]);
    if (const int sign = sign_of(cofactors.lifted(r[0], r[1], r[2], r[3])))
      return {sign, false, stage};
    return {perturbed_sign<4>(vertices, p, [&](int k) { return sign_of(cofactors.of[k]); }), true,
            stage};
  }

  template <class Place>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART static Exact_sign
  rounded(const Exact_differences<4, Place>& differences, const Place* vertices, Place p)
  {
    const Difference_sizes<4> sizes(differences);
    if (sizes.columns.are_flat())
      if (const int sign = sphere_sign_by_columns(vertices, p))
        return {sign, false, BALANCED, true};
    if (sizes.are_unbalanced())
      return balanced_sign<4>(vertices, p);
    const int sign = close_sphere_sign(differences);
    if (sign == 0 && sizes.has_close_pair(differences))
      return balanced_sign<4>(vertices, p);
    return {sign, false, DOUBLE_DOUBLE};
  }
};

struct Exact_beyond
{
  static constexpr int size = 3;

  template <class Number, class Place>
  static Exact_sign sign(const Row<Number>* r, Exact_stage stage, const Place* vertices, Place p)
  {
    if (const int height = sign_of(determinant_of(r[0], r[1], r[2])))
      return {-height, false, stage};
    using R = Row<Number>;
    Circle_cofactors<Number> cofactors(r, &R::x, &R::y);
    if (sign_of(cofactors.area) == 0)
      cofactors = {r, &R::y, &R::z};
    if (sign_of(cofactors.area) == 0)
      cofactors = {r, &R::z, &R::x};
    const int area = sign_of(cofactors.area);
    if (const int sign = sign_of(cofactors.lifted(r)))
      return {area * sign, false, stage};
    return {perturbed_sign<3>(vertices, p, [&](int k) { return area * sign_of(cofactors.of[k]); }),
            true, stage};
  }

  template <class Place>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART static Exact_sign
  rounded(const Exact_differences<3, Place>& differences, const Place* vertices, Place p)
  {
    const Difference_sizes<3> sizes(differences);
    if (sizes.columns.are_flat())
      if (const int sign = beyond_sign_by_columns(vertices, p))
        return {sign, false, BALANCED, true};
    if (!sizes.are_unbalanced() && !sizes.has_close_pair(differences)) // two digits are cheap here
      return {0, false, DOUBLE_DOUBLE};
    const Exact_sign height = balanced_sign<3>(vertices, p);
    return {-height.sign, false, height.stage};
  }
};

template <class Determinant, class Place>
Exact_sign wide_sign(const Place* vertices, Place p)
{
  const Big_differences<Determinant::size, Place> differences(vertices, p);
  return Determinant::sign(differences.rows, ANY_WIDTH, vertices, p);
}

// The sphere test of a positively oriented cell, or the test of an infinite cell, given by its three
// finite vertices. Weights that are all equal, as in a lattice of equal balls, are left out.
template <class Determinant, class Place>
Exact_sign exact_sign(const Place* vertices, Place p)
{
  constexpr int n = Determinant::size;
  if constexpr (is_weighted<Place>)
    if (std::all_of(vertices, vertices + n, [p](Place v) { return v.weight() == p.weight(); })) {
      decltype(position_of(p)) unweighted[n];
      std::transform(vertices, vertices + n, unweighted, [](Place v) { return position_of(v); });
      return exact_sign<Determinant>(unweighted, position_of(p));
    }
  const Exact_differences<n, Place> exact_differences(vertices, p);
  if constexpr (is_copy<Place>)
    if (!exact_differences.are_exact)
      return wide_sign<Determinant>(vertices, p);
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER)
  const Integer_differences<n, Place> differences(exact_differences);
  if (!differences.can_be_scaled())
    return wide_sign<Determinant>(vertices, p);
  if (differences.has_one_digit() && differences.has_half_a_digit()) {
    Row<Fixed_integer<1>> rows[n];
    if (differences.set_rows(rows))
      return Determinant::sign(rows, HALF_DIGIT, vertices, p);
  }
  if (differences.has_one_digit()) {
    Row<Fixed_integer<2>> rows[n];
    if (differences.set_rows(rows))
      return Determinant::sign(rows, ONE_DIGIT, vertices, p);
  }
#endif
  if constexpr (!is_copy<Place>) { // whose differences alone are known in doubles
    const Exact_sign rounded = Determinant::rounded(exact_differences, vertices, p);
    if (rounded.sign != 0)
      return rounded;
  }
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER)
  Row<Fixed_integer<4>> rows[n];
  if (differences.set_rows(rows))
    return Determinant::sign(rows, TWO_DIGITS, vertices, p);
#endif
  return wide_sign<Determinant>(vertices, p);
}

// Does the same in doubles, if all coordinates are multiples of a power of 2, g, all weights of g^2, or
// equal, and all rows of a size of at most `most` = 2^19 g^2; else the sign is 0, as it is if `most` is
// 0. Let m be the largest size. Then minors are at most 2 m, those of three columns 6 m^(3/2), and
// determinants, with each sum on the way, 24 m^(5/2) < 2^53 g^5. They are multiples of g^2, g^3 and
// g^5, so nothing is rounded.
template <class Determinant, class Place>
Exact_sign lattice_sign(const Place* vertices, Place p, double most)
{
  Row<double> rows[Determinant::size];
  double largest = 0;
  for (int k = 0; k < Determinant::size; ++k) {
    const auto sized = row(vertices[k], p);
    largest = (std::max)(largest, size_of(sized));
    rows[k] = sized;
  }
  if (most == 0 || !(largest <= most))
    return {0, false, LATTICE};
  return Determinant::sign(rows, LATTICE, vertices, p);
}

// The kernel rarely asks more than its tests of conflict (Compact_predicates.h): orientations and
// distances of points given by their coordinates. Each is asked in doubles first, with a bound
// on the error; integers of fewer bits decide what these leave open, and those of any width the
// rest. The coordinates may be any finite numbers: where products might overflow, or the compiler
// is free to change operations, doubles decide nothing.

// Returns true if products of three numbers up to this one, a squared length, are rounded and
// nothing worse.
inline bool is_safe(double square)
{
  return square < 1e100 && obstacle_of_compiler() == nullptr;
}

// The sign of an integer determinant of differences, whatever their size.
template <class Determinant, class Place>
int exact_sign_of_any(const Place* vertices, Place p)
{
  return (obstacle_of_compiler() == nullptr ? exact_sign<Determinant>(vertices, p)
                                            : wide_sign<Determinant>(vertices, p))
      .sign;
}

// The orientation alone, of rows; never perturbed.
struct Exact_orientation
{
  static constexpr int size = 3;

  template <class Number, class Place>
  static Exact_sign sign(const Row<Number>* r, Exact_stage stage, const Place*, Place)
  {
    return {sign_of(determinant_of(r[0], r[1], r[2])), false, stage};
  }
  static Exact_sign rounded(const Exact_differences<3>&, const double* const*, const double*)
  {
    return {0, false, DOUBLE_DOUBLE};
  }
};

// Tells whether a triangle has an area, 0 if not, from two corners relative to the third.
struct Exact_area
{
  static constexpr int size = 2;

  template <class Number, class Place>
  static Exact_sign sign(const Row<Number>* r, Exact_stage stage, const Place*, Place)
  {
    const Row<Number>&a = r[0], &b = r[1];
    const bool has_area = sign_of(carried(a.x * b.y - a.y * b.x)) != 0 ||
                          sign_of(carried(a.y * b.z - a.z * b.y)) != 0 ||
                          sign_of(carried(a.z * b.x - a.x * b.z)) != 0;
    return {int(has_area), false, stage};
  }
  static Exact_sign rounded(const Exact_differences<2>&, const double* const*, const double*)
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXACT_SIGNS_H
