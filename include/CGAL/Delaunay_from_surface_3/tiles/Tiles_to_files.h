// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_TO_FILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_TO_FILES_H

// All of it: from files of points to files of tiles, in one call or task by task. In the folder:
// state/, and what write_tiles.h writes.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Folder_lock.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_stages.h>
#include <CGAL/Delaunay_from_surface_3/tiles/files_of_tiles.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tasks.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tiles.h>
#include <CGAL/Delaunay_from_surface_3/tiles/write_tiles.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_to_files
{
public:
  Tiles_to_files(std::filesystem::path folder, std::size_t number_of_threads, bool with_vtu,
                 bool with_neighbors = false)
    : m_folder(std::move(folder))
    , m_executor(number_of_threads)
    , m_engine(m_folder, number_of_threads)
    , m_with_vtu(with_vtu)
    , m_with_neighbors(with_neighbors)
  {
  }

  // Begins or goes on, to the end.
  Tiles_report run(const Tile_source_3& source, const Tiles_options& options)
  {
    const Folder_lock lock(m_folder, Folder_lock::ALONE);
    refuse_other_tiles(source);
    const auto no_seed = [] { return std::uint64_t(0); }; // it is in the state
    const auto write = [&](const Tiles_report& report) {
      write_all(options);
      if (m_with_neighbors)
        Tile_neighbors(m_folder, m_folder / "state", report.tiles).run(m_executor);
      return finish();
    };
    return run_until_certified(m_engine, source, options, no_seed, write);
  }

  // Begins, or closes what is done, and returns how many tasks there are now; 0: all is done, but
  // neighbors.
  std::size_t next(const Tile_source_3& source, const Tiles_options& options)
  {
    const Folder_lock lock(m_folder, Folder_lock::SHARED);
    refuse_other_tiles(source);
    const Folder_lock turn = my_turn(); // another would close the same stage
    try {
      return close_and_count(source, options);
    } catch (const Surface_input_error&) {
      forget(); // the next one is another
      throw;
    }
  }

  // After next(): what the tasks are for, and how many tiles there are.
  std::string name()
  {
    return m_engine.stages().stage() == Tiles_stages::DONE ? "writing" : m_engine.stages().name();
  }
  std::uint32_t number_of_tiles() const { return m_engine.number_of_tiles(); }

  // Removes the state, so that the work can begin again with other options.
  void forget() { m_engine.forget(); }

  // Of those that next() has counted, by all threads.
  void do_task(const Tile_source_3& source, const Tiles_options& options, std::size_t k)
  {
    const Folder_lock lock(m_folder, Folder_lock::SHARED);
    refuse_other_tiles(source);
    Tiles_stages& stages = begin_in_turn(source, options);
    const bool writes = stages.stage() == Tiles_stages::DONE;
    const std::size_t n = writes ? m_engine.number_of_tiles() : stages.number_of_tasks();
    if (k >= n)
      throw Tile_files_error(m_folder.string() + ": there are tasks 0 to " + std::to_string(n - 1) +
                             " only");
    if (writes)
      write(std::uint32_t(k));
    else
      stages.do_task(k, threads_of_task(0, 1, m_executor.number_of_workers()));
  }

private:
  Folder_lock my_turn() const { return Folder_lock(m_folder / "state", Folder_lock::IN_TURN); }

  std::size_t close_and_count(const Tile_source_3& source, const Tiles_options& options)
  {
    Tiles_stages& stages = begin(source, options);
    if (stages.stage() != Tiles_stages::DONE && is_all_done(stages)) {
      const bool was_pieces = stages.stage() == Tiles_stages::PIECES;
      stages.close();
      if (was_pieces && stages.stage() == Tiles_stages::PIECES)
        repair(stages);
    }
    if (stages.stage() != Tiles_stages::DONE)
      return stages.number_of_tasks();
    for (std::uint32_t t = 0; t < m_engine.number_of_tiles(); ++t)
      if (!is_written(t))
        return m_engine.number_of_tiles();
    stages.clean(); // who closed the last stage may have been killed before
    finish();
    return 0;
  }

  // For tasks, of which one is in memory, and has all threads.
  Tiles_stages& begin(const Tile_source_3& source, const Tiles_options& options)
  {
    m_engine.stages().begin(source, options, 1);
    return m_engine.stages();
  }
  Tiles_stages& begin_in_turn(const Tile_source_3& source, const Tiles_options& options)
  {
    const Folder_lock turn = my_turn();
    return begin(source, options);
  }

  static bool is_all_done(const Tiles_stages& stages)
  {
    for (std::size_t k = 0; k < stages.number_of_tasks(); ++k)
      if (!stages.is_done(k))
        return false;
    return true;
  }

  static void repair(Tiles_stages& stages)
  {
    const Tile_pairs differing = tiles_that_differ(stages.certificates());
    if (differing.empty())
      throw std::runtime_error(tiles_do_not_fit);
    stages.show(differing);
  }

  // What is there without a state is of another run, and would be taken for what is written already.
  void refuse_other_tiles(const Tile_source_3& source) const
  {
    refuse_to_overwrite(source, m_folder);
    if (std::filesystem::exists(m_folder / "state" / "input"))
      return;
    std::vector<std::filesystem::path> others = files_of_tiles(m_folder);
    for (const std::string& name : names_in(m_folder / "state")) // it is removed as a whole
      if (name_when_finished(name).empty())
        others.push_back(m_folder / "state" / name);
    if (std::filesystem::exists(m_folder / "tiles.json"))
      others.insert(others.begin(), m_folder / "tiles.json");
    if (!others.empty())
      throw Tile_files_error(others.front().string() +
                             ": is of another run: remove all files of its tiles, or name another "
                             "folder");
  }

  bool is_written(std::uint32_t t) const
  {
    return std::filesystem::exists(file_of_tile(m_folder, "cells", t, "npy")) &&
           (!m_with_vtu || std::filesystem::exists(file_of_tile(m_folder, "tile", t, "vtu")));
  }

  void write(std::uint32_t t)
  {
    if (!is_written(t)) {
      if (!std::filesystem::exists(m_engine.stages().folder().file("piece", t)))
        throw Tile_files_error(m_folder.string() +
                               ": a tile has been removed, or tiles are written "
                               "without .vtu: remove it, or name another folder");
      const Delaunay_3_tile tile = m_engine.tile(t);
      if (m_with_vtu)
        write_tile_as_vtu(m_folder, tile);
      write_tile_as_arrays(m_folder, tile);
    }
    m_engine.drop_tile(t);
  }

  void write_all(const Tiles_options& options)
  {
    const std::size_t n = m_engine.number_of_tiles();
    std::size_t done = 0;
    run_tasks(m_executor, n, [&](std::size_t t) {
      write(std::uint32_t(t));
      const std::lock_guard<std::mutex> lock(m_mutex);
      if (options.progress && !options.progress("writing", ++done, n))
        throw Tiles_stopped();
    });
  }

  Tiles_report finish() const
  {
    Tiles_report report;
    report.points = m_engine.number_of_points();
    report.tiles = m_engine.number_of_tiles();
    report.rounds = m_engine.rounds();
    report.told = m_engine.told();
    report_certificates(m_engine.certificates(), report);
    if (m_with_vtu)
      write_pvtu(m_folder, report.tiles);
    remove_left();
    write_report(m_folder, report);
    return report;
  }

  // What processes left that were killed; the state is this run's own.
  void remove_left() const
  {
    std::vector<std::filesystem::path> left = left_files(m_folder);
    for (const std::string& name : names_in(m_folder / "state"))
      if (!name_when_finished(name).empty())
        left.push_back(m_folder / "state" / name);
    std::error_code ignored; // they are in nobody's way
    for (const auto& path : left)
      std::filesystem::remove(path, ignored);
  }

  const std::filesystem::path m_folder;
  Thread_executor m_executor;
  Tiles_in_files m_engine;
  const bool m_with_vtu, m_with_neighbors;
  std::mutex m_mutex;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_TO_FILES_H
