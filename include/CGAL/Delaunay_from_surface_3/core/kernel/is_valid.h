// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_VALID_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_VALID_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_validity_level.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/are_links_spheres.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_delaunay.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Id>
bool are_links_spheres(const Compact_complex<Id>& complex)
{
  using Complex = Compact_complex<Id>;
  std::vector<Id> cells;
  for (std::size_t c = 0; c < complex.cells_end(); ++c)
    if (!Complex::is_dead(complex.cell(c)))
      cells.push_back(Id(c));
  return are_links_spheres<Id>(
      cells.size(), complex.vertices_end(),
      [&](std::size_t i, unsigned k) { return complex.cell(cells[i]).v[k]; }, Alone());
}

template <class Id>
bool are_finite_cells_positive(const Compact_complex<Id>& complex)
{
  using Complex = Compact_complex<Id>;
  const auto at = [&](Id v) { return complex.exact_coordinates(v); };
  for (std::size_t c = 0; c < complex.cells_end(); ++c) {
    const Compact_cell<Id>& cell = complex.cell(c);
    if (!Complex::is_dead(cell) && !Complex::is_infinite(cell) &&
        orientation(at(cell.v[0]), at(cell.v[1]), at(cell.v[2]), at(cell.v[3])) <= 0)
      return false;
  }
  return true;
}

// Checks as much as the level says. Linear.
template <class Id>
bool is_valid(const Compact_complex<Id>& complex, Delaunay_validity_level level)
{
  using Level = Delaunay_validity_level;
  return complex.is_valid() && (level < Level::EULER || are_links_spheres(complex)) &&
         (level < Level::ORIENTATION || are_finite_cells_positive(complex)) &&
         (level < Level::DELAUNAY || is_delaunay(complex));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_VALID_H
