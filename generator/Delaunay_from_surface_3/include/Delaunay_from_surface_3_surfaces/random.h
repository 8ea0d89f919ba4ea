// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RANDOM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RANDOM_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace surfaces {

/// Random numbers that depend on the seed alone. The distributions are Boost's, because those of
/// the standard library differ from one library to the next.
class Random
{
public:
  using Vector_3 = Indexed_surface::Vector_3;

  explicit Random(std::uint64_t seed)
    : engine(seed)
  {
  }

  double uniform(double low, double high)
  {
    return low + (high - low) * boost::random::uniform_01<double>()(engine);
  }

  double normal() { return boost::random::normal_distribution<double>()(engine); }

  /// A number in `0 .. count - 1`.
  std::size_t below(std::size_t count)
  {
    return boost::random::uniform_int_distribution<std::size_t>(0, count - 1)(engine);
  }

  /// A vector in the unit ball.
  Vector_3 in_ball()
  {
    Vector_3 v;
    do {
      const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      v = Vector_3(x, y, z);
    } while (v.squared_length() > 1);
    return v;
  }

  /// The numbers `0 .. count - 1` in random order.
  std::vector<std::size_t> permutation(std::size_t count)
  {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = below(i + 1);
      order[i] = order[j];
      order[j] = i;
    }
    return order;
  }

private:
  boost::random::mt19937_64 engine;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RANDOM_H
