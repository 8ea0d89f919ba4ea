// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_TABLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_TABLE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace surfaces {

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

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_CUBES_TABLE_H
