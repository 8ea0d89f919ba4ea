// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_STAGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_STAGES_H

// The stages of a run in a folder (Tile_folder.h), and their tasks: to read the ranges of the
// input, to bring their points home, rounds, and what all is for.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Range_summary.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_folder.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_tasks.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/Delaunay_from_surface_3/tiles/forget_folder.h>
#include <CGAL/Delaunay_from_surface_3/tiles/number_of_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_stages
{
public:
  enum Stage { SAMPLE, HOME, ROUND, PIECES, DONE };

  explicit Tiles_stages(const std::filesystem::path& place)
    : m_folder(place)
  {
  }

  // Begins, or finds out what there is. At once: how many tiles are in memory.
  void begin(const Tile_source_3& source, const Tiles_options& options, std::size_t at_once)
  {
    m_source = &source;
    m_tiling.reset(); // of another call
    m_closed = {};
    m_limit = most_points_kept(options, at_once);
    std::error_code error;
    std::filesystem::create_directories(m_folder.place(), error);
    if (error)
      fail_to_write(m_folder.place(), error.value());
    if (std::filesystem::exists(m_folder.file("input")))
      go_on(options);
    else
      begin_anew(options, at_once);
    find_stage();
  }

  const Tile_folder& folder() const { return m_folder; }
  const Tiles_input& input() const { return m_input; }
  Stage stage() const { return m_stage; }
  std::size_t rounds() const { return m_round; } // that are closed
  std::uint64_t told() const { return m_told; }

  std::string name() const
  {
    return m_stage == SAMPLE  ? "reading"
           : m_stage == HOME  ? "sorting"
           : m_stage == ROUND ? "round " + std::to_string(m_round)
                              : "certificate";
  }

  std::size_t number_of_tasks() const
  {
    return m_stage <= HOME ? tasks().number_of_ranges() : m_tasks.size();
  }

  bool is_done(std::size_t k) const { return std::filesystem::exists(result_of(k)); }

  // By n threads. Of several tasks at once each is done by any thread or process.
  void do_task(std::size_t k, std::size_t n) const
  {
    if (is_done(k))
      return;
    const Rounding_to_nearest rounding;
    switch (m_stage) {
    case SAMPLE:
      return tasks().summarize(k);
    case HOME:
      return tasks().bring_home(k, *m_tiling);
    case ROUND:
      return tasks(n).do_round(m_tasks[k], *m_tiling, m_round, m_closed, m_shown);
    case PIECES:
      return tasks(n).finish_tile(m_tasks[k], *m_tiling, m_closed);
    case DONE:
      return;
    }
  }

  // When all tasks are done, and nobody does any.
  void close()
  {
    for (std::size_t k = 0; k < number_of_tasks(); ++k)
      if (!is_done(k))
        throw Tile_files_error(m_folder.place().string() + ": task " + std::to_string(k) + " of " +
                               name() + " is not done");
    const Rounding_to_nearest rounding;
    if (m_stage == SAMPLE)
      m_folder.write_tiling(tasks().make_tiling());
    else if (m_stage == HOME) {
      if (m_input.fingerprint != fingerprint_of(*m_source))
        throw Surface_input_error("the input has changed while it was read");
      m_folder.write_mark("homes");
    } else if (m_stage == ROUND)
      close_round();
    else if (m_stage == PIECES && is_certified(certificates(), m_input.tiles, m_input.points))
      m_folder.write_mark("certified"); // else the driver goes on, by show()
    find_stage();
    clean();
  }

  std::vector<Tile_certificate> certificates() const
  {
    std::vector<Tile_certificate> certificates;
    for (std::uint32_t t = 0; t < m_input.tiles; ++t)
      certificates.push_back(m_folder.read_certificate(t));
    return certificates;
  }

  // Rounds go on, in which these show each other why they differ.
  void show(const Tile_pairs& pairs)
  {
    m_folder.write_show(m_round, pairs);
    find_stage();
  }

  // Removes what is not read any more, and what killed processes left. When nobody does any task.
  void clean() const
  {
    std::set<std::string> kept;
    for (std::uint32_t t = 0; m_stage != DONE && m_round > 0 && t < m_input.tiles; ++t) {
      kept.insert(m_folder.file("tile", t, m_closed.last_rounds[t]).filename().string());
      kept.insert(m_folder.file("post", t, m_round - 1).filename().string());
    }
    std::vector<std::filesystem::path> gone;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.place())) {
      const std::string name = entry.path().filename().string();
      const std::string kind = name.substr(0, name.find('-'));
      const bool is_unfinished = entry.path().extension() == unfinished;
      const bool is_old = (kind == "tile" || kind == "post") && kept.count(name) == 0;
      const bool is_read =
          (kind == "range" && m_stage > SAMPLE) || (kind == "home" && m_stage == DONE);
      if (is_unfinished || is_old || is_read)
        gone.push_back(entry.path());
    }
    std::error_code ignored;
    for (const auto& path : gone)
      std::filesystem::remove(path, ignored);
  }

  void forget() const { forget_folder(m_folder.place()); }

