// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
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
    require(n >= 3, "a volume needs at least 3 lattice points in each direction");
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

/// The loops of marching cubes (Lorensen, Cline 1987) for each of the 256 ways in which the
/// corners of a cube can lie inside or outside, and triangulations of them. Corner c has the
/// coordinates that are the bits of c; edge 4 d + e leads along axis d.
///
/// On each square of the cube the surface runs from edge to edge around the corners inside, each
/// for itself where two lie at a diagonal: an ambiguous square. That depends on the square alone,
/// so that neighbouring cubes agree. A loop has 3 to 7 edges. Its triangulation has no diagonal
/// that lies in a square, where the neighbour could have the same: the triangles of all cubes form
/// a closed 2-manifold.
///
/// The corners inside an ambiguous square may be joined instead, if both its cubes do so; the
/// surface then runs around each corner outside. Loops of such cubes have up to 12 edges.
class Marching_cubes_table
{
public:
  using Loop = std::vector<int>;               // edges of the cube, around the corners inside
  using Triangle = std::array<std::size_t, 3>; // places in a loop
  using Triangulation = std::vector<Triangle>;

  Marching_cubes_table()
  {
    for (int inside = 0; inside < 256; ++inside) {
      m_loops[inside] = loops(inside, 0);
      for (const Loop& loop : m_loops[inside])
        m_triangulations[inside].push_back(triangulations(loop).front());
    }
  }

  /// Bit c of `inside` says whether corner c lies inside.
  const std::vector<Loop>& loops(int inside) const { return m_loops[std::size_t(inside)]; }

  /// The same where the corners inside each ambiguous square of the set `joined` are joined. Square
  /// 2 d is the lower one across axis d, 2 d + 1 the upper one.
  static std::vector<Loop> loops(int inside, int joined)
  {
    std::array<int, 12> next;
    next.fill(-1);
    for (int s = 0; s < 6; ++s) {
      const std::array<int, 4> q = square(s / 2, s % 2 == 1);
      const auto is_inside = [&](std::size_t k) { return (inside >> q[k % 4] & 1) != 0; };
      const auto edge_after = [&](std::size_t k) { return edge(q[k % 4], q[(k + 1) % 4]); };
      for (std::size_t k = 0; k < 4; ++k) { // a run of corners inside that begins with corner k
        if (!is_inside(k) || is_inside(k + 3))
          continue;
        std::size_t last = k;
        while (is_inside(last + 1))
          ++last;
        const bool is_joined = (joined >> s & 1) != 0 && last == k && is_inside(k + 2);
        next[std::size_t(edge_after(is_joined ? k + 1 : k + 3))] = edge_after(last);
      }
    }
    std::vector<Loop> result;
    for (int e = 0; e < 12; ++e) {
      if (next[std::size_t(e)] < 0)
        continue;
      result.emplace_back();
      for (int f = e; next[std::size_t(f)] >= 0;) {
        result.back().push_back(f);
        f = std::exchange(next[std::size_t(f)], -1);
      }
    }
    return result;
  }

  /// Whether two corners at a diagonal of the square lie inside, and the others outside.
  static bool is_ambiguous(int inside, int s)
  {
    const std::array<int, 4> q = square(s / 2, s % 2 == 1);
    const auto is_inside = [&](std::size_t k) { return (inside >> q[k] & 1) != 0; };
    return is_inside(0) == is_inside(2) && is_inside(1) == is_inside(3) &&
           is_inside(0) != is_inside(1);
  }

  /// Whether two edges lie in a common square.
  static bool share_square(int e, int f)
  {
    const int ands = corners(e)[0] & corners(e)[1] & corners(f)[0] & corners(f)[1];
    const int ors = corners(e)[0] | corners(e)[1] | corners(f)[0] | corners(f)[1];
    return ands != 0 || ors != 7;
  }

  /// One triangulation for each of the loops.
  const std::vector<Triangulation>& triangulations_of_loops(int inside) const
  {
    return m_triangulations[std::size_t(inside)];
  }

  /// All triangulations of a loop without a diagonal in a square of the cube.
  static std::vector<Triangulation> triangulations(const Loop& loop)
  {
    return triangulations_between(loop, 0, loop.size() - 1);
  }

  /// The two corners of an edge, the lower first.
  static std::array<int, 2> corners(int edge)
  {
    const int axis = edge / 4, other = edge % 4;
    const int low = (other & 1) << (axis + 1) % 3 | (other >> 1) << (axis + 2) % 3;
    return {low, low | 1 << axis};
  }

  /// The edge between two corners that differ in one bit.
  static int edge(int c, int d)
  {
    const int low = c & d, axis = (c ^ d) >> 1;
    return 4 * axis + (low >> (axis + 1) % 3 & 1) + 2 * (low >> (axis + 2) % 3 & 1);
  }

private:
  // The corners of a square, counterclockwise from outside.
  static std::array<int, 4> square(int axis, bool is_upper)
  {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, c = is_upper ? 1 << axis : 0;
    std::array<int, 4> result = {c, c | u, c | u | v, c | v};
    if (!is_upper)
      std::reverse(result.begin(), result.end());
    return result;
  }

