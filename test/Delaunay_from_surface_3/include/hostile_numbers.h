// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_NUMBERS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_NUMBERS_H

// Points that break predicates by their numbers: of every size a double has, on lattices and on
// spheres, exactly or up to a rounding. Each function makes n of them, all finite.

#include "random_bits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace fuzz {

using Coordinates = std::array<double, 3>;
using Points = std::vector<Coordinates>;

template <class Make>
Points repeated(std::size_t n, const Make& make)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(make());
  return points;
}

// From a function for one coordinate.
template <class Make>
Points by_coordinate(std::size_t n, const Make& make)
{
  return repeated(n, [&] {
    Coordinates p;
    for (double& c : p)
      c = make();
    return p;
  });
}

inline Points times(Points points, double factor)
{
  for (Coordinates& p : points)
    for (double& c : p)
      c *= factor;
  return points;
}

inline Points moved(Points points, const Coordinates& by)
{
  for (Coordinates& p : points)
    for (std::size_t c = 0; c < 3; ++c)
      p[c] += by[c];
  return points;
}

inline Points cube(Random& r, std::size_t n)
{
  return by_coordinate(n, [&] { return r.signed_unit(); });
}

inline Points sphere(Random& r, std::size_t n)
{
  return repeated(n, [&] {
    const double z = r.signed_unit(), a = 6.283185307179586 * r.unit(), s = std::sqrt(1 - z * z);
    return Coordinates{s * std::cos(a), s * std::sin(a), z};
  });
}

inline Points lattice(Random& r, std::size_t n)
{
  const int side = r.between(1, 6);
  return by_coordinate(n, [&] { return double(r.between(-side, side)); });
}

// --- sizes -------------------------------------------------------------------------------------

inline Points denormals(Random& r, std::size_t n)
{
  const int bits = r.between(1, 52);
  return by_coordinate(n, [&] { return std::ldexp(r.signed_unit(), bits - 1074); });
}

inline Points tiny(Random& r, std::size_t n)
{
  return times(sphere(r, n), std::ldexp(1., r.between(-1040, -900)));
}

inline Points huge(Random& r, std::size_t n)
{
  return times(r.one_in(2) ? sphere(r, n) : lattice(r, n), std::ldexp(1., r.between(300, 1019)));
}

inline Points near_the_largest_double(Random& r, std::size_t n)
{
  const double largest = (std::numeric_limits<double>::max)();
  return by_coordinate(n, [&] {
    return r.one_in(3) ? r.signed_unit() * largest : r.one_in(2) ? largest : -largest;
  });
}

inline Points factors_of_all_sizes(Random& r, std::size_t n)
{
  return by_coordinate(n, [&] { return std::ldexp(r.signed_unit(), r.between(-1000, 1000)); });
}

inline Points points_of_all_sizes(Random& r, std::size_t n)
{
  Points points = sphere(r, n);
  for (Coordinates& p : points) {
    const int e = r.between(-1074, 1020);
    for (double& c : p)
      c = std::ldexp(c, e);
  }
  return points;
}

inline Points two_sizes_far_apart(Random& r, std::size_t n)
{
  const int large = r.between(400, 1000), small = r.between(-1070, large - 1023);
  return by_coordinate(
      n, [&] { return std::ldexp(double(r.between(-4, 4)), r.one_in(2) ? large : small); });
}

inline Points sizes_within_a_filters_reach(Random& r, std::size_t n)
{
  const int range = r.between(1, 80);
  return by_coordinate(n, [&] { return std::ldexp(r.signed_unit(), r.between(-range, range)); });
}

// Flat or thin along the axes: each coordinate times a power of 2 of its own.
inline Points flat_along_axes(Random& r, std::size_t n)
{
  Points points = r.one_in(3) ? lattice(r, n) : r.one_in(2) ? sphere(r, n) : cube(r, n);
  Coordinates factors;
  for (double& f : factors)
    f = std::ldexp(1., -int(r.one_in(2) ? 0 : r.between(0, r.one_in(2) ? 80 : 400)));
  const std::size_t axis = r.below(3); // a lattice with noise, as a sheet that was turned back
  const double noise = r.one_in(2) ? 0 : std::ldexp(1., -r.between(20, 200));
  for (Coordinates& p : points) {
    for (std::size_t c = 0; c < 3; ++c)
      p[c] *= factors[c];
    p[axis] = noise == 0 ? p[axis] : noise * r.signed_unit();
  }
  return points;
}

