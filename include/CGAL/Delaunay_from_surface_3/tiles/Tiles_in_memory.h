// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H

// Consecutive tiles in the memory of this process, which may be all or some, and their messages.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Lanes.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns how many threads work on task k of n, if several can insert points together: in the end
// there are fewer tasks than threads, and the threads share them.
inline std::size_t threads_of_task(std::size_t k, std::size_t n, std::size_t threads)
{
  const std::size_t last = n % threads, first = n - last; // the last tasks are shared
  const std::size_t share = k < first ? 1 : (threads + last - 1 - (k - first)) / last;
  return (std::min)(share, std::size_t(Lanes::most_workers));
}

// Calls task(0), …, task(n - 1), which the executor's workers take one after the other. If a task
// throws, the first exception is thrown again when all tasks that have begun have ended.
template <class Function>
void run_tasks(const Executor& executor, std::size_t n, const Function& task)
{
  struct Worker final : Task
  {
    const Function& task;
    const std::size_t n;
    mutable std::atomic<std::size_t> next{0};
    mutable std::mutex mutex;
    mutable std::exception_ptr error;

    Worker(const Function& f, std::size_t number)
      : task(f)
      , n(number)
    {
    }
    void operator()(std::size_t) const override
    {
      try {
        for (std::size_t k = next++; k < n; k = next++)
          task(k);
      } catch (...) {
        next = n;
        const std::lock_guard<std::mutex> lock(mutex);
        if (!error)
          error = std::current_exception();
      }
    }
  };
  const Worker worker(task, n);
  executor.run((std::min)(n, executor.number_of_workers()), worker);
  if (worker.error)
    std::rethrow_exception(worker.error);
}

// The driver: tiles tell each other until no tile has anything to tell, and then compare their
// certificates. If two tiles differ, they show each other why, and all go on.
//
// An engine has four verbs: exchange() lets every tile hear what it was told, and tell, and returns
// how many points were told; gather(seed) returns the certificates of all tiles; show(pairs) lets
// each tile of a pair tell the other what is around the cells that both see
// (Delaunay_tile::witnesses()); give(sink) hands out the tiles, unless they go into files. If several processes run the
// driver, all of them call each verb, and it returns the same on all, or throws.

// Writes the certificates' part of the report, and whether they hold.
inline void report_certificates(const std::vector<Tile_certificate>& certificates,
                                Tiles_report& report)
{
  report.kept = report.most_kept = report.cells = report.hash = 0;
  for (const Tile_certificate& c : certificates) {
    report.kept += c.points_kept;
    report.most_kept = (std::max)(report.most_kept, c.points_kept);
    report.cells += c.owned_cells;
    report.hash += c.hash;
  }
  report.is_certified = is_certified(certificates, report.tiles, report.points);
}

// Returns a seed. For many processes there is another overload, in which one draws it for all.
template <class Engine, class Draw>
std::uint64_t draw_seed(const Engine&, const Draw& draw)
{
  return draw();
}

constexpr int most_repairs = 64; // tiles of a thousand points and more needed no repair

// Runs an engine that has begun. `draw` draws a seed when no cell changes any more.
template <class Engine, class Draw>
Tiles_report run_tiles(Engine& engine, const Draw& draw)
{
  Tiles_report report;
  report.points = engine.number_of_points();
  report.tiles = engine.number_of_tiles();
  for (int repairs = 0;; ++repairs) {
    while (engine.exchange() > 0)
      ;
    const auto certificates = engine.gather(draw_seed(engine, draw));
    report.rounds = engine.rounds();
    report.told = engine.told();
    Tile_pairs differing;
    engine.together([&] { // it may throw on one of many processes
      report_certificates(certificates, report);
      differing = tiles_that_differ(certificates);
    });
    if (report.is_certified || differing.empty() || repairs == most_repairs)
      return report;
    engine.show(differing);
  }
}

constexpr const char* tiles_do_not_fit =
    "the tiles do not fit together: the certificate does not hold";

// Begins; if the input is refused, forgets all of it, because the next one is another.
template <class Engine>
void begin_or_forget(Engine& engine, const Tile_source_3& source, const Tiles_options& options)
{
  try {
    engine.begin(source, options);
  } catch (const Surface_input_error&) {
    engine.forget();
    throw;
  }
}

