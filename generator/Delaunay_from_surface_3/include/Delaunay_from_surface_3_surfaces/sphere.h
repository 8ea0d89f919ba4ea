// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SPHERE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SPHERE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace surfaces {
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
  CGAL::Surface_mesh<Indexed_surface::Point_3> hull;
  CGAL::convex_hull_3(best.begin(), best.end(), hull);
  return from_mesh(hull);
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SPHERE_H
