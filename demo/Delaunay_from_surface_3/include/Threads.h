// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_THREADS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <thread>

// Has as many threads as asked for, even more than the machine has. TBB makes them when there is
// work, and ends the process if it cannot; so there is some work at once, before files are opened.
class Threads
{
public:
  explicit Threads(unsigned number)
    : m_limit(tbb::global_control::max_allowed_parallelism, number)
    , m_arena(int(number))
  {
    m_arena.execute([number] { meet(number); });
  }

  template <class F>
  auto execute(const F& f)
  {
    return m_arena.execute(f);
  }

private:
  // Each thread waits for all, but not for long.
  static void meet(unsigned number)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
    std::atomic<unsigned> here(0);
    const auto wait = [&](unsigned) {
      ++here;
      while (here < number && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
    };
    tbb::parallel_for(0u, number, wait, tbb::simple_partitioner());
  }

  const tbb::global_control m_limit;
  tbb::task_arena m_arena;
};

#endif // CGAL_LINKED_WITH_TBB

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_THREADS_H
