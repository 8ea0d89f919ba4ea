// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXACT_SIGNS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXACT_SIGNS_H

// The exact stages: signs of the determinants in integers of fixed width, and CGAL's perturbation
// where they are 0.
//
// The differences v - p are exact as sums of two doubles. The power of 2 that brings the largest of
// them just under 2^60 makes all of them integers, unless the least bit of one is more than 60 bits
// below the largest; then the same is tried with 120 bits. Numbers of single precision and lattices
// need fewer than 30 more often than not, at half the price. Nothing is ever rounded away: what does
// not fit is left open.

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Fixed_integer.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/determinants.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// sign: 1 or -1, perturbed where the determinant is 0; 0: not decided.
struct Exact_sign
{
  int sign;
  bool is_perturbed;
  Exact_stage stage;
};

inline bool is_lexicographically_less(const double* a, const double* b)
{
  return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

// CGAL's symbolic perturbation (Devillers, Teillaud 2003): the paraboloid is raised at the
// lexicographically greatest of the points, and so on down. Raising it at a vertex has the sign of the
// vertex's cofactor; raising it at p moves p out.
template <int N, class Sign_of_cofactor>
int perturbed_sign(const double* const* vertices, const double* p, const Sign_of_cofactor& sign_of)
{
  for (unsigned left = (1u << N) - 1;;) {
    int greatest = -1;
    const double* point = p;
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

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER)

inline double power_of_2(std::uint64_t biased_exponent)
{
  const std::uint64_t bits = biased_exponent << 52;
  double power;
  std::memcpy(&power, &bits, sizeof(power));
  return power;
}

// The differences of N vertices and p, times a power of 2, in digits of 60 bits.
template <int N>
class Integer_differences
{
  static constexpr int size = 3 * N;

public:
  // Finds the first digits.
  Integer_differences(const double* const* vertices, const double* p)
  {
    double largest = 0, lost = 0;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k) {
      const double a = vertices[k / 3][k % 3], b = p[k % 3];
      m_rest[k] = a - b; // and what that lost (Knuth 1969)
      const double minus_b = m_rest[k] - a;
      m_lost[k] = (a - (m_rest[k] - minus_b)) - (b + minus_b);
      largest = (std::max)(largest, std::abs(m_rest[k]));
      lost += std::abs(m_lost[k]);
    }
    std::uint64_t exponent;
    std::memcpy(&exponent, &largest, sizeof(largest));
    exponent >>= 52; // the largest is less than 2^(exponent - 1022)
    m_can_be_scaled = exponent > digit_bits && exponent < 1023 + digit_bits;
    if (m_can_be_scaled)
      set_first_digits(power_of_2(2 * 1023 - 1 + digit_bits - exponent), lost != 0);
  }

  // Whether the first digits are defined: not where numbers are so small that the power would overflow.
  bool can_be_scaled() const { return m_can_be_scaled; }
  // Whether one digit is enough, and, if so, whether its upper half is.
  bool has_one_digit() const { return m_has_one_digit; }
  bool has_half_a_digit() const
  {
    std::int64_t any = 0;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k)
      any |= m_first[k];
    return (any & ((std::int64_t(1) << digit_bits / 2) - 1)) == 0;
  }

  // Rows of the first digits.
  void set_rows(Row<Fixed_integer<2>>* rows) const
  {
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      rows[k] = {{{m_first[3 * k]}}, {{m_first[3 * k + 1]}}, {{m_first[3 * k + 2]}}};
  }

  // Rows of their upper halves.
  void set_rows(Row<Fixed_integer<1>>* rows) const
  {
    constexpr int half = digit_bits / 2;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      rows[k] = {{{m_first[3 * k] >> half}},
                 {{m_first[3 * k + 1] >> half}},
                 {{m_first[3 * k + 2] >> half}}};
  }

  // Rows of two digits. Returns whether these are enough.
  bool set_rows(Row<Fixed_integer<4>>* rows) const
  {
    Fixed_integer<4> d[size];
    bool is_exact = true;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k) {
      std::int64_t second = 0;
      for (const double rest : {m_rest[k] * digit_base, m_lost[k] * digit_base}) {
        const std::int64_t digit = static_cast<std::int64_t>(rest);
        is_exact &= static_cast<double>(digit) == rest;
        second += digit;
      }
      d[k] = {{second, m_first[k]}};
    }
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      rows[k] = {d[3 * k], d[3 * k + 1], d[3 * k + 2]};
    return is_exact;
  }

