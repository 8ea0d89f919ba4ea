// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_WINDING_NUMBER_3_H
#define CGAL_WINDING_NUMBER_3_H

#include <CGAL/Delaunay_from_surface_3/door/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/door/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Inside

is the generalised winding number of a surface, a function of points: how often the surface goes
around them (\cgalCite{jks-rioss-13}). It is a whole number if the surface is closed, and nearly one
away from its gaps if it nearly is. The surface may have any number of parts, edges with any number
of faces, and intersect itself; but its faces should be oriented alike.

Groups of triangles that are far from a point count as a whole, to the third order
(\cgalCite{bdslj-fwn-18}), so that the numbers are right up to about 0.01.

<b>Complexity</b>: \f$O(n \log n)\f$ for n triangles, about 110 bytes for each; a call takes
\f$O(\log n)\f$ where the surface is spread evenly. Calls may be made by many threads.
*/
class Winding_number_3
{
public:
  /*!
  reads a surface, and keeps nothing of what it is given.

  \tparam PointRange a range of points as `delaunay_3_arrays()` takes them
  \tparam FaceRange a range of ranges of integers

  \param points the points
  \param faces for each face the indices of its points, in order; seen from outside they are
    counterclockwise. A polygon counts as the fan of triangles at its first point.

  \throws Surface_input_error if a coordinate is not a finite number, or an index is out of range
  */
  template <class PointRange, class FaceRange>
  Winding_number_3(const PointRange& points, const FaceRange& faces)
    : m_field(read(points, faces))
  {
  }

  /// returns the number of a point: of any kernel, or with coordinates `p[0]`, `p[1]`, `p[2]` that
  /// are numbers. On the surface itself it is any number between those of the two sides.
  template <class Point>
  double operator()(const Point& p) const
  {
    using namespace Delaunay_from_surface_3::internal;
    const Rounding_to_nearest rounding; // to denormal numbers, too
    const auto q = converted_point<Point_of_doubles>(p);
    return m_field.tree(m_field.frame({q.x(), q.y(), q.z()}));
  }

private:
  template <class PointRange, class FaceRange>
  static Delaunay_from_surface_3::internal::Winding_field read(const PointRange& points,
                                                               const FaceRange& faces)
  {
    using namespace Delaunay_from_surface_3::internal;
    const Rounding_to_nearest rounding;
    Read_coordinates<PointRange> read(points);
    return winding_field(read.points(), faces);
  }

  Delaunay_from_surface_3::internal::Winding_field m_field;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_WINDING_NUMBER_3_H
