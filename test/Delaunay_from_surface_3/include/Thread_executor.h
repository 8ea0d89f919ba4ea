// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_THREAD_EXECUTOR_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_THREAD_EXECUTOR_H

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <cstddef>
#include <thread>
#include <vector>

namespace tests {

// One std::thread for each worker but the first: ThreadSanitizer knows these, and would have to be
// told of TBB's.
class Thread_executor : public CGAL::Delaunay_from_surface_3::internal::Executor
{
protected:
  using Task = CGAL::Delaunay_from_surface_3::internal::Task;

public:
  explicit Thread_executor(std::size_t number = 8)
    : m_number(number)
  {
  }
  std::size_t number_of_workers() const override { return m_number; }

  void run(std::size_t number, const Task& task) const override
  {
    std::vector<std::thread> others;
    for (std::size_t t = 1; t < number; ++t)
      others.emplace_back([&task, t] { task(t); });
    task(0);
    for (std::thread& thread : others)
      thread.join();
  }

private:
  std::size_t m_number;
};

// The workers one after the other, as TBB may run them; the last first.
class One_after_the_other : public Thread_executor
{
public:
  using Thread_executor::Thread_executor;

  void run(std::size_t number, const Task& task) const override
  {
    for (std::size_t t = number; t-- > 0;)
      task(t);
  }
};

// The caller's first, before the others begin.
class Caller_first : public Thread_executor
{
public:
  using Thread_executor::Thread_executor;

  void run(std::size_t number, const Task& task) const override
  {
    for (std::size_t t = 0; t < number; ++t)
      task(t);
  }
};

// Leaves the last one out, as no executor may.
class Forgetful_executor : public Thread_executor
{
public:
  using Thread_executor::Thread_executor;

  void run(std::size_t number, const Task& task) const override
  {
    Thread_executor::run(number - 1, task);
  }
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_THREAD_EXECUTOR_H
