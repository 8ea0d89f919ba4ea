// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_DELAUNAY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_DELAUNAY_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether no cell is in conflict with the vertex across a facet; links and vertices are right.
// Linear.
template <class Id>
bool is_delaunay(const Compact_complex<Id>& complex)
{
  using Complex = Compact_complex<Id>;
  Insertion_counts uncounted;
  Compact_predicates<Id> predicates(complex, uncounted);
  for (std::size_t c = 0; c < complex.cells_end(); ++c) {
    const Compact_cell<Id>& cell = complex.cell(c);
    for (unsigned k = 0; !Complex::is_dead(cell) && k < 4; ++k) {
      const Id across = complex.cell(cell.links[k] >> 2).v[cell.links[k] & 3];
      if (across != Complex::infinite && predicates.is_in_conflict(cell, across))
        return false;
    }
  }
  return true;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_DELAUNAY_H
