// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_H

// Makes long calls see signals, above all Ctrl-C.

#include "Unlocked.h"

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>

#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <thread>

namespace python {

namespace py = pybind11;

// Returns whether a user's function has returned False, Python's or NumPy's, not merely nothing.
inline bool says_no(const py::object& answer)
{
  if (py::isinstance<py::bool_>(answer))
    return !answer.cast<bool>();
  return py::isinstance(answer, py::module_::import("numpy").attr("bool_")) && !py::bool_(answer);
}

// Says at first, and then every 50 ms, that it is time.
class Alarm_clock
{
  using Clock = std::chrono::steady_clock;

public:
  bool is_time()
  {
    const Clock::time_point now = Clock::now();
    if (m_has_rung && now - m_last_ring < std::chrono::milliseconds(50))
      return false;
    m_has_rung = true;
    m_last_ring = now;
    return true;
  }

private:
  bool m_has_rung = false;
  Clock::time_point m_last_ring;
};

// Takes the interpreter lock now and then, for signals and for the user's function. An exception
// that these raise, such as KeyboardInterrupt, passes through the core.
class Interruptible_observer final : public CGAL::Delaunay_from_surface_3::core::Observer
{
  using Rounding = CGAL::Delaunay_from_surface_3::core::Rounding_to_nearest;

public:
  // Keeps references.
  Interruptible_observer(std::size_t number_of_points, const py::object& progress,
                         const Rounding& rounding)
    : m_number_of_points(number_of_points)
    , m_progress(progress)
    , m_rounding(rounding)
  {
  }

  bool go_further(std::size_t inserted) override
  {
    if (!m_clock.is_time())
      return true;
    return m_rounding.in_mode_of_caller([&] {
      const Locked lock;
      see_signals();
      return m_progress.is_none() || is_content(double(inserted));
    });
  }

  // Returns whether the user's function has stopped the work.
  bool is_stopped() const { return m_is_stopped; }

  // To be called with the lock, when all is done. This answer counts, too.
  void finish()
  {
    if (!m_progress.is_none() && !m_is_stopped)
      m_is_stopped = says_no(called(m_progress, py::make_tuple(1.)));
  }

private:
  bool is_content(double inserted)
  {
    // Copies of points in a box are inserted, too.
    m_is_stopped = says_no(
        called(m_progress, py::make_tuple((std::min)(inserted / double(m_number_of_points), 1.))));
    return !m_is_stopped;
  }

  std::size_t m_number_of_points;
  const py::object& m_progress;
  const Rounding& m_rounding;
  Alarm_clock m_clock;
  bool m_is_stopped = false;
};

// Runs tasks by threads, and ends them when a signal has raised an exception, such as
// KeyboardInterrupt. One thread makes the executor and calls run(), without the interpreter's lock.
class Interruptible_executor final : public CGAL::Delaunay_from_surface_3::core::Executor
{
  using Task = CGAL::Delaunay_from_surface_3::core::Task;

public:
  explicit Interruptible_executor(std::size_t threads)
    : m_threads(threads)
  {
  }

  std::size_t number_of_workers() const override { return m_threads.number_of_workers(); }
  void run(std::size_t number, const Task& task) const override { m_threads.run(number, task); }

  void interruption_point() const override
  {
    if (std::this_thread::get_id() == m_caller && m_clock.is_time())
      look_for_signals();
    if (m_is_stopped)
      std::rethrow_exception(m_error);
  }

private:
  void look_for_signals() const
  {
    const Locked lock;
    try {
      see_signals();
    } catch (const py::error_already_set&) {
      m_error = std::current_exception();
      m_is_stopped = true;
    }
  }

  const CGAL::Delaunay_from_surface_3::core::Thread_executor m_threads;
  const std::thread::id m_caller = std::this_thread::get_id();
  mutable Alarm_clock m_clock; // for the caller's thread only
  mutable std::exception_ptr m_error;
  mutable std::atomic<bool> m_is_stopped{false};
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_H
