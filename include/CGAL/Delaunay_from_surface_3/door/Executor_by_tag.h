// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_EXECUTOR_BY_TAG_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_EXECUTOR_BY_TAG_H

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/door/Tbb_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Default.h>
#include <CGAL/tags.h>

#if defined(CGAL_LINKED_WITH_TBB) && !defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
#include <CGAL/Delaunay_from_surface_3/core/threads/Insert_by_workers.h>
#endif

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Tag>
struct Executor_of_tag
{
  static constexpr bool is_parallel = std::is_convertible<Tag, Parallel_tag>::value;
  static_assert(!is_parallel || !std::is_void<Parallel_executor>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
  using type = std::conditional_t<is_parallel, Parallel_executor, Alone>;
};

// The crew that inserts with an executor.
template <class Executor>
struct Crew
{
  using type = Many_threads;
};
template <>
struct Crew<Alone>
{
  using type = One_thread;
};

// The executor for the concurrency tag of a call, or else of the triangulation.
template <class ConcurrencyTag, class Triangulation>
using Executor_by_tag = typename Executor_of_tag<
    typename Default::Get<ConcurrencyTag, typename Triangulation::Concurrency_tag>::type>::type;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_EXECUTOR_BY_TAG_H
