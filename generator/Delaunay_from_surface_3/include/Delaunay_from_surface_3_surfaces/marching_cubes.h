// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Marching_cubes_table.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace surfaces {

/// An image volume: values at the points of a cubic lattice, negative ones inside.
class Volume
{
public:
  /// `n` x `n` x `n` lattice points; on the rim all are outside, so that surfaces are closed.
  template <class Function>
  Volume(std::size_t n, const Function& value)
    : m_size(n)
    , m_values(n * n * n, 1.)
  {
    if (n < 3)
      throw std::invalid_argument("a volume needs at least 3 lattice points in each direction");
    for (std::size_t k = 1; k + 1 < n; ++k)
      for (std::size_t j = 1; j + 1 < n; ++j)
        for (std::size_t i = 1; i + 1 < n; ++i)
          m_values[number(i, j, k)] = value(i, j, k);
  }

  std::size_t size() const { return m_size; }
  std::size_t number(std::size_t i, std::size_t j, std::size_t k) const
  {
    return i + m_size * (j + m_size * k);
  }
  double operator[](std::size_t number) const { return m_values[number]; }

private:
  std::size_t m_size;
  std::vector<double> m_values;
};

/// A sum of waves, smooth where `frequency` times the spacing is small, in a cube of side 1; about
/// half of it is inside.
class Random_waves
{
public:
  Random_waves(double frequency, std::uint64_t seed)
  {
    Random random(seed);
    for (Wave& wave : m_waves) {
      for (double& x : wave.direction)
        x = frequency * random.normal();
      wave.phase = random.uniform(0, 6.28);
    }
  }

  double operator()(double x, double y, double z) const
  {
    double sum = 0;
    for (const Wave& w : m_waves)
      sum += std::sin(w.direction[0] * x + w.direction[1] * y + w.direction[2] * z + w.phase);
    return sum;
  }

private:
  struct Wave
  {
    std::array<double, 3> direction;
    double phase;
  };
  std::array<Wave, 12> m_waves;
};

inline Volume random_waves(std::size_t n, double frequency, std::uint64_t seed)
{
  const Random_waves waves(frequency, seed);
  const double h = 1. / double(n - 1);
  return Volume(n, [&](std::size_t i, std::size_t j, std::size_t k) {
    return waves(double(i) * h, double(j) * h, double(k) * h);
  });
}

/// Nothing but noise: the worst that a table has to serve.
inline Volume noise(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  return Volume(n, [&](std::size_t, std::size_t, std::size_t) { return random.uniform(-1, 1); });
}

namespace internal {

// What triangulates each loop as the table says.
struct Table_triangulation
{
  const Marching_cubes_table& table;

  template <class Points>
  const Marching_cubes_table::Triangulation& operator()(int inside, std::size_t loop,
                                                        const Points&) const
  {
    return table.triangulations_of_loops(inside)[loop];
  }
};

} // namespace internal

/// The surface between the lattice points inside and outside a volume, by marching cubes: a closed
/// 2-manifold, oriented counterclockwise from inside, with a point on each lattice edge that it
/// crosses. `triangulate(inside, k, points)` gives the triangulation of loop k of case `inside`,
/// whose points are given by their numbers. O(n^3).
template <class Triangulate>
Indexed_surface marching_cubes(const Volume& volume, const Marching_cubes_table& table,
                               const Triangulate& triangulate)
{
  const std::size_t n = volume.size();
  Indexed_surface surface;
  std::vector<std::size_t> points(3 * n * n * n, 0); // by lattice edges
  const auto position = [&](std::size_t number) {
    const double h = 1. / double(n - 1);
    return Indexed_surface::Point_3(double(number % n) * h, double(number / n % n) * h,
                                    double(number / n / n) * h);
  };
  const std::array<std::size_t, 3> step = {1, n, n * n};
  for (std::size_t p = 0; p < n * n * n; ++p)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p / step[axis] % n + 1 == n || (volume[p] < 0) == (volume[p + step[axis]] < 0))
        continue;
      // Kept away from the ends, the points around a lattice point stay apart.
      const double f = volume[p], g = volume[p + step[axis]];
      const double t = (std::min)((std::max)(f / (f - g), 0.05), 0.95);
      points[3 * p + axis] = surface.points.size();
      surface.points.push_back(position(p) + t * (position(p + step[axis]) - position(p)));
    }

  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k + 1 < n; ++k)
    for (std::size_t j = 0; j + 1 < n; ++j)
      for (std::size_t i = 0; i + 1 < n; ++i) {
        const auto at = [&](int c) {
          return volume.number(i + std::size_t(c & 1), j + std::size_t(c >> 1 & 1),
                               k + std::size_t(c >> 2));
        };
        int inside = 0;
        for (int c = 0; c < 8; ++c)
          inside |= int(volume[at(c)] < 0) << c;
        const auto& loops = table.loops(inside);
        for (std::size_t l = 0; l < loops.size(); ++l) {
          corners.clear();
          for (const int e : loops[l])
            corners.push_back(
                points[3 * at(Marching_cubes_table::corners(e)[0]) + std::size_t(e / 4)]);
          for (const Marching_cubes_table::Triangle& t : triangulate(inside, l, corners))
            surface.faces.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
        }
      }
  return surface;
}

/// The same with the triangulations of the table.
inline Indexed_surface marching_cubes(const Volume& volume)
{
  const Marching_cubes_table table;
  return marching_cubes(volume, table, internal::Table_triangulation{table});
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H
