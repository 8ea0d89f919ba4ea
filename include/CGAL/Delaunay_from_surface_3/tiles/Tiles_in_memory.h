// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H

// The driver of all engines, and the engine whose tiles are in memory: all in one process, or side
// by side in several.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Marks.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns how many threads work on task k of n, if several can insert points together: in the end
// there are fewer tasks than threads, and the threads share them.
inline std::size_t threads_of_task(std::size_t k, std::size_t n, std::size_t threads)
{
  const std::size_t last = n % threads, first = n - last; // the last tasks are shared
  const std::size_t share = k < first ? 1 : (threads + last - 1 - (k - first)) / last;
  return (std::min)(share, std::size_t(Marks::most_workers));
}

// Calls task(0), …, task(n - 1), which the executor's workers take one after the other. If a task
// throws, the first exception is thrown again when all tasks that have begun have ended.
template <class Function>
void run_tasks(const Executor& executor, std::size_t n, const Function& task)
{
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  call_each(executor, (std::min)(n, executor.number_of_workers()), [&](std::size_t) {
    try {
      for (std::size_t k = next++; k < n; k = next++)
        task(k);
    } catch (...) {
      next = n;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!error)
        error = std::current_exception();
    }
  });
  if (error)
    std::rethrow_exception(error);
}

// The driver: tiles tell each other until no tile has anything to tell, and then compare their
// certificates. If two tiles differ, they show each other why, and all go on.
//
// An engine has four verbs: exchange() lets every tile hear what it was told, and tell, and returns
// how many points were told; gather(draw) returns the certificates of all tiles, for which draw()
// draws a seed when no cell changes any more; show(pairs) lets each tile of a pair tell the other
// what is around the cells that both see (Delaunay_tile::witnesses()); give(sink) hands out the
// tiles, unless they go into files. If several processes run the driver, all of them call each
// verb, and it returns the same on all, or throws.

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

inline std::uint64_t draw_seed()
{
  std::random_device random;
  return std::uint64_t(random()) << 32 | random();
}

constexpr int most_repairs = 64; // tiles of a thousand points and more needed no repair

// Runs an engine that has begun.
template <class Engine, class Draw>
Tiles_report run_tiles(Engine& engine, const Draw& draw)
{
  Tiles_report report;
  report.points = engine.number_of_points();
  report.tiles = engine.number_of_tiles();
  for (int repairs = 0;; ++repairs) {
    while (engine.exchange() > 0)
      ;
    const auto certificates = engine.gather(draw);
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
template <class Engine, class Finish, class Draw = std::uint64_t (*)()>
Tiles_report run_until_certified(Engine& engine, const Tile_source_3& source, Tiles_options options,
                                 const Finish& finish, const Draw& draw = draw_seed)
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
// Tiles_stopped if progress returns false. After that, or an exception of its own, progress is not
// called again. Keeps a reference.
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
    if (!m_progress || std::exchange(m_is_over, true))
      return;
    if (!m_progress(m_what.c_str(), m_done, m_all))
      throw Tiles_stopped();
    m_is_over = false;
  }

  const Function& m_progress;
  const std::string m_what;
  const std::size_t m_all;
  mutable std::size_t m_done = 0;
  mutable bool m_is_over = false;
  mutable std::mutex m_mutex;
};

// The processes that share the tiles, if there is only one; otherwise they are Ranks_of_mpi. All
// processes call the same functions in the same order. together(f) calls f() on each process; if it
// throws on some, all throw. all_gather(mine) returns the items of all processes; exchange(to)
// sends each process its items, and returns those that this one was sent. Both return them by the
// process that they come from.
struct One_process
{
  int rank() const { return 0; }
  int size() const { return 1; }

  template <class F>
  void together(const F& f) const
  {
    f();
  }
  std::uint64_t sum(std::uint64_t number) const { return number; }
  std::uint64_t of_first(std::uint64_t number) const { return number; }

  template <class T>
  std::vector<T> all_gather(std::vector<T> mine) const
  {
    return mine;
  }
  template <class T>
  std::vector<T> exchange(std::vector<std::vector<T>> to) const
  {
    return std::move(to.front());
  }
};

// Describes what a process will read, and the options on which the driver's decisions depend.
struct Input_of_rank
{
  std::uint64_t points, first, last; // it reads the points first, …, last - 1
  std::uint64_t tiles;
  std::array<std::uint64_t, 4> options;
};

