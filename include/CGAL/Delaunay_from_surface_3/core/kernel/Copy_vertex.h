// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COPY_VERTEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COPY_VERTEX_H

// Vertices that are copies of points in a periodic box: a point x, moved by k periods L along each
// axis. The filters see x + k L rounded (Rounded_place). The exact stages see x, k and L, from which
// the difference of two copies, (x - y) + (k - l) L, is known exactly: mostly as a sum of two doubles,
// as that of other vertices is, and else as an integer of any width.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Big_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The periods, 0 along an axis that has none.
struct Periods
{
  double lengths[3];
  bool are_scaled; // or else only integers of any width are exact
};

// Moves x by whole periods until it is less than one away from 0, exactly, and returns by how many; with
// 2^29 or more the copies of it cannot be numbered.
inline double wrap(double& x, double period)
{
  const double inside = std::fmod(x, period), by = std::round((x - inside) / period);
  x = inside;
  return by;
}
constexpr double too_many_periods = 0x1p29;

// A copy as the exact stages see it.
template <bool has_weight>
struct Copy_place
{
  const double* point; // three coordinates and, if it has one, a weight
  const Periods* periods;
  std::array<std::int16_t, 3> shift;

  double weight() const { return point[3]; }
};
template <bool has_weight>
inline constexpr bool is_copy<Copy_place<has_weight>> = true;
template <>
inline constexpr bool is_weighted<Copy_place<true>> = true;

template <bool has_weight_>
struct alignas(has_weight_ ? 8 : 32) Copy_vertex
{
  using Place = Rounded_place<has_weight_>;
  using Exact_place = Copy_place<has_weight_>;
  static constexpr bool has_weight = has_weight_;
  static constexpr std::size_t size = has_weight ? 4 : 3;

  double coordinates[size];
  Id cell; // any cell of the vertex; for a hidden one see Weighted_vertex
  Id label;
};

// The copies that are the vertices of a complex, by number.
template <bool has_weight>
struct Periodic_copies
{
  const double* points = nullptr; // as Copy_place::point; owned elsewhere, as the periods
  const Periods* periods = nullptr;
  std::vector<Periodic_copy> copies;

  Copy_place<has_weight> place(std::size_t i) const
  {
    const Periodic_copy& c = copies[i];
    return {points + (has_weight ? 4 : 3) * std::size_t(c.point),
            periods,
            {c.shift[0], c.shift[1], c.shift[2]}};
  }
};

template <bool has_weight>
struct Exact_coordinates<Copy_vertex<has_weight>>
{
  using type = Periodic_copies<has_weight>;
};

template <bool has_weight>
Copy_place<false> position_of(Copy_place<has_weight> v)
{
  return {v.point, v.periods, v.shift};
}

// The difference of two copies along an axis: high + low, if it is a sum of two doubles.
struct Periodic_difference
{
  double high, low;
  bool is_exact;

  template <bool W>
  Periodic_difference(const Copy_place<W>& v, const Copy_place<W>& p, std::size_t axis)
    : high(v.point[axis] - p.point[axis])
    , low(error_of_difference(v.point[axis], p.point[axis], high))
    , is_exact(p.periods->are_scaled)
  {
    const int periods = v.shift[axis] - p.shift[axis];
    if (periods != 0)
      add(periods, p.periods->lengths[axis]);
  }

private:
  static double error_of_sum(double a, double b, double sum)
  {
    return error_of_difference(a, -b, sum);
  }

  // Adds the product, in sums that lose nothing: what is left over in the end is 0, or the difference
  // needs a third double.
  void add(double periods, double length)
  {
    const double moved = opaque(periods * length);
    const double moved_low = Portable_products::error(periods, length, moved);
    const double sum = high + moved, sum_low = error_of_sum(high, moved, sum);
    const double lows = low + moved_low, lows_low = error_of_sum(low, moved_low, lows);
    const double rest = sum_low + lows, rest_low = error_of_sum(sum_low, lows, rest);
    high = sum + rest;
    const double second = error_of_sum(sum, rest, high);
    const double third = rest_low + lows_low;
    low = second + third;
    is_exact = is_exact && error_of_sum(rest_low, lows_low, third) == 0 &&
               error_of_sum(second, third, low) == 0 && high + low == high;
  }
};

