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

#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#if defined(__SIZEOF_INT128__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
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
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // __SIZEOF_INT128__

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIXED_INTEGER_H
