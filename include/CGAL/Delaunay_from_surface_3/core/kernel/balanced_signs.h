// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BALANCED_SIGNS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BALANCED_SIGNS_H

// Signs of points at distances of very different size, or in a box that is nearly flat: by a
// determinant of other rows, which has the same sign, with a bound on its own error.
//
// The determinant of the rows (1, x, y, z, w) of five points changes its sign where two of them
// change places; so any of them may be the origin. A row may be subtracted from another: let D be
// the edge that joins a point to its parent in a tree with the origin o as root. Then w differs by
//   w = D · F,  F = (point - o) + (parent - o),
// less the difference of their weights, if they have any. And rows and columns may be multiplied by
// powers of 2: each row so that the largest of D is at least 2^59 and less than 2^60, and the column
// w so that the largest |point - o| is. Coordinates are at most 2^58, so these powers are at least 1,
// and nothing is lost but where a power would be too large for a double.
//
// In doubles a product goes through 3 + (1 + 2 + 3) + 8 = 17 roundings: 18 u S is on the safe side
// (Bounded_number). In sums of two doubles differences are exact, and it goes through 1 + 3 + 8 =
// 12 of less than 2^-100 (Double_double.h): so 2^-96 S is. A difference of weights goes through
// fewer, and joins the last of three products. What underflows, 2^-1074 each time and less than 2^10
// times, meets factors of less than 2^184: less than 2^-880 altogether. So differences of weights
// must be less than 2^122 when they are scaled; if no power of 2 that is at least 1 does that for
// the column w, nothing is decided.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Numbers that carry the bound of their own error: the sum of the absolute values of the products
// that they are made of. Let S be that sum, exactly. Where each product went through at most n
// roundings by a share of at most e, so that the value is wrong by at most ((1 + e)^n - 1) S, the
// size went through at most 17 of u = 2^-53, and is at least (1 - u)^17 S.

