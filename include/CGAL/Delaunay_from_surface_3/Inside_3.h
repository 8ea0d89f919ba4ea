// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_3_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Inside

says which tetrahedra lie inside a surface. It is returned by `inside_of_surface_3()`.
*/
struct Inside_3
{
  /// the winding number of each tetrahedron at the mean of its vertices, up to about 0.01. It is 0
  /// outside and 1 inside a closed surface, -1 inside if its triangles are oriented inwards, 2
  /// inside two overlapping parts, and between these values near gaps.
  std::vector<double> winding_numbers;

  /// the number of tetrahedra in doubt, whose winding number differs by more than 0.1 from every
  /// integer.
  std::size_t number_of_doubtful = 0;

  /// the number of tetrahedra inside more than one part: their winding number is above 1.5 or below
  /// -1.5.
  std::size_t number_of_multiple = 0;

  /// the volume of the tetrahedra in doubt divided by that of the tetrahedra inside.
  double doubtful_volume = 0;

  /// the number of faces that have been turned round, to agree with their neighbours.
  std::size_t number_of_turned = 0;

  /// the area of the faces that are no facets of the triangulation, divided by that of the surface.
  double missing_area = 0;

  /// a bound on the volume that may be wrong, divided by that of the tetrahedra inside and of what may
  /// be missing there. Of each tetrahedron that such faces pass through, it counts the parts beyond
  /// their planes, seen from its centre. It may be far too large for large tetrahedra outside.
  double crossed_volume = 0;

  /// the area of triangles that would close the openings, each from its middle, divided by that of
  /// the surface.
  double share_of_openings = 0;

  /// returns whether tetrahedron `c` is inside: its winding number is at least 1/2, or at most
  /// -1/2.
  bool operator[](std::size_t c) const { return std::abs(winding_numbers[c]) >= 0.5; }

  /// returns the fraction of the tetrahedra that are in doubt.
  double doubtful_share() const
  {
    return winding_numbers.empty() ? 0
                                   : double(number_of_doubtful) / double(winding_numbers.size());
  }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_3_H
