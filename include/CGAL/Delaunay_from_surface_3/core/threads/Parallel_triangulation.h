// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_PARALLEL_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_PARALLEL_TRIANGULATION_H

// Several workers insert a chunk of a round of Choi 2002, Fig. 1, lines 2b and 2c. Every start is a
// vertex of an earlier round, or leads to one, so that any worker can insert any point of the chunk
// at any time. No worker waits for another: a point that clashes is put off, and tried twice more
// when nothing else is left to its worker; the caller inserts the rest when all workers have ended.
//
// The result is right even if workers run one after the other: the first one then takes all points.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Insertion_worker.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Deals out the numbers first, …, last - 1 in one share for each worker. If the order follows the
// surface, each share is a patch of it, so workers meet only at the seams. A worker takes batches
// from the front of its share; when that is empty, it takes the second half of the largest one left.
class Shares
{
public:
  using Range = std::pair<std::size_t, std::size_t>;

  Shares(std::size_t first, std::size_t last, std::size_t number)
    : m_first(first)
    , m_shares(number)
  {
    const std::size_t n = last - first;
    for (std::size_t t = 0; t < number; ++t)
      m_shares[t].ends = packed({n / number * t + (std::min)(t, n % number),
                                 n / number * (t + 1) + (std::min)(t + 1, n % number)});
  }

  // Returns the next numbers of worker t, `batch` or fewer; the range is empty if all are taken.
  Range take(std::size_t t, std::size_t batch)
  {
    for (;;) {
      std::uint64_t ends = m_shares[t].ends.load();
      Range range = unpacked(ends);
      while (range.first < range.second) {
        const std::size_t next = (std::min)(range.first + batch, range.second);
        if (m_shares[t].ends.compare_exchange_weak(ends, packed({next, range.second})))
          return {m_first + range.first, m_first + next};
        range = unpacked(ends);
      }
      if (!steal_half_of_largest(t))
        return {m_first, m_first};
    }
  }

private:
  // Each share has a cache line of its own.
  struct alignas(64) Share
  {
    std::atomic<std::uint64_t> ends{0};
  };

  static std::uint64_t packed(const Range& range)
  {
    return std::uint64_t(range.first) << 32 | std::uint64_t(range.second);
  }
  static Range unpacked(std::uint64_t ends)
  {
    return {std::size_t(ends >> 32), std::size_t(ends & 0xffffffff)};
  }

  // Returns false if nothing is left. Share t is empty; only its owner fills it.
  bool steal_half_of_largest(std::size_t t)
  {
    for (;;) {
      std::size_t largest = t, most = 0;
      std::uint64_t ends = 0;
      for (std::size_t s = 0; s < m_shares.size(); ++s) {
        const std::uint64_t those = m_shares[s].ends.load();
        const Range range = unpacked(those);
        if (range.first < range.second && range.second - range.first > most)
          largest = s, most = range.second - range.first, ends = those;
      }
      if (most == 0)
        return false;
      const Range range = unpacked(ends);
      const std::size_t middle = range.first + (range.second - range.first) / 2;
      if (m_shares[largest].ends.compare_exchange_strong(ends, packed({range.first, middle}))) {
        m_shares[t].ends.store(packed({middle, range.second}));
        return true;
      }
    }
  }

  std::size_t m_first;
  std::vector<Share> m_shares;
};

// These rules give the number of workers of a chunk, and of the points that they take at a time.
struct Parallel_rules
{
  std::size_t first_points = 500;      // until so many are inserted, one worker works
  std::size_t points_per_worker = 200; // at least, in a chunk
  std::size_t batch = 64;
};

// A Worker inserts points beside others; tests use other workers.
template <class Vertex, class Worker = Insertion_worker<Vertex>>
class Parallel_triangulation
{
  using Complex = Compact_complex<Vertex>;

public:
  // Triangulates the vertices of `complex`, which starts before the first round. Keeps references.
  Parallel_triangulation(Complex& complex, const Executor& executor,
                         const Parallel_rules& rules = Parallel_rules())
    : m_shared(complex, unsigned(executor.number_of_workers()))
    , m_executor(executor)
    , m_rules(rules)
  {
  }

