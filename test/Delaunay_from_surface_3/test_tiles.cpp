// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tiles: the union of their owned cells is the triangulation of all points, and the certificate holds;
// where messages are lost it holds only if the union is right all the same.

#define BOOST_TEST_MODULE test_tiles
#include <boost/test/included/unit_test.hpp>

#include "named_surfaces.h"
#include "tile_calls.h"

#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/delaunay_3_tiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using tests::source_of;
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
  for (const auto& tile : engine.tiles()) {
    const core::Tile_triangulation& tr = tile->triangulation();
    tr.for_each_cell([&](const auto& cell) {
      if (tr.owner_of(cell) == tile->number())
        append_sorted(
            std::array{tr.id(cell.v[0]), tr.id(cell.v[1]), tr.id(cell.v[2]), tr.id(cell.v[3])},
            cells);
    });
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

CGAL::Tiles_options options_of(std::uint32_t tiles, std::size_t share = 8)
{
  CGAL::Tiles_options options = tests::options_of(tiles);
  options.sample_share = share;
  return options;
}

template <class Engine>
CGAL::Tiles_report run_to_rest(Engine& engine)
{
  return core::run_tiles(engine, [] { return std::uint64_t(1); });
}

// As the engine does it, but post(message) may lose or change messages.
template <class Post>
std::uint64_t exchange(core::Tiles_here& engine, const Post& post)
{
  std::uint64_t told = 0;
  std::vector<core::Tile_message> messages = engine.tell();
  for (core::Tile_message& message : messages) {
    told += message.points.size();
    post(message);
  }
  engine.deliver(std::move(messages));
  return told;
}

auto seed_of(std::uint64_t seed)
{
  return [seed] { return seed; };
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
  for (const std::uint32_t most : {1u, 2u, 16u, 64u, 256u})
    BOOST_TEST_CONTEXT(name << ", " << most << " tiles")
    {
      core::Tiles_here engine;
      CGAL::Tiles_options options = options_of(most);
      options.least_points = most > 64 ? 20 : 1;
      engine.begin(source_of(points), options);
      const CGAL::Tiles_report report = run_to_rest(engine);
      BOOST_TEST(report.is_certified);
      BOOST_TEST(report.cells == expected.size());
      BOOST_TEST((cells_of(engine) == expected));
      BOOST_TEST(report.rounds < (points.size() > 64 * most ? 12u : 60u));
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
    const Cells expected = cells_of(arrays);
    core::Tiles_here engine;
    engine.begin(source_of(points), options_of(1 + random() % 9, 1 + random() % 20));
    const auto post = [&](core::Tile_message& message) {
      std::shuffle(message.points.begin(), message.points.end(), random);
      if (loses && random() % 4 == 0)
        message.points.resize(random() % message.points.size());
      else if (!message.points.empty())
        message.points.push_back(message.points.front());
    };
    while (exchange(engine, post) > 0)
      ;
    const auto certificates = engine.gather(seed_of(random()));
    const bool is_certified =
        core::is_certified(certificates, engine.number_of_tiles(), points.size());
    const bool is_right = cells_of(engine) == expected;
    BOOST_TEST((is_right || (loses && !is_certified)));
    BOOST_TEST((is_certified || loses));
    wrong += !is_right;
    refused += !is_certified;
    if (is_certified)
      continue;
    BOOST_TEST(!core::tiles_that_differ(certificates).empty()); // they show each other why
    engine.show(core::tiles_that_differ(certificates));
    BOOST_TEST(run_to_rest(engine).is_certified);
    BOOST_TEST((cells_of(engine) == expected));
  }
  BOOST_TEST(wrong > 20);
  BOOST_TEST(refused >= wrong);
}

namespace {

// What can go wrong, by name; the certificate shall see it if the union is wrong.
enum Mutation {
  A_POINT_DOES_NOT_REACH_A_TILE,
  NOTHING_IS_TOLD_AFTER_THE_FIRST_ROUND,
  A_COORDINATE_CHANGES_ON_THE_WAY,
  AN_ID_CHANGES_ON_THE_WAY,
  A_POINT_COMES_HOME_TO_ANOTHER_TILE,
  A_POINT_DOES_NOT_COME_HOME,
  MUTATIONS
};

struct Outcome
{
  bool is_right, is_certified;
};

Outcome run_mutated(Mutation mutation, const Points& points, const Cells& expected,
                    std::mt19937& random)
{
  core::Tiles_here engine;
  const std::uint32_t tiles = 2 + random() % 6;
  auto own = engine.bring_home(source_of(points), options_of(tiles));
  auto& from = own[random() % tiles];
  if (mutation >= A_POINT_COMES_HOME_TO_ANOTHER_TILE && !from.empty()) {
    const core::Tile_point point = from.back();
    from.pop_back();
    if (mutation == A_POINT_COMES_HOME_TO_ANOTHER_TILE)
      own[random() % tiles].push_back(point);
  }
  engine.make_tiles(std::move(own), core::most_points_of_tile);
  const std::uint64_t id = random() % points.size(), other = random() % points.size();
  const std::uint32_t tile = random() % tiles;
  std::size_t round = 0;
  const auto post = [&](core::Tile_message& message) {
    if (mutation == NOTHING_IS_TOLD_AFTER_THE_FIRST_ROUND && round > 0)
      message.points.clear();
    if (message.to != tile)
      return;
    auto& told = message.points;
    const auto is_it = [&](const core::Tile_point& p) { return p.id == id; };
    const auto found = std::find_if(told.begin(), told.end(), is_it);
    if (found == told.end())
      return;
    if (mutation == A_POINT_DOES_NOT_REACH_A_TILE)
      told.erase(found);
    else if (mutation == A_COORDINATE_CHANGES_ON_THE_WAY)
      found->coordinates[0] += 1;
    else if (mutation == AN_ID_CHANGES_ON_THE_WAY)
      found->id = other;
  };
  for (; round < 30 && exchange(engine, post) > 0; ++round)
    ;
  return {cells_of(engine) == expected,
          core::is_certified(engine.gather(seed_of(random())), tiles, points.size())};
}

} // namespace

BOOST_AUTO_TEST_CASE(mutations_of_the_protocol)
{
  std::mt19937 random(2);
  int wrong[MUTATIONS] = {};
  for (int run = 0; run < 100; ++run) {
    const Points points = few_points(random);
    const auto arrays = CGAL::delaunay_3_arrays(points);
    const Cells expected = cells_of(arrays);
    for (int m = 0; m < MUTATIONS && arrays.dimension() == 3; ++m) {
      const Outcome outcome = run_mutated(Mutation(m), points, expected, random);
      BOOST_TEST((outcome.is_right || !outcome.is_certified), "mutation " << m << ", run " << run);
      wrong[m] += !outcome.is_right;
    }
  }
  for (int m = 0; m < MUTATIONS; ++m)
    BOOST_TEST(wrong[m] > 3, "mutation " << m << ": " << wrong[m]);
}

namespace {

// By tile: the ids of its vertices, in their order.
std::vector<std::vector<std::uint64_t>> vertices_of(const core::Tiles_here& engine)
{
  std::vector<std::vector<std::uint64_t>> ids;
  for (const auto& tile : engine.tiles()) {
    ids.emplace_back();
    for (std::size_t v = 0; v < tile->triangulation().vertices_end(); ++v)
      ids.back().push_back(tile->triangulation().id(std::uint32_t(v)));
  }
  return ids;
}

// Two layers of a grid, which kd leaves cut into flat ones, and points that are there two times and
// more.
Points layers_with_equal_points(std::size_t n, std::mt19937& random)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({double(i % 2) * 1000, double(i / 2 % 150), double(i / 300)});
  for (std::size_t i = 0; i < n / 10; ++i)
    points.push_back(points[random() % (n / 20)]);
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

} // namespace

// Whatever the number of threads, a tile has the same vertices with the same numbers, and the same
// cells.
BOOST_AUTO_TEST_CASE(threads_that_share_a_tile)
{
  std::mt19937 random(3);
  for (const Points& points :
       {points_of(tests::ordinary_surfaces(25000)[1]), layers_with_equal_points(25000, random)}) {
    const Cells expected = cells_of(CGAL::delaunay_3_arrays(points));
    for (const std::uint32_t tiles : {1u, 2u}) {
      std::vector<std::vector<std::uint64_t>> vertices;
      for (const std::size_t threads : {1, 2, 4})
        BOOST_TEST_CONTEXT(tiles << " tiles, " << threads << " threads")
        {
          core::Tiles_here engine(threads);
          engine.begin(source_of(points), options_of(tiles));
          BOOST_TEST(run_to_rest(engine).is_certified);
          BOOST_TEST((cells_of(engine) == expected));
          if (threads == 1)
            vertices = vertices_of(engine);
          BOOST_TEST((vertices_of(engine) == vertices));
        }
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_by_task)
{
  BOOST_TEST(core::threads_of_task(0, 1, 99) == 64u); // there are no more workers
  for (const std::size_t threads : {1, 2, 3, 8})
    for (const std::size_t n : {1, 2, 3, 5, 8, 13}) {
      std::size_t last = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t of_task = core::threads_of_task(k, n, threads);
        BOOST_TEST((k < n - n % threads ? of_task == 1 : of_task >= 1));
        last += k < n - n % threads ? 0 : of_task;
      }
      BOOST_TEST(last == (n % threads == 0 ? 0 : threads));
    }
}

BOOST_AUTO_TEST_CASE(what_is_told_and_kept)
{
  // On a surface a tile keeps its own points, and about as many again of others'.
  const Points points = points_of(tests::ordinary_surfaces(20000)[1]);
  core::Tiles_here engine;
  engine.begin(source_of(points), options_of(8));
  const CGAL::Tiles_report report = run_to_rest(engine);
  std::size_t kept = 0;
  for (const auto& tile : engine.tiles())
    kept += tile->number_of_points_kept();
  BOOST_TEST(report.is_certified);
  BOOST_TEST(report.rounds <= 7);
  BOOST_TEST_MESSAGE("told " << report.told << ", kept " << kept << " of " << points.size());
  BOOST_TEST(report.told < 3 * points.size());
  BOOST_TEST(kept < 2.5 * double(points.size()));
}

BOOST_AUTO_TEST_CASE(more_tiles_than_points_and_tiles_without_any)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, 1}};
  check_tiles(points, "six points");
}

