// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_INPUT_ERROR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_INPUT_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Progress

is thrown if the input is refused: for a coordinate that is not a finite number, an index out of
range or given twice, a graph whose number of vertices differs from the number of points, a surface
that is not a simple triangulated manifold if one is required, and in other cases that the functions
document. The message says on one line what is wrong and where. Input is checked before the
triangulation is modified.
*/
class Surface_input_error : public std::invalid_argument
{
public:
  /// inherits the constructors, which take the message.
  using std::invalid_argument::invalid_argument;
};

namespace Delaunay_from_surface_3 {

// Thrown where there are more cells than numbers of 32 bits name. Users know it as a std::length_error.
struct Too_many_cells : std::length_error
{
  Too_many_cells()
    : std::length_error("there are more than 2^30 cells, or 2^31 points: tiles serve these")
  {
  }
};

namespace internal {

// Returns the index of an end of an edge, which a broken mesh leads to a vertex that is none of its n.
template <class VertexIndexMap, class Vertex>
std::size_t index_of_end(const VertexIndexMap& index_map, const Vertex& v, std::size_t n)
{
  const auto index = static_cast<std::size_t>(get(index_map, v));
  if (index >= n)
    throw Surface_input_error("an edge leads to a vertex that was removed: remove the edge, too");
  return index;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_INPUT_ERROR_H
