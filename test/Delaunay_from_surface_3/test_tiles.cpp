// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tiles: the union of their owned cells is the triangulation of all points, and the certificate holds;
// where messages are lost it holds only if the union is right all the same.

#define BOOST_TEST_MODULE test_tiles
#include <boost/test/included/unit_test.hpp>

#include "named_surfaces.h"

#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_here.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tiles.h>
#include <CGAL/delaunay_3_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::internal;

namespace {

using Points = std::vector<std::array<double, 3>>;
using Cells = std::vector<std::array<std::uint64_t, 4>>;

template <class Cell>
void append_sorted(const Cell& cell, Cells& cells)
{
  std::array<std::uint64_t, 4> sorted;
  for (unsigned k = 0; k < 4; ++k)
    sorted[k] = std::uint64_t(std::int64_t(cell[k])); // the infinite vertex is -1
  std::sort(sorted.begin(), sorted.end());
  cells.push_back(sorted);
}

Cells cells_of(const CGAL::Delaunay_3_arrays<>& arrays)
{
  Cells cells;
  for (std::size_t c = 0; c < arrays.number_of_cells(); ++c)
    append_sorted(arrays.vertices(c), cells);
  std::sort(cells.begin(), cells.end());
  return cells;
}

Cells cells_of(const core::Tiles_here& engine)
{
  Cells cells;
  for (const auto& tile : engine.tiles())
    tile->for_each_owned_cell([&](const auto& cell) { append_sorted(cell, cells); });
  std::sort(cells.begin(), cells.end());
  return cells;
}

core::Point_array view(const Points& points)
{
  return core::Point_array(points.front().data(), points.size());
}

Points points_of(const tests::Named_surface& named)
{
  Points points;
  for (const auto& p : named.surface.points)
    points.push_back({p.x(), p.y(), p.z()});
  return points;
}

void check_tiles(const Points& points, const std::string& name)
{
  const auto arrays = CGAL::delaunay_3_arrays(points);
  if (arrays.dimension() < 3)
    return; // one tile's affair
  const Cells expected = cells_of(arrays);
  for (const std::uint32_t tiles : {1u, 2u, 16u, 64u, 256u})
    BOOST_TEST_CONTEXT(name << ", " << tiles << " tiles")
    {
      core::Tiles_here engine(view(points), tiles);
      const core::Tiles_report report = core::run_tiles(engine, 1);
      BOOST_TEST(report.is_certified);
      BOOST_TEST((cells_of(engine) == expected));
      BOOST_TEST(report.rounds < 12);
    }
}

// A few points, of which many lie in one plane, on one sphere or at one place.
Points few_points(std::mt19937& random)
{
  const auto integer = [&](int m) { return double(std::uniform_int_distribution<>(0, m)(random)); };
  const int kind = int(integer(3)), n = 5 + int(integer(60));
  Points points;
  for (int i = 0; i < n; ++i)
    switch (kind) {
    case 0:
      points.push_back({integer(3), integer(3), integer(3)});
      break;
    case 1:
      points.push_back({integer(9), integer(9), integer(9) == 0 ? 1. : 0.});
      break;
    case 2: {
      const double t = integer(1000);
      points.push_back({std::cos(t), std::sin(t), integer(5)});
      break;
    }
    default:
      points.push_back({integer(1000000), integer(1000000), integer(1000000)});
    }
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(surfaces_of_all_kinds)
{
  for (const auto& surfaces : {tests::ordinary_surfaces(1500), tests::degenerate_surfaces(700),
                               tests::tiny_and_flat_surfaces()})
    for (const tests::Named_surface& named : surfaces)
      check_tiles(points_of(named), named.name);
}

BOOST_AUTO_TEST_CASE(zeros_with_a_sign_and_numbers_of_all_sizes)
{
  Points points;
  for (const double x : {-0., 0., 1., 0x1p-1060, 0x1p900})
    for (const double y : {-0., 0., 3., 0x1p-1000})
      for (const double z : {0., -0., -2., 0x1p-300})
        points.push_back({x, y, z});
  check_tiles(points, "zeros");
}

BOOST_AUTO_TEST_CASE(a_hull_vertex_with_many_facets)
{
  Points points = {{0, 0, 5}, {0, 0, 1}};
  for (int k = 0; k < 600; ++k)
    points.push_back({std::cos(k * 0.0104719), std::sin(k * 0.0104719), 0});
  check_tiles(points, "cone");
}

BOOST_AUTO_TEST_CASE(messages_that_are_lost_doubled_and_out_of_order)
{
  std::mt19937 random(1);
  int wrong = 0, refused = 0;
  for (int run = 0; run < 600; ++run) {
    const Points points = few_points(random);
    const auto arrays = CGAL::delaunay_3_arrays(points);
    if (arrays.dimension() < 3)
      continue;
    const bool loses = run % 2 == 1;
    core::Tiles_here engine(view(points), 1 + random() % 9, 1 + random() % 20);
    const auto post = [&](core::Tile_message& message) {
      std::shuffle(message.points.begin(), message.points.end(), random);
      if (loses && random() % 4 == 0)
        message.points.resize(random() % message.points.size());
      else if (!message.points.empty())
        message.points.push_back(message.points.front());
    };
    while (engine.exchange(post) > 0)
      ;
    const bool is_certified = core::is_certified(engine.gather(random()));
    const bool is_right = cells_of(engine) == cells_of(arrays);
    BOOST_TEST((is_right || (loses && !is_certified)));
    BOOST_TEST((is_certified || loses));
    wrong += !is_right;
    refused += !is_certified;
  }
  BOOST_TEST(wrong > 20);
  BOOST_TEST(refused >= wrong);
}

BOOST_AUTO_TEST_CASE(what_is_told_and_kept)
{
  // On a surface a tile keeps its own points, and about as many again of others'.
  const Points points = points_of(tests::ordinary_surfaces(20000)[1]);
  core::Tiles_here engine(view(points), 8);
  const core::Tiles_report report = core::run_tiles(engine, 1);
  std::size_t kept = 0;
  for (const auto& tile : engine.tiles())
    kept += tile->number_of_points_kept();
  BOOST_TEST(report.is_certified);
  BOOST_TEST(report.rounds <= 7);
  BOOST_TEST_MESSAGE("told " << report.told << ", kept " << kept << " of " << points.size());
  BOOST_TEST(report.told < 3 * points.size());
  BOOST_TEST(kept < 2.5 * double(points.size()));
}
