// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_PERIODIC_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_PERIODIC_H

// Builds triangulations of points in a periodic box, as build.h does in space. The compiled core has
// this in an object file of its own.

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <type_traits>

#if !defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED) || defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY)
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Periodic_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Builds it, without weights if these are null, for periods `box`, infinite along an axis that has none.
// It is exact, with CGAL's symbolic perturbation, which commutes with shifts. If the points do not
// span the space together with the periods, they are not inserted. Throws a Surface_input_error that
// names an axis if a period is no positive number, or so much smaller than others, or than a
// coordinate, that numbers of periods are not representable.
Built_in_box build_in_box(const Point_array& points, const double* weights, const double* box,
                          const Build_options& options, Observer& observer,
                          const Executor& executor);

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY) || !defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Does it with the class that inserts vertices.
template <template <class> class Insert>
Built_in_box build_in_box_by(const Point_array& points, const double* weights, const double* box,
                             const Build_options& options, Observer& observer,
                             const Executor& executor)
{
  const auto build = [&](const auto& box_of_points) {
    using Box = std::decay_t<decltype(box_of_points)>;
    return Periodic_triangulation<Box>(box_of_points, observer, executor)
        .template build<Insert>(options);
  };
  return weights == nullptr ? build(Box_of_points<false>(points, weights, box))
                            : build(Box_of_points<true>(points, weights, box));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE Built_in_box
build_in_box(const Point_array& points, const double* weights, const double* box,
             const Build_options& options, Observer& observer, const Executor& executor)
{
  return executor.number_of_workers() > 1
             ? build_in_box_by<Insert_by_workers>(points, weights, box, options, observer, executor)
             : build_in_box_by<Insert_alone>(points, weights, box, options, observer, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

#endif

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Does the same with one thread, as that of build.h.
inline Built_in_box build_in_box(const Point_array& points, const double* weights,
                                 const double* box, const Build_options& options,
                                 Observer& observer, const Alone& executor)
{
  return build_in_box_by<Insert_alone>(points, weights, box, options, observer, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
#endif
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_PERIODIC_H
