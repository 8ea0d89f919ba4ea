// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>

namespace python {

namespace py = pybind11;

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
    if (m_asked++ % 4096 != 0)
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
  bool m_is_stopped = false;
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_INTERRUPTIBLE_VISITOR_H
