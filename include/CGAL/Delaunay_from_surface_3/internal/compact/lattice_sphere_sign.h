// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_LATTICE_SPHERE_SIGN_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_LATTICE_SPHERE_SIGN_H

// The sphere test where points lie on a lattice whose step is another on each axis, and no power of 2,
// such as plates and extruded profiles: their spheres have many points, and floating point cannot
// certify a 0.
//
// With steps s, t, u and integers x, y, z of at most 24 bits the determinant is, but for the positive
// factor s t u,
//   s^2 det(x, y, z, x^2) + t^2 det(x, y, z, y^2) + u^2 det(x, y, z, z^2):
// numbers times integers, each less than 2^125. It is 0 if the three are, and else mostly far from 0.

#include <CGAL/Delaunay_from_surface_3/internal/compact/integer_sphere_sign.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

#if defined(__SIZEOF_INT128__)

template <class Predicate>
bool all_of_first(int n, const Predicate& holds)
{
  int k = 0;
  while (k < n && holds(k))
    ++k;
  return k == n;
}

// The N numbers d as multiples of a step, less than 2^24 in size. Returns the step: a power of 2, or
// the least of the numbers that is not 0. If neither will do, or its square would be no normal
// number, returns 0.
template <int N>
double common_step(const double* d, std::int64_t* multiples)
{
  double largest = 0, least = (std::numeric_limits<double>::max)();
  for (int k = 0; k < N; ++k) {
    largest = (std::max)(largest, std::abs(d[k]));
    least = d[k] == 0 ? least : (std::min)(least, std::abs(d[k]));
  }
  if (largest == 0) {
    std::fill(multiples, multiples + N, 0);
    return 1;
  }
  if (largest > 8388608. || least < 1e-100)
    return 0;
  const double scale = scale_to_24_bits(largest);
  const auto is_power_step = [&](int k) {
    multiples[k] = static_cast<std::int64_t>(d[k] * scale);
    return double(multiples[k]) == d[k] * scale;
  };
  const auto is_multiple_of_least = [&](int k) {
    const double quotient = d[k] / least;
    multiples[k] = static_cast<std::int64_t>(quotient);
    return double(multiples[k]) == quotient &&
           (std::abs(quotient) <= 1 || std::fmod(d[k], least) == 0); // which is exact
  };
  if (all_of_first(N, is_power_step))
    return 1 / scale;
  if (largest < 8388608. * least && all_of_first(N, is_multiple_of_least))
    return least;
  return 0;
}

template <int N>
struct Lattice_rows
{
  Integer_row rows[N];
  double steps[3]; // by axis

  // N vertices relative to p. Returns false if they do not lie on a lattice with p.
  bool set(const double* const* vertices, const double* p)
  {
    for (int c = 0; c < 3; ++c) {
      double d[N];
      for (int k = 0; k < N; ++k) {
        const auto difference = Double_double<Split_products>::difference(vertices[k][c], p[c]);
        if (difference.low != 0)
          return false;
        d[k] = difference.high;
      }
      std::int64_t multiples[N];
      steps[c] = common_step<N>(d, multiples);
      if (steps[c] == 0)
        return false;
      constexpr std::int64_t Integer_row::*coordinate[3] = {&Integer_row::x, &Integer_row::y,
                                                            &Integer_row::z};
      for (int k = 0; k < N; ++k)
        rows[k].*coordinate[c] = multiples[k];
    }
    return true;
  }

  // The sign of the sum of the squared lengths of the rows times these.
  template <class Minor>
  Integer_sign lifted_sign(const Minor* minors) const
  {
    Wide_integer lifted[3] = {0, 0, 0};
    for (int k = 0; k < N; ++k) {
      const Integer_row& r = rows[k];
      lifted[0] += Wide_integer(r.x * r.x) * minors[k];
      lifted[1] += Wide_integer(r.y * r.y) * minors[k];
      lifted[2] += Wide_integer(r.z * r.z) * minors[k];
    }
    double sum = 0, size = 0;
    for (int c = 0; c < 3; ++c) {
      const double term = steps[c] * steps[c] * static_cast<double>(lifted[c]);
      sum += term;
      size += std::abs(term);
    }
    // In half ulps of `size`, a term is wrong by less than 3.1 times its share, and each sum by 1.
    const bool is_known = size == 0 || std::abs(sum) > 1e-15 * size;
    return {is_known, (sum > 0) - (sum < 0)};
  }
};

// Positive if p is inside the sphere through the four vertices of a positively oriented cell.
inline Integer_sign lattice_sphere_sign(const double* const* vertices, const double* p)
{
  Lattice_rows<4> lattice;
  if (!lattice.set(vertices, p))
    return {false, 0};
  return lattice.lifted_sign(Sphere_minors(lattice.rows).of);
}

// As integer_beyond_sign().
inline Integer_sign lattice_beyond_sign(const double* const* vertices, const double* p)
{
  Lattice_rows<3> lattice;
  if (!lattice.set(vertices, p))
    return {false, 0};
  const Circle_minors minors(lattice.rows);
  if (minors.height != 0)
    return {true, -minors.height};
  const Integer_sign lifted = lattice.lifted_sign(minors.of);
  return {lifted.is_known, minors.area * lifted.sign};
}

#else

inline Integer_sign lattice_sphere_sign(const double* const*, const double*)
{
  return {false, 0};
}

inline Integer_sign lattice_beyond_sign(const double* const*, const double*)
{
  return {false, 0};
}

#endif

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_LATTICE_SPHERE_SIGN_H
