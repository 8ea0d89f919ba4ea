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
#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

namespace python {

inline bool interpreter_ends()
{
#if PY_VERSION_HEX >= 0x030d0000
  return Py_IsFinalizing() != 0;
#else
  return _Py_IsFinalizing() != 0;
#endif
}

[[noreturn]] inline void wait_for_the_end()
{
  for (;;)
    std::this_thread::sleep_for(std::chrono::seconds(1));
}

// Returns what a function returns that may ask for the lock. Where the interpreter has begun to end
// while the function waits, Python up to 3.13 calls pthread_exit(), and that unwinds the stack.
template <class Function>
auto unless_interpreter_ends(const Function& function)
{
  if (interpreter_ends())
    wait_for_the_end();
#ifdef __GLIBCXX__
  try {
    return function();
  } catch (const abi::__forced_unwind&) {
    wait_for_the_end();
  }
#else
  return function();
#endif
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
    unless_interpreter_ends([this] { PyEval_RestoreThread(m_state); });
  }

private:
  PyThreadState* const m_state = PyEval_SaveThread();
};

// The lock is held as long as this lives, in a thread without it.
class Locked
{
  const pybind11::gil_scoped_acquire m_lock =
      unless_interpreter_ends([] { return pybind11::gil_scoped_acquire(); });
};

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_UNLOCKED_H
