// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INTEGER_DIFFERENCES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INTEGER_DIFFERENCES_H

// The differences v - p are exact as sums of two doubles. The power of 2 that brings the largest of
// them just under 2^60 makes all of them integers, unless the least bit of one is more than 60 bits
// below the largest; then the same is tried with 120 bits. Numbers of single precision and lattices
// need fewer than 30 more often than not, at half the price. Nothing is ever rounded away: what
// does not fit is left open. That 60 bits are not enough shows most often in the lower parts of the
// sums, before any digit is computed.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Fixed_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/powers_of_2.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER)

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The differences of N vertices and p, times a power of 2, in digits of 60 bits.
template <int N>
class Integer_differences
{
  static constexpr int size = 3 * N;

public:
  // Finds the first digits if one may be enough. Keeps a reference.
  explicit Integer_differences(const Exact_differences<N>& differences)
    : m_differences(differences)
  {
    double largest = 0;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k)
      largest = (std::max)(largest, std::abs(differences.high[k]));
    const std::uint64_t exponent = biased_exponent(largest);
    m_can_be_scaled = exponent > digit_bits && exponent < 1023 + digit_bits;
    if (!m_can_be_scaled)
      return;
    m_scale = power_of_2(2 * 1023 - 1 + digit_bits - exponent);
    const double unit = power_of_2(exponent + 1 - digit_bits);
    double rests[size];
    for (int k = 0; k < size; ++k)
      rests[k] = differences.low[k] - rounded(differences.low[k], unit);
    if (are_zero(rests))
      set_first_digits(!are_zero(differences.low));
  }

  // Whether the numbers are not so small that the power would overflow, nor so large that it would
  // be less than 1: then the least of them could be lost.
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

  // Rows of one digit, where it is enough.
  void set_rows(Row<Fixed_integer<2>>* rows) const
  {
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      rows[k] = {{{m_first[3 * k]}}, {{m_first[3 * k + 1]}}, {{m_first[3 * k + 2]}}};
  }

  // Rows of its upper half, where that is enough.
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
      std::int64_t first = 0, second = 0;
      for (double rest : {m_differences.high[k] * m_scale, m_differences.low[k] * m_scale}) {
        first += take_digit(rest);
        rest *= digit_base;
        second += take_digit(rest);
        is_exact &= rest == 0;
      }
      d[k] = {{second, first}};
    }
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      rows[k] = {d[3 * k], d[3 * k + 1], d[3 * k + 2]};
    return is_exact;
  }

private:
  static constexpr double digit_base = 1152921504606846976.; // 2^60

  // To a multiple of the unit, for numbers of less than 2^51 of them.
  static double rounded(double d, double unit)
  {
    const double power = 6755399441055744. * unit; // 3 2^51: all doubles near it are multiples
    return (d + power) - power;
  }

  void set_first_digits(bool has_lows)
  {
    double rests[size];
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k) {
      rests[k] = m_differences.high[k] * m_scale;
      m_first[k] = take_digit(rests[k]);
    }
    if (has_lows)
      for (int k = 0; k < size; ++k)
        m_first[k] += static_cast<std::int64_t>(m_differences.low[k] * m_scale);
    m_has_one_digit = are_zero(rests);
  }

  static bool are_zero(const double (&numbers)[size])
  {
    std::uint64_t bits[size], any = 0;
    std::memcpy(bits, numbers, sizeof(bits));
    for (int k = 0; k < size; ++k)
      any |= bits[k];
    return any << 1 == 0; // but for the sign
  }

  // Leaves in d what is behind the point.
  static std::int64_t take_digit(double& d)
  {
    const std::int64_t digit = static_cast<std::int64_t>(d);
    d -= static_cast<double>(digit);
    return digit;
  }

  const Exact_differences<N>& m_differences;
  double m_scale;
  std::int64_t m_first[size];
  bool m_can_be_scaled, m_has_one_digit = false;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INTEGER_DIFFERENCES_H
