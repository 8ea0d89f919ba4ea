// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_REGULAR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_REGULAR_H

// Builds regular triangulations, of points with weights, as build.h does Delaunay triangulations.
// They differ in the type of the vertices, on which the kernel's predicates depend. Programs without
// weights need not compile this; the compiled core has it in an object file of its own.

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <memory>

#if !defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED) || defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY)
#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Is build() for points with weights, on as many threads as the executor has. A point is hidden if
// the others' power cells leave nothing to its own; Built::vertex_of is 0 for its place. Of points
// in a plane the triangulation is that of the plane, at an apex; points on a line are not inserted.
std::unique_ptr<Built> build(Weighted_point_source& points, const Build_options& options,
                             Observer& observer, const Executor& executor);

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY) || !defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE std::unique_ptr<Built> build(Weighted_point_source& points,
                                                                 const Build_options& options,
                                                                 Observer& observer,
                                                                 const Executor& executor)
{
  return executor.number_of_workers() > 1
             ? build_by<Weighted_vertex, Insert_by_workers>(points, options, observer, executor)
             : build_by<Weighted_vertex, Insert_alone>(points, options, observer, executor);
}

#endif

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Does the same with one thread, as that of build.h.
inline std::unique_ptr<Built> build(Weighted_point_source& points, const Build_options& options,
                                    Observer& observer, const Alone& executor)
{
  return build_by<Weighted_vertex, Insert_alone>(points, options, observer, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
#endif
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_REGULAR_H