// Runs the engine, again with more tiles whenever one becomes too large, and returns finish(report)
// if the certificate holds; otherwise it throws.
template <class Engine, class Draw, class Finish>
Tiles_report run_until_certified(Engine& engine, const Tile_source_3& source, Tiles_options options,
                                 const Draw& draw, const Finish& finish)
{
  for (;;) {
    try {
      begin_or_forget(engine, source, options);
      const Tiles_report report = run_tiles(engine, draw);
      if (!report.is_certified)
        throw std::runtime_error(tiles_do_not_fit);
      return finish(report);
    } catch (const Tile_too_large& error) {
      if (!ask_for_more_tiles(options, error, engine.number_of_points(), engine.number_of_tiles()))
        throw;
      engine.forget();
    }
  }
}

// Tells Tiles_options::progress how much of a stage is done, by one thread at a time; throws
// Tiles_stopped if progress returns false. Keeps a reference.
class Stage_progress
{
public:
  using Function = std::function<bool(const char*, std::size_t, std::size_t)>;

  Stage_progress(const Function& progress, std::string what, std::size_t all)
    : m_progress(progress)
    , m_what(std::move(what))
    , m_all(all)
  {
    tell();
  }

  void tell_next() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_done;
    tell();
  }

private:
  void tell() const
  {
    if (m_progress && !m_progress(m_what.c_str(), m_done, m_all))
      throw Tiles_stopped();
  }

  const Function& m_progress;
  const std::string m_what;
  const std::size_t m_all;
  mutable std::size_t m_done = 0;
  mutable std::mutex m_mutex;
};

class Tiles_in_memory
{
public:
  explicit Tiles_in_memory(std::size_t number_of_threads)
    : m_executor(number_of_threads)
  {
  }

  // Makes tiles first, first + 1, … of their own points. Keeps a reference. Any thread calls
  // done(k) when tile first + k is made.
  template <class Done>
  void begin(const Tiling& tiling, std::uint32_t first, std::vector<std::vector<Tile_point>> own,
             std::size_t limit, const Done& done)
  {
    m_tiling = &tiling;
    m_first = first;
    m_tiles.clear();
    m_tiles.resize(own.size());
    m_inboxes.assign(own.size(), {});
    for (std::size_t k = 0; k < own.size(); ++k)
      m_inboxes[k].push_back({number(k), number(k), tiling.sample});
    for_each([&](std::size_t k) {
      const Thread_executor executor(
          threads_of_task(k, own.size(), m_executor.number_of_workers()));
      m_tiles[k] = std::make_unique<Delaunay_tile>(tiling, number(k), std::move(own[k]),
                                                   Tile_state(), limit, executor);
      done(k);
    });
  }

  void clear()
  {
    m_tiles.clear();
    m_inboxes.clear();
  }

  const std::vector<std::unique_ptr<Delaunay_tile>>& tiles() const { return m_tiles; }
  bool has(std::uint32_t t) const { return t >= m_first && t - m_first < m_tiles.size(); }

  // Lets every tile hear what it was told, and tell. Returns the messages by their senders.
  template <class Done>
  std::vector<std::vector<Tile_message>> exchange(const Done& done)
  {
    std::vector<std::vector<Tile_message>> messages(m_tiles.size());
    for_each([&](std::size_t k) {
      messages[k] = m_tiles[k]->absorb(
          news_of(std::move(m_inboxes[k]), *m_tiling, number(k), m_tiles[k]->known()));
      done(k);
    });
    m_inboxes.assign(m_tiles.size(), {});
    return messages;
  }

  // Stores a message to one of the tiles, which hears it in the next exchange.
  void deliver(Tile_message message)
  {
    m_inboxes[message.to - m_first].push_back(std::move(message));
  }

  template <class Done>
  std::vector<Tile_certificate> certificates(std::uint64_t seed, const Done& done) const
  {
    std::vector<Tile_certificate> certificates(m_tiles.size());
    for_each([&](std::size_t k) {
      certificates[k] = certificate_of(*m_tiles[k], seed);
      done(k);
    });
    return certificates;
  }

  // Returns the messages by which these tiles show why they differ from others.
  std::vector<Tile_message> witnesses(const Tile_pairs& pairs) const
  {
    std::vector<Tile_message> messages;
    for (const auto& [a, b] : pairs)
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
        if (has(from))
          for (Tile_message& message : m_tiles[from - m_first]->witnesses({to}))
            messages.push_back(std::move(message));
    return messages;
  }

  // Returns the result of tile t.
  Delaunay_3_tile tile(std::uint32_t t) const { return piece_of(*m_tiles[t - m_first]); }

private:
  std::uint32_t number(std::size_t k) const { return m_first + std::uint32_t(k); }