private:
  Tile_tasks tasks(std::size_t n = 1) const { return {m_folder, *m_source, m_input, m_limit, n}; }

  void begin_anew(const Tiles_options& options, std::size_t at_once)
  {
    remove_forgotten(m_folder.place());
    m_input = {m_source->size(),
               fingerprint_of(*m_source),
               options.sample_share,
               most_points_read(options, at_once),
               number_of_tiles(options, m_source->size(), at_once),
               options.compares_cells};
    std::random_device random;
    m_folder.set_run(std::uint64_t(random()) << 32 | random() | 1);
    m_folder.write_input(m_input);
  }

  void go_on(const Tiles_options& options)
  {
    m_input = m_folder.read_input();
    const std::string place = m_folder.place().string();
    if (m_input.points != m_source->size() || m_input.fingerprint != fingerprint_of(*m_source))
      throw Tile_files_error(place + ": holds the state of a run on another input, of " +
                             std::to_string(m_input.points) +
                             " points: remove it, or name another folder");
    if (options.compares_cells && m_input.compares_cells == 0)
      throw Tile_files_error(place + ": holds the state of a run that compares sums of hashes: "
                                     "remove it to compare cells");
    if (options.number_of_tiles != 0 &&
        number_of_tiles(options, m_input.points, 1) != m_input.tiles)
      throw Tile_files_error(place + ": holds the state of a run with " +
                             std::to_string(m_input.tiles) +
                             " tiles: remove it, or ask for as many");
  }

  void find_stage()
  {
    const auto is_there = [&](const auto&... name) {
      return std::filesystem::exists(m_folder.file(name...));
    };
    m_stage = !is_there("tiling") ? SAMPLE : !is_there("homes") ? HOME : ROUND;
    if (m_stage >= HOME && !m_tiling)
      m_tiling.emplace(m_folder.read_tiling());
    m_round = 0;
    m_told = 0;
    m_shown.clear();
    for (; m_stage == ROUND && is_there("closed", m_round); ++m_round) {
      m_closed = m_folder.read_closed(m_round);
      m_told += m_closed.told;
    }
    if (m_stage == ROUND && is_there("show", m_round))
      m_shown = m_folder.read_show(m_round);
    else if (m_round > 0 && m_closed.told == 0)
      m_stage = is_there("certified") ? DONE : PIECES;
    find_tasks();
  }

  void find_tasks()
  {
    std::set<std::uint32_t> tiles;
    if (m_stage == PIECES || (m_stage == ROUND && m_round == 0)) {
      for (std::uint32_t t = 0; t < m_input.tiles; ++t)
        tiles.insert(t);
    } else if (m_stage == ROUND) {
      for (const Posted& posted : m_closed.posts)
        tiles.insert(posted.to);
      for (const auto& [a, b] : m_shown)
        tiles.insert({a, b});
    }
    m_tasks.assign(tiles.begin(), tiles.end());
  }

  std::filesystem::path result_of(std::size_t k) const
  {
    switch (m_stage) {
    case SAMPLE:
      return m_folder.file("range", k);
    case HOME:
      return m_folder.file("home", k);
    case ROUND:
      return m_folder.file("tile", m_tasks[k], m_round);
    default:
      return m_folder.file("certificate", m_tasks[k]);
    }
  }

  void close_round()
  {
    Closed_round closed;
    closed.last_rounds = m_closed.last_rounds;
    closed.last_rounds.resize(m_input.tiles);
    for (const std::uint32_t t : m_tasks) {
      closed.last_rounds[t] = std::uint32_t(m_round);
      if (std::filesystem::exists(m_folder.file("post", t, m_round)))
        for (const Posted& posted : m_folder.read_posts(t, m_round)) {
          closed.told += posted.number;
          closed.posts.push_back(posted);
        }
    }
    for (std::uint32_t t = 0; t < m_input.tiles && closed.told == 0; ++t)
      for (const char* kind : {"certificate", "piece"}) // before rounds went on
        std::filesystem::remove(m_folder.file(kind, t));
    std::random_device random;
    closed.seed = std::uint64_t(random()) << 32 | random();
    m_folder.write_closed(m_round, closed);
  }

  Tile_folder m_folder;
  const Tile_source_3* m_source = nullptr;
  std::size_t m_limit = 0;
  Tiles_input m_input{};
  Stage m_stage = SAMPLE;
  std::optional<Tiling> m_tiling;
  std::size_t m_round = 0;
  std::uint64_t m_told = 0;
  Closed_round m_closed; // the last one
  Tile_pairs m_shown;
  std::vector<std::uint32_t> m_tasks; // tiles
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_STAGES_H
