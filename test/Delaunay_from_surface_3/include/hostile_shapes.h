// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_SHAPES_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_SHAPES_H

// Points that break a triangulation by their shape: flat, thin, the same, with as many cells as
// there can be.

#include "hostile_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fuzz {

// --- flat --------------------------------------------------------------------------------------

// In a plane across an axis, on which half of the sets are lattices.
inline Points flat(Random& r, std::size_t n)
{
  Points points = r.one_in(2) ? tenths(r, n) : cube(r, n);
  const std::size_t axis = r.below(3);
  const double height = r.one_in(2) ? .1 : 0;
  for (Coordinates& p : points)
    p[axis] = height;
  return points;
}

inline Points tilted_plane(Random& r, std::size_t n)
{
  Points points = cube(r, n);
  const double a = r.signed_unit(), b = r.signed_unit();
  const int e = r.between(-80, -5);
  for (Coordinates& p : points)
    p[2] = a * p[0] + b * p[1] + std::ldexp(r.signed_unit(), e);
  return points;
}

// In a plane through axes or diagonals, z = 0, z = x or z = x + y, exactly: the numbers have few
// bits. Every third set lies on a line in it. Of every size.
inline Points planes_of_all_sizes(Random& r, std::size_t n)
{
  const int bits = r.one_in(2) ? 3 : r.between(1, 29), plane = r.between(0, 2);
  const bool are_collinear = r.one_in(3);
  const int slope = r.between(-1, 1);
  const double size = std::ldexp(1., r.one_in(3) ? r.between(-20, 20) : r.between(-1074, 990));
  return repeated(n, [&] {
    const double x = r.between(-(1 << bits), 1 << bits);
    const double y = are_collinear ? slope * x : r.between(-(1 << bits), 1 << bits);
    const double z = plane == 0 ? 0 : plane == 1 ? x : x + y;
    return Coordinates{size * x, size * y, size * z};
  });
}

inline Points plane_and_one_point(Random& r, std::size_t n)
{
  Points points = flat(r, n);
  points.back() = {r.signed_unit(), r.signed_unit(), r.signed_unit()};
  return points;
}

inline Points plane_and_denormal_heights(Random& r, std::size_t n)
{
  Points points = lattice(r, n);
  const std::size_t axis = r.below(3);
  for (Coordinates& p : points)
    p[axis] *= std::ldexp(1., r.between(-1074, -1000));
  return points;
}

// Two parallel circles of points, and the axis: prisms and antiprisms.
inline Points circles(Random& r, std::size_t n)
{
  const std::size_t k = r.between(3, 24);
  const double turn = r.one_in(2) ? 0 : r.unit();
  return repeated(n, [&] {
    const double height = double(r.between(-1, 1)), a = 6.283185307179586 * double(r.below(k));
    const double angle = a / double(k) + height * turn;
    return r.one_in(10) ? Coordinates{0, 0, height * r.unit()}
                        : Coordinates{std::cos(angle), std::sin(angle), height};
  });
}

// --- thin --------------------------------------------------------------------------------------

inline Points collinear(Random& r, std::size_t n)
{
  const Coordinates direction = {double(r.between(-3, 3)), double(r.between(-3, 3)), 1};
  const double step = r.one_in(2) ? 1 : .1;
  return repeated(n, [&] {
    const double t = step * r.between(-100, 100);
    return Coordinates{t * direction[0], t * direction[1], t * direction[2]};
  });
}

inline Points nearly_collinear(Random& r, std::size_t n)
{
  const int e = r.between(-60, -10);
  return repeated(n, [&] {
    const double t = r.signed_unit();
    const double y = std::ldexp(r.signed_unit(), e), z = std::ldexp(r.signed_unit(), e);
    return Coordinates{t, t + y, t / 3 + z};
  });
}

inline Points line_and_few_points(Random& r, std::size_t n)
{
  Points points = collinear(r, n);
  for (std::size_t i = 0; i < n && i < 1 + r.below(4); ++i)
    points[i] = {r.signed_unit(), r.signed_unit(), r.signed_unit()};
  return points;
}

// --- the same ----------------------------------------------------------------------------------

inline Points duplicates(Random& r, std::size_t n)
{
  const Points few = r.one_in(2) ? cube(r, 1 + n / 4) : lattice(r, 1 + n / 4);
  return repeated(n, [&] { return few[r.below(few.size())]; });
}

inline Points all_equal(Random& r, std::size_t n)
{
  return Points(n, cube(r, 1).front());
}

inline Points all_equal_but_one(Random& r, std::size_t n)
{
  Points points = all_equal(r, n);
  points[r.below(n)] = cube(r, 1).front();
  return points;
}

inline Points zeros_of_both_signs(Random& r, std::size_t n)
{
  return by_coordinate(n,
                       [&] { return r.one_in(2) ? (r.one_in(2) ? 0. : -0.) : r.between(-1, 1); });
}

inline Points one_to_five(Random& r, std::size_t)
{
  const std::size_t n = 1 + r.below(5);
  return r.one_in(2) ? cube(r, n) : lattice(r, n);
}

// --- parts and scenes --------------------------------------------------------------------------

inline Points mirrored_parts(Random& r, std::size_t n)
{
  Points points = sphere_with_noise(r, (n + 1) / 2);
  const std::size_t axis = r.below(3);
  const double plane = r.one_in(2) ? 0 : .1;
  for (std::size_t i = 0, half = points.size(); i < half; ++i) {
    points.push_back(points[i]);
    points.back()[axis] = plane - points.back()[axis];
  }
  return points;
}

inline Points cluster_far_away(Random& r, std::size_t n)
{
  return moved(times(cube(r, n), std::ldexp(1., r.between(-40, 0))), {1e9, 3e8, -7e8});
}

inline Points clusters(Random& r, std::size_t n)
{
  const Points centers = cube(r, 4);
  const int e = r.between(-50, -10);
  return repeated(n, [&] {
    Coordinates p = centers[r.below(centers.size())];
    for (double& c : p)
      c += std::ldexp(r.signed_unit(), e);
    return p;
  });
}

// A hub over a ring: a star as large as the set.
inline Points hub_and_ring(Random& r, std::size_t n)
{
  Points points = sphere(r, n);
  for (Coordinates& p : points)
    p[2] *= std::ldexp(1., -20);
  points.front() = {0, 0, std::ldexp(1., r.between(-10, 10))};
  return points;
}

// Near the centre of a sphere the stars and conflict zones are as large as the set too, in any
// order.
inline Points sphere_and_its_centre(Random& r, std::size_t n)
{
  Points points = r.one_in(2) ? sphere(r, n) : integer_sphere(r, n);
  const double size = std::ldexp(1., r.between(-60, -3));
  for (std::size_t i = 0; i < n / 8; ++i)
    points[i] = times(cube(r, 1), size).front();
  return points;
}

// --- quadratic ---------------------------------------------------------------------------------

inline Points moment_curve(Random& r, std::size_t n)
{
  const double step = r.one_in(2) ? 1 : .01;
  return repeated(n, [&] {
    const double t = step * r.between(-200, 200);
    return Coordinates{t, t * t, t * t * t};
  });
}

inline Points two_skew_lines(Random& r, std::size_t n)
{
  const double noise = r.one_in(2) ? 0 : std::ldexp(1., r.between(-55, -20));
  return repeated(n, [&] {
    const double t = r.one_in(2) ? r.signed_unit() : .1 * r.between(-50, 50);
    const double e = noise * r.signed_unit();
    return r.one_in(2) ? Coordinates{t, e, 1} : Coordinates{e, t, -1};
  });
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_SHAPES_H
