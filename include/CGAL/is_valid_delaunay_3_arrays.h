// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_IS_VALID_DELAUNAY_3_ARRAYS_H
#define CGAL_IS_VALID_DELAUNAY_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Delaunay_validity_level.h>
#include <CGAL/Delaunay_from_surface_3/arrays/is_valid_arrays.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <stdexcept>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
void check_that_nothing_was_dropped(const Delaunay_3_arrays<Index>& arrays)
{
  if (arrays.number_of_cells() > 0 && arrays.neighbors_data() == nullptr)
    throw std::invalid_argument("the neighbours of the arrays have been dropped");
  if (arrays.number_of_cells() > 0 && arrays.number_of_cells() == arrays.number_of_simplices())
    throw std::invalid_argument("the infinite cells of the arrays have been dropped");
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Arrays

checks whether arrays are the Delaunay triangulation of points, up to `level`. The last level
detects every error. The arrays may come from anywhere: a file, another process, another program. The
check is exact.

<b>Complexity</b>: \f$O(m)\f$ time for m cells, and some 100 bytes for each.

\param arrays the arrays to be checked, with neighbours and infinite cells
\param points the points of the arrays, in the same order; any range that `delaunay_3_arrays()`
takes
\param level how much is checked

\return whether no error was found

\throws std::invalid_argument if neighbours or infinite cells have been dropped
\throws Surface_input_error if a coordinate is not a finite number

Example: \ref Delaunay_from_surface_3/arrays_and_inside.cpp

\sa `delaunay_3_arrays()`
*/
template <class Index, class PointRange>
bool is_valid_delaunay_3_arrays(const Delaunay_3_arrays<Index>& arrays, const PointRange& points,
                                Delaunay_validity_level level = Delaunay_validity_level::DELAUNAY)
{
  using namespace Delaunay_from_surface_3::internal;
  check_that_nothing_was_dropped(arrays);
  Read_coordinates<PointRange> read(points);
  const Rounding_to_nearest rounding; // as the bounds of the filters need it
  return is_valid(arrays, read.points(), level);
}

/// \ingroup PkgDelaunayFromSurface3Arrays
/// does the same for the regular triangulation of points with weights: any range that
/// `regular_3_arrays()` takes. The last level also checks that hidden points, and no others, have
/// the vertex `none`, by a walk for each of them.
template <class Index, class PointRange, class WeightRange>
bool is_valid_delaunay_3_arrays(const Delaunay_3_arrays<Index>& arrays, const PointRange& points,
                                const WeightRange& weights,
                                Delaunay_validity_level level = Delaunay_validity_level::DELAUNAY)
{
  using namespace Delaunay_from_surface_3::internal;
  check_that_nothing_was_dropped(arrays);
  Read_weighted_points<PointRange, WeightRange> read(points, weights);
  const Rounding_to_nearest rounding;
  return is_valid<Weighted_vertex>(arrays, read.points(), level, Alone(), read.weights());
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_IS_VALID_DELAUNAY_3_ARRAYS_H