// Throws on all ranks unless all see the same number of points and have the same options, and each
// point is read by one of them. Whether they see the same points is unknown, since no two ranks
// read the same point.
template <class Ranks>
Input_of_rank agree_on_input(Ranks& ranks, const Tile_source_3& source,
                             const Tiles_options& options)
{
  const auto rank = std::size_t(ranks.rank()), size = std::size_t(ranks.size());
  std::vector<Input_of_rank> mine;
  ranks.together([&] {
    const std::uint64_t n = source.size();
    mine.push_back({n,
                    source.first_of_part(rank, size),
                    source.first_of_part(rank + 1, size),
                    number_of_tiles(options, n, 1),
                    {options.sample_share, options.least_points, options.memory,
                     std::uint64_t(options.starts_again)}});
  });
  const std::vector<Input_of_rank> all = ranks.all_gather(mine);
  ranks.together([&] {
    const Input_of_rank &input = mine.front(), &theirs = all.front();
    if (input.points != theirs.points)
      throw std::runtime_error("sees " + std::to_string(input.points) + " points, and rank 0 " +
                               std::to_string(theirs.points));
    if (input.tiles != theirs.tiles || input.options != theirs.options)
      throw std::runtime_error("was given other options than rank 0");
    const std::uint64_t before = rank == 0 ? 0 : all[rank - 1].last;
    if (input.first != before || input.last < input.first ||
        (rank + 1 == size && input.last != input.points))
      throw Surface_input_error("reads the points from " + std::to_string(input.first) +
                                " to before " + std::to_string(input.last) + " of " +
                                std::to_string(input.points) + ", where it should begin with " +
                                std::to_string(before) + ": the parts do not join");
  });
  return mine.front();
}

// Each process has consecutive tiles in memory, which lie side by side, and reads one range of the
// input. All run the same driver, whose decisions depend only on what all know. A process that
// throws does so between two exchanges, inside of together(), which ends the run on all.
template <class Ranks>
class Tiles_in_memory
{
public:
  template <class... Arguments>
  explicit Tiles_in_memory(std::size_t number_of_threads = 1, const Arguments&... of_ranks)
    : m_ranks(of_ranks...)
    , m_executor(number_of_threads)
  {
  }
  Tiles_in_memory(const Tiles_in_memory&) = delete; // tiles refer to m_tiling

  // Calls f() on each rank; if it throws on one, all throw.
  template <class F>
  void together(const F& f) const
  {
    m_ranks.together(f);
  }

  // Makes the tiles, each of its own points.
  void begin(const Tile_source_3& source, const Tiles_options& options)
  {
    make_tiles(bring_home(source, options), most_points_kept(options, 1));
  }

  // The two steps of begin(); the first returns the points of each tile of this rank.
  std::vector<std::vector<Tile_point>> bring_home(const Tile_source_3& source,
                                                  const Tiles_options& options)
  {
    forget();
    m_rounds = 0;
    m_told = 0;
    together([&] { m_progress = options.progress; });
    const Input_of_rank input = agree_on_input(m_ranks, source, options);
    const Sampling sampling(input.points, std::uint32_t(input.tiles), options.sample_share);
    std::vector<double> coordinates;
    std::vector<Range_summary> summary;
    together([&] {
      const Rounding_to_nearest rounding;
      const Stage_progress progress(m_progress, "reading", 1);
      coordinates = read_range(source, input.first, input.last);
      summary.push_back(summary_of(coordinates, input.first, sampling));
      progress.tell_next();
    });
    summary = m_ranks.all_gather(std::move(summary));
    std::vector<std::vector<Tile_point>> to, own;
    together([&] {
      const Rounding_to_nearest rounding;
      m_tiling.emplace(
          tiling_of(summary, input.points, std::uint32_t(input.tiles), sampling)); // same on all
      to.resize(std::size_t(m_ranks.size()));
      for (std::size_t i = 0; i < coordinates.size() / 3; ++i) {
        const Tile_point point = tile_point(input.first + i, &coordinates[3 * i]);
        to[rank_of(owner(point))].push_back(point);
      }
      std::vector<double>().swap(coordinates);
    });
    std::vector<Tile_point> points = m_ranks.exchange(std::move(to)); // by id
    together([&] {
      own.resize(end_of_tiles(m_ranks.rank()) - first_tile());
      for (const Tile_point& point : points)
        own[owner(point) - first_tile()].push_back(point);
    });
    return own;
  }
  void make_tiles(std::vector<std::vector<Tile_point>> own, std::size_t limit)
  {
    together([&] {
      const std::size_t n = own.size();
      m_tiles.resize(n);
      m_inboxes.resize(n);
      for_each_tile("own points", [&](std::size_t k) {
        m_inboxes[k].push_back({number(k), number(k), m_tiling->sample});
        const Thread_executor executor(threads_of_task(k, n, m_executor.number_of_workers()));
        m_tiles[k] = std::make_unique<Delaunay_tile>(*m_tiling, number(k), std::move(own[k]),
                                                     Tile_state(), true, limit, executor);
      });
    });
  }

  std::uint64_t number_of_points() const { return m_tiling->number_of_points; }
  std::uint32_t number_of_tiles() const { return m_tiling->tree.number_of_tiles(); }
  std::size_t rounds() const { return m_rounds; }
  std::uint64_t told() const { return m_told; }

  std::uint64_t exchange()
  {
    std::vector<Tile_message> messages = tell();
    std::uint64_t told = 0;
    for (const Tile_message& message : messages)
      told += message.points.size();
    deliver(std::move(messages));
    told = m_ranks.sum(told);
    m_told += told;
    return told;
  }

