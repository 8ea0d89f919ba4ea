// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_UNLOCKED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_UNLOCKED_H

// Gives the interpreter's lock back and takes it again. When the interpreter ends, it ends every
// thread that asks for the lock, as daemon threads still do; threads in the middle of C++ would
// take the process with them. So they wait until it is gone, as Python 3.14 makes them.

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>

namespace python {

inline void wait_if_interpreter_ends()
{
  const auto ends = [] {
#if PY_VERSION_HEX >= 0x030d0000
    return Py_IsFinalizing() != 0;
#else
    return _Py_IsFinalizing() != 0;
#endif
  };
  while (ends())
    std::this_thread::sleep_for(std::chrono::seconds(1));
}

// The lock is not held as long as this lives.
class Unlocked
{
public:
  Unlocked() = default;
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked()
  {
    wait_if_interpreter_ends();
    PyEval_RestoreThread(m_state);
  }

private:
  PyThreadState* const m_state = PyEval_SaveThread();
};

// The lock is held as long as this lives, in a thread without it.
class Locked
{
  struct Wait
  {
    Wait() { wait_if_interpreter_ends(); }
  };

  const Wait m_wait;
  const pybind11::gil_scoped_acquire m_lock;
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_UNLOCKED_H
