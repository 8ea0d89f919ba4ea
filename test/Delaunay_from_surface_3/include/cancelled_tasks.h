// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CANCELLED_TASKS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CANCELLED_TASKS_H

// Calls in tasks of TBB whose group is cancelled, at a moment that the callee chooses.

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_group.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace tests {

// Calls f(cancel) in a task; cancel() cancels its group.
template <class F>
void call_in_group(const F& f)
{
  tbb::task_group_context group;
  tbb::parallel_for(
      0, 1, [&](int) { f([&] { group.cancel_group_execution(); }); }, group);
}

struct Sibling_error : std::runtime_error
{
  Sibling_error()
    : std::runtime_error("the sibling's own")
  {
  }
};

// Calls f(cancel) beside another iteration of a loop, which throws after cancel(). Returns whether
// that arrived.
template <class F>
bool call_beside_one_that_throws(const F& f)
{
  tbb::task_group_context group;
  std::atomic<bool> is_beside{false}, throws{false};
  const auto cancel = [&] {
    throws = true;
    while (is_beside && !group.is_group_execution_cancelled())
      std::this_thread::yield();
  };
  try {
    tbb::parallel_for(
        0, 2,
        [&](int i) {
          if (i == 0) { // the one that begins
            f(cancel);
            throws = true;
            return;
          }
          is_beside = true;
          while (!throws)
            std::this_thread::yield();
          throw Sibling_error();
        },
        tbb::simple_partitioner(), group);
  } catch (const Sibling_error&) {
    return true;
  }
  return false;
}

} // namespace tests

#endif // CGAL_LINKED_WITH_TBB

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CANCELLED_TASKS_H
