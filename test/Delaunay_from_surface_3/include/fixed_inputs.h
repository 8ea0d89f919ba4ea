// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_FIXED_INPUTS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_FIXED_INPUTS_H

// Points that are the same on every machine, and what their triangulations must be: integers,
// multiples of powers of 2, and random numbers of splitmix64, with no function of the library, no
// division of doubles, and no product that fma would change. python/test_module.py makes the same.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace tests {

using Fixed_points = std::vector<std::array<double, 3>>;
using Fixed_random = CGAL::Delaunay_from_surface_3::internal::Split_mix;

// n points; next() gives one.
inline Fixed_points fixed_points(int n, const std::function<std::array<double, 3>(int)>& next)
{
  Fixed_points points;
  for (int i = 0; i < n; ++i)
    points.push_back(next(i));
  return points;
}

// (0, …, n-1)^3 times a step.
inline Fixed_points fixed_grid(int n, double step)
{
  return fixed_points(n * n * n, [&](int i) -> std::array<double, 3> {
    return {step * (i / (n * n)), step * (i / n % n), step * (i % n)};
  });
}

// All points of integers whose squares sum up to this.
inline Fixed_points points_at_square(int square)
{
  Fixed_points points;
  for (int x = -99; x < 100; ++x)
    for (int y = -99; y < 100; ++y)
      for (int z = -99; z < 100; ++z)
        if (x * x + y * y + z * z == square)
          points.push_back({double(x), double(y), double(z)});
  return points;
}

struct Fixed_input
{
  const char* name;
  std::size_t points, simplices;
  std::uint64_t hash; // of the simplices
};

inline Fixed_points points_of(const Fixed_input& input)
{
  const std::string name = input.name;
  Fixed_random random(1);
  const auto bits = [&random](int n) { return double(random() >> (64 - n)); };
  const auto below = [&random](std::uint64_t n) { return double(random.below(n)); };
  if (name == "cube")
    return fixed_points(3000, [&](int) -> std::array<double, 3> {
      const double x = bits(53), y = bits(53);
      return {x * 0x1p-53, y * 0x1p-53, bits(53) * 0x1p-53};
    });
  if (name == "near duplicates")
    return fixed_points(3000, [&](int i) -> std::array<double, 3> {
      random = Fixed_random(std::uint64_t(i / 2));
      const double x = bits(24), y = bits(24);
      return {x + i % 2, y, bits(24)}; // neighbours in single precision
    });
  if (name == "grid")
    return fixed_grid(11, .1);
  if (name == "lattice with duplicates")
    return fixed_points(3000, [&](int) -> std::array<double, 3> {
      const double x = below(9), y = below(9);
      return {x, y, below(9)};
    });
  if (name == "integer sphere")
    return points_at_square(5861);
  if (name == "plane")
    return fixed_points(900, [](int i) -> std::array<double, 3> {
      return {double(i / 30), double(i % 30), double(i / 30 + 2 * (i % 30))};
    });
  if (name == "line")
    return fixed_points(500, [](int i) -> std::array<double, 3> {
      const double t = i * 7 % 500;
      return {t, 2 * t, -t};
    });
  if (name == "thin sheet")
    return fixed_points(2000, [&](int) -> std::array<double, 3> {
      const double x = bits(30), y = bits(30);
      return {x, y, bits(53) * 0x1p-83};
    });
  if (name == "all sizes")
    return fixed_points(300, [&](int) -> std::array<double, 3> {
      std::array<double, 3> p;
      for (double& c : p) {
        c = below(9) - 4;
        for (int e = int(below(200)) - 100; e != 0; e += e < 0 ? 1 : -1)
          c *= e < 0 ? .5 : 2;
      }
      return p;
    });
  if (name == "skew lines")
    return fixed_points(120, [](int i) -> std::array<double, 3> {
      const double t = i / 2;
      return {i % 2 == 0 ? t : 0, i % 2 == 0 ? 0 : t, double(i % 2)};
    });
  if (name == "cone") {
    Fixed_points points; // all points of integers on a circle
    for (int x = -1088; x <= 1088; ++x)
      for (int y = -1088; y <= 1088; ++y)
        if (x * x + y * y == 1185665) // 5 13 17 29 37
          points.push_back({double(x), double(y), 0});
    points.push_back({0, 0, 3000});
    return points;
  }
  if (name == "rounded cone")
    return fixed_points(513, [](int i) -> std::array<double, 3> {
      if (i == 512)
        return {0, 0, 0x1p42};
      const std::int64_t p = i % 128, q = 128; // a quarter of the circle, turned
      const double c = double(((q * q - p * p) << 40) / (p * p + q * q));
      const double s = double((2 * p * q << 40) / (p * p + q * q));
      const double xs[] = {c, -s, -c, s};
      return {xs[i / 128], xs[(i / 128 + 3) % 4], 0};
    });
  if (name == "far away")
    return fixed_points(2000, [&](int) -> std::array<double, 3> {
      const double x = bits(20), y = bits(20);
      return {0x1p52 + x, 0x1p40 + y, bits(20) * 0x1p-20};
    });
  return {};
}