private:
  static constexpr double digit_base = 1152921504606846976.; // 2^60

  void set_first_digits(double scale, bool is_any_lost)
  {
    double rests = 0;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k) {
      m_first[k] = take_digit(m_rest[k], scale);
      rests += std::abs(m_rest[k]);
    }
    if (is_any_lost)
      for (int k = 0; k < size; ++k) {
        m_first[k] += take_digit(m_lost[k], scale);
        rests += std::abs(m_lost[k]);
      }
    m_has_one_digit = rests == 0;
  }

  // Leaves in d what is behind the point.
  static std::int64_t take_digit(double& d, double scale)
  {
    d *= scale;
    const std::int64_t digit = static_cast<std::int64_t>(d);
    d -= static_cast<double>(digit);
    return digit;
  }

  double m_rest[size], m_lost[size];
  std::int64_t m_first[size];
  bool m_can_be_scaled, m_has_one_digit = false;
};

struct Exact_sphere
{
  static constexpr int size = 4;

  template <int Halves>
  static Exact_sign sign(const Row<Fixed_integer<Halves>>* r, Exact_stage stage,
                         const double* const* vertices, const double* p)
  {
    const Sphere_cofactors<Fixed_integer<Halves>> cofactors(r[0], r[1], r[2], r[3]);
    if (const int sign = sign_of(cofactors.lifted(r[0], r[1], r[2], r[3])))
      return {sign, false, stage};
    return {perturbed_sign<4>(vertices, p, [&](int k) { return sign_of(cofactors.of[k]); }), true,
            stage};
  }

  static int filtered_sign(const double* const* vertices, const double* p, bool is_fused)
  {
    return is_fused ? fused_close_sphere_sign(vertices, p) : close_sphere_sign(vertices, p);
  }
};

struct Exact_beyond
{
  static constexpr int size = 3;

  template <int Halves>
  static Exact_sign sign(const Row<Fixed_integer<Halves>>* r, Exact_stage stage,
                         const double* const* vertices, const double* p)
  {
    if (const int height = sign_of(determinant_of(r[0], r[1], r[2])))
      return {-height, false, stage};
    using R = Row<Fixed_integer<Halves>>;
    Circle_cofactors<Fixed_integer<Halves>> cofactors(r, &R::x, &R::y);
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

  // Two digits are cheap here.
  static int filtered_sign(const double* const*, const double*, bool) { return 0; }
};

template <class Determinant>
Exact_sign exact_sign(const double* const* vertices, const double* p, bool is_fused)
{
  constexpr int n = Determinant::size;
  const Integer_differences<n> differences(vertices, p);
  if (!differences.can_be_scaled())
    return {0, false, KERNEL};
  if (differences.has_one_digit() && differences.has_half_a_digit()) {
    Row<Fixed_integer<1>> rows[n];
    differences.set_rows(rows);
    return Determinant::sign(rows, HALF_DIGIT, vertices, p);
  }
  if (differences.has_one_digit()) {
    Row<Fixed_integer<2>> rows[n];
    differences.set_rows(rows);
    return Determinant::sign(rows, ONE_DIGIT, vertices, p);
  }
  if (const int sign = Determinant::filtered_sign(vertices, p, is_fused))
    return {sign, false, DOUBLE_DOUBLE};
  Row<Fixed_integer<4>> rows[n];
  if (!differences.set_rows(rows))
    return {0, false, KERNEL};
  return Determinant::sign(rows, TWO_DIGITS, vertices, p);
}

// Of a positively oriented cell.
inline Exact_sign exact_sphere_sign(const double* const* vertices, const double* p, bool is_fused)
{
  return exact_sign<Exact_sphere>(vertices, p, is_fused);
}

// Of an infinite cell, given by its three finite vertices.
inline Exact_sign exact_beyond_sign(const double* const* vertices, const double* p)
{
  return exact_sign<Exact_beyond>(vertices, p, false);
}

#else

inline Exact_sign exact_sphere_sign(const double* const* vertices, const double* p, bool is_fused)
{
  const int sign = is_fused ? fused_close_sphere_sign(vertices, p) : close_sphere_sign(vertices, p);
  return {sign, false, sign != 0 ? DOUBLE_DOUBLE : KERNEL};
}

inline Exact_sign exact_beyond_sign(const double* const*, const double*)
{
  return {0, false, KERNEL};
}

#endif

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXACT_SIGNS_H
