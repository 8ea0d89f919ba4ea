// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_EMPTY_BALL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_EMPTY_BALL_H

// The ball of a cell, rounded outward: which boxes of points may touch it.
//
// Relative to the first vertex, with weight W, let a, b, c be the others, and |a|² and so on their
// squared lengths, each less its weight and plus W. Let A = |a b c| > 0 and
// N = |a|² b × c + |b|² c × a + |c|² a × b. A point d is in conflict with the cell if
// A |d|² - N d < 0: the centre is N / 2 A. Unlike centre and radius, this serves a cell that is nearly
// flat, too, whose ball is nearly a half-space.
//
// Let m bound these sizes (Power_row), and let coordinates be off by at most e. Then A is off by less
// than 16 u m^(3/2) + 8 e m (Sphere_filter.h). A coordinate of N is a sum of 12 products of at most 11
// roundings, with absolute values that sum up to less than 6 m²; it is off by less than
// 80 u m² + 32 e m^(3/2), since a square is moved by 2 √3 e √m, and a cross product by as much. In sums
// of two doubles u is 2^-95, and that covers the differences of copies, too: those that are no such
// sums are off by less than 2^-104 of themselves. Cells that are flatter call for integers.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Big_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Empty_ball
{
public:
  // The ball of four vertices, given by their rounded places, whose differences are off by at most
  // `rounding`, and their exact ones.
  template <bool has_weight>
  Empty_ball(const Rounded_place<has_weight>* places, const Copy_place<has_weight>* exact,
             double rounding)
    : m_off(rounding)
  {
    std::copy_n(coordinates_of(places[0]), 3, m_origin);
    std::array<double, 3> v[3];
    double weights[3] = {};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t a = 0; a < 3; ++a)
        v[k][a] = places[k + 1][a] - m_origin[a];
      if constexpr (has_weight)
        weights[k] = places[k + 1].weight() - places[0].weight();
    }
    if constexpr (has_weight)
      m_weight = places[0].weight();
    m_most_more_weight = (std::max)({0., weights[0], weights[1], weights[2]});
    set(v, weights, Filter_bounds::unit, m_off);
    if (is_uncertain() && exact[0].periods->are_scaled) {
      set_again(exact);
      if (is_uncertain())
        set_exactly(exact);
    }
    for (std::size_t a = 0; a < 3; ++a)
      m_center[a] = m_n[a] / (2 * m_a);
    m_square = dot(m_center, m_center);
    m_off_center = 1.01 * (m_off_n + 2 * std::sqrt(m_square) * m_off_a) / (2 * m_a) + 4 * m_off;
    m_is_known = !is_uncertain() && std::sqrt(m_square) + m_off_center < 0x1p400;
  }

  // Returns false if the ball may be anything.
  bool is_known() const { return m_is_known; }

  // Returns no less than the distance of the centre from any vertex; infinite if it is not known.
  double radius() const
  {
    return m_is_known ? 1.01 * std::sqrt(m_square + m_most_more_weight) + 4 * m_off_center
                      : std::numeric_limits<double>::infinity();
  }

  // Returns a box with all points in it that may touch the ball, if their weights are at most this.
  Bounds bounds(double weight) const
  {
    const double far = std::sqrt(m_square) + m_off_center, dw = weight - m_weight;
    const double reach = std::sqrt((std::max)(m_square + dw, 0.) + 8 * far * m_off_center +
                                   0x1p-48 * (m_square + std::abs(dw))) +
                         4 * m_off_center + 0x1p-40 * far;
    Bounds b;
    for (std::size_t a = 0; a < 3; ++a) {
      b.low[a] = m_origin[a] + m_center[a] - reach;
      b.high[a] = m_origin[a] + m_center[a] + reach;
    }
    return b;
  }

  // Returns the least power of points in a box with weights of at most this: it is less than 0 in the ball,
  // and infinite if the points surely do not touch it.
  double least_power(const Bounds& box, double weight) const
  {
    const double dw = weight - m_weight;
    double least = -m_a * dw, off_by = (m_off_a + 8 * Filter_bounds::unit * m_a) * std::abs(dw);
    for (std::size_t a = 0; a < 3; ++a) {
      const double low = box.low[a] - m_origin[a] - 4 * m_off,
                   high = box.high[a] - m_origin[a] + 4 * m_off;
      const double d = (std::max)(low, (std::min)(high, m_center[a]));
      const double longest = (std::max)(std::abs(low), std::abs(high));
      least += (m_a * d - m_n[a]) * d;
      off_by += (m_off_a * longest + m_off_n) * longest +
                8 * Filter_bounds::unit * (m_a * longest + std::abs(m_n[a])) * longest;
    }
    return least > off_by ? std::numeric_limits<double>::infinity() : least;
  }

