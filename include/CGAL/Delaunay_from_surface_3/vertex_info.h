// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_VERTEX_INFO_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_VERTEX_INFO_H

// Named parameters that CGAL has not: what the `info()` of the vertices is to be.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The tags of the two parameters.
enum Vertex_info_map_tag { vertex_info_map_tag };
enum Vertex_info_range_tag { vertex_info_range_tag };

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Points

begins a sequence of \ref bgl_namedparameters "Named Parameters" with a property map whose values
become the `info()` of the vertices. Other parameters may follow, joined by dots:

\code{.cpp}
namespace DFS = CGAL::Delaunay_from_surface_3;
CGAL::insert_surface_vertices_3(tr, mesh, DFS::vertex_info_map(colors).random_seed(7));
\endcode

Of several equal points, the one with the smallest index determines the info, whatever the order of
insertion. With %CGAL's own insertion of pairs, the last in its order does. A vertex that existed
before the call gets a new info, too.

\tparam InfoMap a model of `ReadablePropertyMap` whose keys are what the function writes into
`vertex_to_vertex_output_iterator` (the vertices of a mesh, otherwise the indices of the points),
and whose values can be assigned to the info. It is copied.
*/
template <class InfoMap>
auto vertex_info_map(const InfoMap& map)
{
  return Named_function_parameters<InfoMap, internal::Vertex_info_map_tag>(map);
}

/*!
\ingroup PkgDelaunayFromSurface3Points

does the same for a range whose i-th item is the info of the i-th point, or of the i-th vertex of a
mesh in the order of `vertices(mesh)`. If the numbers of items and points differ, the functions that
insert throw a `Surface_input_error` before they change anything.

\tparam InfoRange a model of `RandomAccessRange`; a reference to it is kept
*/
template <class InfoRange>
auto vertex_info_range(const InfoRange& infos)
{
  return Named_function_parameters<const InfoRange*, internal::Vertex_info_range_tag>(&infos);
}

/// \cond
template <class InfoRange>
auto vertex_info_range(const InfoRange&& infos) = delete; // it would be gone when it is read
/// \endcond

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_VERTEX_INFO_H
