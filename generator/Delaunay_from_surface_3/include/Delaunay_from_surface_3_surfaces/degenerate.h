// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DEGENERATE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DEGENERATE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/random.h>
#include <Delaunay_from_surface_3_surfaces/sphere.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace surfaces {

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DEGENERATE_H
