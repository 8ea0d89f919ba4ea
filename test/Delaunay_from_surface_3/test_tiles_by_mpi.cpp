// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tiles by MPI, on as many ranks as there are: the same as tiles in memory, and as CGAL's triangulation; and
// what one rank throws, all throw.

#define BOOST_TEST_MODULE test_tiles_by_mpi
#include <boost/test/included/unit_test.hpp>

#include "tile_calls.h"

#include <CGAL/Tiles_by_mpi_3.h>
#include <CGAL/delaunay_3_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using tests::options_of;
using tests::source_of;
using Points = std::vector<std::array<double, 3>>;
using Cells = std::vector<std::array<std::uint64_t, 4>>;

struct Mpi
{
  Mpi()
  {
    int threads = MPI_THREAD_SINGLE; // some engines have two
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &threads);
    BOOST_REQUIRE(threads >= MPI_THREAD_FUNNELED);
  }
  ~Mpi() { MPI_Finalize(); }
};
BOOST_TEST_GLOBAL_FIXTURE(Mpi);

Points random_points(std::size_t n, unsigned seed, int most)
{
  std::mt19937 random(seed);
  Points points(n);
  for (auto& p : points)
    for (double& x : p)
      x = double(random() % unsigned(most));
  return points;
}

// On a sphere, many at the same height; a lattice is random_points() of few numbers.
Points points_on_sphere(std::size_t n)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = double(i / 20 * 20) / double(n) * 2 - 1, r = std::sqrt(1 - z * z);
    points.push_back({r * std::cos(double(i)), r * std::sin(double(i)), z});
  }
  return points;
}

// In two planes that meet.
Points points_in_planes(std::size_t n)
{
  Points points = random_points(n, 2, 40);
  for (auto& p : points)
    p[2] = p[2] < 20 ? 0 : p[0];
  return points;
}

