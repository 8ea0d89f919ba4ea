// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H

// Defines build() for any executor. Programs without threads need not compile this.

#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <memory>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE std::unique_ptr<Built> build(Point_source& points,
                                                                 const Build_options& options,
                                                                 Observer& observer,
                                                                 const Executor& executor)
{
  return executor.number_of_workers() > 1
             ? build_by<Compact_vertex, Insert_by_workers>(points, options, observer, executor)
             : build_by<Compact_vertex, Insert_alone>(points, options, observer, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H
