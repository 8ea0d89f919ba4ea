// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DELAUNAY_MARCHING_CUBES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DELAUNAY_MARCHING_CUBES_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Nearby_delaunay_test.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace surfaces {

/// Finds a triangulation of a loop, a polygon in space, of least cost: the dynamic program for
/// triangulations of polygons (Gilbert 1979; Klincsek 1980). Costs of triangles and diagonals add
/// up.
///
/// O(m^3) calls of the cost of a triangle for m points, in time and number.
class Loop_triangulator
{
public:
  using Triangle = Marching_cubes_table::Triangle;
  using Triangulation = Marching_cubes_table::Triangulation;

  /// What must not be.
  static constexpr std::size_t forbidden = std::size_t(1) << 40;

  /// `triangle_cost(i, k, j)` and `diagonal_cost(i, j)` get places i < k < j in the loop.
  template <class TriangleCost, class DiagonalCost>
  Loop_triangulator(std::size_t size, const TriangleCost& triangle_cost,
                    const DiagonalCost& diagonal_cost)
    : m_size(size)
    , m_best(size * size)
  {
    for (std::size_t length = 2; length < size; ++length)
      for (std::size_t i = 0; i + length < size; ++i) {
        const std::size_t j = i + length;
        Best& best = m_best[i * size + j];
        best.cost = std::numeric_limits<std::size_t>::max();
        for (std::size_t k = i + 1; k < j; ++k) {
          const std::size_t cost = at(i, k).cost + at(k, j).cost + triangle_cost(i, k, j);
          if (cost < best.cost)
            best = {cost, k};
        }
        if (length + 1 < size)
          best.cost += diagonal_cost(i, j);
      }
    collect(0, size - 1);
  }

  std::size_t cost() const { return at(0, m_size - 1).cost; }
  const Triangulation& triangulation() const { return m_triangles; }

  /// The diagonals of the triangulation.
  const std::vector<std::array<std::size_t, 2>>& diagonals() const { return m_diagonals; }

private:
  // Of the polygon from place i to place j: the corner of the triangle at the edge from i to j.
  struct Best
  {
    std::size_t cost = 0, corner = 0;
  };

  const Best& at(std::size_t i, std::size_t j) const { return m_best[i * m_size + j]; }

  void collect(std::size_t i, std::size_t j)
  {
    if (j - i < 2)
      return;
    const std::size_t k = at(i, j).corner;
    m_triangles.push_back({i, k, j});
    if (j - i + 1 < m_size)
      m_diagonals.push_back({i, j});
    collect(i, k);
    collect(k, j);
  }

  std::size_t m_size;
  std::vector<Best> m_best;
  Triangulation m_triangles;
  std::vector<std::array<std::size_t, 2>> m_diagonals;
};

// Why edges can be Delaunay. The points lie on lattice edges, of unit length, where f changes its
// sign. Consider a square of the lattice, from (0, 0) to (1, 1), and an edge of a loop in it. The
// ball that has the edge as diameter reaches no parallel plane of the lattice, as its radius is less
// than 1. In the plane of the square it is a disc; no lattice point will be inside, so the ball meets
// no lattice edge that leaves the plane. Between points (a, 0) and (c, 1) the disc meets the lines
// y = 0 and y = 1 between a and c only, and the lines x = 0 and x = 1 between y = 0 and y = 1, where no
// points are. Between (a, 0) and (0, b) its circle goes through (0, 0); on the other sides of the
// square it can contain (t, 1) only if t < a, and (1, r) only if r < b. These are there only in an
// ambiguous square, where two corners at a diagonal are inside and the others are not; so in all
// other squares the edges of loops are Delaunay. An ambiguous one can be cut by edges from (a, 0) to
// (0, b) and from (t, 1) to (1, r), which are Delaunay if a <= t and b <= r; or from (a, 0) to (1, r)
// and from (0, b) to (t, 1), which are if a >= t and b >= r. As points are found by linear
// interpolation, a <= t and b <= r say the same, |f(0, 0) f(1, 1)| <= |f(0, 1) f(1, 0)|. So one of the
// two ways always has Delaunay edges: that of the asymptotic decider (Nielson, Hamann 1991).
//
// Triangles with such edges need not be. Each triangle considered for a loop is tested, exactly, with
// the points as far as the smallest of its empty balls reaches. A loop is triangulated as the table
// says if that is Delaunay, else with as few triangles as can be that are not; as a last resort it
// gets diagonals in an ambiguous square, unless the neighbouring cube has the same ones, or the square
// is cut the other way, for both cubes. Each edge has two triangles whatever is chosen, and the degree
// is bounded, as loops have at most 12 points.

