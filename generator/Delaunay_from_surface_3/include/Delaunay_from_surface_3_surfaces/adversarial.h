// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_ADVERSARIAL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_ADVERSARIAL_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace surfaces {

// Surfaces that mislead an order made from them, or whose triangulation is large whatever the
// order.

/// A hub, vertex 0, and a fan of triangles around it: `n` - 1 points at random directions and
/// distances between 0.9 and 1 from the hub. \pre `n >= 3`
inline Indexed_surface star(std::size_t n, std::uint64_t seed)
{
  require(n >= 3, "a star needs at least 3 vertices");
  Random random(seed);
  Indexed_surface surface;
  surface.points.emplace_back(0, 0, 0);
  for (std::size_t i = 1; i < n; ++i) {
    Indexed_surface::Vector_3 v = random.in_ball();
    while (v.squared_length() < 0.01)
      v = random.in_ball();
    surface.points.push_back(CGAL::ORIGIN +
                             random.uniform(0.9, 1) / std::sqrt(v.squared_length()) * v);
    if (i > 1)
      surface.faces.push_back({0, i - 1, i});
  }
  return surface;
}

/// `n` random points on a sphere with noise, and 2 `n` faces that join three of them at random.
/// \pre `n >= 3`
inline Indexed_surface faces_at_random(std::size_t n, std::uint64_t seed)
{
  require(n >= 3, "faces at random need at least 3 vertices");
  Indexed_surface surface = star(n, seed); // its points but for the hub
  surface.faces.clear();
  surface.points[0] = Indexed_surface::Point_3(1, 0, 0);
  Random random(seed + 1);
  while (surface.faces.size() < 2 * n) {
    const std::size_t a = random.below(n), b = random.below(n), c = random.below(n);
    if (a != b && b != c && c != a)
      surface.faces.push_back({a, b, c});
  }
  return surface;
}

/// `n` points on two lines askew, joined by a band of triangles: every two neighbours of one line
/// form a cell with every two of the other, n^2 / 4 altogether. \pre `n >= 4`
inline Indexed_surface two_lines(std::size_t n)
{
  require(n >= 4, "two lines need at least 4 vertices");
  const std::size_t half = n / 2;
  Indexed_surface surface;
  for (std::size_t i = 0; i < half; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(half - 1) - 0.5;
    surface.points.emplace_back(t, 0.01 * t * t, -1);
    surface.points.emplace_back(0.01 * t * t, t, 1);
    if (i == 0)
      continue;
    surface.faces.push_back({2 * i - 2, 2 * i - 1, 2 * i});
    surface.faces.push_back({2 * i, 2 * i - 1, 2 * i + 1});
  }
  return surface;
}

/// Disjoint stars of 16 vertices: their hubs lie in turn on two lines askew, the 15 leaves of each,
/// joined to a fan of triangles, anywhere in a ball. All hubs alone have a
/// triangulation of quadratic size, all points do not. \pre `n >= 64`
inline Indexed_surface skew_stars(std::size_t n, std::uint64_t seed)
{
  require(n >= 64, "skew stars need at least 64 vertices");
  constexpr std::size_t leaves = 15;
  const std::size_t stars = n / (leaves + 1);
  Random random(seed);
  Indexed_surface surface;
  for (std::size_t k = 0; k < stars; ++k) {
    const std::size_t hub = surface.points.size();
    const double t = double(k) / double(stars - 1) - 0.5;
    if (k % 2 == 0)
      surface.points.emplace_back(t, 0.01 * t * t, -0.5);
    else
      surface.points.emplace_back(0.01 * t * t, t, 0.5);
    for (std::size_t i = 1; i <= leaves; ++i) {
      surface.points.push_back(CGAL::ORIGIN + random.in_ball());
      if (i > 1)
        surface.faces.push_back({hub, hub + i - 1, hub + i});
    }
  }
  return surface;
}

/// A room: about `n` points of the six walls of a cube that bulge inwards, moved at random along
/// them and denser in their middles, and one point in the middle of the room, in no face, the last.
/// In the triangulation of all points it is a neighbour of about a quarter of them, but the cells
/// are few. \pre `n >= 9`
inline Indexed_surface room(std::size_t n, std::uint64_t seed)
{
  require(n >= 9, "a room needs at least 9 vertices");
  const std::size_t cells = static_cast<std::size_t>(std::lround(std::sqrt(double(n - 3) / 6)));
  Indexed_surface surface = lattice_surface(0, 6 * cells * cells + 2);
  Random random(seed);
  const double half = (*std::max_element(surface.points.begin(), surface.points.end())).x() / 2;
  for (Indexed_surface::Point_3& p : surface.points) {
    std::array<double, 3> q = {p.x() / half - 1, p.y() / half - 1, p.z() / half - 1};
    for (double& x : q)
      if (std::abs(x) < 1)
        x += random.uniform(-0.4, 0.4) / half;
    for (double& x : q)
      x *= 0.4 + 0.6 * x * x;
    const std::array<double, 3> wall = q;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(wall[k]) == 1) {
        const double u = wall[(k + 1) % 3], v = wall[(k + 2) % 3];
        q[k] *= 1 - 0.05 * (1 - u * u) * (1 - v * v);
      }
    p = Indexed_surface::Point_3(q[0], q[1], q[2]);
  }
  surface.points.emplace_back(0, 0, 0);
  return surface;
}

/// About `n` points of the unit square, moved off a grid at random, and off their plane by up to
/// `noise`. \pre `n >= 4`
inline Indexed_surface nearly_flat(std::size_t n, double noise, std::uint64_t seed)
{
  require(n >= 4, "a nearly flat patch needs at least 4 vertices");
  Random random(seed);
  return internal::grid_patch(n, [&](double i, double j, double last) {
    const double x = (i + random.uniform(0, 0.4)) / last, y = (j + random.uniform(0, 0.4)) / last;
    return Indexed_surface::Point_3(x, y, random.uniform(-noise, noise));
  });
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_ADVERSARIAL_H
