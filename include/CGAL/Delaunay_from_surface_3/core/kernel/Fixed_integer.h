// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIXED_INTEGER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIXED_INTEGER_H

// Integers for determinants, of a width that the compiler knows: no allocation, no loop that runs
// at run time, and no branch.
//
// A number is a sum of digits times powers of 2^60, with 2^63 for the sign and 8 times the room of
// a digit. Products are added up column by column in 128 bits and carried only when a sum is
// complete: carrying is most of the work where digits are as wide as words. A product has the bits
// of its factors together, so the width of a polynomial follows from its degree.
//
// Let coordinates be at most 2^(30 H) in absolute value. Then minors of two columns are at most 2 ·
// 2^(60 H), squared lengths 3 · 2^(60 H), minors of three columns 6 · 2^(90 H), and the highest
// digit of each is at most 2^62.6. The columns of the sphere's determinant are sums of at most 4 H
// products, each at most 2^122.6, or, the highest, of 4 that are at most 2^124.2. With H <= 4 all
// is less than 2^127, what is carried included. The other columns have fewer terms.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#if defined(__SIZEOF_INT128__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

__extension__ using Double_digit = __int128;

constexpr int digit_bits = 60;

// A number of 30 Halves bits and a little more; only the highest digit may be wider than 60.
template <int Halves>
struct Fixed_integer
{
  static constexpr int size = (Halves + 1) / 2;
  std::int64_t digits[size];
};

// The same number as a sum that has not been carried.
template <int Halves, int Size>
struct Uncarried_integer
{
  static constexpr std::int64_t digit_mask = (std::int64_t(1) << digit_bits) - 1;
  Double_digit columns[Size];

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Uncarried_integer
  operator+(const Uncarried_integer& s, const Uncarried_integer& t)
  {
    Uncarried_integer sum;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int i = 0; i < Size; ++i)
      sum.columns[i] = s.columns[i] + t.columns[i];
    return sum;
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Uncarried_integer
  operator-(const Uncarried_integer& s, const Uncarried_integer& t)
  {
    Uncarried_integer difference;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int i = 0; i < Size; ++i)
      difference.columns[i] = s.columns[i] - t.columns[i];
    return difference;
  }
};

template <int S, int T>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE auto operator*(const Fixed_integer<S>& s,
                                                          const Fixed_integer<T>& t)
{
  constexpr int m = Fixed_integer<S>::size, n = Fixed_integer<T>::size;
  Uncarried_integer<S + T, m + n - 1> product = {};
  CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
  for (int i = 0; i < m; ++i) {
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int j = 0; j < n; ++j)
      product.columns[i + j] += Double_digit(s.digits[i]) * t.digits[j];
  }
  return product;
}

template <int Halves, int Size>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Fixed_integer<Halves>
carried(const Uncarried_integer<Halves, Size>& sum)
{
  using Result = Fixed_integer<Halves>;
  Result result;
  Double_digit carry = 0;
  CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
  for (int i = 0; i < Result::size; ++i) {
    carry += i < Size ? sum.columns[i] : 0;
    if (i + 1 < Result::size) {
      result.digits[i] = std::int64_t(carry) & sum.digit_mask;
      carry >>= digit_bits;
    } else
      result.digits[i] = std::int64_t(carry);
  }
  return result;
}

template <int Halves, int Size>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE int sign_of(const Uncarried_integer<Halves, Size>& sum)
{
  Double_digit carry = 0;
  std::int64_t lower = 0;
  CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
  for (int i = 0; i < Size; ++i) {
    carry += sum.columns[i];
    lower |= std::int64_t(carry) & sum.digit_mask;
    carry >>= digit_bits;
  }
  return carry < 0 ? -1 : int((lower | std::int64_t(carry)) != 0);
}

template <int Halves>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE int sign_of(const Fixed_integer<Halves>& n)
{
  std::int64_t lower = 0;
  CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
  for (int i = 0; i + 1 < n.size; ++i)
    lower |= n.digits[i];
  const std::int64_t highest = n.digits[n.size - 1];
  return highest < 0 ? -1 : int((highest | lower) != 0);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // __SIZEOF_INT128__

// The differences v - p are exact as sums of two doubles. The power of 2 that brings the largest of
// them just under 2^60 makes all of them integers, unless the least bit of one is more than 60 bits
// below the largest; then the same is tried with 120 bits. Numbers of single precision and lattices
// need fewer than 30 more often than not, at half the price. Nothing is ever rounded away: what
// does not fit is left open. That 60 bits are not enough shows most often in the lower parts of the
// sums, before any digit is computed.

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER)

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
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

  // Returns false if the numbers are so small that the power would overflow, or so large that it
  // would be less than 1: then the least of them could be lost.
  bool can_be_scaled() const { return m_can_be_scaled; }
  // Returns true if one digit is enough; if so, the other tells whether its upper half is.
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
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIXED_INTEGER_H