  // Of the polygon from place i to place j.
  static std::vector<Triangulation> triangulations_between(const Loop& loop, std::size_t i,
                                                           std::size_t j)
  {
    if (j - i < 2)
      return {{}};
    std::vector<Triangulation> result;
    const auto is_allowed = [&](std::size_t a, std::size_t b) {
      return b - a < 2 || !share_square(loop[a], loop[b]);
    };
    for (std::size_t k = i + 1; k < j; ++k)
      if (is_allowed(i, k) && is_allowed(k, j))
        for (const Triangulation& left : triangulations_between(loop, i, k))
          for (const Triangulation& right : triangulations_between(loop, k, j)) {
            result.push_back(left);
            result.back().insert(result.back().end(), right.begin(), right.end());
            result.back().push_back({i, k, j});
          }
    return result;
  }

  std::array<std::vector<Loop>, 256> m_loops;
  std::array<std::vector<Triangulation>, 256> m_triangulations;
};

/// The lattice of a volume with a point on each edge that the surface crosses: those whose ends lie
/// inside and outside. A cube has the number of its lowest lattice point.
class Crossed_lattice
{
public:
  static constexpr std::size_t none = std::size_t(-1);

  /// O(n^3) for n x n x n lattice points, whose coordinates are the integers from 0.
  explicit Crossed_lattice(const Volume& volume)
    : m_size(volume.size())
    , m_step({1, m_size, m_size * m_size})
    , m_is_inside(m_size * m_size * m_size)
    , m_number(3 * m_is_inside.size(), none)
  {
    for (std::size_t p = 0; p < m_is_inside.size(); ++p)
      m_is_inside[p] = volume[p] < 0;
    for (std::size_t p = 0; p < m_is_inside.size(); ++p)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (coordinate(p, axis) + 1 == m_size || m_is_inside[p] == m_is_inside[p + m_step[axis]])
          continue;
        // Kept away from the ends, the points around a lattice point stay apart.
        const double f = volume[p], g = volume[p + m_step[axis]];
        const double t = (std::min)((std::max)(f / (f - g), 0.05), 0.95);
        m_number[3 * p + axis] = m_points.size();
        m_points.push_back(position(p) + t * (position(p + m_step[axis]) - position(p)));
      }
  }

  std::size_t size() const { return m_size; }
  const std::vector<Indexed_surface::Point_3>& points() const { return m_points; }

  /// Of lattice point or cube p.
  std::size_t coordinate(std::size_t p, std::size_t axis) const
  {
    return p / m_step[axis] % m_size;
  }

  /// From a lattice point or cube to the next along an axis.
  std::size_t step(std::size_t axis) const { return m_step[axis]; }

  std::size_t corner(std::size_t cube, int c) const
  {
    return cube + std::size_t(c & 1) * m_step[0] + std::size_t(c >> 1 & 1) * m_step[1] +
           std::size_t(c >> 2) * m_step[2];
  }

  /// Bit c says whether corner c of the cube lies inside.
  int inside(std::size_t cube) const
  {
    int result = 0;
    for (int c = 0; c < 8; ++c)
      result |= int(m_is_inside[corner(cube, c)]) << c;
    return result;
  }

  /// The number of the point on the lattice edge from p along an axis, or `none`.
  std::size_t point_along(std::size_t p, std::size_t axis) const { return m_number[3 * p + axis]; }

  /// The numbers of the points of a loop of a cube.
  std::vector<std::size_t> points_of(std::size_t cube, const Marching_cubes_table::Loop& loop) const
  {
    std::vector<std::size_t> result;
    for (const int e : loop)
      result.push_back(
          point_along(corner(cube, Marching_cubes_table::corners(e)[0]), std::size_t(e / 4)));
    return result;
  }

  template <class Visit>
  void for_each_cube(const Visit& visit) const
  {
    for (std::size_t k = 0; k + 1 < m_size; ++k)
      for (std::size_t j = 0; j + 1 < m_size; ++j)
        for (std::size_t i = 0; i + 1 < m_size; ++i)
          visit(i + m_size * (j + m_size * k));
  }

private:
  Indexed_surface::Point_3 position(std::size_t p) const
  {
    return {double(coordinate(p, 0)), double(coordinate(p, 1)), double(coordinate(p, 2))};
  }

  std::size_t m_size;
  std::array<std::size_t, 3> m_step;
  std::vector<bool> m_is_inside;
  std::vector<std::size_t> m_number; // by lattice edges
  std::vector<Indexed_surface::Point_3> m_points;
};

/// The surface between the lattice points inside and outside a volume, by marching cubes: a closed
/// 2-manifold, oriented counterclockwise from outside, with a point on each lattice edge that it
/// crosses. O(n^3) for n x n x n lattice points.
inline Indexed_surface marching_cubes(const Volume& volume)
{
  const Marching_cubes_table table;
  const Crossed_lattice lattice(volume);
  Indexed_surface surface;
  surface.points = lattice.points();
  lattice.for_each_cube([&](std::size_t cube) {
    const int inside = lattice.inside(cube);
    const auto& loops = table.loops(inside);
    for (std::size_t k = 0; k < loops.size(); ++k) {
      const std::vector<std::size_t> corners = lattice.points_of(cube, loops[k]);
      for (const auto& t : table.triangulations_of_loops(inside)[k])
        surface.faces.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    }
  });
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_H