  // Returns how many points the next chunk should have: enough for its workers to be worth their
  // start, but, after the first batch, no more than are inserted already, because the caller looks
  // at the costs between chunks.
  std::size_t size_of_chunk(std::size_t inserted) const
  {
    if (inserted < m_rules.first_points) // one worker works
      return (std::min)(m_rules.batch, m_rules.first_points - inserted);
    return (std::max)({m_rules.batch, (std::min)(inserted, 32 * m_rules.batch), inserted / 4});
  }

  // Inserts the points first, …, last - 1. vertex_of[i] becomes the vertex of point i. Each worker
  // has a copy of `hints`. Whenever the caller's thread takes a batch, it calls go_further(i),
  // where i is the farthest point at which it has begun a batch. Returns false if the answer was
  // no.
  template <class Hints, class GoFurther>
  bool insert_chunk(std::size_t first, std::size_t last, std::vector<Id>& vertex_of,
                    const Hints& hints, const GoFurther& go_further)
  {
    m_shared.begin();
    note_cells(); // among which Starting_cells may look for a living one
    const std::size_t number = workers_of_chunk(first, last - first);
    Chunk<Hints, GoFurther> chunk(first, last, number, vertex_of, hints, go_further);
    for (bool is_first = true; is_first || chunk.is_full; is_first = false) {
      if (chunk.is_full.exchange(false))
        m_shared.grow();
      call_each(m_executor, number, [&](std::size_t t) { work(chunk, t); });
      if (chunk.error)
        std::rethrow_exception(chunk.error);
      if (chunk.is_stopped)
        return false;
    }
    return insert_put_off(chunk);
  }

  // Updates Compact_complex::cells_end(). To be called between chunks.
  void note_cells() { m_shared.note_cells(); }

  // To be called when all points are inserted. Gives back the memory that only threads need.
  void finish()
  {
    m_shared.finish();
    m_counts = counts();
    m_workers.clear();
  }

  Insertion_counts counts() const
  {
    Insertion_counts sum = m_counts;
    for (const auto& worker : m_workers)
      sum += worker->counts();
    return sum;
  }
  std::size_t number_of_threads() const { return m_executor.number_of_workers(); }

private:
  // Holds the data that the workers of a chunk have in common, and the data of each worker.
  template <class Hints, class GoFurther>
  struct Chunk
  {
    Chunk(std::size_t first, std::size_t last, std::size_t number, std::vector<Id>& vertices,
          const Hints& h, const GoFurther& go)
      : shares(first, last, number)
      , own(number, Own{h, {}, 0})
      , vertex_of(vertices)
      , go_further(go)
    {
    }

    struct alignas(64) Own
    {
      Hints hints;
      std::vector<std::size_t> put_off;
      std::size_t clashes;
    };

    Shares shares;
    std::vector<Own> own;
    std::vector<Id>& vertex_of;
    const GoFurther& go_further;
    std::size_t farthest = 0; // the farthest point at which the caller's thread began a batch
    std::atomic<bool> is_stopped{false}, is_full{false}, has_error{false};
    std::exception_ptr error;
  };

  std::size_t workers_of_chunk(std::size_t inserted, std::size_t points)
  {
    std::size_t number = m_executor.number_of_workers();
    number = (std::min)(number, points / m_rules.points_per_worker);
    number = inserted < m_rules.first_points || number == 0 ? 1 : number;
    while (m_workers.size() < number)
      m_workers.push_back(std::make_unique<Worker>(m_shared, unsigned(m_workers.size())));
    return number;
  }

  template <class Chunk>
  void work(Chunk& chunk, std::size_t t)
  {
    try {
      auto& own = chunk.own[t];
      while (!chunk.is_stopped && !chunk.is_full) {
        const Shares::Range batch = chunk.shares.take(t, m_rules.batch);
        if (batch.first == batch.second || !may_go_further(chunk, t, batch.first))
          break;
        const std::size_t before = own.clashes;
        for (std::size_t i = batch.first; i < batch.second; ++i)
          insert_or_put_off(chunk, t, i);
        // If more than half of the points clash, there are too many workers: those with odd numbers
        // stop, and the first one stays.
        if (t % 2 == 1 && 2 * (own.clashes - before) > batch.second - batch.first)
          break;
      }
      for (unsigned again = 0; again < 2; ++again) { // others have gone on by now
        const std::vector<std::size_t> put_off = std::exchange(own.put_off, {});
        for (std::size_t k = 0; k < put_off.size(); ++k)
          if (k % m_rules.batch != 0 || may_go_further(chunk, t, put_off[k]))
            insert_or_put_off(chunk, t, put_off[k]);
      }
    } catch (...) {
      if (!chunk.has_error.exchange(true))
        chunk.error = std::current_exception();
      chunk.is_stopped = true;
    }
  }

