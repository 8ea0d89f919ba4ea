// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_DOUBLE_DOUBLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_DOUBLE_DOUBLE_H

// The second stage of the sphere test: the determinant of Sphere_filter.h in sums of two doubles.
// Near-planar and near-spherical surfaces fail the first stage millions of times; nearly all of
// that is decided here, at a fraction of the price of exact arithmetic.
//
// A product or sum of two such numbers is wrong by less than 2^-100 of (the sum of) the absolute
// values of what enters, and differences of two doubles are exact. So the bound of the first stage
// holds with 2^-100 for u, and 2^-93 m^(5/2) is on the safe side.
//
// The error terms are exact only if no product is fused into a sum behind our back, as compilers do
// when the user allows fma. opaque() hides from them what is a product.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Sphere_filter.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

#if defined(__GNUC__) && defined(__x86_64__)
inline double opaque(double product)
{
  __asm__("" : "+x"(product));
  return product;
}
#elif defined(__GNUC__) && defined(__aarch64__)
inline double opaque(double product)
{
  __asm__("" : "+w"(product));
  return product;
}
#else
inline double opaque(double product)
{
  volatile double hidden = product;
  return hidden;
}
#endif

#if defined(__GNUC__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE __attribute__((always_inline)) inline
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE inline
#endif

// What a product lost by rounding, a b - product, exactly: for any machine (Dekker 1971) …
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

// … and where it is one instruction.
struct Fused_products
{
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static double error(double a, double b, double product)
  {
    return std::fma(a, b, -product);
  }
};

// The number high + low, with |low| at most half an ulp of high.
template <class Products>
struct Double_double
{
  double high, low;

  // a - b, exactly.
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Double_double difference(double a, double b)
  {
    const double high = a - b;
    const double minus_b = high - a;
    return {high, (a - (high - minus_b)) - (b + minus_b)};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Double_double operator+(const Double_double& s,
                                                                            const Double_double& t)
  {
    const double sum = s.high + t.high;
    const double part = sum - s.high;
    const double error = (s.high - (sum - part)) + (t.high - part);
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

template <class Products>
struct Close_sphere
{
  using Number = Double_double<Products>;

  struct Row
  {
    Number x, y, z, w;
    CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Row(const double* v, const double* p)
      : x(Number::difference(v[0], p[0]))
      , y(Number::difference(v[1], p[1]))
      , z(Number::difference(v[2], p[2]))
      , w(x * x + y * y + z * z)
    {
    }
  };

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Number minor(const Row& s, const Row& t)
  {
    return s.x * t.y - s.y * t.x;
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static int sign(const double* const* vertices,
                                                             const double* p)
  {
    const Row a(vertices[0], p), b(vertices[1], p), c(vertices[2], p), d(vertices[3], p);
    const Number ab = minor(a, b), bc = minor(b, c), cd = minor(c, d), da = minor(d, a),
                 ac = minor(a, c), bd = minor(b, d);
    const Number bcd = b.z * cd - c.z * bd + d.z * bc, acd = a.z * cd + c.z * da + d.z * ac;
    const Number abd = a.z * bd + b.z * da + d.z * ab, abc = a.z * bc - b.z * ac + c.z * ab;
    const Number value = (a.w * bcd - b.w * acd) + (c.w * abd - d.w * abc);
    const double m = (std::max)((std::max)(a.w.high, b.w.high), (std::max)(c.w.high, d.w.high));
    const double bound = 1. / 9903520314283042199192993792. * (m * m * std::sqrt(m)) + // 2^-93
                         Filter_bounds::tiny;
    return certified_sign(value.high, bound);
  }
};

#undef CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE

// Positive if p is inside the sphere through the four vertices of a positively oriented cell,
// negative if it is outside, 0 if that is not decided.
inline int close_sphere_sign(const double* const* vertices, const double* p)
{
#if defined(__FMA__) || defined(__aarch64__)
  return Close_sphere<Fused_products>::sign(vertices, p);
#else
  return Close_sphere<Split_products>::sign(vertices, p);
#endif
}

#if defined(__GNUC__) && defined(__x86_64__)
// The same, to be called if the machine has fma.
__attribute__((target("fma"))) inline int fused_close_sphere_sign(const double* const* vertices,
                                                                  const double* p)
{
  return Close_sphere<Fused_products>::sign(vertices, p);
}

inline bool has_fused_products()
{
  return __builtin_cpu_supports("fma");
}
#else
inline int fused_close_sphere_sign(const double* const* vertices, const double* p)
{
  return close_sphere_sign(vertices, p);
}

inline bool has_fused_products()
{
  return false;
}
#endif

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_DOUBLE_DOUBLE_H
