// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_VOLUME_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_VOLUME_H

#include <Delaunay_from_surface_3_surfaces/random.h>

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

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_VOLUME_H
