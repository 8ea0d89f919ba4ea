// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COUNTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COUNTS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Insertion

names the stages of the predicates after the first floating-point filters, in the order in which
they are tried. Digits have 60 bits. A stage of integers applies if the differences of the points
are such integers times a power of 2.
*/
enum Exact_stage {
  LATTICE,               ///< doubles that round nothing, of points close together on a lattice.
  HALF_DIGIT,            ///< integers of 30 bits.
  ONE_DIGIT,             ///< integers of 60 bits.
  BALANCED,              ///< doubles, of points at very different distances or in a flat box.
  DOUBLE_DOUBLE,         ///< sums of two doubles, with a bound on their error.
  TWO_DIGITS,            ///< integers of 120 bits.
  ANY_WIDTH,             ///< integers of any width.
  NUMBER_OF_EXACT_STAGES ///< the number of stages.
};

/*!
\ingroup PkgDelaunayFromSurface3Insertion

counts what the insertions of the core did. The counts tell a good order from a bad one on any
machine. Most of the time is spent on what `cells_destroyed` and `sphere_tests` count.
*/
struct Insertion_counts
{
  /// sets all counts to 0.
  // NOLINTNEXTLINE(modernize-use-equals-default)
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Insertion_counts() {}

  /// cells tested until one in conflict was found, including that one (Fig.\ 1, line 2b).
  std::size_t cells_tested_to_start = 0;

  /// cells in conflict with the points inserted (line 2c).
  std::size_t cells_destroyed = 0;

  /// cells of the stars that replaced them.
  std::size_t cells_created = 0;

  /// tests of neighbours of cells in conflict.
  std::size_t sphere_tests = 0;

  /// tests against spheres that floating point left open, by the stage that decided them.
  std::size_t sphere_tests_by_stage[NUMBER_OF_EXACT_STAGES] = {};

  /// tests against facets of the convex hull that floating point left open, by the stage.
  std::size_t facet_tests_by_stage[NUMBER_OF_EXACT_STAGES] = {};

  /// tests of these kinds whose sign was 0 and had to be perturbed.
  std::size_t perturbed = 0;

  /// insertions that were withdrawn because of another thread, before any change, and tried again.
  /// Their tests, and the cells that they would have destroyed, are included in the other counts.
  std::size_t clashes = 0;

  /// points that were tried several times in vain, and left to the calling thread.
  std::size_t put_off = 0;

  /// adds the counts of another worker.
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Insertion_counts&
  operator+=(const Insertion_counts& other)
  {
    cells_tested_to_start += other.cells_tested_to_start;
    cells_destroyed += other.cells_destroyed;
    cells_created += other.cells_created;
    sphere_tests += other.sphere_tests;
    for (int stage = 0; stage < NUMBER_OF_EXACT_STAGES; ++stage) {
      sphere_tests_by_stage[stage] += other.sphere_tests_by_stage[stage];
      facet_tests_by_stage[stage] += other.facet_tests_by_stage[stage];
    }
    perturbed += other.perturbed;
    clashes += other.clashes;
    put_off += other.put_off;
    return *this;
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COUNTS_H