private:
  static double high(double n) { return n; }
  template <class Number>
  static double high(const Number& n)
  {
    return n.high;
  }

  // `weights` are those of a, b and c, less W.
  template <class Number>
  void set(const std::array<Number, 3>* v, const Number* weights, double unit, double off_by)
  {
    const std::array<Number, 3> areas[3] = {cross(v[1], v[2]), cross(v[2], v[0]),
                                            cross(v[0], v[1])};
    Number squares[3];
    double m = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      squares[k] = dot(v[k], v[k]);
      m = (std::max)(m, high(squares[k]) + std::abs(high(weights[k])));
      squares[k] = squares[k] - weights[k];
    }
    m_a = high(dot(v[0], areas[0]));
    for (std::size_t a = 0; a < 3; ++a)
      m_n[a] = high(squares[0] * areas[0][a] + squares[1] * areas[1][a] + squares[2] * areas[2][a]);
    const double root = std::sqrt(m);
    m_off_a = m * (16 * unit * root + 8 * off_by) + Filter_bounds::tiny; // for underflows
    m_off_n = m * (80 * unit * m + 32 * off_by * root) + Filter_bounds::tiny;
  }

  // Does it in sums of two doubles.
  template <bool has_weight>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART void set_again(const Copy_place<has_weight>* exact)
  {
    using Number = Double_double<Portable_products>;
    const Exact_differences<3, Copy_place<has_weight>> differences(exact + 1, exact[0]);
    std::array<Number, 3> v[3];
    Number weights[3] = {};
    for (std::size_t k = 0; k < 9; ++k)
      v[k / 3][k % 3] = {differences.high[k], differences.low[k]};
    if constexpr (has_weight) // these are W less the others
      for (std::size_t k = 0; k < 3; ++k)
        weights[k] = {-differences.weight_high[k], -differences.weight_low[k]};
    set(v, weights, 0x1p-95, 0);
  }

  // Does it in integers, up to a power of 2.
  template <bool has_weight>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART void set_exactly(const Copy_place<has_weight>* exact)
  {
    using Vector = std::array<Big_integer, 3>;
    const Big_differences<3, Copy_place<has_weight>> differences(exact + 1, exact[0]);
    const Row<Big_integer>* const r = differences.rows;
    const Vector v[3] = {
        {r[0].x, r[0].y, r[0].z}, {r[1].x, r[1].y, r[1].z}, {r[2].x, r[2].y, r[2].z}};
    const Vector areas[3] = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
    double n[3], m = 0;
    int exponent = 0, exponents[3];
    const double a = dot(v[0], areas[0]).scaled_double(exponent);
    int most = exponent + 59; // A d is as large as that
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = (r[0].w * areas[0][k] + r[1].w * areas[1][k] + r[2].w * areas[2][k])
                 .scaled_double(exponents[k]);
      exponents[k] += differences.unit;
      if (n[k] != 0)
        most = (std::max)(most, exponents[k]);
    }
    m_a = std::ldexp(a, exponent - most);
    for (std::size_t k = 0; k < 3; ++k) {
      m_n[k] = n[k] == 0 ? 0 : std::ldexp(n[k], exponents[k] - most);
      m = (std::max)(m, std::abs(m_n[k]));
    }
    m_off_a = 0x1p-50 * m_a;
    m_off_n = 0x1p-50 * m;
  }

  bool is_uncertain() const { return !(m_a > 0x1p10 * m_off_a); }

  const double m_off; // by how much a difference of rounded coordinates may be
  double m_origin[3], m_weight = 0;
  double m_most_more_weight = 0; // that another vertex has
  double m_n[3], m_a = 0, m_off_a = 0, m_off_n = 0;
  std::array<double, 3> m_center; // relative to the origin
  double m_square = 0, m_off_center = 0;
  bool m_is_known = false;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_EMPTY_BALL_H
