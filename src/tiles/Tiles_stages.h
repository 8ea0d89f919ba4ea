// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_SRC_TILES_TILES_STAGES_H
#define DELAUNAY_FROM_SURFACE_3_SRC_TILES_TILES_STAGES_H

// An engine out of core: the state of a round is in a folder, and the work of a stage consists of
// tasks, one for each range of the input or each tile. A task reads files and writes others, which
// are the same whenever it is done; so it may be killed at any moment and done again, by any
// process. When all tasks of a stage are done, one more file closes the stage.
//
// In memory there is one tile for each thread: when its turn comes, it is made again from the
// points that it keeps.

#include "Tile_folder.h"

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The tasks of a run in a folder. A task writes the same whenever it is done, except for the order
// of a tile's cells if several threads make it.

// Refers to the data of a run.
struct Tile_tasks
{
  const Tile_folder& folder;
  const Tile_source_3& source;
  const Tiles_input& input;
  std::size_t limit;   // how many points a tile may keep
  std::size_t threads; // for one task

  std::size_t number_of_ranges() const
  {
    return std::size_t((input.points + input.points_at_once - 1) / input.points_at_once);
  }

  void summarize(std::size_t k) const
  {
    const std::uint64_t first = first_of_range(k);
    folder.write(summary_of(read_range(source, first, first_of_range(k + 1)), first, sampling()),
                 "range", k);
  }

  Tiling make_tiling() const
  {
    std::vector<Range_summary> ranges;
    for (std::size_t k = 0; k < number_of_ranges(); ++k)
      ranges.push_back(folder.read<Range_summary>("range", k));
    return tiling_of(ranges, input.points, std::uint32_t(input.tiles), sampling());
  }

  // Sorts the points of a range by the tiles that own them.
  void bring_home(std::size_t k, const Tiling& tiling) const
  {
    const std::uint64_t first = first_of_range(k);
    std::vector<Tile_point> points;
    {
      const std::vector<double> read = read_range(source, first, first_of_range(k + 1));
      points.reserve(read.size() / 3);
      for (std::size_t i = 0; i < read.size() / 3; ++i)
        points.push_back(tile_point(first + i, &read[3 * i]));
    }
    const auto owner = [&](const Tile_point& p) { return tiling.tree.owner(p.coordinates); };
    folder.write_parts(points, std::size_t(input.tiles), owner, "home", k);
  }

  // Lets a tile hear what it was told in the round before, and tell; it also shows the tiles that
  // differ from it why.
  void do_round(std::uint32_t t, const Tiling& tiling, std::size_t round,
                const Closed_round& before, const Tile_pairs& shown) const
  {
    Tile_state state;
    if (round > 0)
      state = folder.read<Tile_state>("tile", t, before.last_rounds[t]);
    std::optional<Delaunay_tile> tile; // made when something is new
    const auto make = [&] {
      if (!tile)
        tile.emplace(tiling, t, own_points(t), std::move(state), round == 0, limit,
                     Thread_executor(threads));
    };
    std::vector<Tile_message> questions;
    const auto hear = [&](std::vector<Tile_message> messages) {
      Tile_news news = news_of(std::move(messages), tiling, t, tile ? tile->known() : state.known);
      if (news.empty())
        return;
      make();
      tile->offer(std::move(news.offers));
      std::move(news.questions.begin(), news.questions.end(), std::back_inserter(questions));
    };
    if (round == 0)
      hear({{t, t, tiling.sample}});
    else
      hear_messages(t, round - 1, before, hear);
    const std::vector<std::uint32_t> partners = partners_of(t, shown);
    if (round > 0 && !tile && partners.empty()) // nothing is new
      return folder.write(state, "tile", t, round);
    make();
    std::vector<Tile_message> messages = tile->tell_and_answer(questions);
    for (Tile_message& message : tile->witnesses(partners))
      messages.push_back(std::move(message));
    if (!messages.empty())
      folder.write_post(t, round, messages);
    std::vector<Tile_message>().swap(messages);
    folder.write(std::move(*tile).state(), "tile", t, round);
  }

  // Writes the result and the certificate of a tile.
  void finish_tile(std::uint32_t t, const Tiling& tiling, const Closed_round& last) const
  {
    auto state = folder.read<Tile_state>("tile", t, last.last_rounds[t]);
    state = {std::move(state.kept), {}, {}}; // nothing is told now
    const Delaunay_tile tile(tiling, t, own_points(t), std::move(state), false, limit,
                             Thread_executor(threads));
    folder.write_piece(Piece_of_tile(tile));
    folder.write(certificate_of(tile, last.seed), "certificate", t);
  }

private:
  std::uint64_t first_of_range(std::size_t k) const
  {
    return (std::min)(input.points, k * input.points_at_once);
  }
  Sampling sampling() const
  {
    return Sampling(input.points, std::uint32_t(input.tiles), std::size_t(input.sample_share));
  }

