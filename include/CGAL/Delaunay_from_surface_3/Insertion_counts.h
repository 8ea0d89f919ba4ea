// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COUNTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COUNTS_H

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Insertion

says what the insertions of an `InsertionTarget_3` did. It tells a good order from a bad one on any
machine: times are proportional to `sphere_tests`, but for exact arithmetic.
*/
struct Insertion_counts
{
  /// cells looked at until one in conflict was found, that one included (Fig.\ 1, line 2b).
  std::size_t cells_tested_to_start = 0;

  /// cells in conflict with the points inserted (line 2c).
  std::size_t cells_destroyed = 0;

  /// cells of the stars that took their place.
  std::size_t cells_created = 0;

  /// tests of neighbours of cells in conflict.
  std::size_t sphere_tests = 0;

  /// sphere tests that the first filter left open.
  std::size_t first_failures = 0;

  /// sphere tests that all filters left open.
  std::size_t second_failures = 0;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COUNTS_H
