// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PARAMETRIC_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PARAMETRIC_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace surfaces {
namespace internal {

// A grid of points, `position(i, j)`, row by row. If it is closed, the last row and column are joined
// to the first ones.
template <class Position>
Indexed_surface grid(std::size_t rows, std::size_t columns, bool is_closed, Position position)
{
  Indexed_surface surface;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      surface.points.push_back(position(i, j));
      if (!is_closed && (i + 1 == rows || j + 1 == columns))
        continue;
      const std::size_t p = i * columns, q = (i + 1) % rows * columns, j1 = (j + 1) % columns;
      surface.faces.push_back({p + j, q + j, q + j1});
      surface.faces.push_back({p + j, q + j1, p + j1});
    }
  return surface;
}

// About n points in a square grid, `position(i, j, last)` with i and j from 0 to last, joined to a
// disc.
template <class Position>
Indexed_surface grid_patch(std::size_t n, Position position)
{
  const std::size_t side = (std::max)(std::size_t(2), static_cast<std::size_t>(std::sqrt(n) + 0.5));
  return grid(side, side, false, [&](std::size_t i, std::size_t j) {
    return position(double(i), double(j), double(side - 1));
  });
}

constexpr double tube_of_torus = 0.4;

// Returns the point of a torus at these angles around its axis and around its tube.
inline Indexed_surface::Point_3 point_of_torus(double a, double b)
{
  const double radius = 1 + tube_of_torus * std::cos(b);
  return {radius * std::cos(a), radius * std::sin(a), tube_of_torus * std::sin(b)};
}

} // namespace internal

/// A torus with about `n` points on a regular grid of its two angles: every row of the grid is
/// cocircular up to rounding.
inline Indexed_surface grid_torus(std::size_t n)
{
  using namespace internal;
  const auto at_least_3 = [](std::size_t k) { return (std::max)(std::size_t(3), k); };
  const std::size_t v = at_least_3(std::size_t(std::sqrt(tube_of_torus * n) + 0.5));
  const std::size_t u = at_least_3((n + v / 2) / v);
  return grid(u, v, true, [&](std::size_t i, std::size_t j) {
    return point_of_torus(2 * pi * double(i) / double(u), 2 * pi * double(j) / double(v));
  });
}

/// A piece of hilly land over the unit square: a disc with about `n` points, one boundary loop.
/// The seed shapes the hills. \pre `n >= 4`
inline Indexed_surface terrain(std::size_t n, std::uint64_t seed = 0)
{
  Random random(seed);
  std::vector<std::array<double, 4>> waves; // two frequencies, phase, height
  for (int octave = 1; octave <= 8; ++octave)
    waves.push_back({random.uniform(-4, 4) * octave, random.uniform(-4, 4) * octave,
                     random.uniform(0, 6.28), 0.15 / octave});
  return internal::grid_patch(n, [&waves](double i, double j, double last) {
    const double x = i / last, y = j / last;
    double height = 0;
    for (const std::array<double, 4>& wave : waves)
      height += wave[3] * std::sin(wave[0] * x + wave[1] * y + wave[2]);
    return Indexed_surface::Point_3(x, y, height);
  });
}

namespace internal {

// 1, 1, 2, 3, 5, …, up to the Fibonacci number that is nearest to n by ratio.
inline std::vector<std::size_t> fibonacci_numbers(std::size_t n)
{
  std::vector<std::size_t> numbers = {1, 1};
  while (numbers.back() < n)
    numbers.push_back(numbers.end()[-2] + numbers.end()[-1]);
  if (double(numbers.back()) * double(numbers.end()[-2]) > double(n) * double(n))
    numbers.pop_back();
  return numbers;
}

} // namespace internal

