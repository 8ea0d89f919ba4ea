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

says which tetrahedra lie inside a surface: what `inside_of_surface_3()` returns.
*/
struct Inside_3
{
  /// of each tetrahedron, at the mean of its corners, up to about 0.01: 0 outside and 1 inside a
  /// closed surface, -1 where its triangles are turned inwards, 2 inside two parts that overlap,
  /// and numbers between these near gaps.
  std::vector<double> winding_numbers;

  /// how many tetrahedra have a number that differs by more than 0.1 from all whole ones.
  std::size_t number_of_doubtful = 0;

  /// how many lie inside more than one part: their number is above 1.5, or below -1.5.
  std::size_t number_of_multiple = 0;

  /// the volume of the tetrahedra with such doubtful numbers, over that of those inside.
  double doubtful_volume = 0;

  /// the area of triangles that would close the openings, each from its middle, over that of the
  /// surface.
  double share_of_openings = 0;

  /// returns whether tetrahedron `c` counts as inside: its number is at least 1/2, or at most -1/2.
  bool operator[](std::size_t c) const { return std::abs(winding_numbers[c]) >= 0.5; }

  /// returns the share of the tetrahedra that are doubtful.
  double doubtful_share() const
  {
    return winding_numbers.empty() ? 0
                                   : double(number_of_doubtful) / double(winding_numbers.size());
  }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_3_H
