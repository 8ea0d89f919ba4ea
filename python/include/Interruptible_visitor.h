// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>

namespace python {

namespace py = pybind11;

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
// raises, KeyboardInterrupt too, goes through the package as an exception.
class Interruptible_visitor : public CGAL::Default_surface_insertion_visitor_3
{
public:
  Interruptible_visitor(std::size_t number_of_points, const py::object& progress)
    : m_number_of_points(number_of_points)
    , m_progress(progress)
  {
  }

  using CGAL::Default_surface_insertion_visitor_3::go_further;

  bool go_further(std::size_t inserted)
  {
    if (!m_clock.is_time())
      return true;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    return m_progress.is_none() || is_content(double(inserted));
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
    m_is_stopped = m_progress(inserted / double(m_number_of_points)).is(py::bool_(false));
    return !m_is_stopped;
  }

  std::size_t m_number_of_points;
  const py::object& m_progress;
  Alarm_clock m_clock;
  bool m_is_stopped = false;
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H
