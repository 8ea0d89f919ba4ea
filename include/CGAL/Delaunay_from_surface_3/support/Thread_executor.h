// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_THREAD_EXECUTOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_THREAD_EXECUTOR_H

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Has threads of its own, for programs without TBB. They live as long as the executor; the first is
// started when there is a second task. If the system gives fewer, these do all.
class Thread_executor final : public Executor
{
public:
  explicit Thread_executor(std::size_t number)
    : m_number((std::max)(number, std::size_t(1)))
  {
  }
  Thread_executor(const Thread_executor&) = delete;
  Thread_executor& operator=(const Thread_executor&) = delete;
  ~Thread_executor() override
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_work.notify_all();
    for (std::thread& thread : m_threads)
      thread.join();
  }

  std::size_t number_of_workers() const override { return m_number; }

  void run(std::size_t number, const Task& task) const override
  {
    if (number == 0)
      return;
    std::unique_lock<std::mutex> lock(m_mutex);
    start_threads(number);
    m_task = &task;
    m_next = 1;
    m_end = number;
    m_running = 0;
    if (number > 1)
      m_work.notify_all();
    lock.unlock();
    task(0);
    lock.lock();
    while (m_next < m_end)
      run_next(lock);
    m_done.wait(lock, [this] { return m_running == 0; });
    m_task = nullptr;
  }

private:
  void start_threads(std::size_t tasks) const
  {
    try {
      while (m_threads.size() + 1 < m_number && m_threads.size() + 1 < tasks)
        m_threads.emplace_back([this] { work(); });
    } catch (const std::system_error&) { // those that have started suffice
    }
  }

  void work() const
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    for (;;) {
      m_work.wait(lock, [this] { return m_is_over || m_next < m_end; });
      if (m_is_over)
        return;
      run_next(lock);
      if (m_running == 0 && m_next == m_end)
        m_done.notify_one();
    }
  }

  void run_next(std::unique_lock<std::mutex>& lock) const
  {
    const Task& task = *m_task;
    const std::size_t t = m_next++;
    ++m_running;
    lock.unlock();
    task(t);
    lock.lock();
    --m_running;
  }

  const std::size_t m_number;
  mutable std::mutex m_mutex; // guards all members below
  mutable std::condition_variable m_work, m_done;
  mutable std::vector<std::thread> m_threads;
  mutable const Task* m_task = nullptr;
  mutable std::size_t m_next = 0, m_end = 0, m_running = 0;
  bool m_is_over = false;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_THREAD_EXECUTOR_H