template <class Number>
struct Bounded_number
{
  Number value;
  double size;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Bounded_number
  operator+(const Bounded_number& s, const Bounded_number& t)
  {
    return {s.value + t.value, s.size + t.size};
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Bounded_number
  operator-(const Bounded_number& s, const Bounded_number& t)
  {
    return {s.value - t.value, s.size + t.size};
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE friend Bounded_number
  operator*(const Bounded_number& s, const Bounded_number& t)
  {
    return {s.value * t.value, s.size * t.size};
  }
};

// The points of a test joined by their shortest tree. Seen from a point that is far from the others
// these lie in one direction, and nothing can be decided; the edges of the tree differ as much as
// they can. Its root is the point where the product of the distances to the others is least.

// The tree depends on rounded distances; the sign that is found by it must not.
template <int N, class Place>
class Shortest_tree
{
public:
  // Spans N vertices and p. Keeps pointers to the coordinates.
  Shortest_tree(const Place* vertices, Place p)
  {
    std::copy(vertices, vertices + N, m_points);
    m_points[N] = p;
    for (int i = 1; i <= N; ++i)
      for (int j = 0; j < i; ++j)
        m_squares[i][j] = m_squares[j][i] = square(i, j);
    grow();
  }

  // Return the k-th vertex, and what it hangs on: the root or another vertex. The vertices are
  // those given to the constructor, but p has the place of the root.
  Place point(int k) const { return m_points[m_places[k]]; }
  Place parent(int k) const { return m_points[m_parents[k]]; }
  Place root() const { return m_points[m_root]; }
  // Returns true if two points have changed places for it.
  bool is_odd() const { return m_root != N; }

private:
  double square(int i, int j) const
  {
    const Place a = m_points[i], b = m_points[j];
    return Row<double>(a[0] - b[0], a[1] - b[1], a[2] - b[2]).w;
  }

  void grow()
  {
    double products[N + 1];
    for (int i = 0; i <= N; ++i) {
      products[i] = 1;
      for (int j = 0; j <= N; ++j)
        products[i] *= i == j ? 1 : m_squares[i][j];
    }
    const int root = int(std::min_element(products, products + N + 1) - products);
    double distances[N]; // to the tree
    for (int k = 0; k < N; ++k) {
      m_places[k] = k == root ? N : k;
      m_parents[k] = root;
      distances[k] = m_squares[m_places[k]][root];
    }
    m_root = root;
    bool is_in_tree[N] = {};
    for (int joined = 0; joined < N; ++joined) {
      int next = -1;
      for (int k = 0; k < N; ++k)
        if (!is_in_tree[k] && (next < 0 || distances[k] < distances[next]))
          next = k;
      is_in_tree[next] = true;
      for (int k = 0; k < N; ++k)
        if (!is_in_tree[k] && m_squares[m_places[k]][m_places[next]] < distances[k]) {
          distances[k] = m_squares[m_places[k]][m_places[next]];
          m_parents[k] = m_places[next];
        }
    }
  }

  Place m_points[N + 1];
  double m_squares[N + 1][N + 1];
  int m_places[N], m_parents[N], m_root;
};

struct Bounded_doubles
{
  using Number = double;
  static constexpr double error = 18 * Filter_bounds::unit;
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Number difference(double a, double b,
                                                                      double scale)
  {
    return (a - b) * scale;
  }
  static Number scaled(double high, double, double scale) { return high * scale; }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static double high(Number d) { return d; }
};

template <class Products>
struct Bounded_double_doubles
{
  using Number = Double_double<Products>;
  static constexpr double error = 0x1p-96;
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Number difference(double a, double b,
                                                                      double scale)
  {
    const double high = a - b;
    return {high * scale, error_of_difference(a, b, high) * scale};
  }
  static Number scaled(double high, double low, double scale)
  {
    return {high * scale, low * scale};
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static double high(const Number& d) { return d.high; }
};

// The power of 2 that brings the largest coordinate of a - b to at least 2^59 and less than 2^60,
// as near as the range of numbers allows.
template <class Place>
double power_to_60_bits(Place a, Place b)
{
  const double largest =
      (std::max)((std::max)(std::abs(a[0] - b[0]), std::abs(a[1] - b[1])), std::abs(a[2] - b[2]));
  return power_of_2((std::min)(1022 + 60 + 1023 - biased_exponent(largest), std::uint64_t(2023)));
}

// The powers, for all numbers.
template <int N, class Place>
struct Balancing_scales
{
  double rows[N], w = 0x1p1000;

  explicit Balancing_scales(const Shortest_tree<N, Place>& tree)
  {
    for (int k = 0; k < N; ++k) {
      rows[k] = power_to_60_bits(tree.point(k), tree.parent(k));
      w = (std::min)(w, power_to_60_bits(tree.point(k), tree.root()));
    }
    if constexpr (is_weighted<Place> && N == 4)
      for (int k = 0; k < N; ++k)
        limit(std::abs(tree.parent(k).weight() - tree.point(k).weight()), rows[k]);
  }

  // Returns false if no scale of the column w is small enough, and at least 1.
  bool are_found() const { return w >= 1; }

private:
  // Lets dw be less than 2^122 when it is scaled, and the scales' product be finite.
  void limit(double dw, double scale)
  {
    const std::uint64_t exponent = biased_exponent(dw * scale);
    const std::uint64_t wanted = (std::min)(1022 + 121 + 1023 - exponent, std::uint64_t(2023));
    w = exponent > 1023 + 120 ? 0 : (std::min)({w, power_of_2(wanted), 0x1p1000 / scale});
  }
};

template <class Numbers, int N, class Place>
struct Balanced_rows
{
  using Bounded = Bounded_number<typename Numbers::Number>;
  Row<Bounded> r[N];

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE
  Balanced_rows(const Shortest_tree<N, Place>& tree, const Balancing_scales<N, Place>& scales)
  {
    for (int k = 0; k < N; ++k) {
      const Place a = tree.point(k), b = tree.parent(k), o = tree.root();
      r[k].x = difference(a[0], b[0], scales.rows[k]);
      r[k].y = difference(a[1], b[1], scales.rows[k]);
      r[k].z = difference(a[2], b[2], scales.rows[k]);
      if constexpr (N == 4) { // else nothing is lifted
        Bounded last = r[k].z * sum(a[2], b[2], o[2], scales.w);
        if constexpr (is_weighted<Place>)
          last = last + difference(b.weight(), a.weight(), scales.rows[k] * scales.w);
        r[k].w = r[k].x * sum(a[0], b[0], o[0], scales.w) +
                 r[k].y * sum(a[1], b[1], o[1], scales.w) + last;
      }
    }
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE int sign() const
  {
    if constexpr (N == 4)
      return sign_of(
          Sphere_cofactors<Bounded>(r[0], r[1], r[2], r[3]).lifted(r[0], r[1], r[2], r[3]));
    else
      return sign_of(determinant_of(r[0], r[1], r[2]));
  }

private:
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Bounded difference(double a, double b,
                                                                       double scale)
  {
    const auto d = Numbers::difference(a, b, scale);
    return {d, std::abs(Numbers::high(d))};
  }
  // (a - o) + (b - o)
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static Bounded sum(double a, double b, double o,
                                                                double scale)
  {
    return difference(a, o, scale) + difference(b, o, scale);
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE static int sign_of(const Bounded& d)
  {
    return certified_sign(Numbers::high(d.value), Numbers::error * d.size + 0x1p-880);
  }
};

// The signs of N vertices and p, as those of the determinants of their rows (Sphere_filter.h); 0
// where they are not decided.
template <int N, class Place = const double*>
class Balanced_signs
{
public:
  Balanced_signs(const Place* vertices, Place p)
    : m_tree(vertices, p)
    , m_scales(m_tree)
  {
  }

  template <class Numbers>
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE int sign() const
  {
    if (!m_scales.are_found())
      return 0;
    const int value = Balanced_rows<Numbers, N, Place>(m_tree, m_scales).sign();
    return m_tree.is_odd() ? -value : value;
  }

  int in_double_doubles() const
  {
    return machine_has_vectors() ? in_fused_double_doubles()
                                 : sign<Bounded_double_doubles<Portable_products>>();
  }

private:
  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS int in_fused_double_doubles() const
  {
    return sign<Bounded_double_doubles<Fused_products>>();
  }

  Shortest_tree<N, Place> m_tree;
  Balancing_scales<N, Place> m_scales;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_BALANCED_SIGNS_H