/// What `delaunay_marching_cubes()` makes.
struct Delaunay_iso_surface
{
  Indexed_surface surface;
  std::size_t loops = 0;            ///< in all cubes.
  std::size_t other_loops = 0;      ///< not triangulated as the table does, or not in the table.
  std::size_t failed_loops = 0;     ///< without a triangulation found that is Delaunay.
  std::size_t failed_triangles = 0; ///< of these: not in the Delaunay triangulation.
  std::size_t joined_squares = 0;   ///< ambiguous ones where the corners inside are joined.
  std::size_t flat_diagonals = 0;   ///< diagonals of loops that lie in a square.
};

namespace internal {

// Chooses the triangulations of loops, and joins corners where that makes more of them Delaunay.
class Triangulate_cubes
{
public:
  explicit Triangulate_cubes(const Volume& volume)
    : m_lattice(volume)
    , m_is_delaunay(m_lattice)
    , m_is_joined(3 * volume.size() * volume.size() * volume.size(), false)
  {
    m_lattice.for_each_cube([&](std::size_t cube) {
      const int inside = m_lattice.inside(cube);
      if (inside != 0 && inside != 255)
        triangulate(cube);
    });
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (const auto& [number, cube] : m_cubes)
        if (cube.cost() >= failure)
          is_better |= join_or_part(number);
    }
  }

  Delaunay_iso_surface result() const
  {
    Delaunay_iso_surface result;
    result.surface.points = m_lattice.points();
    for (const auto& [number, cube] : m_cubes)
      for (const Loop& loop : cube.loops) {
        const std::vector<std::size_t> corners = m_lattice.points_of(number, loop.edges);
        for (const auto& t : loop.triangulation)
          result.surface.faces.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
        ++result.loops;
        result.other_loops += !is_as_in_table(m_lattice.inside(number), loop);
        result.failed_loops += loop.cost >= failure;
        result.failed_triangles += loop.cost / failure;
      }
    result.joined_squares = std::size_t(std::count(m_is_joined.begin(), m_is_joined.end(), true));
    result.flat_diagonals = m_owner.size();
    return result;
  }

private:
  using Triangulation = Marching_cubes_table::Triangulation;
  using Diagonal = std::array<std::size_t, 2>; // numbers of points, the smaller first

  struct Loop
  {
    Marching_cubes_table::Loop edges;
    Triangulation triangulation;
    std::size_t cost = 0;
    std::vector<Diagonal> flat_diagonals; // that lie in squares
  };

  struct Cube
  {
    std::vector<Loop> loops;

    std::size_t cost() const
    {
      std::size_t sum = 0;
      for (const Loop& loop : loops)
        sum += loop.cost;
      return sum;
    }
  };

  // The cost of a triangle that is not Delaunay. Diagonals in squares cost 1: they are the last
  // resort, as the neighbour has to do without.
  static constexpr std::size_t failure = 1 << 10;

  // The square across axis s / 2 as in `Marching_cubes_table::loops()`.
  std::size_t square(std::size_t cube, int s) const
  {
    const std::size_t axis = std::size_t(s / 2);
    return 3 * (s % 2 == 0 ? cube : cube + m_lattice.step(axis)) + axis;
  }

  // Chooses the triangulations of the loops of a cube that owns no diagonals.
  void triangulate(std::size_t number)
  {
    int joined = 0;
    for (int s = 0; s < 6; ++s)
      joined |= int(m_is_joined[square(number, s)]) << s;
    Cube cube;
    for (const auto& edges : Marching_cubes_table::loops(m_lattice.inside(number), joined))
      cube.loops.push_back(triangulated(number, edges));
    own(number, cube);
  }

  Loop triangulated(std::size_t cube, const Marching_cubes_table::Loop& edges)
  {
    const std::vector<std::size_t> corners = m_lattice.points_of(cube, edges);
    const auto is_delaunay = [&](std::size_t i, std::size_t k, std::size_t j) {
      return m_is_delaunay(cube, {corners[i], corners[k], corners[j]});
    };
    if (const Triangulation* t = in_table(m_lattice.inside(cube), edges))
      if (std::all_of(t->begin(), t->end(),
                      [&](const auto& c) { return is_delaunay(c[0], c[1], c[2]); }))
        return {edges, *t, 0, {}};

    const auto diagonal = [&](std::size_t i, std::size_t j) -> Diagonal {
      return {(std::min)(corners[i], corners[j]), (std::max)(corners[i], corners[j])};
    };
    const auto is_flat = [&](std::size_t i, std::size_t j) {
      return Marching_cubes_table::share_square(edges[i], edges[j]);
    };
    const Loop_triangulator best(
        edges.size(),
        [&](std::size_t i, std::size_t k, std::size_t j) {
          return is_delaunay(i, k, j) ? 0 : failure;
        },
        [&](std::size_t i, std::size_t j) -> std::size_t {
          if (!is_flat(i, j))
            return 0;
          return m_owner.count(diagonal(i, j)) != 0 ? Loop_triangulator::forbidden : 1;
        });
    Loop loop = {edges, best.triangulation(), best.cost(), {}};
    for (const auto& [i, j] : best.diagonals())
      if (is_flat(i, j))
        loop.flat_diagonals.push_back(diagonal(i, j));
    return loop;
  }