// The same in any direction, up to rounding.
inline Points flat_and_turned(Random& r, std::size_t n)
{
  Points points = flat_along_axes(r, n);
  const double a = r.unit(), b = r.unit();
  for (Coordinates& p : points) {
    const double x = std::cos(a) * p[0] - std::sin(a) * p[1],
                 y = std::sin(a) * p[0] + std::cos(a) * p[1];
    p = {x, std::cos(b) * y - std::sin(b) * p[2], std::sin(b) * y + std::cos(b) * p[2]};
  }
  return points;
}

// Some points, or one coordinate of them, 2^k times as large; or a mark in its place.
inline Points some_far_away(Random& r, std::size_t n)
{
  Points points = r.one_in(3) ? lattice(r, n) : sphere(r, n);
  const int k = r.between(10, r.one_in(2) ? 150 : 1000);
  const std::size_t share = 1 + r.below(20), axis = r.below(3), kind = r.below(3);
  for (Coordinates& p : points)
    if (r.one_in(share)) {
      const int e = r.one_in(4) ? -k : k;
      for (std::size_t c = 0; c < 3; ++c)
        if (kind == 0 || c == axis)
          p[c] = kind == 2 ? std::ldexp(1., k) : std::ldexp(p[c], e);
    }
  return points;
}

// --- lattices ----------------------------------------------------------------------------------

inline Points tenths(Random& r, std::size_t n)
{
  return times(lattice(r, n), .1);
}

inline Points tenths_far_away(Random& r, std::size_t n)
{
  return moved(tenths(r, n), {1e9, -1e9, r.one_in(2) ? 1e9 : 0});
}

inline Points long_integers(Random& r, std::size_t n)
{
  const int bits = r.between(20, 53);
  const double side = std::ldexp(1., bits);
  return by_coordinate(n, [&] {
    return r.one_in(3) ? (r.one_in(2) ? side : -side) : std::floor(side * r.signed_unit());
  });
}

inline Points other_steps_on_each_axis(Random& r, std::size_t n)
{
  const Coordinates steps = {r.unit(), std::ldexp(1., r.between(-60, 0)), 1e-9 * r.unit()};
  Points points = lattice(r, n);
  for (Coordinates& p : points)
    for (std::size_t c = 0; c < 3; ++c)
      p[c] *= steps[c];
  return points;
}

inline Points nudged_by_ulps(Random& r, std::size_t n)
{
  Points points = r.one_in(2) ? lattice(r, n) : tenths_far_away(r, n);
  for (Coordinates& p : points)
    for (double& c : p)
      for (int steps = r.between(0, 3); steps > 0 && r.one_in(2); --steps)
        c = std::nextafter(c, r.one_in(2) ? 1e300 : -1e300);
  return points;
}

// --- spheres -----------------------------------------------------------------------------------

// All signs and orders of three numbers that are up to 85 binary places apart: cospherical,
// exactly.
inline Points cospherical_85_bits(Random& r, std::size_t n)
{
  Coordinates abc;
  for (double& c : abc)
    c = std::ldexp(r.unit(), -r.between(0, r.one_in(2) ? 85 : 20));
  return repeated(n, [&] {
    Coordinates p;
    for (std::size_t c = 0, from = r.below(3), step = 1 + r.below(2); c < 3; ++c)
      p[c] = (r.one_in(2) ? 1 : -1) * abc[(from + step * c) % 3];
    return p;
  });
}

// x^2 + y^2 + z^2 = a sum with many solutions.
inline Points integer_sphere(Random& r, std::size_t n)
{
  const int sums[] = {101, 194, 341, 1001, 2309, 5174};
  const int sum = sums[r.below(6)], root = int(std::sqrt(sum));
  Points all;
  for (int x = -root; x <= root; ++x)
    for (int y = -root; y <= root; ++y) {
      const int rest = sum - x * x - y * y, z = rest < 0 ? -1 : int(std::lround(std::sqrt(rest)));
      if (z >= 0 && z * z == rest)
        all.push_back({double(x), double(y), double(r.one_in(2) ? z : -z)});
    }
  const double factor = r.one_in(2) ? 1 : std::ldexp(1., r.between(-200, 200));
  return times(repeated(n, [&] { return all[r.below(all.size())]; }), factor);
}

inline Points sphere_with_noise(Random& r, std::size_t n)
{
  Points points = sphere(r, n);
  const int e = r.between(-56, -5);
  for (Coordinates& p : points) {
    const double factor = 1 - std::ldexp(r.unit(), e);
    for (double& c : p)
      c *= factor;
  }
  return points;
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_NUMBERS_H
