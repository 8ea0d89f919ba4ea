// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_CIRCUMSPHERES_3_H
#define CGAL_CIRCUMSPHERES_3_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns the spheres; points without weights have the weight 0.
template <class Index, class Source>
std::vector<std::array<double, 4>> spheres_of(const Delaunay_3_arrays<Index>& arrays, Source read)
{
  const Rounding_to_nearest rounding;
  const Point_array points = read.points();
  const double* const weights = weights_of(read);
  check_number_of_points(arrays, points.size());
  std::vector<std::array<double, 4>> spheres(arrays.dimension() < 3 ? 0
                                                                    : arrays.number_of_simplices());
  for (std::size_t c = 0; c < spheres.size(); ++c) {
    std::array<double, 4> corners[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto v = std::size_t(arrays.vertices(c)[k]);
      const double* const p = points[v];
      corners[k] = {p[0], p[1], p[2], weights == nullptr ? 0 : weights[v]};
    }
    const Power_sphere sphere = power_sphere_of(corners);
    for (std::size_t i = 0; i < 3; ++i)
      spheres[c][i] = corners[0][i] + sphere.center[i];
    spheres[c][3] = sphere.squared_radius;
  }
  return spheres;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Arrays

returns the sphere through the corners of each tetrahedron, whose centre is a Voronoi vertex.

With weights it is the sphere orthogonal to those around the corners whose squared radii are the
weights. Its centre is a vertex of the power diagram (\cgalCite{a-pdpaa-87}): all four corners have
the same power there, which is the squared radius, and may be negative.

\code{.cpp}
const auto spheres = CGAL::circumspheres_3(arrays, points); // or arrays, points, weights
const auto [x, y, z, squared_radius] = spheres[0];          // of tetrahedron 0
\endcode

However flat the tetrahedron, the error of the centre is at most 1e-12 of its distance from a corner,
plus the rounding of its coordinates. The error of the squared radius is at most 1e-12 of the square of
this distance and of the weight. What is larger than any `double` is infinite.

<b>Complexity</b>: \f$O(m)\f$ for m tetrahedra

\param arrays the triangulation of the points
\param points the points of the arrays, in the same order; any range that `delaunay_3_arrays()`
takes

\return for each tetrahedron the coordinates of the centre, and the square of the radius; nothing
if the dimension of the arrays is less than 3

\throws Surface_input_error if a coordinate or weight is not a finite number, or if the arrays are
of another number of points, or there are not as many weights

\sa `delaunay_3_arrays()`
\sa `regular_3_arrays()`
*/
template <class Index, class PointRange>
std::vector<std::array<double, 4>> circumspheres_3(const Delaunay_3_arrays<Index>& arrays,
                                                   const PointRange& points)
{
  using namespace Delaunay_from_surface_3::internal;
  return spheres_of(arrays, Read_coordinates<PointRange>(points));
}

/// \ingroup PkgDelaunayFromSurface3Arrays
/// does the same with the weights of the points: any range that `regular_3_arrays()` takes.
template <class Index, class PointRange, class WeightRange>
std::vector<std::array<double, 4>> circumspheres_3(const Delaunay_3_arrays<Index>& arrays,
                                                   const PointRange& points,
                                                   const WeightRange& weights)
{
  using namespace Delaunay_from_surface_3::internal;
  return spheres_of(arrays, Read_weighted_points<PointRange, WeightRange>(points, weights));
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_CIRCUMSPHERES_3_H
