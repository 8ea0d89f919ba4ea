// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_INTEGER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_INTEGER_H

// Integers of any width, for the determinants that no other stage can decide. All doubles are
// integers times the least of them, 2^-1074, and the determinant of the sphere has degree 5: so
// no number here has more than 10,500 bits, and most have a few hundred. Schoolbook arithmetic on
// digits of 32 bits, least first, with a sign beside (Knuth 1969): short, and the same on every
// machine. Speed is no concern; Fixed_integer.h is for what is common.
//
// Cost: O(s t) for a product of s and t digits; memory is allocated for every result.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// A finite number is bits 2^exponent, but for its sign; bits is odd, or 0.
struct Bits_of_double
{
  explicit Bits_of_double(double d)
  {
    bits = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(d), &exponent), 53));
    exponent -= 53;
    for (; bits != 0 && bits % 2 == 0; bits /= 2)
      ++exponent;
  }
  std::uint64_t bits;
  int exponent;
};

class Wide_integer
{
public:
  // 0.
  Wide_integer() = default;

  // d 2^-unit, which must be an integer.
  Wide_integer(double d, int unit)
    : m_is_negative(d < 0)
  {
    const Bits_of_double of(d);
    if (of.bits == 0)
      return;
    const int shift = of.exponent - unit;
    m_digits.assign(std::size_t(shift / digit_bits), 0);
    const int rest = shift % digit_bits;
    std::uint64_t low = of.bits << rest, high = rest == 0 ? 0 : of.bits >> (64 - rest);
    for (; (low | high) != 0; low = low >> digit_bits | high << digit_bits, high >>= digit_bits)
      m_digits.push_back(std::uint32_t(low));
  }

  friend int sign_of(const Wide_integer& n)
  {
    return n.m_digits.empty() ? 0 : n.m_is_negative ? -1 : 1;
  }

  friend Wide_integer operator+(const Wide_integer& s, const Wide_integer& t)
  {
    return sum(s, t, t.m_is_negative);
  }
  friend Wide_integer operator-(const Wide_integer& s, const Wide_integer& t)
  {
    return sum(s, t, !t.m_is_negative);
  }

  friend Wide_integer operator*(const Wide_integer& s, const Wide_integer& t)
  {
    Wide_integer product;
    product.m_is_negative = s.m_is_negative != t.m_is_negative;
    product.m_digits.assign(s.m_digits.size() + t.m_digits.size(), 0);
    for (std::size_t i = 0; i < s.m_digits.size(); ++i) {
      std::uint64_t carry = 0; // digit, digit and digit² fit
      for (std::size_t j = 0; j < t.m_digits.size(); ++j) {
        carry += product.m_digits[i + j] + std::uint64_t(s.m_digits[i]) * t.m_digits[j];
        product.m_digits[i + j] = std::uint32_t(carry);
        carry >>= digit_bits;
      }
      product.m_digits[i + t.m_digits.size()] = std::uint32_t(carry);
    }
    product.trim();
    return product;
  }

private:
  using Digits = std::vector<std::uint32_t>;
  static constexpr int digit_bits = 32;

  void trim()
  {
    while (!m_digits.empty() && m_digits.back() == 0)
      m_digits.pop_back();
  }

  // s, and t with another sign.
  static Wide_integer sum(const Wide_integer& s, const Wide_integer& t, bool is_t_negative)
  {
    Wide_integer result;
    if (s.m_is_negative == is_t_negative) {
      result.m_is_negative = s.m_is_negative;
      result.m_digits = added(s.m_digits, t.m_digits);
    } else if (is_less(s.m_digits, t.m_digits)) {
      result.m_is_negative = is_t_negative;
      result.m_digits = subtracted(t.m_digits, s.m_digits);
    } else {
      result.m_is_negative = s.m_is_negative;
      result.m_digits = subtracted(s.m_digits, t.m_digits);
    }
    result.trim();
    return result;
  }

  static bool is_less(const Digits& s, const Digits& t)
  {
    return s.size() != t.size()
               ? s.size() < t.size()
               : std::lexicographical_compare(s.rbegin(), s.rend(), t.rbegin(), t.rend());
  }

  static Digits added(const Digits& s, const Digits& t)
  {
    if (s.size() < t.size())
      return added(t, s);
    Digits sum(s.size() + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      carry += std::uint64_t(s[i]) + (i < t.size() ? t[i] : 0);
      sum[i] = std::uint32_t(carry);
      carry >>= digit_bits;
    }
    sum.back() = std::uint32_t(carry);
    return sum;
  }

  // t is not greater than s.
  static Digits subtracted(const Digits& s, const Digits& t)
  {
    Digits difference(s.size());
    std::int64_t borrowed = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      const std::int64_t digit =
          std::int64_t(s[i]) - (i < t.size() ? std::int64_t(t[i]) : 0) - borrowed;
      difference[i] = std::uint32_t(digit);
      borrowed = digit < 0;
    }
    return difference;
  }

  bool m_is_negative = false;
  Digits m_digits; // the highest is not 0
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_INTEGER_H
