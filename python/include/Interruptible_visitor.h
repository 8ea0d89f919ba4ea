// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <pybind11/pybind11.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>

namespace python {

namespace py = pybind11;

// Says at once, and then every 50 ms, that it is time. It is asked before each point, of which one
// may take a microsecond and another a millisecond: the clock is looked at for each point once a
// look came late, and otherwise for ever fewer, up to every 64th.
class Alarm_clock
{
  using Clock = std::chrono::steady_clock;

public:
  bool is_time()
  {
    if (--m_calls_before_look > 0)
      return false;
    const Clock::time_point now = Clock::now();
    const bool is_late = now - m_last_look > std::chrono::milliseconds(1);
    m_calls_between_looks = is_late ? 1 : (std::min)(2 * m_calls_between_looks, 64);
    m_calls_before_look = m_calls_between_looks;
    m_last_look = now;
    if (m_has_rung && now - m_last_ring < std::chrono::milliseconds(50))
      return false;
    m_has_rung = true;
    m_last_ring = now;
    return true;
  }

private:
  int m_calls_before_look = 1, m_calls_between_looks = 1;
  bool m_has_rung = false;
  Clock::time_point m_last_look, m_last_ring;
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

  void order_is_replaced(const std::string&) { m_asked = 0; }

  bool go_further()
  {
    ++m_asked;
    if (!m_clock.is_time())
      return true;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    return m_progress.is_none() || is_content(double(m_asked - 1));
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

  std::size_t m_number_of_points, m_asked = 0;
  const py::object& m_progress;
  Alarm_clock m_clock;
  bool m_is_stopped = false;
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H
