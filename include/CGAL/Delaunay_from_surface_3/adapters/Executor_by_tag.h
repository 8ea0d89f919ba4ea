// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_EXECUTOR_BY_TAG_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_EXECUTOR_BY_TAG_H

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Default.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#include <CGAL/Delaunay_from_surface_3/core/build_by_threads.h>
#endif
#include <CGAL/Delaunay_from_surface_3/core/threads/Marks.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

#ifdef CGAL_LINKED_WITH_TBB

// Runs bodies as tasks of TBB, in the arena of the caller. They are isolated: while the caller
// waits for them it takes no other task, such as one that called this package, too; and they belong
// to a group of their own, since tasks that inherit the group of the caller are left out when that
// is cancelled.
class Tbb_executor : public Executor
{
public:
  Tbb_executor()
    : m_number((std::min)(
          {std::size_t(tbb::this_task_arena::max_concurrency()),
           tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
           std::size_t(Marks::most_workers)}))
  {
  }

  std::size_t number_of_workers() const override { return m_number; }

  void run(std::size_t number, const Task& task) const override
  {
    if (number == 1)
      return task(0);
    tbb::this_task_arena::isolate([&] {
      tbb::task_group_context group(tbb::task_group_context::isolated);
      tbb::task_group others(group);
      for (std::size_t t = 1; t < number; ++t)
        others.run([&task, t] { task(t); });
      task(0);
      others.wait();
    });
  }

private:
  std::size_t m_number;
};

using Parallel_executor = Tbb_executor;

#else

using Parallel_executor = void;

#endif // CGAL_LINKED_WITH_TBB

template <class Tag>
struct Executor_of_tag
{
  static constexpr bool is_parallel = std::is_convertible<Tag, Parallel_tag>::value;
  static_assert(!is_parallel || !std::is_void<Parallel_executor>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
  using type = std::conditional_t<is_parallel, Parallel_executor, Alone>;
};

// Gives the executor for the concurrency tag of a call, or else of the triangulation.
template <class ConcurrencyTag, class Triangulation>
using Executor_by_tag = typename Executor_of_tag<
    typename Default::Get<ConcurrencyTag, typename Triangulation::Concurrency_tag>::type>::type;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_EXECUTOR_BY_TAG_H