template <int N, bool has_weight>
struct Exact_differences<N, Copy_place<has_weight>> : Weight_differences<N, Copy_place<has_weight>>
{
  using Place = Copy_place<has_weight>;
  static constexpr int size = 3 * N;
  double high[size], low[size];
  bool are_exact = true;

  Exact_differences(const Place* vertices, Place p)
    : Weight_differences<N, Place>(vertices, p)
  {
    for (int k = 0; k < size; ++k) {
      const Periodic_difference d(vertices[k / 3], p, std::size_t(k % 3));
      high[k] = d.high;
      low[k] = d.low;
      are_exact = are_exact && d.is_exact;
    }
  }
};

template <int N, bool has_weight>
struct Big_differences<N, Copy_place<has_weight>>
{
  using Place = Copy_place<has_weight>;
  Row<Big_integer> rows[N];
  int unit = std::numeric_limits<double>::max_exponent;

  Big_differences(const Place* vertices, Place p)
  {
    look_at(p);
    for (int k = 0; k < N; ++k)
      look_at(vertices[k]);
    for (int k = 0; k < N; ++k) {
      const Place& v = vertices[k];
      const Big_integer dx = difference(v, p, 0), dy = difference(v, p, 1),
                        dz = difference(v, p, 2);
      if constexpr (has_weight)
        rows[k] = {dx, dy, dz,
                   Big_integer(p.weight(), 2 * unit) - Big_integer(v.weight(), 2 * unit)};
      else
        rows[k] = {dx, dy, dz};
    }
  }

private:
  void look_at(double x, int share)
  {
    if (x != 0) {
      const int exponent = Bits_of_double(x).exponent;
      unit = (std::min)(unit, exponent >= 0 ? exponent / share : (exponent + 1) / share - 1);
    }
  }
  void look_at(const Place& v)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      look_at(v.point[k], 1);
      if (v.shift[k] != 0)
        look_at(v.periods->lengths[k], 1);
    }
    if constexpr (has_weight)
      look_at(v.weight(), 2);
  }
  Big_integer difference(const Place& v, const Place& p, std::size_t axis) const
  {
    const Big_integer d = Big_integer(v.point[axis], unit) - Big_integer(p.point[axis], unit);
    const int periods = v.shift[axis] - p.shift[axis];
    return periods == 0 ? d
                        : d + Big_integer(periods, 0) * Big_integer(p.periods->lengths[axis], unit);
  }
};

// The sign of the difference of two copies along an axis.
template <bool W>
int sign_of_difference(const Copy_place<W>& v, const Copy_place<W>& p, std::size_t axis)
{
  const double x = v.point[axis], y = p.point[axis];
  if (v.shift[axis] == p.shift[axis])
    return (x > y) - (x < y);
  const Periodic_difference d(v, p, axis);
  if (d.is_exact)
    return (d.high > 0) - (d.high < 0);
  return sign_of([&] { // the rows have all three
    const Copy_place<W> one[1] = {v};
    const auto row = Big_differences<1, Copy_place<W>>(one, p).rows[0];
    return axis == 0 ? row.x : axis == 1 ? row.y : row.z;
  }());
}

template <bool W>
bool is_lexicographically_less(Copy_place<W> a, Copy_place<W> b)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const int sign = sign_of_difference(a, b, axis))
      return sign < 0;
  return false;
}

template <bool W>
bool are_equal(Copy_place<W> a, Copy_place<W> b)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (sign_of_difference(a, b, axis) != 0)
      return false;
  return !W || a.weight() == b.weight();
}

inline int orientation(Copy_place<false> a, Copy_place<false> b, Copy_place<false> c,
                       Copy_place<false> d)
{
  const Copy_place<false> vertices[3] = {b, c, d};
  return exact_sign<Exact_orientation>(vertices, a).sign;
}

inline bool are_collinear(Copy_place<false> a, Copy_place<false> b, Copy_place<false> c)
{
  const Copy_place<false> vertices[2] = {b, c};
  return exact_sign<Exact_area>(vertices, a).sign == 0;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COPY_VERTEX_H