  std::vector<Tile_point> own_points(std::uint32_t t) const
  {
    std::vector<Tile_point> own;
    for (std::size_t k = 0; k < number_of_ranges(); ++k)
      folder.append_part("home", k, t, own);
    return own;
  }

  // Calls hear(messages) with the messages to a tile in a round, in portions of about as many
  // points as it may keep.
  template <class Hear>
  void hear_messages(std::uint32_t t, std::size_t round, const Closed_round& closed,
                     const Hear& hear) const
  {
    std::vector<Tile_message> messages;
    std::size_t waiting = 0;
    auto [posted, end] = std::equal_range(closed.posts.begin(), closed.posts.end(),
                                          Posted{0, t, 0, 0}, is_to_an_earlier_tile);
    for (; posted != end; ++posted) {
      messages.push_back({posted->from, t, {}});
      folder.append_message(*posted, round, messages.back().points);
      waiting += messages.back().points.size();
      if (waiting > limit) {
        hear(std::exchange(messages, {}));
        waiting = 0;
      }
    }
    hear(std::move(messages));
  }

  static std::vector<std::uint32_t> partners_of(std::uint32_t t, const Tile_pairs& pairs)
  {
    std::vector<std::uint32_t> partners;
    for (const auto& [a, b] : pairs)
      if (a == t || b == t)
        partners.push_back(a == t ? b : a);
    return partners;
  }
};

// The stages of a run in a folder (Tile_folder.h), and their tasks: first the ranges of the input
// are read, then their points are brought home, then there are rounds, and at last the results. An
// engine does the tasks of a stage by its threads, and closes it; or a caller does one by one.

class Tiles_in_files
{
public:
  enum Stage { SAMPLE, HOME, ROUND, PIECES, DONE };

  explicit Tiles_in_files(const std::filesystem::path& folder, std::size_t number_of_threads = 1)
    : m_executor(number_of_threads)
    , m_folder(folder / "state")
  {
  }

  // Begins, or continues from the state in the folder.
  void begin(const Tile_source_3& source, const Tiles_options& options)
  {
    m_progress = options.progress;
    find(source, options, m_executor.number_of_workers());
    if (m_stage == DONE) // it may have been killed before it cleaned
      clean();
    while (m_stage < ROUND)
      do_stage();
  }

  std::uint64_t exchange()
  {
    if (m_stage != ROUND)
      return 0;
    const std::uint64_t before = told();
    do_stage();
    return told() - before;
  }

  // The seed was drawn when the last round was closed.
  template <class Draw>
  std::vector<Tile_certificate> gather(const Draw&)
  {
    if (m_stage == PIECES)
      do_stage();
    return certificates();
  }

  // Continues with a round in which the tiles of each pair show each other why they differ.
  void show(const Tile_pairs& pairs)
  {
    m_folder.write(pairs, "show", m_round);
    find_stage();
  }

  // Removes the whole state.
  void forget() const { forget_folder(m_folder.place()); }

  template <class F>
  void together(const F& f) const
  {
    f();
  }

