// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_POWER_SHARES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_POWER_SHARES_H

// What tetrahedra add to volumes and facets of Voronoi and power cells, with as many digits as it takes.

#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace python {

namespace core = CGAL::Delaunay_from_surface_3::core;

// Represents what a tetrahedron adds to the power diagram of its corners. Each edge is crossed by a
// facet, between the power cells of its ends; in each triangle at the edge, the centres of edge and
// triangle, where the two and three powers are least and equal, and that of the tetrahedron form a
// right triangle that belongs to it. Shares are signed: positive on the inner side of the triangle.
struct Power_shares
{
  std::array<double, 3> center;  // relative to the first corner
  std::array<double, 6> areas;   // of edges 01, 02, 03, 12, 13, 23
  std::array<double, 4> volumes; // of corners
};

inline std::size_t number_of_edge(std::size_t i, std::size_t j)
{
  return i < j ? i * (5 - i) / 2 + j - 1 : number_of_edge(j, i);
}

// Adds the shares of the edges and corners of one triangle, whose corners `at` are given relative to
// an origin with the weight there less their own. o is the centre of the tetrahedron relative to the
// first corner. Rows have to be multiplied by 2^unit to be in the unit of o, in which the shares are.
// The centre of the triangle has barycentric coordinates of[k] / (2 |n|^2).
template <class Rows, class Number>
bool add_power_shares(const std::array<std::array<Number, 3>, 4>& at,
                      const std::array<Number, 4>& lifts, const unsigned char (&f)[3],
                      const std::array<double, 3>& o, int unit, Power_shares& sums)
{
  const auto u = core::minus(at[f[1]], at[f[0]]), v = core::minus(at[f[2]], at[f[0]]),
             w = core::minus(v, u);
  const auto n = core::cross(v, u); // inwards
  if (!core::is_known<Rows>(n))
    return false;
  const core::Scaled_double length = Rows::rounded(n[core::largest_of<Rows>(n)]);
  std::array<double, 3> normal;
  for (std::size_t i = 0; i < 3; ++i)
    normal[i] = core::quotient(Rows::rounded(n[i]), length);
  const double height = core::dot(normal, o) / (4 * core::dot(normal, normal));
  const auto uu = core::dot(u, u), vv = core::dot(v, v), uv = core::dot(u, v), uw = core::dot(u, w),
             vw = core::dot(v, w);
  const auto of_u = lifts[f[1]] - lifts[f[0]], of_v = lifts[f[2]] - lifts[f[0]];
  const std::array<Number, 3> of = {core::dot(w, w) * uv + of_v * uw - of_u * vw,
                                    of_u * vv - of_v * uv - vv * uw,
                                    of_v * uu - of_u * uv + uu * vw};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = f[(k + 1) % 3], j = f[(k + 2) % 3];
    const auto edge = core::minus(at[i], at[j]);
    const Number square = core::dot(edge, edge), of_weights = lifts[j] - lifts[i];
    const double d = core::root(Rows::rounded(square), 2 * unit);
    const double area = core::quotient(Rows::rounded(of[k]), length, 2 * unit) * (height / d);
    const auto from = [&](const Number& twice) { // a third of the distance of an end
      return area * (core::quotient(Rows::rounded(twice), {6, 0}, 2 * unit) / d);
    };
    sums.areas[number_of_edge(i, j)] += area;
    sums.volumes[i] += from(square + of_weights);
    sums.volumes[j] += from(square - of_weights);
  }
  return true;
}

// Lets the point that is the origin be elsewhere, and moves the others along. With other weights power
// cells stay as they are: the planes between the first point and others are 2 p · x = w.
template <class Rows>
void move_points(Rows& in, const std::array<double, 3>& by)
{
  using Number = typename Rows::Number;
  std::array<Number, 3> move;
  if constexpr (std::is_same<Number, core::Big_integer>::value) {
    int unit = in.unit;
    for (const double x : by)
      unit = x == 0 ? unit : (std::min)(unit, core::Bits_of_double(x).exponent);
    const Number factor(1, unit - in.unit), square = factor * factor;
    for (auto& row : in.rows) {
      row.x = row.x * factor;
      row.y = row.y * factor;
      row.z = row.z * factor;
      row.w = row.w * square;
    }
    in.unit = unit;
    for (std::size_t i = 0; i < 3; ++i)
      move[i] = Number(by[i], unit);
  } else {
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = std::ldexp(by[i], -in.unit);
      move[i] = {{x, 0}, std::abs(x)};
    }
  }
  for (auto& row : in.rows) {
    const auto product = core::dot(core::vector_of(row), move);
    row.w = row.w - product - product;
  }
}

// Finds the shares of the corners that these rows are of, and returns whether they were accurate enough.
template <class Rows>
bool find_power_shares(const Rows& in, bool has_weights, int unit, Power_shares& shares)
{
  using Number = typename Rows::Number;
  core::Circumsphere sphere;
  if (!sphere.find(in))
    return false;
  const auto b = core::vector_of(in.rows[0]);
  std::array<std::array<Number, 3>, 4> at = {core::minus(b, b)};
  std::array<Number, 4> lifts;
  lifts.fill(at[0][0]); // 0
  for (std::size_t k = 1; k < 4; ++k) {
    at[k] = core::vector_of(in.rows[k - 1]);
    if (has_weights)
      lifts[k] = in.rows[k - 1].w - core::dot(at[k], at[k]);
  }
  // Numbers near 1 are scaled only in the end; integers may be too large for doubles.
  const int scale = std::is_same<Number, core::Big_integer>::value ? unit : in.unit;
  const auto scaled = [](auto& numbers, int exponent) {
    for (double& x : numbers)
      x = std::ldexp(x, exponent);
  };
  Power_shares sums = {sphere.center, {}, {}};
  scaled(sphere.center, -scale);
  for (const auto& f : core::facet_corners) {
    std::array<double, 3> o = sphere.center;
    for (std::size_t i = 0; i < 3; ++i)
      o[i] -= core::quotient(Rows::rounded(at[f[0]][i]), {1, 0}, in.unit - scale);
    if (!add_power_shares<Rows>(at, lifts, f, o, in.unit - scale, sums))
      return false;
  }
  scaled(sums.areas, 2 * (scale - unit));
  scaled(sums.volumes, 3 * (scale - unit));
  shares = sums;
  return true;
}

// Returns the shares of a tetrahedron in powers of 2^unit, NaNs if its corners are not finite: the sum
// over the tetrahedra of an edge is the area of the facet that crosses it, and that over those of a
// vertex the volume of its cell, by Voronoi's rule or, if corners have weights, by power. If a site is
// given, relative to the first corner, the first three areas and the first volume are shares as seen
// from there, for which differences of doubles would seldom be enough.
template <class Corner>
Power_shares power_shares_of(const Corner (&corners)[4], int unit,
                             const std::array<double, 3>* site = nullptr)
{
  constexpr double none = core::no_measure;
  Power_shares shares = {
      {none, none, none}, {none, none, none, none, none, none}, {none, none, none, none}};
  core::measure_at_corner(corners, 0, [&](const auto& in) {
    using Rows = std::decay_t<decltype(in)>;
    if (site == nullptr)
      return find_power_shares(in, core::is_weighted<decltype(core::place_of(corners[0]))>, unit,
                               shares);
    if constexpr (std::is_same<typename Rows::Number, core::Bounded_number<double>>::value)
      return false;
    else {
      Rows moved = in;
      move_points(moved, *site);
      return find_power_shares(moved, true, unit, shares);
    }
  });
  return shares;
}

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_POWER_SHARES_H