  template <class Function>
  void for_each(const Function& f) const
  {
    run_tasks(m_executor, m_tiles.size(), [&](std::size_t k) {
      const Rounding_to_nearest rounding;
      f(k);
    });
  }

  Thread_executor m_executor;
  const Tiling* m_tiling = nullptr;
  std::uint32_t m_first = 0;
  std::vector<std::unique_ptr<Delaunay_tile>> m_tiles;
  std::vector<std::vector<Tile_message>> m_inboxes; // by tile
};

// The engine Tiles_here_3, for tiles that are all in this process. Others are compared with it.

class Tiles_here
{
public:
  explicit Tiles_here(std::size_t number_of_threads = 1)
    : m_tiles(number_of_threads)
  {
  }
  Tiles_here(const Tiles_here&) = delete; // tiles refer to m_tiling

  // Makes the tiles, each of its own points.
  void begin(const Tile_source_3& source, const Tiles_options& options)
  {
    begin(source, options, [](std::vector<std::vector<Tile_point>>&) {});
  }

  // Does the same, but home(own) may lose points on their way home, as tests do it.
  template <class Home>
  void begin(const Tile_source_3& source, const Tiles_options& options, const Home& home)
  {
    const Rounding_to_nearest rounding;
    const std::uint64_t n = source.size();
    const std::uint32_t tiles = internal::number_of_tiles(options, n, 1);
    const Sampling sampling(n, tiles, options.sample_share);
    m_tiles.clear();
    m_rounds = 0;
    m_told = 0;
    m_progress = options.progress;
    std::vector<std::vector<Tile_point>> own(tiles);
    const std::vector<double> coordinates = read_range(source, 0, n);
    m_tiling.emplace(tiling_of({summary_of(coordinates, 0, sampling)}, n, tiles, sampling));
    for (std::size_t i = 0; i < n; ++i)
      own[m_tiling->tree.owner(&coordinates[3 * i])].push_back(tile_point(i, &coordinates[3 * i]));
    home(own);
    const Stage_progress progress(m_progress, "own points", tiles);
    m_tiles.begin(*m_tiling, 0, std::move(own), most_points_kept(options, 1),
                  [&](std::size_t) { progress.tell_next(); });
  }

  std::uint64_t number_of_points() const { return m_tiling->number_of_points; }
  std::uint32_t number_of_tiles() const { return m_tiling->tree.number_of_tiles(); }
  std::size_t rounds() const { return m_rounds; }
  std::uint64_t told() const { return m_told; }

  // Lets every tile hear what it was told, and tell. Returns how many points were told.
  std::uint64_t exchange()
  {
    return exchange([](Tile_message&) {});
  }

  // Does the same, but post(message) may lose or change messages, as tests do it.
  template <class Post>
  std::uint64_t exchange(const Post& post)
  {
    std::uint64_t told = 0;
    const Stage_progress progress(m_progress, "round " + std::to_string(m_rounds),
                                  number_of_tiles());
    for (auto& from : m_tiles.exchange([&](std::size_t) { progress.tell_next(); }))
      for (Tile_message& message : from) {
        told += message.points.size();
        post(message);
        m_tiles.deliver(std::move(message));
      }
    ++m_rounds;
    m_told += told;
    return told;
  }

  std::vector<Tile_certificate> gather(std::uint64_t seed) const
  {
    const Stage_progress progress(m_progress, "certificate", number_of_tiles());
    return m_tiles.certificates(seed, [&](std::size_t) { progress.tell_next(); });
  }

  void show(const Tile_pairs& pairs)
  {
    for (Tile_message& message : m_tiles.witnesses(pairs))
      m_tiles.deliver(std::move(message));
  }

  // tile(t) returns the result of tile t; give(sink) calls sink(tile) for all tiles.
  Delaunay_3_tile tile(std::uint32_t t) const { return m_tiles.tile(t); }
  template <class Sink>
  void give(Sink& sink) const
  {
    for (std::uint32_t t = 0; t < number_of_tiles(); ++t)
      sink(tile(t));
  }

  void forget() { m_tiles.clear(); }

  template <class F>
  void together(const F& f) const
  {
    f();
  }

  const std::vector<std::unique_ptr<Delaunay_tile>>& tiles() const { return m_tiles.tiles(); }

private:
  std::optional<Tiling> m_tiling;
  std::size_t m_rounds = 0;
  std::uint64_t m_told = 0;
  Tiles_in_memory m_tiles;
  Stage_progress::Function m_progress;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H
