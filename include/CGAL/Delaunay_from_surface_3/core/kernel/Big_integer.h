// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BIG_INTEGER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BIG_INTEGER_H

// These integers are as large as need be, for the determinants that no other stage can decide. All
// doubles are integers times the least positive one, 2^-1074, so differences have at most 2099 bits,
// the determinant of the sphere, of degree 5, at most 10,504, and a squared radius, of degree 8, 16,812.
// The arithmetic is of the schoolbook kind (Knuth 1969), on digits, least first, and a sign. The digits
// are in the object's own memory: nothing is allocated, and only digits in use are touched.
//
// Cost: O(s t) for a product, where s counts the digits of one factor that are not 0, and t the
// digits of the other. Zeros at either end are not stored.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A finite number is, up to its sign, bits · 2^exponent, where bits is odd, or 0.
struct Bits_of_double
{
  explicit Bits_of_double(double d)
  {
    std::memcpy(&bits, &d, sizeof(bits));
    const int biased_exponent = int(bits >> 52 & 0x7ff);
    bits &= (std::uint64_t(1) << 52) - 1;
    bits |= std::uint64_t(biased_exponent != 0) << 52; // denormal numbers lack this bit
    exponent = (std::max)(biased_exponent, 1) - 1075;
    for (int zeros = 32; bits != 0 && zeros > 0; zeros /= 2)
      if ((bits & ((std::uint64_t(1) << zeros) - 1)) == 0) {
        bits >>= zeros;
        exponent += zeros;
      }
  }
  std::uint64_t bits;
  int exponent;
};

class Big_integer
{
#if defined(__SIZEOF_INT128__)
  using Digit = std::uint64_t;
  __extension__ using Two_digits = unsigned __int128;
#else
  using Digit = std::uint32_t;
  using Two_digits = std::uint64_t;
#endif
  static constexpr int digit_bits = std::numeric_limits<Digit>::digits;
  static constexpr int most_digits = 16800 / digit_bits + 8; // sizes of factors are rounded up

public:
  // Makes 0.
  Big_integer()
    : m_begin(0)
    , m_size(0)
    , m_is_negative(false)
  {
  }

  // Makes d · 2^-unit, which must be an integer.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART Big_integer(double d, int unit)
    : m_begin(0)
    , m_size(0)
    , m_is_negative(d < 0)
  {
    const Bits_of_double of(d);
    if (of.bits == 0)
      return;
    m_size = m_begin = (of.exponent - unit) / digit_bits;
    std::uint64_t bits = of.bits;
    for (int offset = (of.exponent - unit) % digit_bits; bits != 0; offset = 0) {
      m_digits[m_size++] = Digit(bits << offset);
      bits = digit_bits - offset < 64 ? bits >> (digit_bits - offset) : 0;
    }
  }

