// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_EXECUTOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_EXECUTOR_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// What an executor runs; it must not throw.
class Task
{
public:
  virtual void operator()(std::size_t t) const = 0;

protected:
  ~Task() = default;
};

// Runs tasks by one thread or by many: those of TBB, or any others that the caller has.
class Executor
{
public:
  virtual ~Executor() = default;

  // At least 1; the same whenever it is asked.
  virtual std::size_t number_of_workers() const = 0;

  // Calls task(0) in the thread that calls this, and task(1), …, task(number - 1) at the same time,
  // or later, anywhere. Returns when all have returned, or throws.
  virtual void run(std::size_t number, const Task& task) const = 0;

  // Long tasks call this now and then; what it throws stops them.
  virtual void interruption_point() const {}
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Runs all in the caller's thread.
class Alone final : public Executor
{
public:
  std::size_t number_of_workers() const override { return 1; }

  void run(std::size_t number, const Task& task) const override
  {
    for (std::size_t t = 0; t < number; ++t)
      task(t);
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_EXECUTOR_H
