// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Choi 2002, Lemma 6: the degree on a surface of marching cubes is bounded. The proof counts the
// edges of the loops and says 8; there are 4, but diagonals too. All 2^18 ways in which the lattice
// points around an edge can lie inside or outside are enumerated, for the table of the generator,
// for all its triangulations, and for CGAL's.

#define BOOST_TEST_MODULE test_marching_cubes
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>

#if __has_include(<CGAL/Isosurfacing_3/internal/tables.h>)
#include <CGAL/Isosurfacing_3/internal/tables.h>
#define HAS_TABLE_OF_CGAL
#endif

#include "Closed_surface_check.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using surfaces::Marching_cubes_table;

namespace {

using Corners = std::array<int, 2>; // of an edge of the cube
using Edges = std::uint64_t; // a set of edges of the 3 x 3 x 2 lattice points around the edge
using Triangles = std::vector<std::array<Corners, 3>>;

int popcount(Edges edges)
{
  return int(std::bitset<64>(edges).count());
}

// The lattice point that is corner c of voxel v; bits of v are x and y.
int point_of(int v, int c)
{
  return (v & 1) + (c & 1) + 3 * ((v >> 1) + (c >> 1 & 1)) + 9 * (c >> 2);
}

// An edge of voxel v as one of the lattice: 3 directions for each of the 8 points that may be lower
// ends.
Edges edge_bit(int v, const Corners& corners)
{
  const int p = point_of(v, (std::min)(corners[0], corners[1])),
            q = point_of(v, (std::max)(corners[0], corners[1]));
  return Edges(1) << ((q - p == 1 ? 0 : q - p == 3 ? 18 : 36) + p);
}

// The edge in the middle, from (1, 1, 0) to (1, 1, 1), as one of voxel v.
Corners middle(int v)
{
  const int low = (v & 1 ? 0 : 1) | (v & 2 ? 0 : 2);
  return {low, low | 4};
}

// The neighbours of the point on the middle edge in voxel v.
Edges neighbors(int v, const Triangles& triangles)
{
  Edges result = 0;
  const Edges m = edge_bit(v, middle(v));
  for (const auto& t : triangles) {
    const Edges all = edge_bit(v, t[0]) | edge_bit(v, t[1]) | edge_bit(v, t[2]);
    if (all & m)
      result |= all & ~m;
  }
  return result;
}

// Calls look(cases) for all ways in which the 18 points can lie while the middle edge is crossed:
// the cases of the four voxels.
template <class Look>
void enumerate(const Look& look)
{
  std::array<std::array<int, 8>, 4> points;
  for (int v = 0; v < 4; ++v)
    for (int c = 0; c < 8; ++c)
      points[std::size_t(v)][std::size_t(c)] = point_of(v, c);
  for (int inside = 0; inside < 1 << 18; ++inside) {
    if ((inside >> 4 & 1) == (inside >> 13 & 1))
      continue;
    std::array<int, 4> cases = {0, 0, 0, 0};
    for (std::size_t v = 0; v < 4; ++v)
      for (std::size_t c = 0; c < 8; ++c)
        cases[v] |= (inside >> points[v][c] & 1) << c;
    look(cases);
  }
}

// The largest and smallest degree in the middle with the triangles of a table.
template <class TrianglesOf>
std::pair<int, int> degrees(const TrianglesOf& triangles_of)
{
  std::array<std::array<Edges, 256>, 4> masks;
  for (int v = 0; v < 4; ++v)
    for (int inside = 0; inside < 256; ++inside)
      masks[std::size_t(v)][std::size_t(inside)] = neighbors(v, triangles_of(inside));
  std::pair<int, int> result = {64, 0};
  enumerate([&](const std::array<int, 4>& cases) {
    Edges all = 0;
    for (std::size_t v = 0; v < 4; ++v)
      all |= masks[v][std::size_t(cases[v])];
    result = {(std::min)(result.first, popcount(all)), (std::max)(result.second, popcount(all))};
  });
  return result;
}

Triangles triangles_of_loop(const Marching_cubes_table::Loop& loop,
                            const Marching_cubes_table::Triangulation& triangulation)
{
  Triangles result;
  for (const auto& t : triangulation)
    result.push_back({Marching_cubes_table::corners(loop[t[0]]),
                      Marching_cubes_table::corners(loop[t[1]]),
                      Marching_cubes_table::corners(loop[t[2]])});
  return result;
}

} // namespace

// Each crossed edge is in one loop, each loop is a polygon of 3 to 7 edges, and can be triangulated
// without a diagonal in a square.
BOOST_AUTO_TEST_CASE(loops)
{
  const Marching_cubes_table table;
  std::array<int, 13> lengths = {};
  for (int inside = 0; inside < 256; ++inside) {
    std::array<int, 12> uses = {};
    for (const auto& loop : table.loops(inside)) {
      ++lengths[loop.size()];
      for (const int e : loop)
        ++uses[std::size_t(e)];
      for (const auto& triangulation : Marching_cubes_table::triangulations(loop))
        BOOST_TEST(triangulation.size() + 2 == loop.size());
    }
    BOOST_TEST(table.triangulations_of_loops(inside).size() == table.loops(inside).size());
    for (int e = 0; e < 12; ++e) {
      const Corners c = Marching_cubes_table::corners(e);
      BOOST_TEST(Marching_cubes_table::edge(c[0], c[1]) == e);
      BOOST_TEST(uses[std::size_t(e)] == ((inside >> c[0] & 1) != (inside >> c[1] & 1)));
    }
  }
  BOOST_TEST((lengths == std::array<int, 13>{0, 0, 0, 144, 66, 72, 52, 24, 0, 0, 0, 0, 0}));
}