  Big_integer(const Big_integer& other)
  {
    *this = other;
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_APART Big_integer& operator=(const Big_integer& other)
  {
    if (this != &other) {
      m_begin = other.m_begin;
      m_size = other.m_size;
      m_is_negative = other.m_is_negative;
      std::copy(other.m_digits + m_begin, other.m_digits + m_size, m_digits + m_begin);
    }
    return *this;
  }

  friend int sign_of(const Big_integer& n)
  {
    return n.m_size == 0 ? 0 : n.m_is_negative ? -1 : 1;
  }

  // Returns the number / 2^exponent, rounded to a double of less than 2^65; only 0 becomes 0.
  double scaled_double(int& exponent) const
  {
    const int lowest = (std::max)(m_begin, m_size - 3);
    double value = 0;
    for (int i = lowest; i < m_size; ++i)
      value = std::ldexp(value, -digit_bits) + double(m_digits[i]);
    exponent = m_size == 0 ? 0 : digit_bits * (m_size - 1);
    return m_is_negative ? -value : value;
  }

  friend Big_integer operator+(const Big_integer& s, const Big_integer& t)
  {
    return sum(s, t, t.m_is_negative);
  }
  friend Big_integer operator-(const Big_integer& s, const Big_integer& t)
  {
    return sum(s, t, !t.m_is_negative);
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_APART friend Big_integer operator*(const Big_integer& s,
                                                                  const Big_integer& t)
  {
    Big_integer product;
    product.m_is_negative = s.m_is_negative != t.m_is_negative;
    product.m_begin = s.m_begin + t.m_begin;
    product.m_size = s.m_size + t.m_size;
    std::fill(product.m_digits + product.m_begin, product.m_digits + product.m_size, Digit(0));
    for (int i = s.m_begin; i < s.m_size; ++i) {
      const Digit factor = s.m_digits[i];
      if (factor == 0)
        continue;
      Digit carry = 0;
      for (int j = t.m_begin; j < t.m_size; ++j) { // digit² + 2 digit fit
        const Two_digits column =
            Two_digits(factor) * t.m_digits[j] + product.m_digits[i + j] + carry;
        product.m_digits[i + j] = Digit(column);
        carry = Digit(column >> digit_bits);
      }
      product.m_digits[i + t.m_size] = carry;
    }
    product.trim();
    return product;
  }

private:
  void trim()
  {
    while (m_size > m_begin && m_digits[m_size - 1] == 0)
      --m_size;
    while (m_begin < m_size && m_digits[m_begin] == 0)
      ++m_begin;
    if (m_begin == m_size)
      m_begin = m_size = 0;
  }

  // Returns the sum of s and of t with the given sign.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART static Big_integer
  sum(const Big_integer& s, const Big_integer& t, bool is_t_negative)
  {
    Big_integer result;
    const bool is_less = has_less_digits(s, t);
    const Big_integer &larger = is_less ? t : s, &smaller = is_less ? s : t;
    result.m_begin =
        smaller.m_size == 0 ? larger.m_begin : (std::min)(larger.m_begin, smaller.m_begin);
    result.m_is_negative = is_less ? is_t_negative : s.m_is_negative;
    if (s.m_is_negative == is_t_negative)
      result.set_sum(larger, smaller);
    else
      result.set_difference(larger, smaller);
    result.trim();
    return result;
  }

  // Compares absolute values.
  static bool has_less_digits(const Big_integer& s, const Big_integer& t)
  {
    if (s.m_size != t.m_size)
      return s.m_size < t.m_size;
    const int begin = (std::min)(s.m_begin, t.m_begin);
    int i = s.m_size - 1;
    while (i >= begin && s.digit(i) == t.digit(i))
      --i;
    return i >= begin && s.digit(i) < t.digit(i);
  }

  void set_sum(const Big_integer& larger, const Big_integer& smaller)
  {
    Digit carry = 0;
    for (int i = m_begin; i < larger.m_size; ++i) {
      const Two_digits sum = Two_digits(larger.digit(i)) + smaller.digit(i) + carry;
      m_digits[i] = Digit(sum);
      carry = Digit(sum >> digit_bits);
    }
    m_size = larger.m_size + 1;
    m_digits[larger.m_size] = carry;
  }

  void set_difference(const Big_integer& larger, const Big_integer& smaller)
  {
    Digit borrowed = 0;
    for (int i = m_begin; i < larger.m_size; ++i) {
      const Two_digits difference =
          Two_digits(larger.digit(i)) - smaller.digit(i) - borrowed; // modulo digit²
      m_digits[i] = Digit(difference);
      borrowed = Digit(difference >> digit_bits) & 1;
    }
    m_size = larger.m_size;
  }

  Digit digit(int i) const
  {
    return i >= m_begin && i < m_size ? m_digits[i] : 0;
  }

  // The digits from m_begin to m_size - 1 are stored; the first and the last of them are not 0. The
  // digits below are 0, as many are in differences of coordinates of very different size.
  int m_begin, m_size;
  bool m_is_negative;
  Digit m_digits[most_digits];
};

// Holds the differences of N vertices and p, row by row, divided by 2^unit, the greatest power of 2
// of which all coordinates are multiples, and weights of its square. Any finite doubles will do:
// weights in squares of units have at most 3,200 bits, fewer than squares of coordinates may have.
template <int N, class Place = const double*>
struct Big_differences
{
  Row<Big_integer> rows[N];
  int unit;

  Big_differences(const Place* vertices, Place p)
    : unit(unit_of(p))
  {
    for (int k = 0; k < N; ++k)
      unit = (std::min)(unit, unit_of(vertices[k]));
    const Big_integer x(p[0], unit), y(p[1], unit), z(p[2], unit);
    for (int k = 0; k < N; ++k) {
      const Place v = vertices[k];
      const Big_integer dx = Big_integer(v[0], unit) - x, dy = Big_integer(v[1], unit) - y,
                        dz = Big_integer(v[2], unit) - z;
      if constexpr (is_weighted<Place>)
        rows[k] = {dx, dy, dz,
                   Big_integer(p.weight(), 2 * unit) - Big_integer(v.weight(), 2 * unit)};
      else
        rows[k] = {dx, dy, dz};
    }
  }

private:
  static int unit_of(Place p)
  {
    int unit = std::numeric_limits<double>::max_exponent; // of 0
    for (int k = 0; k < 3; ++k)
      if (p[k] != 0)
        unit = (std::min)(unit, Bits_of_double(p[k]).exponent);
    if constexpr (is_weighted<Place>)
      if (p.weight() != 0) {
        const int exponent = Bits_of_double(p.weight()).exponent;
        unit = (std::min)(unit, exponent >= 0 ? exponent / 2 : (exponent - 1) / 2);
      }
    return unit;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BIG_INTEGER_H
