// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_INSIDE_OF_SURFACE_3_H
#define CGAL_INSIDE_OF_SURFACE_3_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/door/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/door/Read_coordinates.h>
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

returns which tetrahedra of a triangulation lie inside a surface on its points, by the winding
numbers of their centres: see `Winding_number_3`. The surface need not be closed: it may have gaps,
faces that are turned round or given twice, and parts that overlap, where it goes around more often.

A surface has an inside if one of two holds. The volume of the tetrahedra that are surely inside,
with numbers near a whole one other than 0, is larger than that of the tetrahedra in doubt, whose
numbers differ by more than 0.1 from all whole ones: a long tube is one. Or not more is in doubt
than inside, triangles that close its openings, from the middle of each, have at most 3/10 of its
area, and one opening has 9/10 of theirs: a hull without a deck. (The second was found by trying: of
the files in \ref dfs_inside it tells apart what is a solid but for a deck, and what is a patch or a
short tube.) A patch, a sheet, a Möbius strip and points alone have none.

\tparam ConcurrencyTag as for `delaunay_3_arrays()`

\param points the points, as `delaunay_3_arrays()` takes them
\param faces the faces: for each the indices of its points in order, counterclockwise seen from
outside
\param arrays the triangulation of these points; neighbours that have been dropped are found anew

<b>Complexity</b>: \f$O((n + m) \log n)\f$ for n faces and m tetrahedra where the surface is spread
evenly.

\throws Surface_input_error if a coordinate is not a finite number, an index is out of range, the
points are not as many as those of `arrays` or lie in a plane, or the surface has no inside

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
  if (array.size() != arrays.number_of_points())
    throw Surface_input_error("the arrays are of " + std::to_string(arrays.number_of_points()) +
                              " points, and " + std::to_string(array.size()) + " are given");
  if (arrays.dimension() < 3)
    throw Surface_input_error("the surface has no inside: there are no tetrahedra");
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
      Corners_view<Index>{arrays.vertices_data(), arrays.stride(), arrays.number_of_simplices(), 0},
      array.size(), executor);
  return find([&](std::size_t c) { return neighbors[c]; });
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_INSIDE_OF_SURFACE_3_H