Cells cells_of(const CGAL::Delaunay_3_arrays<>& arrays)
{
  Cells cells(arrays.number_of_cells());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (unsigned k = 0; k < 4; ++k)
      cells[c][k] = std::uint64_t(std::int64_t(arrays.vertices(c)[k])); // the infinite one is -1
    std::sort(cells[c].begin(), cells[c].end());
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

// Those that the tiles of all ranks own.
struct Owned_cells
{
  Cells cells;

  void operator()(const CGAL::Delaunay_3_tile& tile)
  {
    for (std::size_t c = 0; c < tile.number_of_owned_cells; ++c) {
      cells.emplace_back();
      for (unsigned k = 0; k < 4; ++k) {
        const std::int32_t v = tile.cells[c][k];
        cells.back()[k] = v < 0 ? std::uint64_t(-1) : tile.ids[std::size_t(v)];
      }
      std::sort(cells.back().begin(), cells.back().end());
    }
  }

  Cells of_all_ranks() const
  {
    Cells all = core::Ranks_of_mpi(MPI_COMM_WORLD).all_gather(cells);
    std::sort(all.begin(), all.end());
    return all;
  }
};

void check_tiles(const Points& points, const CGAL::Tiles_options& options)
{
  const auto arrays = CGAL::delaunay_3_arrays(points);
  if (arrays.dimension() < 3)
    return; // one tile's affair
  Owned_cells owned;
  CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
  const auto report = CGAL::delaunay_3_tiles(engine, source_of(points), owned, options);
  CGAL::Tiles_here_3 here;
  const auto expected = CGAL::delaunay_3_tiles(
      here, source_of(points), [](const CGAL::Delaunay_3_tile&) {}, options);
  BOOST_TEST(report.is_certified);
  BOOST_TEST(report.points == expected.points);
  BOOST_TEST(report.tiles == expected.tiles);
  BOOST_TEST(report.rounds == expected.rounds);
  BOOST_TEST(report.told == expected.told);
  BOOST_TEST(report.kept == expected.kept);
  BOOST_TEST(report.most_kept == expected.most_kept);
  BOOST_TEST(report.cells == expected.cells);
  BOOST_TEST(report.hash == expected.hash);
  BOOST_TEST((owned.of_all_ranks() == cells_of(arrays)));
}

// f() throws the same on all ranks, what one rank is to blame for, or some are; then they go on together. Returns
// the message.
template <class Error, class F>
std::string check_thrown(const F& f, int rank, const std::string& text)
{
  std::string what;
  try {
    f();
  } catch (const Error& error) {
    what = error.what();
  }
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::string begin = rank < 0 || ranks == 1 ? "" : "rank " + std::to_string(rank) + ": ";
  BOOST_TEST(what.substr(0, begin.size()) == begin);
  BOOST_TEST(what.find(text) != std::string::npos, what);
  MPI_Barrier(MPI_COMM_WORLD);
  return what;
}

struct Broken_source : CGAL::Tile_array_source_3
{
  using Tile_array_source_3::Tile_array_source_3;
  bool is_broken = false, has_no_size = false;
  std::uint64_t missing = 0, gap = 0;

  std::uint64_t size() const override
  {
    if (has_no_size)
      throw CGAL::Tile_files_error("some.npy: is gone");
    return Tile_array_source_3::size() - missing;
  }
  std::uint64_t first_of_part(std::uint64_t part, std::uint64_t parts) const override
  {
    return Tile_array_source_3::first_of_part(part, parts) + gap;
  }
  void read(std::uint64_t first, std::size_t n, double* coordinates) const override
  {
    if (is_broken)
      throw CGAL::Tile_files_error("some.npy: ends early");
    Tile_array_source_3::read(first, n, coordinates);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(bytes_by_chunks)
{
  core::Ranks_of_mpi ranks(MPI_COMM_WORLD, 7);
  const auto text = [&](int from, int to) {
    std::mt19937 random(unsigned(100 * from + to));
    std::vector<char> bytes(random() % 50);
    for (char& c : bytes)
      c = char(random());
    return bytes;
  };
  using Texts = std::vector<std::vector<char>>;
  std::vector<Texts> to;
  Texts from, all;
  for (int r = 0; r < ranks.size(); ++r) {
    to.push_back({text(ranks.rank(), r), text(ranks.rank(), r + 50)});
    from.insert(from.end(), {text(r, ranks.rank()), text(r, ranks.rank() + 50)});
    all.push_back(text(r, 99));
  }
  BOOST_TEST((ranks.exchange(to) == from));
  BOOST_TEST((ranks.all_gather(Texts{text(ranks.rank(), 99)}) == all));
  BOOST_TEST((ranks.bytes_sent() > 0) == (ranks.size() > 1));
  BOOST_TEST(ranks.sum(1) == std::uint64_t(ranks.size()));
  BOOST_TEST(ranks.of_first(std::uint64_t(ranks.rank() + 3)) == 3u);
}

BOOST_AUTO_TEST_CASE(the_same_as_in_memory)
{
  for (const Points& points : {random_points(3000, 1, 1000000), random_points(900, 2, 6),
                               points_on_sphere(1500), points_in_planes(800)})
    for (const std::uint32_t tiles : {1u, 2u, 13u})
      BOOST_TEST_CONTEXT(points.size() << " points, " << tiles << " tiles")
  check_tiles(points, options_of(tiles));
}

// Points that were made where they are: a rank has a part of them, which is larger if its number is, and none if
// that is 0 and there are others.
BOOST_AUTO_TEST_CASE(points_of_many_ranks)
{
  struct Source : CGAL::Tile_source_3
  {
    const Points& points;
    std::uint64_t first = 0, last = 0; // what this rank has

    explicit Source(const Points& p)
      : points(p)
    {
    }
    std::uint64_t size() const override { return points.size(); }
    std::uint64_t first_of_part(std::uint64_t part, std::uint64_t parts) const override
    {
      return part == parts ? points.size() : points.size() * part * (part - 1) / (parts * parts);
    }
    void read(std::uint64_t from, std::size_t n, double* coordinates) const override
    {
      BOOST_TEST(from == first);
      BOOST_TEST(from + n == last);
      std::copy(points[0].data() + 3 * from, points[0].data() + 3 * (from + n), coordinates);
    }
  };
  const Points points = random_points(2000, 5, 1000);
  CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD, 2);
  Source source(points);
  const auto parts = std::uint64_t(engine.number_of_ranks());
  source.first = source.first_of_part(std::uint64_t(engine.rank()), parts);
  source.last = source.first_of_part(std::uint64_t(engine.rank()) + 1, parts);
  Owned_cells owned;
  CGAL::delaunay_3_tiles(engine, source, owned, options_of(7));
  BOOST_TEST((owned.of_all_ranks() == cells_of(CGAL::delaunay_3_arrays(points))));
}

BOOST_AUTO_TEST_CASE(small_ones_with_many_tiles)
{
  for (unsigned seed = 0; seed < 30; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_tiles(random_points(5 + 2 * seed, seed, seed % 2 == 0 ? 4 : 1000),
                  options_of(1 + seed % 23));
    }
}

// Those that are said to differ show each other what they have, and answer.
BOOST_AUTO_TEST_CASE(shown_and_compared)
{
  const Points points = random_points(500, 1, 1000);
  const CGAL::Tiles_options options = options_of(6);
  CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
  CGAL::Tiles_here_3 here;
  const core::Tile_pairs pairs = {{0, 5}, {1, 2}};
  const auto told_when_shown = [&](auto& tiles) {
    tiles.begin(source_of(points), options);
    tiles.exchange();
    const auto seed = [] { return std::uint64_t(1); };
    BOOST_TEST(!core::tiles_that_differ(tiles.gather(seed)).empty()); // too early
    while (tiles.exchange() > 0)
      ;
    tiles.show(pairs);
    const std::uint64_t told = tiles.exchange();
    BOOST_TEST(told > 0u);
    while (tiles.exchange() > 0)
      ;
    BOOST_TEST(core::is_certified(tiles.gather(seed), 6, points.size()));
    return told;
  };
  BOOST_TEST(told_when_shown(engine) == told_when_shown(here));
}

BOOST_AUTO_TEST_CASE(what_one_rank_throws)
{
  const Points points = random_points(2000, 1, 1000);
  const int bad = CGAL::Tiles_by_mpi_3(MPI_COMM_WORLD).number_of_ranks() - 1;
  const auto run = [&](const auto& sink, const std::function<void(CGAL::Tiles_options&)>& change,
                       const std::function<void(Broken_source&)>& brk) {
    CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
    CGAL::Tiles_options options = options_of(9);
    Broken_source source(points.front().data(), points.size());
    if (engine.rank() == bad) {
      change(options);
      brk(source);
    }
    CGAL::delaunay_3_tiles(
        engine, source,
        [&](const CGAL::Delaunay_3_tile& tile) {
          if (engine.rank() == bad)
            sink(tile);
        },
        options);
  };
  const auto same = [](auto&) {};
  const auto keep = [](const CGAL::Delaunay_3_tile&) {};
  check_thrown<std::runtime_error>(
      [&] { run([](auto&) { throw std::logic_error("the sink is full"); }, same, same); }, bad,
      "the sink is full");
  check_thrown<std::runtime_error>([&] { run([](auto&) { throw std::bad_alloc(); }, same, same); },
                                   bad, "not enough memory");
  check_thrown<CGAL::Tile_files_error>(
      [&] { run(keep, same, [](Broken_source& s) { s.is_broken = true; }); }, bad,
      "some.npy: ends early");
  check_thrown<CGAL::Tile_files_error>(
      [&] { run(keep, same, [](Broken_source& s) { s.has_no_size = true; }); }, bad, "is gone");
  check_thrown<CGAL::Surface_input_error>(
      [&] { run(keep, same, [](Broken_source& s) { s.gap = 1; }); }, bad, "the parts do not join");
  const auto stop = [](CGAL::Tiles_options& o) {
    o.progress = [](const char* what, std::size_t, std::size_t) {
      return what != std::string("round 1");
    };
  };
  check_thrown<CGAL::Tiles_stopped>([&] { run(keep, stop, same); }, -1, "stopped");
  if (bad > 0) {
    check_thrown<std::runtime_error>(
        [&] { run(keep, same, [](Broken_source& s) { s.missing = 5; }); }, bad,
        "sees 1995 points, and rank 0 2000");
    for (const auto& change : std::vector<std::function<void(CGAL::Tiles_options&)>>{
             [](auto& o) { o.least_points = 2; }, [](auto& o) { o.number_of_tiles = 8; }})
      check_thrown<std::runtime_error>([&] { run(keep, change, same); }, bad, "other options");
  }
  Points worse = points;
  worse.back()[1] = INFINITY;
  check_thrown<CGAL::Surface_input_error>(
      [&] {
        CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
        CGAL::delaunay_3_tiles(engine, source_of(worse), keep, options_of(3));
      },
      bad, "finite");
  run(keep, same, same); // nothing is left of all that
}

BOOST_AUTO_TEST_CASE(what_all_ranks_throw)
{
  Points flat = random_points(100, 1, 50);
  for (auto& p : flat)
    p[2] = 3;
  CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
  const std::string what = check_thrown<CGAL::Surface_input_error>(
      [&] {
        CGAL::delaunay_3_tiles(
            engine, source_of(flat), [](const CGAL::Delaunay_3_tile&) {}, options_of(3));
      },
      -1, "the points lie in one plane");
  BOOST_TEST(what.find("rank ") == std::string::npos); // nobody is to blame
}

// One rank draws the seed; what it throws all throw.
BOOST_AUTO_TEST_CASE(seed_of_the_first_rank)
{
  const Points points = random_points(500, 1, 1000);
  CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
  int drawn = 0;
  bool is_broken = false;
  const auto run = [&] {
    return core::run_until_certified(
        engine, source_of(points), options_of(3),
        [](const CGAL::Tiles_report& report) { return report; },
        [&] {
          ++drawn;
          if (is_broken && engine.rank() == 0)
            throw std::runtime_error("no random numbers");
          return std::uint64_t(7);
        });
  };
  BOOST_TEST(run().is_certified);
  BOOST_TEST(drawn == (engine.rank() == 0 ? 1 : 0));
  is_broken = true;
  check_thrown<std::runtime_error>(run, 0, "no random numbers");
}

namespace {

struct Engine_with_a_strange_tile : CGAL::Tiles_by_mpi_3
{
  using Base = CGAL::Tiles_by_mpi_3;
  Engine_with_a_strange_tile()
    : Base(MPI_COMM_WORLD)
  {
  }
  template <class Draw>
  std::vector<core::Tile_certificate> gather(const Draw& draw)
  {
    auto certificates = Base::gather(draw);
    if (rank() == number_of_ranks() - 1)
      certificates.front().common[99]; // there is no such tile
    return certificates;
  }
};

} // namespace

// What a rank throws when it has the certificates of all.
BOOST_AUTO_TEST_CASE(certificates_are_judged_together)
{
  const Points points = random_points(500, 1, 1000);
  Engine_with_a_strange_tile engine;
  engine.begin(source_of(points), options_of(3));
  check_thrown<std::runtime_error>(
      [&] { core::run_tiles(engine, [] { return std::uint64_t(7); }); },
      engine.number_of_ranks() - 1, "");
}

BOOST_AUTO_TEST_CASE(begins_again_with_more_tiles)
{
  const Points points = random_points(3000, 1, 100000);
  CGAL::Tiles_options options = options_of(2);
  options.memory = 1000 * core::bytes_per_point_kept;
  options.starts_again = false;
  const auto run = [&] {
    CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
    return CGAL::delaunay_3_tiles(
        engine, source_of(points), [](const CGAL::Delaunay_3_tile&) {}, options);
  };
  check_thrown<std::runtime_error>(run, -1, "tiles would do");
  options.starts_again = true;
  const auto report = run();
  BOOST_TEST(report.is_certified);
  BOOST_TEST(report.tiles > 2u);
}
