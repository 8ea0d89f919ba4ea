// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_WEIGHTS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_WEIGHTS_H

// Weights that break predicates of given points: of every size a double has, and such that lifted
// points lie in a hyperplane, exactly or up to a rounding. Each function makes one per point, all
// finite.

#include "hostile_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace fuzz {

using Weights = std::vector<double>;

template <class Make>
Weights by_point(const Points& points, const Make& make)
{
  Weights weights;
  for (const Coordinates& p : points)
    weights.push_back(make(p));
  return weights;
}

// The exponents of the largest and the least coordinate that is not 0.
struct Exponents
{
  int largest = -1074, least = 1024;

  explicit Exponents(const Points& points)
  {
    for (const Coordinates& p : points)
      for (const double c : p)
        if (c != 0) {
          largest = (std::max)(largest, std::ilogb(c));
          least = (std::min)(least, std::ilogb(c));
        }
    least = (std::min)(least, largest);
  }
};

// Finite, whatever the exponent.
inline double times_power(double factor, int exponent)
{
  return std::ldexp(factor, (std::min)(exponent, 1020));
}

inline Weights equal_weights(Random& r, Points& points)
{
  const double w = r.one_in(2) ? 0 : times_power(r.signed_unit(), 2 * Exponents(points).largest);
  return Weights(points.size(), w);
}

inline Weights one_ulp_apart(Random& r, Points& points)
{
  Weights weights = equal_weights(r, points);
  for (double& w : weights)
    for (int steps = r.between(0, 2); steps > 0; --steps)
      w = std::nextafter(w, r.one_in(2) ? 1e300 : -1e300);
  return weights;
}

// Small multiples of the square of the least coordinate, or of more or less than that.
inline Weights integers(Random& r, Points& points)
{
  const int unit = 2 * Exponents(points).least + (r.one_in(2) ? 0 : r.between(-250, 60));
  return by_point(points, [&](const Coordinates&) { return times_power(r.between(-5, 5), unit); });
}

inline Weights balls(Random& r, Points& points)
{
  const int e = 2 * Exponents(points).largest - r.between(-4, 60);
  return by_point(points, [&](const Coordinates&) { return times_power(r.unit(), e); });
}

// All points lie on a sphere that is orthogonal to theirs, but for roundings.
inline Weights orthogonal(Random& r, Points& points)
{
  const Coordinates centre = r.one_in(2) ? Coordinates{} : points[r.below(points.size())];
  const double power = r.one_in(2) ? 0 : times_power(1, 2 * Exponents(points).least);
  const std::size_t share = 1 + r.below(20);
  const double noise = r.one_in(2) ? 0 : std::ldexp(1., -r.between(20, 60));
  return by_point(points, [&](const Coordinates& p) {
    double w = power;
    for (std::size_t c = 0; c < 3; ++c)
      w += (p[c] - centre[c]) * (p[c] - centre[c]);
    w = std::isfinite(w) ? w : 0;
    w *= r.one_in(share) ? 1 + noise * r.signed_unit() : 1;
    return r.one_in(share) ? std::nextafter(w, r.one_in(2) ? 1e300 : -1e300) : w;
  });
}

// A multiple of a coordinate, which may be much more than squares: points on a sphere stay on one.
inline Weights linear(Random& r, Points& points)
{
  const std::size_t axis = r.below(3), share = 1 + r.below(20);
  const int e = Exponents(points).largest - r.between(r.one_in(2) ? -60 : -2, 60);
  return by_point(points, [&](const Coordinates& p) {
    const double w = std::ldexp(p[axis], e);
    return !std::isfinite(w) ? 0 : r.one_in(share) ? std::nextafter(w, 1e300) : w;
  });
}

inline Weights of_240_orders(Random& r, Points& points)
{
  const int e = 2 * Exponents(points).largest - r.between(-120, 120);
  return by_point(points, [&](const Coordinates&) {
    return times_power(r.signed_unit(), e + r.between(-120, 120));
  });
}

inline Weights of_all_sizes(Random& r, Points& points)
{
  const int largest = r.one_in(2) ? 1020 : 2 * Exponents(points).largest;
  return by_point(points, [&](const Coordinates&) {
    return times_power(r.signed_unit(), r.between(-1074, (std::max)(largest, -1074)));
  });
}

// Which may become 0 when they are scaled, or when the kernel makes integers of them.
inline Weights least_weights(Random& r, Points& points)
{
  const int bits = r.between(0, 60);
  return by_point(points, [&](const Coordinates&) {
    return std::ldexp(r.one_in(2) ? r.between(-3, 3) : r.signed_unit(), bits - 1074);
  });
}

inline Weights two_sizes_of_weights(Random& r, Points& points)
{
  const Exponents e(points);
  const int large = 2 * e.largest - r.between(0, 20), small = 2 * e.least - r.between(0, 130);
  return by_point(points, [&](const Coordinates&) {
    return times_power(r.between(-4, 4), r.one_in(2) ? large : small);
  });
}

inline Weights some_heavy(Random& r, Points& points)
{
  Weights weights = r.one_in(2) ? equal_weights(r, points) : integers(r, points);
  const int e = 2 * Exponents(points).largest + r.between(-60, 300);
  const std::size_t share = 1 + r.below(10);
  for (double& w : weights)
    w = r.one_in(share) ? times_power(r.signed_unit(), e) : w;
  return weights;
}

inline Weights near_the_largest_weight(Random& r, Points& points)
{
  const double largest = r.one_in(2) ? 1e300 : (std::numeric_limits<double>::max)();
  return by_point(points, [&](const Coordinates&) {
    return r.one_in(3) ? r.signed_unit() * largest : r.one_in(2) ? largest : -largest;
  });
}

// Of other points, in a wire along an axis that is so thin that products of rows underflow (and
// weights must not make much of them) where its length is scaled to 2^60.
inline Weights heavy_wire(Random& r, Points& points)
{
  const int thickness = -460 - r.between(590, 602), e = r.between(-700, -400);
  const std::size_t axis = r.below(3);
  for (Coordinates& p : points)
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = std::ldexp(r.between(-9, 9), c == axis ? -460 : thickness);
  return by_point(points, [&](const Coordinates&) { return times_power(r.signed_unit(), e); });
}

struct Weighting
{
  const char* name;
  Weights (*make)(Random& random, Points& points);
};

inline const Weighting weightings[] = {
    {"equal", equal_weights},      {"one ulp apart", one_ulp_apart},
    {"integers", integers},        {"balls", balls},
    {"orthogonal", orthogonal},    {"linear", linear},
    {"240 orders", of_240_orders}, {"all sizes", of_all_sizes},
    {"least", least_weights},      {"two sizes", two_sizes_of_weights},
    {"some heavy", some_heavy},    {"near the largest", near_the_largest_weight},
    {"heavy wire", heavy_wire},
};

constexpr std::size_t number_of_weightings = std::size(weightings);

// Of one of these, with either sign; and some of the points become copies of others.
inline Weights hostile_weights(const Weighting& weighting, Random& r, Points& points)
{
  if (r.one_in(3))
    for (Coordinates& p : points)
      p = r.one_in(4) ? points[r.below(points.size())] : p;
  Weights weights = weighting.make(r, points);
  if (r.one_in(4))
    for (double& w : weights)
      w = -w;
  return weights;
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_WEIGHTS_H
