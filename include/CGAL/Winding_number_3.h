// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_WINDING_NUMBER_3_H
#define CGAL_WINDING_NUMBER_3_H

#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Inside

is a function object that computes the generalised winding number of a surface at a point: how often the
surface winds around the point (\cgalCite{jks-rioss-13}). It is an integer if the surface is closed. If
the surface has gaps, it is nearly an integer away from these. The surface may have any number of parts,
any number of faces at an edge, and may intersect itself, but its faces should be oriented consistently.

Groups of triangles that are far from the point are approximated by an expansion to the third order
(\cgalCite{bdslj-fwn-18}), so the numbers are correct up to about 0.01.

<b>Complexity</b>: construction takes \f$O(n \log n)\f$ time for n triangles, and less than 180
bytes for each. A call takes \f$O(\log n)\f$ if the surface is spread evenly. Several threads may call at
the same time.
*/
class Winding_number_3
{
public:
  /*!
  reads a surface, and keeps no reference to the arguments.

  \tparam PointRange as for `delaunay_3_arrays()`
  \tparam FaceRange a range of ranges of integers

  \param points the points
  \param faces for each face the indices of its points, in order, counterclockwise as seen from
  outside. Every other corner of a polygon, from the second one on, is cut off until three are left.

  \throws Surface_input_error if a coordinate is not a finite number, or an index is out of range
  */
  template <class PointRange, class FaceRange>
  Winding_number_3(const PointRange& points, const FaceRange& faces)
    : m_field(read(points, faces))
  {
  }

  /// returns the winding number at `p`, a point of any kernel, or with arithmetic coordinates
  /// `p[0]`, `p[1]`, `p[2]`. On the surface itself it is any number between those of the two sides.
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
