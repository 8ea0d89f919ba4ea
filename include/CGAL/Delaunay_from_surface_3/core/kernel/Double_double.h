// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DOUBLE_DOUBLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DOUBLE_DOUBLE_H

// A stage of the sphere test between integers of one digit and of two: the determinant in sums of
// two doubles. It decides nearly all of what has too many bits for one digit, at less than half the
// price of two.
//
// A product or sum of two such numbers is wrong by less than 2^-100 of (the sum of) the absolute
// values of what enters, and differences of two doubles are exact, also of weights. So the bound of
// the first stage holds with 2^-100 for u, and 2^-93 m^(5/2) is on the safe side.
//
// The error terms are exact only if no product is fused into a sum, as compilers do when the user
// allows fma. opaque() hides from them what is a product.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

inline double opaque(double product)
{
#if defined(__GNUC__) && defined(__x86_64__)
  __asm__("" : "+x"(product));
  return product;
#elif defined(__GNUC__) && defined(__aarch64__)
  __asm__("" : "+w"(product));
  return product;
#else
  volatile double hidden = product;
  return hidden;
#endif
}

// Computes what a product lost by rounding, a b - product, exactly, on any machine (Dekker 1971) …
struct Split_products
{
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static double error(double a, double b, double product)
  {
    const double a1 = upper_half(a), a0 = a - a1, b1 = upper_half(b), b0 = b - b1;
    return ((opaque(a1 * b1) - product) + opaque(a1 * b0) + opaque(a0 * b1)) + opaque(a0 * b0);
  }

private:
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static double upper_half(double a)
  {
    const double c = opaque(134217729. * a); // 2^27 + 1
    return c - (c - a);
  }
};

// … and where it is one instruction: on machines with vectors, and where the user compiles for it.
struct Fused_products
{
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static double error(double a, double b, double product)
  {
    return std::fma(a, b, -product);
  }
};

#if defined(__FMA__) || defined(__aarch64__)
using Portable_products = Fused_products;
#else
using Portable_products = Split_products;
#endif

// Returns what a difference lost, a - b - difference, exactly (Knuth 1969).
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE double error_of_difference(double a, double b,
                                                                      double difference)
{
  const double minus_b = difference - a;
  return (a - (difference - minus_b)) - (b + minus_b);
}

// The weight of p less those of N vertices, each exactly high + low; nothing without weights.
template <int N, class Place, bool has_weight = is_weighted<Place>>
struct Weight_differences
{
  Weight_differences(const Place*, Place) {}
};
template <int N, class Place>
struct Weight_differences<N, Place, true>
{
  double weight_high[N], weight_low[N];

  Weight_differences(const Place* vertices, Place p)
  {
    for (int k = 0; k < N; ++k) {
      weight_high[k] = p.weight() - vertices[k].weight();
      weight_low[k] = error_of_difference(p.weight(), vertices[k].weight(), weight_high[k]);
    }
  }
};

// The differences of N vertices and p, row by row; each is exactly high + low.
template <int N, class Place = const double*>
struct Exact_differences : Weight_differences<N, Place>
{
  static constexpr int size = 3 * N;
  double high[size], low[size];

  Exact_differences(const Place* vertices, Place p)
    : Weight_differences<N, Place>(vertices, p)
  {
    double a[size], b[size]; // in a row, for vectors
    CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
    for (int k = 0; k < size; ++k) {
      a[k] = vertices[k / 3][k % 3];
      b[k] = p[k % 3];
    }
    for (int k = 0; k < size; ++k) {
      high[k] = a[k] - b[k];
      low[k] = error_of_difference(a[k], b[k], high[k]);
    }
  }
};

// The number high + low, with |low| at most half an ulp of high.
template <class Products>
struct Double_double
{
  double high, low;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Double_double operator+(const Double_double& s,
                                                                            const Double_double& t)
  {
    const double sum = s.high + t.high;
    const double error = error_of_difference(s.high, -t.high, sum);
    return normalized(sum, error + (s.low + t.low));
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Double_double operator-(const Double_double& s,
                                                                            const Double_double& t)
  {
    return s + Double_double{-t.high, -t.low};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Double_double operator*(const Double_double& s,
                                                                            const Double_double& t)
  {
    const double product = opaque(s.high * t.high);
    const double error = Products::error(s.high, t.high, product);
    return normalized(product, error + (opaque(s.high * t.low) + opaque(s.low * t.high)));
  }

private:
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Double_double normalized(double high,
                                                                             double low)
  {
    const double sum = high + low;
    return {sum, low - (sum - high)};
  }
};

template <class Products, class Place>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE int
close_sphere_sign_with(const Exact_differences<4, Place>& differences)
{
  using Number = Double_double<Products>;
  const auto number = [&](int k) { return Number{differences.high[k], differences.low[k]}; };
  Row<Number> r[4];
  double sizes[4];
  CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL
  for (int k = 0; k < 4; ++k) {
    const Number x = number(3 * k), y = number(3 * k + 1), z = number(3 * k + 2);
    if constexpr (is_weighted<Place>) {
      const Number dw = {differences.weight_high[k], differences.weight_low[k]};
      r[k] = {x, y, z, dw};
      sizes[k] = size_of(Power_row(x.high, y.high, z.high, dw.high));
    } else {
      r[k] = {x, y, z};
      sizes[k] = r[k].w.high;
    }
  }
  const Sphere_cofactors<Number> cofactors(r[0], r[1], r[2], r[3]);
  const double m = (std::max)((std::max)(sizes[0], sizes[1]), (std::max)(sizes[2], sizes[3]));
  const double bound = 1. / 9903520314283042199192993792. * (m * m * std::sqrt(m)) + // 2^-93
                       Filter_bounds::tiny;
  return certified_sign(cofactors.lifted(r[0], r[1], r[2], r[3]).high, bound);
}

template <class Place>
CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS int
fused_close_sphere_sign(const Exact_differences<4, Place>& differences)
{
  return close_sphere_sign_with<Fused_products>(differences);
}

// The sphere test of a positively oriented cell.
template <class Place>
int close_sphere_sign(const Exact_differences<4, Place>& differences)
{
  return machine_has_vectors() ? fused_close_sphere_sign(differences)
                               : close_sphere_sign_with<Portable_products>(differences);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DOUBLE_DOUBLE_H
