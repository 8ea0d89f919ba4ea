// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_CORNERS_AROUND_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_CORNERS_AROUND_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/support/fail.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether a cell contains p, its boundary included, or, if it is infinite, p lies beyond its facet.
template <class Id>
bool is_around(const Compact_complex<Id>& complex, const std::array<Id, 4>& v, Id p)
{
  const bool is_infinite = v[3] == complex.infinite;
  for (std::size_t k = is_infinite ? 3 : 0; k < 4; ++k) {
    const double* q[4]; // p in the place of a corner
    for (std::size_t i = 0; i < 4; ++i)
      q[i] = complex.exact_coordinates(i == k ? p : v[i]);
    if (orientation(q[0], q[1], q[2], q[3]) < int(is_infinite))
      return false;
  }
  return true;
}

// The corners of a cell around p, whose zone of conflict is dug. Every cell that contains p is in the
// zone, and if none does, so is one beyond whose facet p lies. Exact; O(cells of the zone).
template <class Id>
std::array<Id, 4> corners_around(const Compact_complex<Id>& complex, const Conflict_zone<Id>& zone,
                                 Id p)
{
  using Complex = Compact_complex<Id>;
  for (const bool is_infinite : {false, true})
    for (std::size_t k = 0; k < zone.number_of_cells; ++k) {
      const Compact_cell<Id>& cell = complex.cell(zone.cells[k]);
      const std::array<Id, 4> v = {Complex::first_vertex(cell), cell.v[1], cell.v[2], cell.v[3]};
      if (Complex::is_infinite(cell) == is_infinite && is_around(complex, v, p))
        return v;
    }
  fail("a point lies in a cell, or beyond a facet of the hull");
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_CORNERS_AROUND_H
