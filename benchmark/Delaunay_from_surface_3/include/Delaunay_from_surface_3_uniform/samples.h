// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_SAMPLES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_SAMPLES_H

// Points on one smooth surface, spread in ways that are not locally uniform.

#include <Delaunay_from_surface_3_surfaces/random.h>
#include <Delaunay_from_surface_3_surfaces/restricted_delaunay.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace uniform {

using Point = surfaces::Indexed_surface::Point_3;
using Vector = surfaces::Indexed_surface::Vector_3;

struct Sample
{
  std::string name;
  std::vector<Point> points;
};

/// Three joined tori with oval tubes, of genus 3.
inline surfaces::Oval_torus_chain shape_of_samples()
{
  return surfaces::Oval_torus_chain(3);
}

namespace internal {

// The point of the surface that Newton's method finds from p, in the plane of p's x if `in_plane`.
template <class Shape>
std::optional<Point> on_surface(const Shape& shape, Point p, bool in_plane)
{
  constexpr double h = 1e-5;
  for (int step = 0; step < 20; ++step) {
    const double f = shape(p);
    if (std::abs(f) < 1e-12)
      return p;
    const auto slope = [&](const Vector& v) { return (shape(p + v) - shape(p - v)) / (2 * h); };
    const Vector gradient(in_plane ? 0 : slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h}));
    if (gradient.squared_length() < 0.04) // nearly tangent to the plane
      return std::nullopt;
    p = p - f / gradient.squared_length() * gradient;
  }
  return std::nullopt;
}

// Random points in a thin shell around the surface, moved by `place` and then onto the surface;
// `place` may refuse them.
template <class Place>
std::vector<Point> points_on_surface(std::size_t n, std::uint64_t seed, bool in_plane,
                                     const Place& place)
{
  const surfaces::Oval_torus_chain shape = shape_of_samples();
  surfaces::Random random(seed);
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = random.uniform(-3.4, 3.4), y = random.uniform(-1.7, 1.7);
    const Point in_box(x, y, random.uniform(-0.7, 0.7));
    if (std::abs(shape(in_box)) > 0.02)
      continue;
    if (const std::optional<Point> p = place(in_box, random))
      if (const std::optional<Point> q = on_surface(shape, *p, in_plane))
        points.push_back(*q);
  }
  return points;
}

} // namespace internal

/// Samples of n points each.
inline std::vector<Sample> samples(std::size_t n, std::uint64_t seed)
{
  using Maybe = std::optional<Point>;
  const auto anywhere = [](const Point& p, surfaces::Random&) { return Maybe(p); };
  // Thirty times as dense at one end as at the other.
  const auto denser_at_one_end = [](const Point& p, surfaces::Random& random) {
    return random.uniform(0, 1) < std::pow(30, -(p.x() + 3.4) / 6.8) ? Maybe(p) : std::nullopt;
  };
  // On curves in parallel planes, on which the points are ten times as near to each other as the
  // planes are: the area is about 80, and 6.8 / step curves have a length of 80 / 6.8 each.
  const double step = std::sqrt(10 * 80 / double(n));
  const auto on_curves = [step](const Point& p, surfaces::Random&) {
    return Maybe(Point(step * std::round(p.x() / step), p.y(), p.z()));
  };
  return {{"at random", internal::points_on_surface(n, seed, false, anywhere)},
          {"denser at one end", internal::points_on_surface(n, seed, false, denser_at_one_end)},
          {"on curves", internal::points_on_surface(n, seed, true, on_curves)}};
}

} // namespace uniform

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_SAMPLES_H