  // Joins or parts the corners inside an ambiguous square, if that makes its two cubes better. No
  // such square is on the rim, where all corners are outside.
  bool join_or_part(std::size_t cube)
  {
    const int inside = m_lattice.inside(cube);
    for (int s = 0; s < 6; ++s) {
      if (!Marching_cubes_table::is_ambiguous(inside, s))
        continue;
      const std::size_t step = m_lattice.step(std::size_t(s / 2)),
                        neighbor = s % 2 == 0 ? cube - step : cube + step;
      const Cube before = disown(cube), neighbor_before = disown(neighbor);
      m_is_joined[square(cube, s)].flip();
      triangulate(cube);
      triangulate(neighbor);
      if (m_cubes[cube].cost() + m_cubes[neighbor].cost() < before.cost() + neighbor_before.cost())
        return true;
      disown(cube);
      disown(neighbor);
      m_is_joined[square(cube, s)].flip();
      own(cube, before);
      own(neighbor, neighbor_before);
    }
    return false;
  }

  void own(std::size_t number, const Cube& cube)
  {
    m_cubes[number] = cube;
    for (const Loop& loop : cube.loops)
      for (const Diagonal& d : loop.flat_diagonals)
        m_owner.emplace(d, number);
  }

  Cube disown(std::size_t number)
  {
    const Cube cube = m_cubes[number];
    for (const Loop& loop : cube.loops)
      for (const Diagonal& d : loop.flat_diagonals)
        if (const auto found = m_owner.find(d); found != m_owner.end() && found->second == number)
          m_owner.erase(found);
    return cube;
  }

  const Triangulation* in_table(int inside, const Marching_cubes_table::Loop& edges) const
  {
    const auto& loops = m_table.loops(inside);
    const auto found = std::find(loops.begin(), loops.end(), edges);
    if (found == loops.end())
      return nullptr;
    return &m_table.triangulations_of_loops(inside)[std::size_t(found - loops.begin())];
  }

  bool is_as_in_table(int inside, const Loop& loop) const
  {
    const Triangulation* t = in_table(inside, loop.edges);
    return t != nullptr && std::is_permutation(t->begin(), t->end(), loop.triangulation.begin(),
                                               loop.triangulation.end());
  }

  const Marching_cubes_table m_table;
  const Crossed_lattice m_lattice;
  Nearby_delaunay_test m_is_delaunay;
  std::vector<bool> m_is_joined; // by squares
  std::map<std::size_t, Cube> m_cubes;
  std::map<Diagonal, std::size_t> m_owner; // cubes that have diagonals in squares
};

} // namespace internal

/// The surface between the lattice points inside and outside a volume, by marching cubes with
/// triangles of the 3D Delaunay triangulation of all its points, as Attali and Lachaud (2001)
/// propose: a closed 2-manifold, oriented counterclockwise from outside. The way there is our own.
///
/// The ball whose diameter is an edge of a loop in a square that is not ambiguous holds no other
/// point: its circle in the plane of the square passes the lattice points of the square by or goes
/// through them, and its radius is less than the spacing. So these edges are Delaunay. In an
/// ambiguous square that is true of at least one of the two ways, the one of the asymptotic decider
/// (Nielson, Hamann 1991). A triangle may not be Delaunay nevertheless; each is tested.
///
/// A loop is triangulated as the table says if the triangles are Delaunay, else with as few as can
/// be that are not. It may have diagonals in an ambiguous square, if the neighbour has not the same
/// ones: so each edge is in two triangles. Where that fails, the corners inside an ambiguous square
/// are joined, or parted again, if the loops of its two cubes become better. What then is left is
/// counted in the result: it does not mean that there is no Delaunay surface.
///
/// O(n^3) for n x n x n lattice points, and O(1) for each loop where the surface bends
/// within some cubes.
inline Delaunay_iso_surface delaunay_marching_cubes(const Volume& volume)
{
  return internal::Triangulate_cubes(volume).result();
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DELAUNAY_MARCHING_CUBES_H
