// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tiles out of core: the same as tiles in memory, however often the work is stopped, and in whatever order
// tasks are done; points from files of all kinds; and bad input, which is refused on one line.

#define BOOST_TEST_MODULE test_tiles_in_files
#include <boost/test/included/unit_test.hpp>

#include "tile_calls.h"

#include <tiles/Records.h>
#include <tiles/Tile_folder.h>

#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/delaunay_3_tiles.h>

#ifdef __linux__
#include <sys/stat.h>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::core;
namespace fs = std::filesystem;

namespace {

using tests::source_of;
using Points = std::vector<std::array<double, 3>>;
using Cells = std::vector<std::array<std::int64_t, 4>>;

// A folder that goes when it is left.
struct Folder
{
  const fs::path path =
      fs::temp_directory_path() / ("tiles-" + std::to_string(std::random_device()()));

  Folder() { fs::create_directories(path); }
  ~Folder()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

Points some_points(std::size_t n)
{
  Points points;
  const auto sphere = surfaces::sphere(n, 0.1);
  for (const auto& p : sphere.points)
    points.push_back({p.x(), p.y(), p.z()});
  return points;
}

CGAL::Tiles_options options_of(std::uint32_t tiles)
{
  CGAL::Tiles_options options = tests::options_of(tiles);
  options.points_at_once = 300; // several ranges
  return options;
}

CGAL::Tiles_report report_of_here(const Points& points, std::uint32_t tiles)
{
  CGAL::Tiles_here_3 engine;
  return CGAL::delaunay_3_tiles(
      engine, source_of(points), [](const CGAL::Delaunay_3_tile&) {}, options_of(tiles));
}

void check_same(const CGAL::Tiles_report& a, const CGAL::Tiles_report& b)
{
  BOOST_TEST(a.is_certified);
  BOOST_TEST(a.hash == b.hash);
  BOOST_TEST(a.cells == b.cells);
  BOOST_TEST(a.told == b.told);
  BOOST_TEST(a.kept == b.kept);
  BOOST_TEST(a.rounds == b.rounds);
}

void write_bytes(const fs::path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

template <class T>
std::string bytes_of(const std::vector<T>& items)
{
  return std::string(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
}

Cells cells_of_npy(const fs::path& file)
{
  core::Bytes_reader from(file);
  const core::Npy_head head = core::read_head_of_npy(from);
  Cells cells(std::size_t(fs::file_size(file) - head.end) / sizeof(Cells::value_type));
  BOOST_TEST(core::value_of_key(head.text, "shape", ",") == std::to_string(cells.size()));
  from.read(cells.data(), cells.size() * sizeof(cells[0]));
  return cells;
}

std::uint64_t join_tiles(const fs::path& folder, const fs::path& file, const char* kind = "cells")
{
  return core::Joined_tiles(source_of({{0, 0, 0}}), folder, file).write(kind);
}

Cells sorted(Cells cells)
{
  for (auto& cell : cells)
    std::sort(cell.begin(), cell.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

Cells finite_cells(const Points& points)
{
  const auto arrays = CGAL::delaunay_3_arrays(points);
  Cells cells;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    const auto v = arrays.vertices(c);
    cells.push_back({v[0], v[1], v[2], v[3]});
  }
  return sorted(cells);
}

// What f() throws; it shall be one line, and name what it is about.
template <class F>
void check_refused(const F& f, const std::string& name, const std::string& what)
{
  try {
    f();
    BOOST_ERROR("not refused: " + what);
  } catch (const std::exception& error) {
    const std::string message = error.what();
    BOOST_TEST(message.find(name) != std::string::npos, message);
    BOOST_TEST(message.find(what) != std::string::npos, message);
    BOOST_TEST(message.find('\n') == std::string::npos);
  }
}

std::string npy(const std::string& type, const std::string& shape, const std::string& order,
                const std::string& data)
{
  std::string head =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (" + shape + "), }\n";
  const char start[] = {'\x93', 'N', 'U', 'M', 'P', 'Y', 1, 0, char(head.size()), 0};
  return std::string(start, sizeof(start)) + head + data;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_as_in_memory)
{
  const Points points = some_points(2000);
  for (const std::uint32_t tiles : {1u, 5u, 16u}) {
    const Folder folder;
    CGAL::Tiles_in_files_3 engine(folder.path, 2);
    std::size_t given = 0;
    const auto report = CGAL::delaunay_3_tiles(
        engine, source_of(points),
        [&](const CGAL::Delaunay_3_tile& tile) { given += tile.number_of_own_vertices; },
        options_of(tiles));
    BOOST_TEST(given == points.size());
    check_same(report, report_of_here(points, tiles));
  }
}

// Such tiles are offered nothing in the first round, and do not begin anew in the second.
BOOST_AUTO_TEST_CASE(tiles_without_a_sample)
{
  for (const unsigned seed : {26u, 37u}) {
    std::mt19937 random(seed);
    Points points(8 + random() % 30);
    for (auto& p : points)
      for (double& x : p)
        x = double(random() % 1000);
    const std::uint32_t tiles = points.size() > 10 ? 3 : 2;
    const Folder folder;
    CGAL::Tiles_in_files_3 engine(folder.path);
    const auto report = CGAL::delaunay_3_tiles(
        engine, source_of(points), [](const CGAL::Delaunay_3_tile&) {}, options_of(tiles));
    check_same(report, report_of_here(points, tiles));
  }
}

// The first tile has all four points that the triangulations start with, and tells nothing in the first
// round: it knows no point of another.
BOOST_AUTO_TEST_CASE(tiles_that_tell_nothing_at_first)
{
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    Points points(20 + random() % 100);
    for (auto& p : points)
      for (double& x : p)
        x = double(random() % 1000);
    std::sort(points.begin(), points.end());
    CGAL::Tiles_options options = options_of(2);
    options.sample_share = 1u << 30;
    const auto report_of = [&](auto&& engine) {
      return CGAL::delaunay_3_tiles(
          engine, source_of(points), [](const CGAL::Delaunay_3_tile&) {}, options);
    };
    const Folder folder;
    check_same(report_of(CGAL::Tiles_in_files_3(folder.path)), report_of(CGAL::Tiles_here_3()));
  }
}

BOOST_AUTO_TEST_CASE(stopped_again_and_again)
{
  const Points points = some_points(1500);
  const auto expected = report_of_here(points, 7);
  const Folder folder;
  std::mt19937 random(1);
  int stops = 0;
  for (;;) {
    CGAL::Tiles_options options = options_of(7);
    int left = int(random() % 9);
    options.progress = [&](const char*, std::size_t, std::size_t) { return left-- > 0; };
    try {
      core::Tiles_to_files tiles(folder.path, 1, false);
      check_same(tiles.run(source_of(points), options), expected);
      break;
    } catch (const CGAL::Tiles_stopped&) {
      ++stops; // a killed process leaves files that are not complete
      write_bytes(folder.path / "state" / ("tile-0-0-" + std::to_string(stops) + ".unfinished"),
                  "x");
    }
  }
  BOOST_TEST(stops > 3);
  for (const auto& entry : fs::recursive_directory_iterator(folder.path))
    BOOST_TEST(entry.path().extension() != ".unfinished");
}

// With less memory than it began with a run does not give up what is done.
BOOST_AUTO_TEST_CASE(stopped_and_continued_with_less_memory)
{
  const Points points = some_points(2000);
  const Folder folder;
  CGAL::Tiles_options options = options_of(4);
  options.starts_again = true;
  options.progress = [](const std::string& what, std::size_t, std::size_t) {
    return what != "round 1";
  };
  const auto run = [&] {
    return core::Tiles_to_files(folder.path, 1, false).run(source_of(points), options);
  };
  BOOST_CHECK_THROW(run(), CGAL::Tiles_stopped);
  options.progress = nullptr;
  options.number_of_tiles = 0; // as many as there are
  options.memory = 600 * core::bytes_per_point_kept;
  BOOST_CHECK_EXCEPTION(run(), CGAL::Tile_files_error, [](const std::exception& error) {
    const std::string message = error.what();
    BOOST_TEST_MESSAGE(message);
    return message.find("holds the state of a run whose tiles may be larger") != message.npos;
  });
  options.memory = 0;
  check_same(run(), report_of_here(points, 4));
}

BOOST_AUTO_TEST_CASE(task_by_task_in_any_order)
{
  const Points points = some_points(1500);
  const Folder folder;
  std::mt19937 random(1);
  const auto source = source_of(points);
  std::size_t stages = 0;
  for (;; ++stages) {
    const std::size_t n =
        core::Tiles_to_files(folder.path, 1, true).next(source, options_of(6)).number;
    if (n == 0)
      break;
    std::vector<std::size_t> tasks(n);
    std::iota(tasks.begin(), tasks.end(), std::size_t(0));
    std::shuffle(tasks.begin(), tasks.end(), random);
    for (const std::size_t k : tasks)
      core::Tiles_to_files(folder.path, 1, true).do_task(source, options_of(6), k);
    check_refused(
        [&] { core::Tiles_to_files(folder.path, 1, true).do_task(source, options_of(6), 99); },
        folder.path.string(), "tasks 0 to");
  }
  BOOST_TEST(stages >= 6);
  check_same(core::Tiles_to_files(folder.path, 1, true).run(source, options_of(6)),
             report_of_here(points, 6));
  BOOST_TEST(fs::exists(folder.path / "tiles.pvtu"));
  BOOST_TEST(join_tiles(folder.path, folder.path / "all.npy") == finite_cells(points).size());
  BOOST_TEST((sorted(cells_of_npy(folder.path / "all.npy")) == finite_cells(points)));
}

// A file that was written again is another input, though its points are as many; what is left of a
// refused one is nothing; and no file of a tile may be missing.
BOOST_AUTO_TEST_CASE(inputs_that_change)
{
  const Folder folder;
  const fs::path file = folder.path / "points.raw", output = folder.path / "tiles";
  const Points points = some_points(1000);
  Points flat = points;
  for (auto& p : flat)
    p[2] = 0;
  const auto run = [&](const Points& input) {
    write_bytes(file, bytes_of(input));
    return core::Tiles_to_files(output, 1, false).run(CGAL::Point_files_3({file}), options_of(3));
  };
  BOOST_CHECK_THROW(run(flat), CGAL::Surface_input_error);
  BOOST_TEST(run(points).is_certified);
  BOOST_TEST(join_tiles(output, folder.path / "all.npy") == finite_cells(points).size());
  Points other = points;
  other[500][0] += .25; // none of those that a glance would see
  check_refused([&] { run(other); }, "another input", "another folder");
  fs::remove(output / "cells-00002.npy");
  check_refused([&] { join_tiles(output, folder.path / "all.npy"); }, "cells-00002.npy",
                "cannot be read");
}

// Files are read twice: for what all tiles know, and to bring each point home.
BOOST_AUTO_TEST_CASE(input_that_changes_while_it_is_read)
{
  const Folder folder;
  const fs::path file = folder.path / "points.raw", output = folder.path / "tiles";
  const Points points = some_points(1000);
  Points other = points;
  other[500] = {1e300, 1e300, 1e300};
  write_bytes(file, bytes_of(points));
  CGAL::Tiles_options options = options_of(3);
  bool has_changed = false;
  options.progress = [&](const std::string& what, std::size_t, std::size_t) {
    if (what == "sorting" && !has_changed) {
      has_changed = true;
      write_bytes(file, bytes_of(other));
      fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(2));
    }
    return true;
  };
  const auto run = [&] {
    return core::Tiles_to_files(output, 1, false).run(CGAL::Point_files_3({file}), options);
  };
  BOOST_CHECK_EXCEPTION(run(), CGAL::Surface_input_error, [](const std::exception& error) {
    return std::string(error.what()) == "the input has changed while it was read";
  });
  BOOST_TEST(has_changed);
  BOOST_TEST(run().is_certified); // nothing is left of it
  BOOST_TEST(join_tiles(output, folder.path / "all.npy") == finite_cells(other).size());
}

// Task by task, too, nothing is left of a refused input.
BOOST_AUTO_TEST_CASE(flat_input_task_by_task)
{
  const Folder folder;
  const fs::path file = folder.path / "points.raw", output = folder.path / "tiles";
  const auto run = [&](const Points& input) {
    write_bytes(file, bytes_of(input));
    for (;;) {
      const CGAL::Point_files_3 source({file});
      const core::Tiles_to_files work(output, 1, false);
      const std::size_t n = work.next(source, options_of(3)).number;
      for (std::size_t k = 0; k < n; ++k)
        work.do_task(source, options_of(3), k);
      if (n == 0)
        return;
    }
  };
  const Points points = some_points(1000);
  Points flat = points;
  for (auto& p : flat)
    p[2] = 0;
  BOOST_CHECK_THROW(run(flat), CGAL::Surface_input_error);
  run(points);
  BOOST_TEST(join_tiles(output, folder.path / "all.npy") == finite_cells(points).size());
}

BOOST_AUTO_TEST_CASE(neighbors_by_global_numbers)
{
  const Points points = some_points(1000);
  const Folder folder;
  core::Tiles_to_files tiles(folder.path, 2, false, true);
  tiles.run(source_of(points), options_of(6));
  join_tiles(folder.path, folder.path / "cells.npy");
  join_tiles(folder.path, folder.path / "links.npy", "neighbors");
  const Cells cells = cells_of_npy(folder.path / "cells.npy");
  const Cells links = cells_of_npy(folder.path / "links.npy");
  BOOST_TEST(links.size() == cells.size());
  std::size_t outside = 0;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t d = links[c][k];
      outside += d < 0;
      for (std::size_t j = 0; j < 4 && d >= 0; ++j) // all other corners are the neighbour's, too
        if (j != k)
          BOOST_TEST(std::count(cells[std::size_t(d)].begin(), cells[std::size_t(d)].end(),
                                cells[c][j]) == 1);
      if (d >= 0)
        BOOST_TEST(std::count(links[std::size_t(d)].begin(), links[std::size_t(d)].end(),
                              std::int64_t(c)) == 1);
    }
  const auto arrays = CGAL::delaunay_3_arrays(points);
  BOOST_TEST(outside == arrays.number_of_cells() - arrays.number_of_simplices());
  fs::remove(folder.path / "neighbors-00003.npy");
  tiles.run(source_of(points), options_of(6)); // which makes it again
  join_tiles(folder.path, folder.path / "again.npy", "neighbors");
  BOOST_TEST((cells_of_npy(folder.path / "again.npy") == links));
}

BOOST_AUTO_TEST_CASE(files_of_points)
{
  const Folder folder;
  const Points points = some_points(900);
  const std::string data = bytes_of(points);
  write_bytes(folder.path / "a.npy", npy("<f8", "900, 3", "False", data));
  write_bytes(folder.path / "b.raw", data);
  std::vector<float> floats;
  std::string swapped, ply;
  for (const auto& p : points)
    for (const double x : p)
      floats.push_back(float(x));
  for (std::size_t i = 0; i < data.size(); i += 8)
    swapped.append(data.rend() - std::ptrdiff_t(i + 8), data.rend() - std::ptrdiff_t(i));
  for (std::size_t i = 0; i < points.size(); ++i)
    ply += "ab" + data.substr(24 * i, 24) + "c";
  write_bytes(folder.path / "c.npy", npy("<f4", "900, 3", "False", bytes_of(floats)));
  write_bytes(folder.path / "d.npy", npy(">f8", "900, 3", "False", swapped));
  write_bytes(
      folder.path / "e.ply",
      "ply\nformat binary_little_endian 1.0\ncomment c\nelement camera 2\nproperty short s\n"
      "element vertex 900\nproperty short n\nproperty double x\nproperty float64 y\n"
      "property double z\nproperty uchar red\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n1234" +
          ply + "xxx");
  const CGAL::Point_files_3 files({folder.path / "a.npy", folder.path / "b.raw",
                                   folder.path / "c.npy", folder.path / "d.npy",
                                   folder.path / "e.ply"});
  BOOST_TEST(files.size() == 4500u);
  Points read(4500);
  files.read(0, 4500, read.front().data());
  for (std::size_t i = 0; i < read.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      BOOST_TEST(read[i][k] ==
                 (i / 900 == 2 ? double(float(points[i % 900][k])) : points[i % 900][k]));
  Points part(1000); // over the ends of files
  files.read(850, 1000, part.front().data());
  BOOST_TEST((std::equal(part.begin(), part.end(), read.begin() + 850)));
  BOOST_TEST(files.name_of(901) == (folder.path / "b.raw").string() + ": point 1");
}

BOOST_AUTO_TEST_CASE(bad_files)
{
  const Folder folder;
  const auto refused = [&](const std::string& name, const std::string& bytes,
                           const std::string& why) {
    write_bytes(folder.path / name, bytes);
    check_refused([&] { CGAL::Point_files_3({folder.path / name}); }, name, why);
  };
  const std::string ply = "ply\nformat binary_little_endian 1.0\n";
  refused("short.npy", npy("<f8", "2, 3", "False", std::string(47, ' ')), "ends early");
  refused("two.npy", npy("<f8", "2, 3", "False", std::string(48, ' ')) + "another array",
          " bytes, where its head says ");
  refused("flat.npy", npy("<f8", "6,", "False", std::string(48, ' ')), "shape");
  refused("cube.npy", npy("<f8", "1, 3, 2", "False", std::string(48, ' ')), "shape");
  refused("columns.npy", npy("<f8", "2, 3", "True", std::string(48, ' ')), "column");
  refused("int.npy", npy("<i8", "2, 3", "False", std::string(48, ' ')), "<i8");
  refused("text.npy", "0 0 0, 1 1 1", "NumPy");
  refused("empty.npy", "", "ends early");
  refused("odd.raw", std::string(25, ' '), "24 bytes");
  refused("points.xyz", "", "extension");
  refused("text.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
          "property float z\nend_header\n0 0 0\n",
          "text");
  refused("flat.ply", ply + "element vertex 1\nproperty float x\nproperty float y\nend_header\n",
          "x, y, z");
  refused("list.ply",
          ply + "element face 1\nproperty list uchar int i\nelement vertex 1\nend_header\n",
          "lists");
  refused("none.ply", ply + "end_header\n", "no vertices");
  refused("head.ply", ply, "no end");
  refused("short.ply",
          ply + "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                "end_header\nxxxxyyyyzzzz",
          "ends early");
  const std::string xyz = "property float x\nproperty float y\nproperty float z\nend_header\n";
  refused("absurd.ply", // 2^62 times 4 bytes are none
          ply + "element cell 4611686018427387904\nproperty int a\nelement vertex 1\n" + xyz +
              std::string(12, ' '),
          "ends early");
  refused("other.ply", "solid part\n", "no .ply: the first line is another");
  refused("type.ply", ply + "element vertex 1\nproperty half w\n" + xyz, "'half' is no type");
  refused("head.npy", std::string("\x93NUMPY\x02\x00\x00\x00\x00\x40", 12), "head has no end");
  check_refused([&] { join_tiles(folder.path, folder.path / "all.npy"); }, folder.path.string(),
                "has no tiles.json");
  const auto join = [&] { join_tiles(folder.path, folder.path / "all.npy"); };
  write_bytes(folder.path / "tiles.json", "{}");
  check_refused(join, "tiles.json", "does not say how many tiles there are");
  write_bytes(folder.path / "tiles.json", "{\"tiles\": 1}");
  write_bytes(folder.path / "cells-00000.npy", npy("<i8", "2, 4", "False", std::string(63, ' ')));
  check_refused(join, "cells-00000.npy", "has another size than its head says");
  check_refused([&] { CGAL::Point_files_3({folder.path / "none.npy"}); }, "none.npy",
                "No such file");
  write_bytes(folder.path / "nan.raw", bytes_of(std::vector<double>{0, 0, 0, 1, 1, std::nan("")}));
  const auto run = [](const CGAL::Tile_source_3& source, const fs::path& place) {
    core::Tiles_to_files(place, 1, false).run(source, options_of(3));
  };
  check_refused([&] { run(CGAL::Point_files_3({folder.path / "nan.raw"}), folder.path / "out"); },
                "nan.raw", "point 1: a coordinate is not a finite number");
  const Points plane = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  check_refused([&] { run(source_of(plane), folder.path / "plane"); }, "plane", "use arrays");
}

BOOST_AUTO_TEST_CASE(states_of_others)
{
  const Folder folder;
  const Points points = some_points(800), others = some_points(900);
  Points moved = points;
  for (auto& p : moved)
    p[0] += 1;
  const auto run = [&](const Points& p, std::uint32_t tiles) {
    return core::Tiles_to_files(folder.path, 1, false).run(source_of(p), options_of(tiles));
  };
  const auto report = run(points, 4);
  const std::string place = folder.path.string();
  check_refused([&] { run(others, 4); }, place, "another input");
  check_refused([&] { run(moved, 4); }, place, "another input");
  check_refused([&] { run(points, 5); }, place, "4 tiles");
  check_same(run(points, 4), report);
  const Folder another;
  const core::Tiles_to_files tiles(another.path, 1, false);
  BOOST_TEST(tiles.next(source_of(points), options_of(4)).stage == "reading");
  fs::copy_file(folder.path / "state" / "tiling", another.path / "state" / "tiling");
  check_refused([&] { tiles.next(source_of(points), options_of(4)); }, another.path.string(),
                "belongs to another run");

  const fs::path tiling = folder.path / "state" / "tiling";
  const auto size = fs::file_size(tiling);
  fs::resize_file(tiling, size - 1);
  check_refused([&] { run(points, 4); }, tiling.string(), "ends early");
  write_bytes(folder.path / "state" / "input",
              "dfs3 tiles 4 input, of an older version of the program");
  check_refused([&] { run(points, 4); }, "input", "version");
  fs::remove_all(folder.path / "state");
  check_refused([&] { run(points, 4); }, "tiles.json", "another run");
  fs::remove(folder.path / "tiles.json");
  check_refused([&] { run(points, 4); }, "cells-00000.npy", "another run");
}

// Reads all of a file of a state, by its name, as those do that need it.
void read_all_of(core::Tile_folder& folder, const std::string& name, std::uint32_t tiles)
{
  std::vector<std::size_t> numbers;
  for (std::size_t dash = name.find('-'); dash != std::string::npos;
       dash = name.find('-', dash + 1))
    numbers.push_back(std::stoul(name.substr(dash + 1)));
  const std::string kind = name.substr(0, name.find('-'));
  std::vector<core::Tile_point> points;
  const auto number = [&](std::size_t k) { return std::uint32_t(numbers.at(k)); };
  if (kind == "input")
    folder.read_input();
  else if (kind == "tiling")
    folder.read<core::Tiling>(kind.c_str());
  else if (kind == "range")
    folder.read<core::Range_summary>(kind.c_str(), number(0));
  else if (kind == "home")
    for (std::uint32_t t = 0; t < tiles; ++t)
      folder.append_part(kind.c_str(), number(0), t, points);
  else if (kind == "tile")
    folder.read<core::Tile_state>(kind.c_str(), number(0), number(1));
  else if (kind == "post")
    for (const auto& posted :
         folder.read<std::vector<core::Posted>>(kind.c_str(), number(0), number(1)))
      folder.append_message(posted, number(1), points);
  else if (kind == "closed")
    folder.read<core::Closed_round>(kind.c_str(), number(0));
  else if (kind == "show")
    folder.read<core::Tile_pairs>(kind.c_str(), number(0));
  else if (kind == "certificate")
    folder.read<core::Tile_certificate>(kind.c_str(), number(0));
  else if (kind == "piece")
    folder.read_piece(number(0));
  else
    BOOST_ERROR("a file of another kind: " + name);
}

// In a state no byte can change without being seen by those who read it: not one that says how much
// there is, either.
BOOST_AUTO_TEST_CASE(states_with_a_byte_that_has_changed)
{
  const Points points = some_points(60);
  const std::uint32_t n = 2;
  std::set<std::string> kinds;
  for (int stop = 1; stop < 12; ++stop) {
    const Folder folder;
    CGAL::Tiles_options options = options_of(n);
    options.points_at_once = 40;
    int calls = 0;
    options.progress = [&](const char*, std::size_t, std::size_t) { return ++calls < 2 * stop; };
    try {
      core::Tiles_to_files(folder.path, 1, false).run(source_of(points), options);
    } catch (const CGAL::Tiles_stopped&) {
    }
    const fs::path state = folder.path / "state";
    for (const std::string& name : core::names_in(state)) {
      if (fs::is_directory(state / name) || fs::file_size(state / name) <= 48) // a mark
        continue;
      if (!kinds.insert(name.substr(0, name.find_first_of("0123456789"))).second)
        continue;
      core::Tile_folder read(state);
      read.read_input();
      read_all_of(read, name, n);
      std::string bytes(std::size_t(fs::file_size(state / name)), ' ');
      core::Bytes_reader(state / name).read(bytes.data(), bytes.size());
      for (std::size_t k = 0; k < bytes.size(); ++k) {
        std::string changed = bytes;
        changed[k] = char(changed[k] ^ (1 << (k % 8)));
        write_bytes(state / name, changed);
        BOOST_CHECK_THROW(read_all_of(read, name, n), CGAL::Tile_files_error);
      }
      write_bytes(state / name, bytes.substr(0, bytes.size() / 2));
      BOOST_CHECK_THROW(read_all_of(read, name, n), CGAL::Tile_files_error);
      std::string changed = bytes;
      changed[bytes.size() - 20] ^= 4;
      write_bytes(state / name, changed);
      if (name != "input" && name != "tiling")
        continue;
      check_refused(
          [&] {
            core::Tiles_to_files(folder.path, 1, false).run(source_of(points), options_of(n));
          },
          name, "is damaged, as its checksum tells: remove the folder of the tiles");
      write_bytes(state / name, bytes);
    }
  }
  for (const char* const kind : {"input", "tiling", "range-", "home-", "tile-", "closed-", "post-"})
    BOOST_TEST(kinds.count(kind) == 1u, kind);
}

#ifdef __linux__
BOOST_AUTO_TEST_CASE(no_room_on_the_disk)
{
  if (!fs::exists("/dev/full"))
    return;
  const Folder folder;
  fs::create_directories(folder.path / "state");
  core::Bytes_writer to(folder.path / "file");
  // Where what is written aside should go there is a device that is full.
  for (const auto& entry : fs::directory_iterator(folder.path))
    BOOST_TEST((entry.path().filename() == "state" || entry.path().extension() == ".unfinished"));
  check_refused([&] { core::Bytes_writer("/dev/full/file"); }, "/dev/full/file",
                "cannot be written");
}
#endif

// What an earlier run left would be taken for what this one has written.
BOOST_AUTO_TEST_CASE(tiles_of_others_without_a_state)
{
  const Points points = some_points(800);
  const auto run = [&](const fs::path& place) {
    core::Tiles_to_files(place, 1, false).run(source_of(points), options_of(3));
  };
  for (const char* const name : {"cells-00001.npy", "ids-00000.npy", "points-100000.npy",
                                 "neighbors-00002.npy", "tile-00001.vtu", "tiles.pvtu"}) {
    const Folder folder;
    write_bytes(folder.path / name, "x");
    check_refused([&] { run(folder.path); }, name, "another run");
    check_refused(
        [&] { core::Tiles_to_files(folder.path, 1, false).next(source_of(points), options_of(3)); },
        name, "another run");
    BOOST_TEST(!fs::exists(folder.path / "state"));
  }
  const Folder folder;
  for (const char* const name :
       {"cells-0001.npy", "cells-.npy", "cells.npy", "other-00001.npy", "cells-00001.vtu", "-"})
    write_bytes(folder.path / name, "x");
  run(folder.path);
}

BOOST_AUTO_TEST_CASE(an_input_that_would_be_overwritten)
{
  const Folder folder;
  const std::string data = bytes_of(some_points(800));
  const fs::path file = folder.path / "points-00000.npy";
  write_bytes(file, npy("<f8", "800, 3", "False", data));
  const auto run = [&](const fs::path& input, const fs::path& place) {
    core::Tiles_to_files(place, 1, false).run(CGAL::Point_files_3({input}), options_of(3));
  };
  check_refused([&] { run(file, folder.path); }, file.string(), "would be overwritten");
  fs::create_symlink(file, folder.path / "link.npy");
  check_refused([&] { run(folder.path / "link.npy", folder.path); }, "link.npy",
                "would be overwritten");
  const Folder capital; // where a system may take both names for the same
  fs::copy_file(file, capital.path / "Points-00000.NPY");
  check_refused([&] { run(capital.path / "Points-00000.NPY", capital.path); }, "Points-00000.NPY",
                "would be overwritten");
  check_refused([&] { run(file, capital.path); }, "Points-00000.NPY", "is of another run");
  // Nor one that would be removed with the state; what others have in a folder of that name stays.
  const Folder used;
  const fs::path below = used.path / "state" / "scans" / "mine.npy";
  fs::create_directories(below.parent_path());
  fs::copy_file(file, below);
  check_refused([&] { run(below, used.path); }, "mine.npy", "would be overwritten");
  check_refused([&] { run(file, used.path); }, "scans", "is of another run");
  BOOST_TEST(fs::exists(below));
  run(file, folder.path / "tiles");
  BOOST_TEST(fs::file_size(file) == npy("<f8", "800, 3", "False", data).size());
}

// The engine alone removes nothing of others either, and has its folder to itself.
BOOST_AUTO_TEST_CASE(a_state_of_others)
{
  const Folder folder;
  const Points points = some_points(800);
  CGAL::Tiles_in_files_3 engine(folder.path);
  const auto run = [&] {
    CGAL::delaunay_3_tiles(
        engine, source_of(points), [](const CGAL::Delaunay_3_tile&) {}, options_of(3));
  };
  const fs::path file = folder.path / "state" / "tile-5";
  fs::create_directories(file.parent_path());
  write_bytes(file, "mine");
  check_refused(run, file.string(), "is of another run");
  BOOST_TEST(fs::file_size(file) == 4u);
  fs::remove(file);
#ifdef __linux__
  {
    const core::Folder_lock lock(folder.path, core::Folder_lock::SHARED);
    check_refused(run, folder.path.string(), "another run is at work there");
  }
#endif
  run();
}

// Of an array every coordinate counts.
BOOST_AUTO_TEST_CASE(arrays_that_change)
{
  const Folder folder;
  Points points = some_points(1000);
  const auto run = [&] {
    return core::Tiles_to_files(folder.path, 1, false).run(source_of(points), options_of(3));
  };
  const auto report = run();
  check_same(run(), report);
  points[500][1] += .25; // none of those that a glance would see
  check_refused(run, folder.path.string(), "another input");
}

// What a process left that was killed while it began again, or before it had cleaned.
BOOST_AUTO_TEST_CASE(leftovers_of_killed_processes)
{
  const Folder folder;
  const fs::path state = folder.path / "state", gone = folder.path / "state-123.unfinished";
  fs::create_directories(gone);
  write_bytes(gone / "tiling", "x");
  const Points points = some_points(800);
  const auto work = [&] { return core::Tiles_to_files(folder.path, 1, false); };
  work().run(source_of(points), options_of(3));
  BOOST_TEST(!fs::exists(gone));
  const auto litter = [&] {
    for (const char* const name : {"range-0", "home-0", "tile-0-1", "post-0-1"})
      write_bytes(state / name, "x");
  };
  const auto is_clean = [&] {
    for (const char* const name : {"range-0", "home-0", "tile-0-1", "post-0-1"})
      if (fs::exists(state / name))
        return false;
    return true;
  };
  BOOST_TEST(is_clean());
  litter();
  work().run(source_of(points), options_of(3));
  BOOST_TEST(is_clean());
  litter();
  BOOST_TEST(work().next(source_of(points), options_of(3)).number == 0u);
  BOOST_TEST(is_clean());

  const fs::path inside = state / "inside";
  fs::create_directories(inside);
  work().forget();
  for (const auto& entry : fs::directory_iterator(folder.path))
    BOOST_TEST(entry.path().filename().string().find("state") == std::string::npos);
  work().forget(); // there is none
}

// One task is in memory, whatever the number of threads.
BOOST_AUTO_TEST_CASE(memory_of_tasks_done_one_by_one)
{
  const Points points = some_points(2000);
  CGAL::Tiles_options options = options_of(0);
  options.memory = core::bytes_per_point_kept * 2000;
  for (const std::size_t threads : {1, 4}) {
    const Folder folder;
    const core::Tiles_to_files work(folder.path, threads, false);
    const std::uint32_t tiles = work.next(source_of(points), options).tiles;
    BOOST_TEST(tiles == core::number_of_tiles(options, 2000, 1));
  }
}

#ifdef __linux__
// Of two that would close a stage one waits for the other.
BOOST_AUTO_TEST_CASE(stages_are_closed_in_turn)
{
  const Folder folder;
  const Points points = some_points(800);
  const auto next = [&] {
    return core::Tiles_to_files(folder.path, 1, false)
        .next(source_of(points), options_of(3))
        .number;
  };
  const std::size_t n = next();
  std::future<std::size_t> other;
  {
    const core::Folder_lock turn(folder.path / "state", core::Folder_lock::IN_TURN);
    other = std::async(std::launch::async, next);
    BOOST_TEST((other.wait_for(std::chrono::milliseconds(200)) == std::future_status::timeout));
  }
  BOOST_TEST(other.get() == n);

  // A task waits for those that close a stage, but not for other tasks.
  const auto task = [&] {
    core::Tiles_to_files(folder.path, 1, false).do_task(source_of(points), options_of(3), 0);
  };
  std::future<void> waiting;
  {
    const core::Folder_lock turn(folder.path / "state", core::Folder_lock::IN_TURN);
    waiting = std::async(std::launch::async, task);
    BOOST_TEST((waiting.wait_for(std::chrono::milliseconds(200)) == std::future_status::timeout));
  }
  waiting.get();
  const core::Folder_lock turn(folder.path / "state", core::Folder_lock::SHARED_IN_TURN);
  task();
}

// As root a rename would put a file where the device is.
BOOST_AUTO_TEST_CASE(what_is_no_regular_file_is_not_replaced)
{
  const Folder folder;
  const fs::path pipe = folder.path / "pipe";
  BOOST_TEST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  check_refused([&] { core::Bytes_writer to(pipe); }, pipe.string(), "no regular file");
  fs::create_symlink(pipe, folder.path / "link");
  check_refused([&] { core::Bytes_writer to(folder.path / "link"); }, "link", "no regular file");
  BOOST_TEST(fs::is_fifo(pipe));
}
#endif