/// A smooth torus (radii 1 and 0.4) whose points wind around it: of m, the Fibonacci number nearest
/// to `n`, the i-th lies at the angles 2 pi i / m and 2 pi (i l mod m) / m, where l is the Fibonacci
/// number before m. All points have the same neighbours, as far as the torus is flat.
/// \pre `n >= 55`
inline Indexed_surface winding_torus(std::size_t n)
{
  require(n >= 55, "a winding torus needs at least 55 vertices");
  const std::vector<std::size_t> numbers = internal::fibonacci_numbers(n);
  const std::size_t m = numbers.end()[-1], l = numbers.end()[-2];
  Indexed_surface surface;
  for (std::size_t i = 0; i < m; ++i)
    surface.points.push_back(
        internal::point_of_torus(2 * internal::pi * double(i) / double(m),
                                 2 * internal::pi * double(i * l % m) / double(m)));
  // So many points on, one is numbers[k] farther around the axis, and numbers[size - 2 - k] around the
  // tube. Neighbours are three such steps in succession, of which two make the third.
  const auto squared_length = [&](std::size_t k) {
    const double x = double(numbers[k]),
                 y = internal::tube_of_torus * double(numbers[numbers.size() - 2 - k]);
    return x * x + y * y;
  };
  std::size_t k = 1;
  while (squared_length(k + 2) < squared_length(k - 1))
    ++k;
  const bool is_odd = k % 2 == 1; // successive numbers go around the tube in opposite directions
  const std::size_t s = numbers[is_odd ? k : k - 1], t = numbers[is_odd ? k - 1 : k];
  for (std::size_t i = 0; i < m; ++i) {
    surface.faces.push_back({i, (i + s) % m, (i + s + t) % m});
    surface.faces.push_back({i, (i + s + t) % m, (i + t) % m});
  }
  return surface;
}

/// About `n` points on a round tube of radius 1 and length 20, open at both ends: in rings, one
/// exactly behind the other, so that each ring and each square of neighbours is cocircular up to
/// rounding. \pre `n >= 60`
inline Indexed_surface round_tube(std::size_t n)
{
  require(n >= 60, "a round tube needs at least 60 vertices");
  const double pi = internal::pi, length = 20;
  const auto around = static_cast<std::size_t>(std::lround(std::sqrt(2 * pi / length * double(n))));
  const std::size_t rings = n / around;
  Indexed_surface surface;
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t i = 0; i < around; ++i) {
      const double a = 2 * pi * double(i) / double(around);
      surface.points.emplace_back(std::cos(a), std::sin(a), length * double(r) / double(rings - 1));
      if (r == 0)
        continue;
      const std::size_t j = (i + 1) % around, top = r * around, below = top - around;
      surface.faces.push_back({below + i, below + j, top + j});
      surface.faces.push_back({below + i, top + j, top + i});
    }
  return surface;
}

namespace internal {

// A circle of latitude with `count` equally spaced points, the first of them at the fraction
// `shift` of a step.
struct Ring
{
  std::size_t first, count;
  double shift;

  double angle(std::size_t i) const
  {
    return (static_cast<double>(i) + shift) / static_cast<double>(count);
  }
  std::size_t point(std::size_t i) const { return first + i % count; }
};

// Spreads n points over rings such that they lie about as dense on each; at least 3 on every ring.
inline std::vector<Ring> rings_of_sphere(std::size_t n, Random& random)
{
  const double side = std::sqrt(8 * pi / (std::sqrt(3.) * static_cast<double>(n))); // of a triangle
  const std::size_t bands = static_cast<std::size_t>(pi / (side * std::sqrt(0.75)) + 0.5);
  const std::size_t rings = (std::min)(bands - 1, (n - 2) / 3);
  std::vector<double> up_to(rings + 1, 0.);
  for (std::size_t i = 0; i < rings; ++i) {
    const double ideal =
        2 * pi * std::sin(pi * static_cast<double>(i + 1) / static_cast<double>(rings + 1)) / side;
    up_to[i + 1] = up_to[i] + (std::max)(ideal - 3, 0.01);
  }
  const double rest = static_cast<double>(n - 2 - 3 * rings);
  std::vector<Ring> result;
  for (std::size_t i = 0, first = 1; i < rings; ++i) {
    const double low = std::round(rest * up_to[i] / up_to.back());
    const double high = std::round(rest * up_to[i + 1] / up_to.back());
    result.push_back({first, 3 + static_cast<std::size_t>(high - low), random.uniform(0, 1)});
    first += result.back().count;
  }
  return result;
}

// Fills the band between two rings, the first of them the northern one.
inline void join_rings(const Ring& a, const Ring& b, std::vector<Indexed_surface::Face>& faces)
{
  std::size_t i = 0, j = 0;
  while (i < a.count || j < b.count) {
    if (j == b.count || (i < a.count && a.angle(i + 1) < b.angle(j + 1))) {
      faces.push_back({a.point(i), b.point(j), a.point(i + 1)});
      ++i;
    } else {
      faces.push_back({a.point(i), b.point(j), b.point(j + 1)});
      ++j;
    }
  }
}

} // namespace internal

