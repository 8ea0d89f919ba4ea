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

// The number high + low, with |low| at most half an ulp of high.
class Double_double
{
public:
  // a - b, exactly.
  static Double_double difference(double a, double b)
  {
    const double high = a - b;
    const double minus_b = high - a;
    return Double_double(high, (a - (high - minus_b)) - (b + minus_b));
  }

  friend Double_double operator+(const Double_double& s, const Double_double& t)
  {
    const double sum = s.m_high + t.m_high;
    const double part = sum - s.m_high;
    const double error = (s.m_high - (sum - part)) + (t.m_high - part);
    return normalized(sum, error + (s.m_low + t.m_low));
  }

  friend Double_double operator-(const Double_double& s, const Double_double& t)
  {
    return s + Double_double(-t.m_high, -t.m_low);
  }

  friend Double_double operator*(const Double_double& s, const Double_double& t)
  {
    const double product = opaque(s.m_high * t.m_high);
    const double error = error_of_product(s.m_high, t.m_high, product);
    return normalized(product, error + (opaque(s.m_high * t.m_low) + opaque(s.m_low * t.m_high)));
  }

  double high() const { return m_high; }

private:
  Double_double(double high, double low)
    : m_high(high)
    , m_low(low)
  {
  }

  static Double_double normalized(double high, double low)
  {
    const double sum = high + low;
    return Double_double(sum, low - (sum - high));
  }

  // a b - product, exactly (Dekker 1971).
  static double error_of_product(double a, double b, double product)
  {
#ifdef __FMA__
    return __builtin_fma(a, b, -product);
#else
    const double a1 = upper_half(a), a0 = a - a1, b1 = upper_half(b), b0 = b - b1;
    return ((opaque(a1 * b1) - product) + opaque(a1 * b0) + opaque(a0 * b1)) + opaque(a0 * b0);
#endif
  }

  static double upper_half(double a)
  {
    const double c = opaque(134217729. * a); // 2^27 + 1
    return c - (c - a);
  }

  double m_high, m_low;
};

struct Exact_row
{
  Double_double x, y, z, w;
  Exact_row(const double* v, const double* p)
    : x(Double_double::difference(v[0], p[0]))
    , y(Double_double::difference(v[1], p[1]))
    , z(Double_double::difference(v[2], p[2]))
    , w(x * x + y * y + z * z)
  {
  }
};

// Positive if p is inside the sphere through the four vertices of a positively oriented cell,
// negative if it is outside, 0 if that is not decided.
inline int close_sphere_sign(const double* const* vertices, const double* p)
{
  const Exact_row a(vertices[0], p), b(vertices[1], p), c(vertices[2], p), d(vertices[3], p);
  const Double_double xy_ab = a.x * b.y - a.y * b.x, xy_bc = b.x * c.y - b.y * c.x,
                      xy_cd = c.x * d.y - c.y * d.x, xy_da = d.x * a.y - d.y * a.x,
                      xy_ac = a.x * c.y - a.y * c.x, xy_bd = b.x * d.y - b.y * d.x;
  const Double_double bcd = b.z * xy_cd - c.z * xy_bd + d.z * xy_bc;
  const Double_double acd = a.z * xy_cd + c.z * xy_da + d.z * xy_ac;
  const Double_double abd = a.z * xy_bd + b.z * xy_da + d.z * xy_ab;
  const Double_double abc = a.z * xy_bc - b.z * xy_ac + c.z * xy_ab;
  const Double_double value = (a.w * bcd - b.w * acd) + (c.w * abd - d.w * abc);
  const double m =
      (std::max)((std::max)(a.w.high(), b.w.high()), (std::max)(c.w.high(), d.w.high()));
  const double bound = 1. / 9903520314283042199192993792. * (m * m * std::sqrt(m)) + // 2^-93
                       Filter_bounds::tiny;
  return certified_sign(value.high(), bound);
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_DOUBLE_DOUBLE_H
