// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Iso-surfaces of Delaunay triangles: closed manifolds, and all triangles are facets of the
// triangulation that plain CGAL builds, but for those that are counted.

#define BOOST_TEST_MODULE test_delaunay_marching_cubes
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Nearby_delaunay_test.h>
#include <Delaunay_from_surface_3_surfaces/delaunay_marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>

#include "Closed_surface_check.h"

#include <Delaunay_from_surface_3_meters/delaunay_share.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using surfaces::Crossed_lattice;
using surfaces::Indexed_surface;
using surfaces::Marching_cubes_table;
using surfaces::Volume;

namespace {

using Kernel = Indexed_surface::Kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<
                CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>,
                CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;

// Plain insertion, and the vertex of each point.
struct Plain_delaunay
{
  Triangulation tr;
  std::vector<Triangulation::Vertex_handle> vertices;

  explicit Plain_delaunay(const std::vector<Kernel::Point_3>& points)
    : vertices(points.size())
  {
    std::vector<std::pair<Kernel::Point_3, std::size_t>> numbered;
    for (const Kernel::Point_3& p : points)
      numbered.emplace_back(p, numbered.size());
    tr.insert(numbered.begin(), numbered.end());
    for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      vertices[v->info()] = v;
  }

  bool is_edge(std::size_t p, std::size_t q) const
  {
    Triangulation::Cell_handle c;
    int i, j;
    return tr.is_edge(vertices[p], vertices[q], c, i, j);
  }

  bool is_facet(const Indexed_surface::Face& t) const
  {
    Triangulation::Cell_handle c;
    int i, j, k;
    return tr.is_facet(vertices[t[0]], vertices[t[1]], vertices[t[2]], c, i, j, k);
  }
};

// A function of the cube from (-1, -1, -1) to (1, 1, 1).
template <class Function>
Volume field(std::size_t n, const Function& value)
{
  const double h = 2. / double(n - 1);
  return Volume(n, [&](std::size_t i, std::size_t j, std::size_t k) {
    return value(double(i) * h - 1, double(j) * h - 1, double(k) * h - 1);
  });
}

Volume sphere(std::size_t n)
{
  return field(n, [](double x, double y, double z) { return x * x + y * y + z * z - 0.6; });
}

Volume torus(std::size_t n)
{
  return field(
      n, [](double x, double y, double z) { return std::hypot(std::hypot(x, y) - 0.6, z) - 0.27; });
}

Volume gyroid(std::size_t n)
{
  return field(n, [](double x, double y, double z) {
    return std::sin(5 * x) * std::cos(5 * y) + std::sin(5 * y) * std::cos(5 * z) +
           std::sin(5 * z) * std::cos(5 * x);
  });
}

// Random values: a power near 0 puts points in the middles of lattice edges, a high one near the
// ends.
Volume powers_of_noise(std::size_t n, double power, std::uint64_t seed)
{
  surfaces::Random random(seed);
  return Volume(n, [&](std::size_t, std::size_t, std::size_t) {
    const double x = random.uniform(-1, 1);
    return std::copysign(std::pow(std::abs(x), power), x);
  });
}

// A mask: the volume of an image that was segmented.
Volume mask_of_a_ball(std::size_t n)
{
  return field(
      n, [](double x, double y, double z) { return x * x + y * y + z * z < 0.64 ? -1. : 1.; });
}

Volume whole_numbers(std::size_t n, std::uint64_t seed)
{
  surfaces::Random random(seed);
  return Volume(n, [&](std::size_t, std::size_t, std::size_t) {
    return std::floor(random.uniform(-3, 3)) + 0.5;
  });
}

// A volume without anything outside but its rim.
Volume box(std::size_t n)
{
  return Volume(n, [](std::size_t, std::size_t, std::size_t) { return -1.; });
}

// Whether an edge of the cube lies in square s.
bool lies_in(int edge, int s)
{
  const auto [c, d] = Marching_cubes_table::corners(edge);
  return (c >> s / 2 & 1) == s % 2 && (d >> s / 2 & 1) == s % 2;
}

surfaces::Delaunay_iso_surface check(const std::string& name, const Volume& volume)
{
  const surfaces::Delaunay_iso_surface made = surfaces::delaunay_marching_cubes(volume);
  const Indexed_surface ordinary = surfaces::marching_cubes(volume);
  BOOST_TEST((made.surface.points == ordinary.points));
  const Closed_surface_check closed(made.surface);
  BOOST_TEST(closed.is_closed_manifold, name);
  BOOST_TEST(closed.volume > 0, name);

  const Plain_delaunay plain(made.surface.points);
  std::size_t others = 0;
  for (const auto& t : made.surface.faces)
    others += !plain.is_facet(t);
  BOOST_TEST(others == made.failed_triangles, name);
  BOOST_TEST((made.failed_loops == 0) == (others == 0), name);
  const auto share = meters::delaunay_share(plain.tr, plain.vertices, ordinary.faces);
  BOOST_TEST_MESSAGE(name << ": " << made.surface.points.size() << " points, "
                          << double(share.delaunay_triangles) / double(share.triangles)
                          << " of the ordinary triangles Delaunay; of " << made.loops << " loops "
                          << made.other_loops << " otherwise, " << made.failed_loops << " failed; "
                          << made.joined_squares << " squares joined, " << made.flat_diagonals
                          << " diagonals in squares");
  return made;
}

} // namespace

