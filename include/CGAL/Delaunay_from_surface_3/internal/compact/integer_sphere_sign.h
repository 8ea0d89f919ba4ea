// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_INTEGER_SPHERE_SIGN_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_INTEGER_SPHERE_SIGN_H

// The sphere test where points lie on a lattice, such as CAD parts, voxel surfaces and everything
// that was once a number of single precision: an exact sign, 0 included, in 128-bit integers.
//
// If the coordinates relative to p are integers of at most 24 bits (times a power of 2), then
// w < 3 · 2^48, and the determinant is at most 4 w^(5/2) < 2^127 by Hadamard's inequality.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Double_double.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

struct Integer_sign
{
  bool is_known;
  int sign;
};

#if defined(__SIZEOF_INT128__)

__extension__ using Wide_integer = __int128;

inline int sign_of(Wide_integer i)
{
  return (i > 0) - (i < 0);
}

struct Integer_row
{
  std::int64_t x, y, z;
};

inline std::int64_t squared_length(const Integer_row& r)
{
  return r.x * r.x + r.y * r.y + r.z * r.z;
}

// The power of 2 that brings a number of at most 2^23 to less than 2^24; 0 if there is none.
inline double scale_to_24_bits(double largest)
{
  std::uint64_t bits;
  std::memcpy(&bits, &largest, sizeof(bits));
  const std::uint64_t exponent = bits >> 52;
  if (exponent < 32 || exponent > 1023 + 23) // so that no number becomes less
    return 0;
  bits = (2 * 1023 + 23 - exponent) << 52;
  double scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return scale;
}

// N vertices relative to p as integers. Returns false if they are none.
template <int N>
bool integer_rows(const double* const* vertices, const double* p, Integer_row* rows)
{
  double largest = 0;
  for (int k = 0; k < N; ++k)
    for (int c = 0; c < 3; ++c)
      largest = (std::max)(largest, std::abs(vertices[k][c] - p[c]));
  const double scale = scale_to_24_bits(largest);
  if (scale == 0)
    return false;
  for (int k = 0; k < N; ++k) {
    std::int64_t row[3];
    for (int c = 0; c < 3; ++c) {
      const auto d = Double_double<Split_products>::difference(vertices[k][c], p[c]);
      row[c] = static_cast<std::int64_t>(d.high * scale);
      if (double(row[c]) != d.high * scale || d.low != 0)
        return false;
    }
    rows[k] = {row[0], row[1], row[2]};
  }
  return true;
}

// The sphere's determinant is that of (x, y, z, w) for w = x^2 + y^2 + z^2: the sum of w times these.
struct Sphere_minors
{
  Wide_integer of[4];

  explicit Sphere_minors(const Integer_row* r)
  {
    using Wide = Wide_integer;
    const Integer_row &a = r[0], &b = r[1], &c = r[2], &d = r[3];
    const std::int64_t ab = a.x * b.y - a.y * b.x, bc = b.x * c.y - b.y * c.x,
                       cd = c.x * d.y - c.y * d.x, da = d.x * a.y - d.y * a.x,
                       ac = a.x * c.y - a.y * c.x, bd = b.x * d.y - b.y * d.x;
    of[0] = Wide(b.z) * cd - Wide(c.z) * bd + Wide(d.z) * bc;
    of[1] = -(Wide(a.z) * cd + Wide(c.z) * da + Wide(d.z) * ac);
    of[2] = Wide(a.z) * bd + Wide(b.z) * da + Wide(d.z) * ab;
    of[3] = -(Wide(a.z) * bc - Wide(b.z) * ac + Wide(c.z) * ab);
  }
};

// Where p is in the plane of three vertices. The circle is where w is an affine function of two
// coordinates, in which the vertices have an area: of it the sum of w times these has the sign.
struct Circle_minors
{
  std::int64_t of[3];
  int area;   // its sign
  int height; // of p over the plane: its sign

  explicit Circle_minors(const Integer_row* r)
  {
    set(&Integer_row::x, &Integer_row::y, r);
    height = sign_of(Wide_integer(r[0].z) * of[0] + Wide_integer(r[1].z) * of[1] +
                     Wide_integer(r[2].z) * of[2]);
    if (area == 0)
      set(&Integer_row::y, &Integer_row::z, r);
    if (area == 0)
      set(&Integer_row::z, &Integer_row::x, r);
  }

private:
  void set(std::int64_t Integer_row::*u, std::int64_t Integer_row::*v, const Integer_row* r)
  {
    for (int k = 0; k < 3; ++k) {
      const Integer_row &s = r[(k + 1) % 3], &t = r[(k + 2) % 3];
      of[k] = s.*u * t.*v - s.*v * t.*u;
    }
    area = sign_of(of[0] + of[1] + of[2]);
  }
};

// Positive if p is inside the sphere through the four vertices of a positively oriented cell.
inline Integer_sign integer_sphere_sign(const double* const* vertices, const double* p)
{
  Integer_row r[4];
  if (!integer_rows<4>(vertices, p, r))
    return {false, 0};
  const Sphere_minors minors(r);
  Wide_integer sum = 0;
  for (int k = 0; k < 4; ++k)
    sum += squared_length(r[k]) * minors.of[k];
  return {true, sign_of(sum)};
}

// Positive if p is beyond the facet (a, b, c) of the convex hull, or in its plane and inside its
// circle; negative if not; 0 if p is on the circle.
inline Integer_sign integer_beyond_sign(const double* const* vertices, const double* p)
{
  Integer_row r[3];
  if (!integer_rows<3>(vertices, p, r))
    return {false, 0};
  const Circle_minors minors(r);
  if (minors.height != 0)
    return {true, -minors.height};
  Wide_integer sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += Wide_integer(squared_length(r[k])) * minors.of[k];
  return {true, minors.area * sign_of(sum)};
}

#else

inline Integer_sign integer_beyond_sign(const double* const*, const double*)
{
  return {false, 0};
}

inline Integer_sign integer_sphere_sign(const double* const*, const double*)
{
  return {false, 0};
}

#endif

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_INTEGER_SPHERE_SIGN_H
