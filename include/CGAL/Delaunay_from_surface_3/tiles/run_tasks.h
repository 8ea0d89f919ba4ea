// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TASKS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TASKS_H

#include <CGAL/Delaunay_from_surface_3/core/threads/Lanes.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// How many of these threads work on task k of n, where several can insert points together: in the
// end there are fewer tasks than threads, which share them.
inline std::size_t threads_of_task(std::size_t k, std::size_t n, std::size_t threads)
{
  const std::size_t last = n % threads, first = n - last; // of the last ones
  const std::size_t share = k < first ? 1 : (threads + last - 1 - (k - first)) / last;
  return (std::min)(share, std::size_t(Lanes::most_workers));
}

// Calls task(0), …, task(n - 1), which may throw: then the first exception is thrown again when
// those that have begun have ended. They are taken one after the other by the executor's workers.
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TASKS_H
