// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_WATCHER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_WATCHER_H

#include "Unlocked.h"

#include <CGAL/Delaunay_from_surface_3/core/interface/Watcher.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>

namespace python {

namespace py = pybind11;

// Whether a user's function has returned False, Python's or NumPy's, and not merely nothing.
inline bool says_no(const py::object& answer)
{
  if (py::isinstance<py::bool_>(answer))
    return !answer.cast<bool>();
  return py::isinstance(answer, py::module_::import("numpy").attr("bool_")) && !py::bool_(answer);
}

// Says at once, and then every 50 ms, that it is time; it is asked every 256 points.
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

// Takes the interpreter lock now and then, for signals and for the user's function. What that
// raises, KeyboardInterrupt too, goes through the core as an exception.
class Interruptible_watcher final : public CGAL::Delaunay_from_surface_3::internal::Watcher
{
  using Rounding = CGAL::Delaunay_from_surface_3::internal::Rounding_to_nearest;

public:
  // Keeps references.
  Interruptible_watcher(std::size_t number_of_points, const py::object& progress,
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
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      return m_progress.is_none() || is_content(double(inserted));
    });
  }

  // Whether the user's function has stopped the work.
  bool is_stopped() const { return m_is_stopped; }

  // To be called with the lock, when all is done.
  void finish()
  {
    if (!m_progress.is_none())
      m_progress(1.);
  }

private:
  bool is_content(double inserted)
  {
    m_is_stopped = says_no(m_progress(inserted / double(m_number_of_points)));
    return !m_is_stopped;
  }

  std::size_t m_number_of_points;
  const py::object& m_progress;
  const Rounding& m_rounding;
  Alarm_clock m_clock;
  bool m_is_stopped = false;
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_WATCHER_H
