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

// True in the thread that ends the interpreter, while it calls this module: it keeps the lock. With
// glibc each thread then gets the memory for the module's own data when it begins, not when it
// first throws: if there were none left, glibc would abort.
#ifdef __GLIBC__
__attribute__((tls_model("initial-exec")))
#endif
inline thread_local bool ends_interpreter = false;

[[noreturn]] inline void wait_for_the_end()
{
  for (;;)
    std::this_thread::sleep_for(std::chrono::seconds(1));
}

// Returns what a function returns that may ask for the lock, and that holds no Python object. Where
// the interpreter has begun to end while the function waits, Python up to 3.13 calls pthread_exit(),
// and that unwinds the stack.
template <class Function>
auto unless_interpreter_ends(const Function& function)
{
  if (interpreter_ends() && !ends_interpreter)
    wait_for_the_end();
#ifdef __GLIBCXX__
  try {
    return function();
  } catch (const abi::__forced_unwind&) {
    if (!interpreter_ends())
      throw;
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
  Unlocked()
    : m_state(interpreter_ends() ? nullptr : PyEval_SaveThread())
  {
    ends_interpreter = m_state == nullptr;
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked()
  {
    ends_interpreter = false;
    if (m_state != nullptr)
      unless_interpreter_ends([this] { PyEval_RestoreThread(m_state); });
  }

private:
  PyThreadState* const m_state;
};

// The lock is held as long as this lives, in a thread without it.
class Locked
{
  const pybind11::gil_scoped_acquire m_lock =
      unless_interpreter_ends([] { return pybind11::gil_scoped_acquire(); });
};

// Calls a user's function, with the lock.
inline pybind11::object called(const pybind11::object& function, const pybind11::tuple& arguments)
{
  PyObject* const result =
      unless_interpreter_ends([&] { return PyObject_CallObject(function.ptr(), arguments.ptr()); });
  if (result == nullptr)
    throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::object>(result);
}

// Sees signals, above all Ctrl-C, with the lock, and passes their exceptions on.
inline void see_signals()
{
  if (unless_interpreter_ends([] { return PyErr_CheckSignals(); }) != 0)
    throw pybind11::error_already_set();
}

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_UNLOCKED_H
