// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_ADVERSARIAL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_ADVERSARIAL_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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

/// The first `n` of three points, and their triangle when all are there. \pre `n <= 3`
inline Indexed_surface few_points(std::size_t n)
{
  require(n <= 3, "there are at most 3 points");
  Indexed_surface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.points.resize(n);
  if (n == 3)
    surface.faces.push_back({0, 1, 2});
  return surface;
}

/// A band of triangles without area on `n` points of one line, exactly collinear. \pre `n >= 3`
inline Indexed_surface collinear(std::size_t n)
{
  require(n >= 3, "a collinear band needs at least 3 vertices");
  Indexed_surface surface;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    surface.points.emplace_back(t, 2 * t, 3 * t);
  }
  for (std::size_t i = 0; i + 2 < n; ++i) // neighbours in a band of triangles turn opposite ways
    surface.faces.push_back(i % 2 == 0 ? Indexed_surface::Face{i, i + 1, i + 2}
                                       : Indexed_surface::Face{i + 1, i, i + 2});
  return surface;
}

/// A square piece of the integer lattice with about `n` points in the plane x + y + z = 0, exactly
/// coplanar, with cocircular squares. \pre `n >= 4`
inline Indexed_surface coplanar(std::size_t n)
{
  require(n >= 4, "a coplanar patch needs at least 4 vertices");
  return internal::grid_patch(
      n, [](double x, double y, double) { return Indexed_surface::Point_3(x + y, x - y, -2 * x); });
}

/// Adds `count` duplicates of points, each of which takes over one random face of its original: a
/// soup that is torn open there.
/// \pre there is a face
inline void duplicate_points(Indexed_surface& surface, std::size_t count, std::uint64_t seed)
{
  require(!surface.faces.empty(), "there are no faces to take points from");
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    Indexed_surface::Face& face = surface.faces[random.below(surface.faces.size())];
    std::size_t& corner = face[random.below(3)];
    surface.points.push_back(Indexed_surface::Point_3(surface.points[corner]));
    corner = surface.points.size() - 1;
  }
}

/// Gives every face three points of its own, as in an STL file.
inline void separate_faces(Indexed_surface& surface)
{
  Indexed_surface result;
  for (const Indexed_surface::Face& face : surface.faces) {
    const std::size_t first = result.points.size();
    for (std::size_t v : face)
      result.points.push_back(surface.points[v]);
    result.faces.push_back({first, first + 1, first + 2});
  }
  surface = std::move(result);
}

// Surfaces whose coordinates are of very different size: along one axis, or in some of the points.

/// A square lattice of about `n` points at distance 1, off its plane by up to 2^-`k`. \pre `n >= 4`
inline Indexed_surface noisy_sheet(std::size_t n, int k, std::uint64_t seed)
{
  require(n >= 4, "a sheet needs at least 4 vertices");
  Random random(seed);
  const double noise = std::ldexp(1., -k);
  return internal::grid_patch(n, [&](double x, double y, double) {
    return Indexed_surface::Point_3(x, y, random.uniform(-noise, noise));
  });
}

/// The same lattice, exactly in its plane but for every tenth point, which is off by `height`, as
/// rotations and text files leave it. \pre `n >= 4`
inline Indexed_surface dented_sheet(std::size_t n, double height)
{
  require(n >= 4, "a sheet needs at least 4 vertices");
  std::size_t i = 0;
  return internal::grid_patch(n, [&](double x, double y, double) {
    return Indexed_surface::Point_3(x, y, i++ % 10 == 0 ? height : 0);
  });
}

/// An open tube along the x axis of length 1 and radius 2^-`k`: about `n` points in rings of 24.
/// \pre `n >= 48`
inline Indexed_surface thin_tube(std::size_t n, int k)
{
  const std::size_t around = 24, rings = n / around;
  require(rings >= 2, "a tube needs at least 48 vertices");
  const double radius = std::ldexp(1., -k), turn = 2 * internal::pi;
  Indexed_surface surface;
  for (std::size_t i = 0; i < rings; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const double a = turn * double(j) / double(around);
      surface.points.emplace_back(double(i) / double(rings - 1), radius * std::cos(a),
                                  radius * std::sin(a));
      if (i + 1 == rings)
        continue;
      const std::size_t j1 = (j + 1) % around, p = i * around, q = p + around;
      surface.faces.push_back({p + j, p + j1, q + j});
      surface.faces.push_back({p + j1, q + j1, q + j});
    }
  return surface;
}

/// A sphere with noise, of whose points every tenth is 2^`k` times as far from the origin.
inline Indexed_surface far_points(std::size_t n, int k, std::uint64_t seed)
{
  Indexed_surface surface = sphere(n, 0.01, seed);
  const double factor = std::ldexp(1., k);
  for (std::size_t i = 0; i < surface.points.size(); i += 10) {
    const Indexed_surface::Point_3 p = surface.points[i];
    surface.points[i] = Indexed_surface::Point_3(factor * p.x(), factor * p.y(), factor * p.z());
  }
  return surface;
}

/// A sphere with noise, of whose points every twentieth has z = 2^`k`, as programs that mark what
/// they do not know.
inline Indexed_surface sentinels(std::size_t n, int k, std::uint64_t seed)
{
  Indexed_surface surface = sphere(n, 0.01, seed);
  for (std::size_t i = 0; i < surface.points.size(); i += 20) {
    const Indexed_surface::Point_3 p = surface.points[i];
    surface.points[i] = Indexed_surface::Point_3(p.x(), p.y(), std::ldexp(1., k));
  }
  return surface;
}

/// About `n` points at one place, joined as a square lattice is. \pre `n >= 4`
inline Indexed_surface all_equal(std::size_t n)
{
  return internal::grid_patch(
      n, [](double, double, double) { return Indexed_surface::Point_3(.1, .2, .3); });
}

/// One of these surfaces, and what it is called.
struct Flat_or_far_family
{
  std::string name, kind;
  std::function<Indexed_surface(std::size_t n, std::uint64_t seed)> make;
};

/// All of them, with the exponents at which the stages of exact predicates take turns.
inline std::vector<Flat_or_far_family> flat_and_far_families()
{
  std::vector<Flat_or_far_family> families;
  const auto power = [](int k) { return "2^" + std::to_string(k); };
  for (const int k : {38, 40, 45, 52, 66, 80, 92, 120, 160})
    families.push_back({"sheet", "noise " + power(-k), [k](std::size_t n, std::uint64_t seed) {
                          return noisy_sheet(n, k, seed);
                        }});
  families.push_back({"sheet", "a tenth at z = 1e-17",
                      [](std::size_t n, std::uint64_t) { return dented_sheet(n, 1e-17); }});
  families.push_back({"tube", "radius " + power(-60),
                      [](std::size_t n, std::uint64_t) { return thin_tube(n, 60); }});
  for (const int k : {60, 100, 123, 200, 500, 996})
    families.push_back({"every tenth point far away", power(k),
                        [k](std::size_t n, std::uint64_t seed) { return far_points(n, k, seed); }});
  families.push_back({"sentinels", "every twentieth z is " + power(123),
                      [](std::size_t n, std::uint64_t seed) { return sentinels(n, 123, seed); }});
  return families;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_ADVERSARIAL_H