  // The two steps of exchange(): lets the tiles of this rank hear what they were told, and returns
  // what they tell; and brings messages to the tiles of all ranks.
  std::vector<Tile_message> tell()
  {
    std::vector<Tile_message> all;
    together([&] {
      std::vector<std::vector<Tile_message>> messages(m_tiles.size());
      for_each_tile("round " + std::to_string(m_rounds), [&](std::size_t k) {
        Tile_news news =
            news_of(std::exchange(m_inboxes[k], {}), *m_tiling, number(k), m_tiles[k]->known());
        m_tiles[k]->offer(std::move(news.offers));
        messages[k] = m_tiles[k]->tell_and_answer(news.questions);
      });
      for (std::vector<Tile_message>& of_tile : messages)
        std::move(of_tile.begin(), of_tile.end(), std::back_inserter(all));
    });
    ++m_rounds;
    return all;
  }
  void deliver(std::vector<Tile_message> messages)
  {
    std::vector<std::vector<Tile_message>> to;
    together([&] {
      to.resize(std::size_t(m_ranks.size()));
      for (Tile_message& message : messages)
        to[rank_of(message.to)].push_back(std::move(message));
    });
    messages = m_ranks.exchange(std::move(to));
    together([&] {
      for (Tile_message& message : messages)
        m_inboxes[message.to - first_tile()].push_back(std::move(message));
    });
  }

  // The first rank draws the seed for all.
  template <class Draw>
  std::vector<Tile_certificate> gather(const Draw& draw)
  {
    std::uint64_t seed = 0;
    together([&] { seed = m_ranks.rank() == 0 ? draw() : 0; });
    seed = m_ranks.of_first(seed);
    std::vector<Tile_certificate> certificates;
    together([&] {
      certificates.resize(m_tiles.size());
      for_each_tile("certificate",
                    [&](std::size_t k) { certificates[k] = certificate_of(*m_tiles[k], seed); });
    });
    return m_ranks.all_gather(std::move(certificates));
  }

  void show(const Tile_pairs& pairs)
  {
    std::vector<Tile_message> messages;
    together([&] {
      for (const auto& [a, b] : pairs)
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
          if (from - first_tile() < m_tiles.size()) // wraps around if it is less
            for (Tile_message& message : m_tiles[from - first_tile()]->witnesses({to}))
              messages.push_back(std::move(message));
    });
    deliver(std::move(messages));
  }

  // Returns the result of tile t of this rank; give(sink) calls sink(tile) for each.
  Delaunay_3_tile tile(std::uint32_t t) const { return piece_of(*m_tiles[t - first_tile()]); }
  template <class Sink>
  void give(Sink& sink) const
  {
    together([&] {
      const Stage_progress progress(m_progress, "writing", m_tiles.size());
      for (std::size_t k = 0; k < m_tiles.size(); ++k) {
        sink(tile(number(k)));
        progress.tell_next();
      }
    });
  }

  void forget()
  {
    m_tiles.clear();
    m_inboxes.clear();
  }

  const std::vector<std::unique_ptr<Delaunay_tile>>& tiles() const { return m_tiles; }

protected:
  const Ranks& ranks() const { return m_ranks; }

private:
  // A rank has the tiles from the end of those of the rank before, which may be none.
  std::uint32_t end_of_tiles(int rank) const
  {
    return std::uint32_t(std::uint64_t(number_of_tiles()) * std::uint64_t(rank + 1) /
                         std::uint64_t(m_ranks.size()));
  }
  std::uint32_t first_tile() const { return end_of_tiles(m_ranks.rank() - 1); }
  std::uint32_t number(std::size_t k) const { return first_tile() + std::uint32_t(k); }
  std::size_t rank_of(std::uint32_t tile) const
  {
    return std::size_t(((tile + std::uint64_t(1)) * std::uint64_t(m_ranks.size()) - 1) /
                       number_of_tiles());
  }
  std::uint32_t owner(const Tile_point& point) const
  {
    return m_tiling->tree.owner(point.coordinates);
  }

  // Calls f(k) for tile first_tile() + k, …, by all threads, and reports progress.
  template <class Function>
  void for_each_tile(const std::string& stage, const Function& f) const
  {
    const Stage_progress progress(m_progress, stage, m_tiles.size());
    run_tasks(m_executor, m_tiles.size(), [&](std::size_t k) {
      f(k);
      progress.tell_next();
    });
  }

  Ranks m_ranks;
  Thread_executor m_executor;
  std::optional<Tiling> m_tiling;
  std::size_t m_rounds = 0;
  std::uint64_t m_told = 0;
  std::vector<std::unique_ptr<Delaunay_tile>> m_tiles;
  std::vector<std::vector<Tile_message>> m_inboxes; // by tile
  Stage_progress::Function m_progress;
};

// The engine Tiles_here_3, for tiles that are all in this process. Others are compared with it.
using Tiles_here = Tiles_in_memory<One_process>;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H
