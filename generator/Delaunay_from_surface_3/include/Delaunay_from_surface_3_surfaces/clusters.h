// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CLUSTERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CLUSTERS_H

// Points alone, which are soups without faces: random ones, and such that crowd in places, as those
// of astronomy and of neural rendering do.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace surfaces {

/// A vector of length 1, all directions equally likely.
inline Random::Vector_3 random_direction(Random& random)
{
  Random::Vector_3 v;
  do
    v = random.in_ball();
  while (v.squared_length() < .01);
  return v / std::sqrt(v.squared_length());
}

/// Random points of a box, one of whose corners is the origin.
inline Indexed_surface points_in_box(std::size_t n, double a, double b, double c,
                                     std::uint64_t seed)
{
  Random random(seed);
  Indexed_surface s;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform(0, a), y = random.uniform(0, b), z = random.uniform(0, c);
    s.points.emplace_back(x, y, z);
  }
  return s;
}

/// A star cluster: the share m of the mass is within \f$ (m^{-2/3} - 1)^{-1/2} \f$ (Plummer 1911).
/// The outermost hundredth is left out.
inline Indexed_surface plummer_sphere(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Indexed_surface s;
  for (std::size_t i = 0; i < n; ++i) {
    const double m = random.uniform(1e-9, .99);
    s.points.push_back(CGAL::ORIGIN +
                       random_direction(random) / std::sqrt(std::pow(m, -2. / 3) - 1));
  }
  return s;
}

/// Clusters of clusters (Soneira, Peebles 1978): in a ball lie four smaller ones, in each of them
/// four again, on nine levels, each smaller by 1.9; the points are drawn from the balls of the last
/// level.
inline Indexed_surface soneira_peebles(std::size_t n, std::uint64_t seed)
{
  constexpr std::size_t children = 4, levels = 9;
  constexpr double shrinks_by = 1.9;
  Random random(seed);
  std::vector<Indexed_surface::Point_3> centers = {CGAL::ORIGIN};
  double radius = 1;
  for (std::size_t level = 0; level < levels; ++level, radius /= shrinks_by) {
    std::vector<Indexed_surface::Point_3> next;
    for (const auto& c : centers)
      for (std::size_t k = 0; k < children; ++k)
        next.push_back(c + radius * random.in_ball());
    centers.swap(next);
  }
  Indexed_surface s;
  for (std::size_t i = 0; i < n; ++i)
    s.points.push_back(centers[random.below(centers.size())] + radius * random.in_ball());
  return s;
}

/// A rotation, all equally likely (Shoemake 1992: by a random quaternion).
inline std::array<std::array<double, 3>, 3> random_rotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  double q[4], square = 0;
  for (double& x : q)
    x = normal(random), square += x * x;
  for (double& x : q)
    x /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// Of each of many Gaussians near a surface the centre and the corners of a box, in no order that
/// helps, as programs of neural rendering make them; float coordinates. Sizes vary over three decades,
/// and from axis to axis.
inline Indexed_surface boxes_of_gaussians(std::size_t n, std::uint64_t seed)
{
  const auto centers = genus_surface(3, n / 9, 0.05, seed).points;
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  std::uniform_real_distribution<double> exponent(-4, -1), flatness(.1, 1);
  std::normal_distribution<double> off(0, .01);
  Indexed_surface s;
  for (const auto& c : centers) {
    const auto axes = random_rotation(random);
    const double size = std::pow(10, exponent(random));
    const double half[3] = {size * flatness(random), size * flatness(random),
                            size * flatness(random)};
    const double center[3] = {c.x() + off(random), c.y() + off(random), c.z() + off(random)};
    const auto add = [&](double t, double u, double v) {
      float p[3];
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = float(center[k] + t * half[0] * axes[k][0] + u * half[1] * axes[k][1] +
                     v * half[2] * axes[k][2]);
      s.points.emplace_back(p[0], p[1], p[2]);
    };
    add(0, 0, 0);
    for (int corner = 0; corner < 8; ++corner)
      add(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  }
  return s;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CLUSTERS_H