/// The unit sphere with exactly `n` points in rings, each moved along its radius by a normally
/// distributed share of the radius with standard deviation `noise`. Without noise the points are
/// cospherical up to rounding. \pre `n >= 5`
inline Indexed_surface sphere(std::size_t n, double noise = 0, std::uint64_t seed = 0)
{
  require(n >= 5, "a sphere needs at least 5 vertices");
  require(noise >= 0, "the noise must not be negative");
  using Vector_3 = Indexed_surface::Vector_3;
  Random random(seed);
  Indexed_surface surface;
  const auto add = [&](double latitude, double longitude) {
    const Vector_3 v(std::sin(latitude) * std::cos(longitude),
                     std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    const double scale = noise > 0 ? (std::max)(1 + noise * random.normal(), 0.1) : 1.;
    surface.points.push_back(CGAL::ORIGIN + scale * v);
  };
  const std::vector<internal::Ring> rings = internal::rings_of_sphere(n, random);
  add(0, 0);
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].count; ++i)
      add(internal::pi * static_cast<double>(r + 1) / static_cast<double>(rings.size() + 1),
          2 * internal::pi * rings[r].angle(i));
  add(internal::pi, 0);
  const internal::Ring north = rings.front(), south = rings.back();
  for (std::size_t i = 0; i < north.count; ++i)
    surface.faces.push_back({0, north.point(i), north.point(i + 1)});
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    internal::join_rings(rings[r], rings[r + 1], surface.faces);
  for (std::size_t i = 0; i < south.count; ++i)
    surface.faces.push_back({n - 1, south.point(i + 1), south.point(i)});
  return surface;
}

/// All points with integer coordinates on the sphere x^2 + y^2 + z^2 = `squared_radius`, in
/// lexicographic order: exactly cospherical. O(squared_radius).
inline std::vector<Indexed_surface::Point_3> integer_points_on_sphere(long squared_radius)
{
  std::vector<Indexed_surface::Point_3> points;
  const long r = static_cast<long>(std::sqrt(static_cast<double>(squared_radius)));
  for (long x = -r; x <= r; ++x) {
    const long in_plane = squared_radius - x * x;
    const long s = static_cast<long>(std::sqrt(static_cast<double>(in_plane)));
    for (long y = -s; y <= s; ++y) {
      const long square = in_plane - y * y;
      const long z = std::lround(std::sqrt(static_cast<double>(square)));
      if (z * z != square)
        continue;
      if (z > 0)
        points.emplace_back(x, y, -z);
      points.emplace_back(x, y, z);
    }
  }
  return points;
}

/// The convex hull of integer points that lie exactly on one sphere, about `n` of them: of sixteen
/// radii of the right size the one that comes nearest. O(n^2), meant for some thousands.
/// \pre `n >= 6`
inline Indexed_surface integer_sphere(std::size_t n)
{
  require(n >= 6, "an integer sphere needs at least 6 vertices");
  // The number of integer points grows as 2 pi times the radius, with large swings.
  const double radius = static_cast<double>(n) / (2 * internal::pi);
  const long first = (std::max)(1L, static_cast<long>(radius * radius));
  std::vector<Indexed_surface::Point_3> best;
  const auto distance = [n](std::size_t m) { return m > n ? m - n : n - m; };
  for (long squared_radius = first; squared_radius < first + 16; ++squared_radius) {
    std::vector<Indexed_surface::Point_3> points = integer_points_on_sphere(squared_radius);
    if (points.size() >= 6 && (best.empty() || distance(points.size()) < distance(best.size())))
      best.swap(points);
  }
  Mesh hull;
  CGAL::convex_hull_3(best.begin(), best.end(), hull);
  return from_mesh(hull);
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PARAMETRIC_H
