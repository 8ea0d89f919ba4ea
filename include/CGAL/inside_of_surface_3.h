// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_INSIDE_OF_SURFACE_3_H
#define CGAL_INSIDE_OF_SURFACE_3_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/inside/find_inside.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <string>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Inside

finds the tetrahedra of a triangulation that lie inside a surface on its points, by the winding
numbers of their centres (see `Winding_number_3`). The surface need not be closed: it may have gaps,
faces that are turned or given twice, and overlapping parts, inside which the number is larger.

Faces are joined across edges with exactly two faces; equal points are one. Where joined faces disagree
in orientation, those with the smaller total area are reversed; if both have the same area, they are
oriented so that the volume is positive. Faces that agree stay as they are: if they look inwards, they
are the wall of a cavity.

Edges with one face are open, and so are those with more than two: leave out walls inside a solid.

Where a face is not a facet of the triangulation, tetrahedra cross the surface: `Inside_3` says how much
volume may be wrong in these.

Call a tetrahedron *surely inside* if its winding number differs by at most 0.1 from an integer
other than 0, *in doubt* if it differs by more than 0.1 from every integer, and *inside* if its
absolute value is at least 1/2. Openings are closed by triangles from the middle of each. A surface
has an inside if one of two conditions holds:

- The tetrahedra surely inside have more volume than those in doubt. A long tube is an example.
- The tetrahedra in doubt have at most as much volume as those inside, the triangles that close the
openings have at most 3/10 of the area of the surface, and those of a single opening have at least
9/10 of that. An example is a hull without a deck. (This condition was found by experiment: for the
files in \ref dfs_inside "the user manual" it separates solids without a deck from patches and short
tubes.)

A patch, a sheet, a Möbius strip and points alone have no inside. Nor has a surface with a part that is
not orientable, or one whose faces cancel each other.

<b>Complexity</b>: \f$O((n + m) \log n)\f$ for n faces and m tetrahedra if the surface is spread
evenly.

\tparam ConcurrencyTag as for `delaunay_3_arrays()`
\tparam PointRange as for `delaunay_3_arrays()`
\tparam FaceRange a range of ranges of integers
\tparam Index that of `arrays`

\param points the points
\param faces for each face the indices of its points, in order, counterclockwise as seen from
outside, up to faces that are turned as said above
\param arrays the triangulation of these points; neighbours that have been dropped are recomputed

\return the winding number of each tetrahedron, and what follows from them

\throws Surface_input_error if a coordinate is not a finite number, an index is out of range, the
number of points differs from that of `arrays`, all points lie in a plane, weights hide a point
from `arrays` (`regular_3_arrays()`), or the surface has no inside
\throws std::length_error if there are \f$2^{30}\f$ tetrahedra or \f$2^{31}\f$ points, or more

Example: \ref Delaunay_from_surface_3/arrays_and_inside.cpp

\sa `delaunay_3_arrays()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class FaceRange, class Index>
Inside_3 inside_of_surface_3(const PointRange& points, const FaceRange& faces,
                             const Delaunay_3_arrays<Index>& arrays)
{
  using namespace Delaunay_from_surface_3::internal;
  const Rounding_to_nearest rounding; // to denormal numbers, too
  Read_coordinates<PointRange> read(points);
  const Point_array array = read.points();
  check_number_of_points(arrays, array.size());
  if (arrays.dimension() < 3)
    throw Surface_input_error("the surface has no inside: there are no tetrahedra");
  refuse_hidden_points(arrays, "surface needs all its vertices");
  const typename Executor_of_tag<ConcurrencyTag>::type executor;
  const auto find = [&](const auto& neighbors_of) {
    return find_inside(
        array, faces, arrays.number_of_simplices(),
        [&](std::size_t c) { return arrays.vertices(c); }, neighbors_of,
        [&](std::size_t i) { return arrays.vertex_of_point(i); }, executor);
  };
  if (arrays.neighbors_data() != nullptr)
    return find([&](std::size_t c) { return arrays.neighbors(c); });
  const auto neighbors = neighbors_of_corners(
      Corners_view<Index>{arrays.vertices_data(), arrays.stride(), arrays.number_of_simplices()},
      array.size(), executor);
  return find([&](std::size_t c) { return neighbors[c]; });
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_INSIDE_OF_SURFACE_3_H