BOOST_AUTO_TEST_CASE(what_a_sink_gets)
{
  const Points points = points_of(tests::ordinary_surfaces(1500)[0]);
  Points with_equal = points;
  with_equal.insert(with_equal.end(), points.begin(), points.begin() + 50);
  const auto arrays = CGAL::delaunay_3_arrays(with_equal);
  CGAL::Tiles_here_3 engine(2);
  Cells owned;
  std::size_t vertices = 0, around = 0, equal = 0;
  const auto report = CGAL::delaunay_3_tiles(
      engine, source_of(with_equal),
      [&](const CGAL::Delaunay_3_tile& tile) {
        vertices += tile.number_of_own_vertices;
        for (std::size_t v = 0; v < tile.ids.size(); ++v)
          BOOST_TEST((tile.points[v] == with_equal[tile.ids[v]]));
        for (const auto& [id, vertex] : tile.equal_points)
          equal += vertex + points.size() == id && vertex < 50;
        for (std::size_t c = 0; c < tile.cells.size(); ++c) {
          std::array<std::int64_t, 4> ids;
          bool has_own = false;
          for (unsigned k = 0; k < 4; ++k) {
            const std::int32_t v = tile.cells[c][k];
            ids[k] = v < 0 ? -1 : std::int64_t(tile.ids[std::size_t(v)]);
            has_own = has_own || (v >= 0 && std::size_t(v) < tile.number_of_own_vertices);
          }
          BOOST_TEST(has_own);
          BOOST_TEST((c < tile.number_of_owned_finite_cells ? ids[3] >= 0 : true));
          if (c < tile.number_of_owned_cells)
            append_sorted(ids, owned);
          around += c >= tile.number_of_owned_cells;
        }
      },
      options_of(5));
  std::sort(owned.begin(), owned.end());
  BOOST_TEST((owned == cells_of(arrays)));
  BOOST_TEST(vertices == points.size());
  BOOST_TEST(equal == 50u);
  BOOST_TEST(around > 0u);
  BOOST_TEST(report.points == with_equal.size());
}