// However corners are joined in ambiguous squares, each crossed edge is in one loop, and in the
// other squares nothing changes.
BOOST_AUTO_TEST_CASE(joined_squares)
{
  const Marching_cubes_table table;
  std::size_t longest = 0, different = 0;
  for (int inside = 0; inside < 256; ++inside)
    for (int joined = 0; joined < 64; ++joined) {
      int ambiguous = 0, edges = 0;
      for (int s = 0; s < 6; ++s)
        ambiguous |= int(Marching_cubes_table::is_ambiguous(inside, s)) << s;
      const auto loops = Marching_cubes_table::loops(inside, joined);
      for (const auto& loop : loops) {
        longest = (std::max)(longest, loop.size());
        for (std::size_t k = 0; k < loop.size(); ++k) {
          edges |= 1 << loop[k];
          BOOST_TEST(Marching_cubes_table::share_square(loop[k], loop[(k + 1) % loop.size()]));
        }
      }
      for (int e = 0; e < 12; ++e) {
        const Corners c = Marching_cubes_table::corners(e);
        BOOST_TEST((edges >> e & 1) == ((inside >> c[0] & 1) != (inside >> c[1] & 1)));
      }
      BOOST_TEST((loops == table.loops(inside)) == ((joined & ambiguous) == 0));
      different += (joined & ambiguous) != 0;
    }
  BOOST_TEST(longest == 12u);
  BOOST_TEST(different > 0u);
}

// Four edges of loops; and in each voxel at most four diagonals, since no loop has more than seven
// points.
BOOST_AUTO_TEST_CASE(loop_edges_and_diagonals)
{
  const Marching_cubes_table table;
  std::array<std::array<Edges, 256>, 4> loop_edges;
  std::array<std::array<int, 256>, 4> diagonals; // at most
  for (int v = 0; v < 4; ++v)
    for (int inside = 0; inside < 256; ++inside) {
      const Edges m = edge_bit(v, middle(v));
      Edges& mask = loop_edges[std::size_t(v)][std::size_t(inside)] = 0;
      int& most = diagonals[std::size_t(v)][std::size_t(inside)] = 0;
      for (const auto& loop : table.loops(inside))
        for (std::size_t k = 0; k < loop.size(); ++k)
          if (edge_bit(v, Marching_cubes_table::corners(loop[k])) == m) {
            for (const std::size_t j : {k + 1, k + loop.size() - 1})
              mask |= edge_bit(v, Marching_cubes_table::corners(loop[j % loop.size()]));
            for (const auto& triangulation : Marching_cubes_table::triangulations(loop))
              most = (std::max)(most,
                                popcount(neighbors(v, triangles_of_loop(loop, triangulation))) - 2);
          }
    }
  int largest = 0;
  enumerate([&](const std::array<int, 4>& cases) {
    Edges all = 0;
    int sum = 0;
    for (std::size_t v = 0; v < 4; ++v) {
      all |= loop_edges[v][std::size_t(cases[v])];
      sum += diagonals[v][std::size_t(cases[v])];
    }
    if (popcount(all) != 4)
      BOOST_ERROR("a point has " << popcount(all) << " edges of loops");
    largest = (std::max)(largest, 4 + sum);
  });
  BOOST_TEST_MESSAGE("largest degree, of all triangulations: " << largest);
  BOOST_TEST(largest == 20);
}

BOOST_AUTO_TEST_CASE(degree_with_the_table_of_the_generator)
{
  const Marching_cubes_table table;
  const auto [least, most] = degrees([&](int inside) {
    Triangles all;
    for (std::size_t l = 0; l < table.loops(inside).size(); ++l)
      for (const auto& t :
           triangles_of_loop(table.loops(inside)[l], table.triangulations_of_loops(inside)[l]))
        all.push_back(t);
    return all;
  });
  BOOST_TEST_MESSAGE("degrees with the generator's table: " << least << " to " << most);
  BOOST_TEST(least == 4);
  BOOST_TEST(most == 15);
}

// Closed, oriented, one fan at each point; and no degree above that of the table.
BOOST_AUTO_TEST_CASE(surfaces_are_closed_manifolds)
{
  for (const surfaces::Volume& volume :
       {surfaces::random_waves(30, 8, 1), surfaces::random_waves(12, 20, 2),
        surfaces::noise(12, 3)}) {
    const surfaces::Indexed_surface surface = surfaces::marching_cubes(volume);
    BOOST_TEST(surface.points.size() > 500u);
    const Closed_surface_check check(surface);
    BOOST_TEST(check.is_closed_manifold);
    BOOST_TEST(check.volume > 0); // counterclockwise from outside
    BOOST_TEST(check.largest_degree <= 15u);
    BOOST_TEST_MESSAGE(surface.points.size() << " points, largest degree " << check.largest_degree);
  }
}

#ifdef HAS_TABLE_OF_CGAL
BOOST_AUTO_TEST_CASE(degree_with_the_table_of_cgal)
{
  namespace tables = CGAL::Isosurfacing::internal::Cube_table;
  const auto [least, most] = degrees([&](int inside) {
    Triangles all;
    const auto corners = [](int e) {
      return Corners{tables::edge_to_vertex[e][0], tables::edge_to_vertex[e][1]};
    };
    for (const int* t = tables::triangle_cases + 16 * inside; *t >= 0; t += 3)
      all.push_back({corners(t[0]), corners(t[1]), corners(t[2])});
    return all;
  });
  BOOST_TEST_MESSAGE("degrees with CGAL's table: " << least << " to " << most);
  BOOST_TEST(most <= 20);
}
#else
BOOST_AUTO_TEST_CASE(table_of_cgal_is_not_at_hand)
{
  BOOST_TEST_MESSAGE("skipped: this CGAL has no Isosurfacing_3");
}
#endif