  // Begins, or finds out how far a run is. `at_once` tiles are in memory at the same time.
  void find(const Tile_source_3& source, const Tiles_options& options, std::size_t at_once)
  {
    m_source = &source;
    m_tiling.reset(); // it is from another call
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

  const Executor& executor() const { return m_executor; }
  const Tile_folder& folder() const { return m_folder; }
  std::uint64_t number_of_points() const { return m_input.points; }
  std::uint32_t number_of_tiles() const { return std::uint32_t(m_input.tiles); }
  Stage stage() const { return m_stage; }
  std::size_t rounds() const { return m_round; } // closed ones
  std::uint64_t told() const { return m_closed.told_before + m_closed.told; }

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

  bool is_all_done() const
  {
    for (std::size_t k = 0; k < number_of_tasks(); ++k)
      if (!is_done(k))
        return false;
    return true;
  }

  // Does task k with n threads. Any threads or processes may do several tasks at once.
  void do_task(std::size_t k, std::size_t n) const
  {
    if (is_done(k))
      return;
    const Rounding_to_nearest rounding;
    try {
      do_task_of_stage(k, n);
    } catch (const Tile_too_large& error) {
      if (m_limit >= m_input.most_points_kept)
        throw;
      throw Tile_files_error(m_folder.place().string() +
                             ": holds the state of a run whose tiles may " +
                             "be larger than memory and threads allow now: " + error.what() +
                             "; allow as much as then, or remove it");
    }
  }

  // Closes the stage, when all of its tasks are done and no process works on any.
  void close()
  {
    if (!is_all_done())
      throw Tile_files_error(m_folder.place().string() + ": a task of " + name() + " is not done");
    const Rounding_to_nearest rounding;
    if (m_stage == SAMPLE)
      m_folder.write(tasks().make_tiling(), "tiling");
    else if (m_stage == HOME) {
      if (m_input.fingerprint != fingerprint_of(*m_source))
        throw Surface_input_error("the input has changed while it was read");
      m_folder.write_mark("homes");
    } else if (m_stage == ROUND)
      close_round();
    else if (m_stage == PIECES &&
             is_certified(certificates(), std::size_t(m_input.tiles), m_input.points))
      m_folder.write_mark("certified"); // else the driver goes on, by show()
    find_stage();
    clean();
  }

  std::vector<Tile_certificate> certificates() const
  {
    std::vector<Tile_certificate> certificates;
    for (std::uint32_t t = 0; t < m_input.tiles; ++t)
      certificates.push_back(m_folder.read<Tile_certificate>("certificate", t));
    return certificates;
  }

  // Removes files that are read no more or were left by killed processes, when no task is at work.
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

private:
  void do_stage()
  {
    const std::size_t n = number_of_tasks();
    const Stage_progress progress(m_progress, name(), n);
    run_tasks(m_executor, n, [&](std::size_t k) {
      do_task(k, threads_of_task(k, n, m_executor.number_of_workers()));
      progress.tell_next();
    });
    close();
  }

  void do_task_of_stage(std::size_t k, std::size_t n) const
  {
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

  Tile_tasks tasks(std::size_t n = 1) const { return {m_folder, *m_source, m_input, m_limit, n}; }

  void begin_anew(const Tiles_options& options, std::size_t at_once)
  {
    for (const std::string& name : names_in(m_folder.place())) // the folder is removed as a whole
      if (name_when_finished(name).empty())
        refuse_file_of_others(m_folder.file(name));
    remove_forgotten(m_folder.place());
    m_input = {m_source->size(),
               fingerprint_of(*m_source),
               options.sample_share,
               most_points_read(options, at_once),
               m_limit,
               core::number_of_tiles(options, m_source->size(), at_once)};
    m_folder.set_run(draw_seed() | 1);
    m_folder.write(m_input, "input");
  }

  void go_on(const Tiles_options& options)
  {
    m_input = m_folder.read_input();
    const std::string place = m_folder.place().string();
    if (m_input.points != m_source->size() || m_input.fingerprint != fingerprint_of(*m_source))
      throw Tile_files_error(place + ": holds the state of a run on another input, of " +
                             std::to_string(m_input.points) +
                             " points: remove it, or name another folder");
    if (options.number_of_tiles != 0 &&
        core::number_of_tiles(options, m_input.points, 1) != m_input.tiles)
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
      m_tiling.emplace(m_folder.read<Tiling>("tiling"));
    m_round = 0;
    m_shown.clear();
    while (m_stage == ROUND && is_there("closed", m_round))
      ++m_round;
    m_closed = {};
    if (m_round > 0)
      m_closed = m_folder.read<Closed_round>("closed", m_round - 1);
    if (m_stage == ROUND && is_there("show", m_round))
      m_shown = m_folder.read<Tile_pairs>("show", m_round);
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
    closed.told_before = told();
    closed.last_rounds = m_closed.last_rounds;
    closed.last_rounds.resize(std::size_t(m_input.tiles));
    for (const std::uint32_t t : m_tasks) {
      closed.last_rounds[t] = std::uint32_t(m_round);
      if (std::filesystem::exists(m_folder.file("post", t, m_round)))
        for (const Posted& posted : m_folder.read<std::vector<Posted>>("post", t, m_round)) {
          closed.told += posted.number;
          closed.posts.push_back(posted);
        }
    }
    for (std::uint32_t t = 0; t < m_input.tiles && closed.told == 0; ++t)
      for (const char* kind : {"certificate", "piece"}) // from before the rounds went on
        std::filesystem::remove(m_folder.file(kind, t));
    std::stable_sort(closed.posts.begin(), closed.posts.end(), is_to_an_earlier_tile);
    closed.seed = draw_seed();
    m_folder.write(closed, "closed", m_round);
  }

  Thread_executor m_executor;
  Stage_progress::Function m_progress;
  Tile_folder m_folder;
  const Tile_source_3* m_source = nullptr;
  std::size_t m_limit = 0;
  Tiles_input m_input{};
  Stage m_stage = SAMPLE;
  std::optional<Tiling> m_tiling;
  std::size_t m_round = 0;
  Closed_round m_closed; // the last one
  Tile_pairs m_shown;
  std::vector<std::uint32_t> m_tasks; // tiles
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // DELAUNAY_FROM_SURFACE_3_SRC_TILES_TILES_STAGES_H
