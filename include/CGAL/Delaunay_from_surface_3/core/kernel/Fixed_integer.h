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
// digit of each is at most 2^62.6. With a difference of weights, at most 2^(60 H), w is at most 4 ·
// 2^(60 H). The columns of the sphere's determinant are sums of at most 4 H products, each at most
// 2^122.6, or, the highest, of 4 that are at most 2^124.6. With H <= 4 all is less than 2^127, what
// is carried included. The other columns have fewer terms.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#if defined(__SIZEOF_INT128__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

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
  return carry < 0 ? -1 : int((lower != 0) | (carry != 0));
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

// The differences v - p are exact as sums of two doubles. The power of 2 that brings the largest of
// them just under 2^60 makes all of them integers, unless the least bit of one is more than 60 bits
// below the largest; then the same is tried with 120 bits. Numbers of single precision and lattices
// need fewer than 30 more often than not, at half the price. Nothing is ever rounded away: what
// does not fit is left open. That 60 bits are not enough shows most often in the lower parts of the
// sums, before any digit is computed.
//
// Differences of weights are as large as squares. They must be integers times the square of that
// power of 2, and fit in the columns of a square that is not carried.

// The differences of N vertices and p, times a power of 2, in digits of 60 bits.
template <int N, class Place = const double*>
class Integer_differences
{
  static constexpr int size = 3 * N;

public:
  // Finds the first digits if one may be enough. Keeps a reference.
  explicit Integer_differences(const Exact_differences<N, Place>& differences)
    : m_differences(differences)
  {
    double largest = 0;
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k)
      largest = (std::max)(largest, std::abs(differences.high[k]));
    if constexpr (is_weighted<Place>) {
      double weight = 0;
      for (const double dw : differences.weight_high)
        weight = (std::max)(weight, std::abs(dw));
      largest = (std::max)(largest, std::sqrt(weight) * (1 + 0x1p-40)); // at least the exact root
    }
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

  // Rows of one digit, where it is enough. These return whether the weights are such integers.
  bool set_rows(Row<Fixed_integer<2>>* rows) const
  {
    using Number = Fixed_integer<2>;
    Weights<4, 1> weights;
    bool is_exact = true;
    if constexpr (is_weighted<Place>)
      for (int k = 0; k < N; ++k)
        weights.of[k].columns[0] =
            whole(m_differences.weight_high[k] * m_scale * m_scale, is_exact) +
            whole(m_differences.weight_low[k] * m_scale * m_scale, is_exact);
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      weights.set_row(rows[k], k, Number{{m_first[3 * k]}}, Number{{m_first[3 * k + 1]}},
                      Number{{m_first[3 * k + 2]}});
    return is_exact;
  }

  // Rows of its upper half, where that is enough.
  bool set_rows(Row<Fixed_integer<1>>* rows) const
  {
    using Number = Fixed_integer<1>;
    constexpr int half = digit_bits / 2;
    Weights<2, 1> weights;
    bool is_exact = true;
    if constexpr (is_weighted<Place>) {
      const double scale = m_scale * 0x1p-30; // may be less than 1, so products may underflow
      for (int k = 0; k < N; ++k) {
        const double high = m_differences.weight_high[k], low = m_differences.weight_low[k];
        const double h = high * scale * scale, l = low * scale * scale;
        is_exact = is_exact && (h != 0 || high == 0) && (l != 0 || low == 0);
        weights.of[k].columns[0] = whole(h, is_exact) + whole(l, is_exact);
      }
    }
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      weights.set_row(rows[k], k, Number{{m_first[3 * k] >> half}},
                      Number{{m_first[3 * k + 1] >> half}}, Number{{m_first[3 * k + 2] >> half}});
    return is_exact;
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
    Weights<8, 3> weights;
    if constexpr (is_weighted<Place>)
      for (int k = 0; k < N; ++k) {
        weights.of[k] = {};
        for (const double part : {m_differences.weight_high[k], m_differences.weight_low[k]}) {
          const double number = part * m_scale * m_scale; // in units of the highest column
          const Double_digit first = static_cast<Double_digit>(number);
          weights.of[k].columns[2] += first;
          weights.of[k].columns[0] +=
              whole((number - static_cast<double>(first)) * digit_base * digit_base, is_exact);
        }
      }
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < N; ++k)
      weights.set_row(rows[k], k, d[3 * k], d[3 * k + 1], d[3 * k + 2]);
    return is_exact;
  }

private:
  static constexpr double digit_base = 1152921504606846976.; // 2^60

  // The differences of weights, as sums of products; nothing without weights. (The scale is at
  // least 1, so its products with weights are exact.)
  template <int Halves, int Size>
  struct Weights
  {
    std::conditional_t<is_weighted<Place>, Uncarried_integer<Halves, Size>, char> of[N];

    template <class Number>
    CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE void
    set_row(Row<Number>& row, int k, const Number& x, const Number& y, const Number& z) const
    {
      if constexpr (is_weighted<Place>)
        row = {x, y, z, of[k]};
      else
        row = {x, y, z};
    }
  };

  // Less than 2^121. Sets is_exact to false if it is no integer.
  static Double_digit whole(double number, bool& is_exact)
  {
    const Double_digit n = static_cast<Double_digit>(number);
    is_exact = is_exact && static_cast<double>(n) == number;
    return n;
  }

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

  const Exact_differences<N, Place>& m_differences;
  double m_scale;
  std::int64_t m_first[size];
  bool m_can_be_scaled, m_has_one_digit = false;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // __SIZEOF_INT128__

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIXED_INTEGER_H