  // The first worker is the caller's thread. It tells how far it has come, and never less than
  // before, although the batches that it takes from others may lie before its own. A no is final.
  template <class Chunk>
  bool may_go_further(Chunk& chunk, std::size_t t, std::size_t i)
  {
    if (t == 0 && !chunk.is_stopped) {
      chunk.farthest = (std::max)(chunk.farthest, i);
      if (!chunk.go_further(chunk.farthest))
        chunk.is_stopped = true;
    }
    return !chunk.is_stopped;
  }

  template <class Chunk>
  void insert_or_put_off(Chunk& chunk, std::size_t t, std::size_t i)
  {
    if (!insert_point(chunk, t, i, most_cells_of_walk))
      chunk.own[t].put_off.push_back(i);
  }

  // Returns false if the point is still to be inserted.
  template <class Chunk>
  bool insert_point(Chunk& chunk, std::size_t t, std::size_t i, std::size_t most_cells)
  {
    auto& own = chunk.own[t];
    if (chunk.is_full || chunk.is_stopped)
      return false;
    Id vertex = Complex::vertex_of_point(i);
    if (chunk.vertex_of[i] != 0) // one of the first four
      return true;
    switch (m_workers[t]->insert(vertex, own.hints.start(i), vertex, most_cells)) {
    case Insertion_try::CLASH:
      ++own.clashes;
      return false;
    case Insertion_try::TOO_FAR:
      own.hints.after_update(i, vertex); // the next walk goes on from there
      return false;
    case Insertion_try::NO_CELLS:
      chunk.is_full = true;
      return false;
    default:
      store_relaxed(chunk.vertex_of[i], vertex);
      own.hints.after_update(i, vertex);
      return true;
    }
  }

  // Inserts the points that were put off, by the caller alone. Returns false if it is stopped.
  template <class Chunk>
  bool insert_put_off(Chunk& chunk)
  {
    const std::size_t any = (std::numeric_limits<std::size_t>::max)();
    for (auto& own : chunk.own) {
      m_counts.put_off += own.put_off.size();
      m_counts.clashes += own.clashes;
      own.clashes = 0;
      for (std::size_t k = 0; k < own.put_off.size(); ++k) {
        if (k % m_rules.batch == 0 && !may_go_further(chunk, 0, own.put_off[k]))
          return false;
        note_cells();
        while (!insert_point(chunk, 0, own.put_off[k], any)) {
          CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(chunk.is_full); // alone it does not clash
          m_shared.grow();
          chunk.is_full = false;
        }
      }
      own.put_off.clear();
    }
    return true;
  }

  // A longer walk may be going in circles, in a changing triangulation, or be a worker's first.
  static constexpr std::size_t most_cells_of_walk = 10000;

  Shared_complex<Vertex> m_shared;
  const Executor& m_executor;
  const Parallel_rules m_rules;
  std::vector<std::unique_ptr<Worker>> m_workers;
  Insertion_counts m_counts; // counts that are not a worker's
};

// Inserts chunks of a round of Choi 2002, Fig. 1, lines 2b and 2c, by several workers.
template <class Vertex>
class Insert_by_workers : public Parallel_triangulation<Vertex>
{
public:
  // Keeps references.
  Insert_by_workers(Ordered_complex<Vertex>& points, const Executor& executor, Observer& observer)
    : Parallel_triangulation<Vertex>(points.complex, executor)
    , m_points(points)
    , m_observer(observer)
  {
  }

  // Inserts the points at the places first, …, last - 1; returns false if the observer stopped it.
  bool operator()(std::size_t first, std::size_t last)
  {
    return this->insert_chunk(
        first, last, m_points.vertices, m_points.starting_cells(),
        [&](std::size_t inserted) { return m_observer.go_further(inserted); });
  }

private:
  Ordered_complex<Vertex>& m_points;
  Observer& m_observer;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_PARALLEL_TRIANGULATION_H
