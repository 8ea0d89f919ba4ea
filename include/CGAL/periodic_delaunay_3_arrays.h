// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_PERIODIC_DELAUNAY_3_ARRAYS_H
#define CGAL_PERIODIC_DELAUNAY_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Periodic_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_periodic.h>
#include <CGAL/Delaunay_from_surface_3/core/build_periodic.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/delaunay_3_arrays.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Makes the arrays of points in a box, with weights if the source has any.
template <class Index, class Source, class Executor, class NamedParameters>
Periodic_3_arrays<Index> insert_into_box(Source& points, const std::array<double, 3>& box,
                                         const Executor& executor, const NamedParameters& np)
{
  static_assert(std::is_same<Index, std::int32_t>::value, "indices are std::int32_t");
  Call_of_core<NamedParameters> call(points.points().size(), Build_options(), std::nullopt, np);
  Built_in_box built = build_in_box(points.points(), weights_of(points), box.data(), call.options,
                                    call.observer, executor);
  if (points.points().size() == 0) { // as for delaunay_3_arrays()
    call.observer.phase_begins(Surface_insertion_phase::INSERTION, 1);
    call.observer.insertion_ends(Insertion_counts());
    call.observer.phase_begins(Surface_insertion_phase::FINISH);
  }
  auto arrays = arrays_of_box<Index>(built, points.points(), box);
  call.observer.phase_begins(Surface_insertion_phase::DONE);
  return arrays;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Arrays

returns the Delaunay triangulation of points in a periodic box as arrays of numbers. Its tetrahedra are
those of a `Periodic_3_Delaunay_triangulation_3<Gt>` with exact predicates, in one sheet. But the box
may have edges of any lengths, some axes may have no period, as in slabs and wires, and there may be any
number of points.

Points may lie anywhere; the offsets of the corners are from the points as they were given. The
positions x + k L of the copies are never rounded. The triangulation is computed from the points and as
many copies around as are needed; the circumscribed balls of the tetrahedra certify that these suffice.
It is unique, as cospherical points are perturbed as in `Delaunay_triangulation_3`, which commutes with
translations.

<b>Complexity</b>: that of `delaunay_3_arrays()` for the points and their copies, whose number is of
the order of n<sup>2/3</sup> for n random points.

\tparam Index `std::int32_t`
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, as for
`delaunay_3_arrays()`
\tparam PointRange a range of points, as for `delaunay_3_arrays()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param box the period along each axis, infinite along an axis that has none
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
`delaunay_3_arrays()`. A visitor counts copies as points.

\return the triangulation; after a stop, one without points and tetrahedra

\throws Surface_input_error if a coordinate is not a finite number; if a period is not positive, is less
than 1/10000 of the box's diagonal, or so small that points are more than 2<sup>29</sup> periods away; if
corners of a tetrahedron are more than 32767 periods apart, as the points are given; or if the points lie
in a plane or on a line parallel to the axes that have periods
\throws std::length_error if there are more than \f$2^{30}\f$ cells, copies included
\throws std::runtime_error as `delaunay_3_arrays()`

\sa `Periodic_3_arrays`
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Periodic_3_arrays<Index>
periodic_delaunay_3_arrays(const PointRange& points, const std::array<double, 3>& box,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  Read_coordinates<PointRange, CGAL_NP_CLASS> read(points, np);
  const typename Executor_of_tag<ConcurrencyTag>::type executor{};
  return insert_into_box<Index>(read, box, executor, np);
}

/*!
\ingroup PkgDelaunayFromSurface3Arrays

does the same for points with weights, as `regular_3_arrays()` does in space: the tetrahedra are those of
the regular triangulation of all copies.

\param points the points
\param weights the weight of each point
\param box the period along each axis
\param np as above

\throws Surface_input_error also if a weight is not a finite number, or if there are not as many weights
as points
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          class WeightRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Periodic_3_arrays<Index>
periodic_regular_3_arrays(const PointRange& points, const WeightRange& weights,
                          const std::array<double, 3>& box,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  Read_weighted_points<PointRange, WeightRange, CGAL_NP_CLASS> read(points, weights, np);
  const typename Executor_of_tag<ConcurrencyTag>::type executor{};
  return insert_into_box<Index>(read, box, executor, np);
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_PERIODIC_DELAUNAY_3_ARRAYS_H