BOOST_AUTO_TEST_CASE(smooth_fields)
{
  const std::vector<std::pair<std::string, Volume>> fields = {
      {"sphere", sphere(16)},
      {"torus", torus(18)},
      {"gyroid", gyroid(18)},
      {"waves", surfaces::random_waves(24, 6, 1)}};
  for (const auto& [name, volume] : fields) {
    const auto made = check(name, volume);
    BOOST_TEST(made.failed_loops == 0u);
    BOOST_TEST(made.other_loops > made.loops / 50);
  }
}

// Here diagonals in squares are needed, and corners to be joined.
BOOST_AUTO_TEST_CASE(noise)
{
  std::size_t joined = 0, flat = 0, failed = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto made = check("noise", surfaces::noise(13, seed));
    BOOST_TEST(made.failed_loops == 0u);
    flat += made.flat_diagonals;
  }
  BOOST_TEST(flat > 0u);
  const std::vector<std::pair<std::size_t, std::uint64_t>> sizes_and_seeds = {
      {12, 1}, {12, 2}, {20, 1}};
  for (const auto& [n, seed] : sizes_and_seeds) {
    const auto made = check("noise near lattice points", powers_of_noise(n, 3, seed));
    BOOST_TEST(made.failed_loops <= made.loops / 100);
    joined += made.joined_squares;
    failed += made.failed_loops;
  }
  BOOST_TEST(joined > 0u);
  BOOST_TEST(failed > 0u); // so that what is counted is compared with more than nothing
}

// Points on common spheres and circles: the choice has to be that of CGAL's perturbation.
BOOST_AUTO_TEST_CASE(images)
{
  BOOST_TEST(check("mask of a ball", mask_of_a_ball(20)).failed_loops == 0u);
  BOOST_TEST(check("black and white", powers_of_noise(11, 0, 1)).failed_loops == 0u);
  BOOST_TEST(check("whole numbers", whole_numbers(11, 1)).failed_loops == 0u);
  BOOST_TEST(check("a box", box(8)).failed_loops == 0u);
  BOOST_TEST(check("one lattice point", box(3)).failed_loops == 0u);
}

// Any three points of a cube: the test from near by says what the triangulation of all says.
BOOST_AUTO_TEST_CASE(triangles_nearby)
{
  for (const Volume& volume : {sphere(16), surfaces::noise(9, 5), powers_of_noise(9, 3, 5),
                               powers_of_noise(8, 0, 5), whole_numbers(8, 5), mask_of_a_ball(12)}) {
    const Crossed_lattice lattice(volume);
    const Plain_delaunay plain(lattice.points());
    surfaces::Nearby_delaunay_test is_delaunay(lattice);
    std::array<std::size_t, 2> answers = {0, 0};
    std::size_t wrong = 0;
    lattice.for_each_cube([&](std::size_t cube) {
      std::vector<std::size_t> points;
      for (int e = 0; e < 12; ++e)
        for (const std::size_t p : lattice.points_of(cube, {e}))
          if (p != Crossed_lattice::none)
            points.push_back(p);
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
          for (std::size_t k = j + 1; k < points.size(); ++k) {
            const bool expected = plain.is_facet({points[i], points[j], points[k]});
            wrong += is_delaunay(cube, {points[i], points[j], points[k]}) != expected;
            ++answers[expected];
          }
    });
    BOOST_TEST(wrong == 0u);
    BOOST_TEST(answers[0] > 100u);
    BOOST_TEST(answers[1] > 100u);
  }
}

// What delaunay_marching_cubes() says of the edges of loops.
BOOST_AUTO_TEST_CASE(edges_of_loops)
{
  std::size_t ambiguous = 0, wrong = 0;
  for (const Volume& volume : {surfaces::noise(12, 7), powers_of_noise(12, 3, 7)}) {
    const Crossed_lattice lattice(volume);
    const Plain_delaunay plain(lattice.points());
    lattice.for_each_cube([&](std::size_t cube) {
      const int inside = lattice.inside(cube);
      std::array<std::array<std::size_t, 6>, 2> others = {}; // by square, not joined and joined
      for (const int joined : {0, 63})
        for (const auto& loop : Marching_cubes_table::loops(inside, joined)) {
          const std::vector<std::size_t> points = lattice.points_of(cube, loop);
          for (std::size_t k = 0; k < loop.size(); ++k)
            for (int s = 0; s < 6; ++s) {
              const std::size_t l = (k + 1) % loop.size();
              if (lies_in(loop[k], s) && lies_in(loop[l], s))
                others[joined == 0 ? 0 : 1][std::size_t(s)] += !plain.is_edge(points[k], points[l]);
            }
        }
      for (int s = 0; s < 6; ++s) {
        const std::size_t apart = others[0][std::size_t(s)], joined = others[1][std::size_t(s)];
        const bool is_ambiguous = Marching_cubes_table::is_ambiguous(inside, s);
        ambiguous += is_ambiguous;
        wrong += is_ambiguous ? apart != 0 && joined != 0 : apart != 0;
      }
    });
  }
  BOOST_TEST(ambiguous > 100u);
  BOOST_TEST(wrong == 0u);
}
