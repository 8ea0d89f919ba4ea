// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_PARTITION_CELLS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_PARTITION_CELLS_H

// Puts the cells in place: the finite ones first, then the infinite ones, and none that is dead.
//
// A link names the facet of the neighbour, too. So a cell can be moved at any time: the four links
// that lead back to it are known, and no table from old to new numbers is needed. Linear, O(1)
// memory.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The cell at place c has come from elsewhere: its neighbours learn it.
template <class Id>
void link_back(Compact_complex<Id>& complex, Id c)
{
  for (unsigned i = 0; i < 4; ++i) {
    const Id there = complex.cell(c).links[i];
    complex.cell(there >> 2).links[there & 3] = Compact_complex<Id>::link(c, i);
  }
}

template <class Id>
void swap_cells(Compact_complex<Id>& complex, Id a, Id b)
{
  std::swap(complex.cell(a), complex.cell(b));
  const auto redirect = [&](Id here,
                            Id former) { // a cell at `here` that names itself meant the other
    for (Id& link : complex.cell(here).links)
      if ((link >> 2) == here)
        link = Compact_complex<Id>::link(former, link & 3);
  };
  redirect(a, b);
  redirect(b, a);
  link_back(complex, a);
  link_back(complex, b);
}

// Moves the last living cells to the places of dead ones. Returns the number of cells.
template <class Id>
std::size_t close_gaps(Compact_complex<Id>& complex)
{
  using Complex = Compact_complex<Id>;
  std::size_t end = complex.cells_end();
  for (std::size_t c = 0; c < end; ++c) {
    while (c < end && Complex::is_dead(complex.cell(c))) {
      --end;
      if (c < end && !Complex::is_dead(complex.cell(end))) {
        complex.cell(c) = complex.cell(end);
        link_back(complex, Id(c));
      }
    }
  }
  return end;
}

struct Numbers_of_cells
{
  std::size_t finite, all;
};

// The vertices' cells are not kept up to date.
template <class Id>
Numbers_of_cells partition_cells(Compact_complex<Id>& complex)
{
  using Complex = Compact_complex<Id>;
  const std::size_t all = close_gaps(complex);
  std::size_t finite = 0, infinite = all;
  while (true) {
    while (finite < infinite && !Complex::is_infinite(complex.cell(finite)))
      ++finite;
    while (finite < infinite && Complex::is_infinite(complex.cell(infinite - 1)))
      --infinite;
    if (finite == infinite)
      return {finite, all};
    swap_cells(complex, Id(finite), Id(infinite - 1));
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_PARTITION_CELLS_H