BOOST_AUTO_TEST_CASE(a_hub_is_to_blame)
{
  Points points = {{0, 0, 5}, {0, 0, 1}};
  for (int k = 0; k < 600; ++k)
    points.push_back({std::cos(k * 0.0104719), std::sin(k * 0.0104719), 0});
  CGAL::Tiles_here_3 engine;
  CGAL::Tiles_options options = options_of(4);
  options.memory = 250 * core::bytes_per_point_kept; // a tile may keep 250 points
  const auto ignore = [](const CGAL::Delaunay_3_tile&) {};
  BOOST_CHECK_EXCEPTION(CGAL::delaunay_3_tiles(engine, source_of(points), ignore, options),
                        core::Tile_too_large, [](const core::Tile_too_large& error) {
                          const std::string message = error.what();
                          BOOST_TEST_MESSAGE(message);
                          return error.number_of_tiles() == 0 &&
                                 message.find("; point 0 ") != std::string::npos;
                        });

  // Others only need more tiles, and get them.
  const Points surface = points_of(tests::ordinary_surfaces(3000)[0]);
  options.memory = core::bytes_per_point_kept * 2000;
  options.number_of_tiles = 1;
  const auto report = CGAL::delaunay_3_tiles(engine, source_of(surface), ignore, options);
  BOOST_TEST(report.tiles > 1u);
  BOOST_TEST(report.is_certified);

  // But not more than there may be.
  options.memory = core::bytes_per_point_kept * 200;
  options.least_points = surface.size() / 7 + 1;
  BOOST_CHECK_EXCEPTION(CGAL::delaunay_3_tiles(engine, source_of(surface), ignore, options),
                        core::Tile_too_large, [](const core::Tile_too_large& error) {
                          const std::string message = error.what();
                          return error.number_of_tiles() == 0 &&
                                 message.find("may be 7 only") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(a_certificate_needs_all_tiles_and_all_points)
{
  const Points points = points_of(tests::ordinary_surfaces(1500)[0]);
  core::Tiles_here engine;
  engine.begin(source_of(points), options_of(4));
  run_to_rest(engine);
  auto certificates = engine.gather(seed_of(5));
  BOOST_TEST(core::is_certified(certificates, 4, points.size()));
  BOOST_TEST(!core::is_certified(certificates, 4, points.size() + 1));
  BOOST_TEST(!core::is_certified(certificates, 5, points.size()));
  certificates.pop_back();
  BOOST_TEST(!core::is_certified(certificates, 4, points.size()));
  BOOST_TEST(!core::is_certified({}, 0, 0));
}

// Points at one place are one vertex, and count once where a tile must not keep too many.
BOOST_AUTO_TEST_CASE(many_equal_points)
{
  Points points = points_of(tests::ordinary_surfaces(1500)[0]);
  const std::size_t n = points.size();
  for (const std::size_t place : {std::size_t(0), std::size_t(1), n / 2, n - 1})
    points.insert(points.end(), 5000, points[place]);
  std::mt19937 random(4);
  std::shuffle(points.begin(), points.end(), random);
  const Cells expected = cells_of(CGAL::delaunay_3_arrays(points));
  for (const std::size_t threads : {1, 4})
    for (const std::uint32_t tiles : {1u, 3u}) {
      CGAL::Tiles_options options = options_of(tiles);
      options.memory = core::bytes_per_point_kept * (n + 10);
      options.starts_again = false;
      core::Tiles_here engine(threads);
      engine.begin(source_of(points), options);
      BOOST_TEST(run_to_rest(engine).is_certified);
      BOOST_TEST((cells_of(engine) == expected));
      for (const auto& tile : engine.tiles()) {
        std::set<std::uint64_t> ids;
        for (const auto& [id, smaller] : tile->equal_points()) {
          BOOST_TEST((points[id] == points[smaller] && smaller < id));
          ids.insert(id);
        }
        BOOST_TEST(ids.size() == tile->equal_points().size());
      }
    }
}

BOOST_AUTO_TEST_CASE(so_many_tiles_are_no_number)
{
  const auto error = core::tile_too_large(0, std::size_t(1) << 40, 64, 0, 4, 1000000);
  BOOST_TEST(error.number_of_tiles() == 4000000000u);
}

// Of workers there are as many as there are tasks, or fewer.
BOOST_AUTO_TEST_CASE(workers_for_few_tasks)
{
  struct Counting final : core::Executor
  {
    mutable std::size_t asked = 0;
    std::size_t number_of_workers() const override { return 1000000; }
    void run(std::size_t number, const core::Task& task) const override
    {
      asked = number;
      for (std::size_t t = 0; t < number; ++t)
        task(t);
    }
  };
  const Counting executor;
  std::size_t done = 0;
  core::run_tasks(executor, 3, [&](std::size_t) { ++done; });
  BOOST_TEST(done == 3u);
  BOOST_TEST(executor.asked == 3u);
}

BOOST_AUTO_TEST_CASE(progress_in_memory)
{
  const Points points = points_of(tests::ordinary_surfaces(1500)[0]);
  const auto ignore = [](const CGAL::Delaunay_3_tile&) {};
  CGAL::Tiles_options options = options_of(4);
  std::set<std::string> stages;
  options.progress = [&](const char* what, std::size_t done, std::size_t all) {
    BOOST_TEST(done <= all);
    stages.insert(what);
    return true;
  };
  CGAL::Tiles_here_3 engine(2);
  CGAL::delaunay_3_tiles(engine, source_of(points), ignore, options);
  for (const char* const stage : {"own points", "round 0", "round 1", "certificate"})
    BOOST_TEST(stages.count(stage) == 1u, stage);
  options.progress = [](const char*, std::size_t, std::size_t) { return false; };
  BOOST_CHECK_THROW(CGAL::delaunay_3_tiles(engine, source_of(points), ignore, options),
                    CGAL::Tiles_stopped);
  std::size_t asked = 0; // not again after it has thrown, nor by another thread
  options.progress = [&](const char*, std::size_t, std::size_t) -> bool {
    if (++asked == 3)
      throw std::domain_error("the caller's");
    return true;
  };
  BOOST_CHECK_THROW(CGAL::delaunay_3_tiles(engine, source_of(points), ignore, options),
                    std::domain_error);
  BOOST_TEST(asked == 3u);
}