inline const Fixed_input fixed_inputs[] = {
    {"cube", 3000, 19537, 0xf12c336b3ba4a1b2},
    {"near duplicates", 3000, 19846, 0xdecfd5ca42c5c398},
    {"grid", 1331, 6000, 0x39be84b1ebd296e1},
    {"lattice with duplicates", 3000, 3043, 0x72c6a4f4c770369c},
    {"integer sphere", 792, 5151, 0x7068e57f57ec1220},
    {"plane", 900, 1682, 0xc9605388c6e849da},
    {"line", 500, 499, 0x588fee6fbb80924f},
    {"thin sheet", 2000, 12026, 0x40305f932dd11dda},
    {"all sizes", 300, 1276, 0xf176bd8b92a26b75},
    {"skew lines", 120, 3481, 0x59c96ed68349da05},
    {"cone", 129, 126, 0x68698d813768572a},
    {"rounded cone", 513, 510, 0xa03230caf3a5821a},
    {"far away", 2000, 12027, 0x0488069dfca6e072},
};

// Of the tetrahedra, or triangles or edges: the numbers of the vertices of each in ascending order,
// -1 for what there is none of, the simplices in ascending order; each number as 32 bits, least byte
// first, by FNV-1a (Fowler, Noll, Vo).
template <class Index>
std::uint64_t hash_of(const CGAL::Delaunay_3_arrays<Index>& arrays)
{
  std::vector<std::array<Index, 4>> simplices;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    simplices.push_back(arrays.vertices(c));
    std::sort(simplices.back().begin(), simplices.back().end());
  }
  std::sort(simplices.begin(), simplices.end());
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const auto& simplex : simplices)
    for (const Index v : simplex)
      for (int byte = 0; byte < 4; ++byte)
        hash = (hash ^ (std::uint64_t(v) >> (8 * byte) & 0xff)) * 0x100000001b3;
  return hash;
}

// A line of the table above.
template <class Index>
std::string line_of(const char* name, const CGAL::Delaunay_3_arrays<Index>& arrays)
{
  char line[120];
  std::snprintf(line, sizeof(line), "{\"%s\", %zu, %zu, 0x%016llx}", name,
                arrays.number_of_points(), arrays.number_of_simplices(),
                static_cast<unsigned long long>(hash_of(arrays)));
  return line;
}

inline std::string line_of(const Fixed_input& input)
{
  char line[120];
  std::snprintf(line, sizeof(line), "{\"%s\", %zu, %zu, 0x%016llx}", input.name, input.points,
                input.simplices, static_cast<unsigned long long>(input.hash));
  return line;
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_FIXED_INPUTS_H
