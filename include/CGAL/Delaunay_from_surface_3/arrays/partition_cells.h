// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_PARTITION_CELLS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_PARTITION_CELLS_H

// Puts the cells in place: the finite ones first, then the infinite ones, and none that is dead.
//
// A link names the facet of the neighbour, too. So a cell can be moved at any time: the four links
// that lead back to it are known, and no table from old to new numbers is needed. Linear, O(1)
// memory.

#include <CGAL/Delaunay_from_surface_3/core/interface/Compact_cell.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The cell at place c has come from elsewhere: its neighbours learn it.
template <class Id>
void link_back(Compact_cell<Id>* cells, Id c)
{
  for (unsigned i = 0; i < 4; ++i) {
    const Id there = cells[c].links[i];
    cells[there >> 2].links[there & 3] = Compact_numbers<Id>::link(c, i);
  }
}

template <class Id>
void swap_cells(Compact_cell<Id>* cells, Id a, Id b)
{
  std::swap(cells[a], cells[b]);
  const auto redirect = [&](Id here,
                            Id former) { // a cell at `here` that names itself meant the other
    for (Id& link : cells[here].links)
      if ((link >> 2) == here)
        link = Compact_numbers<Id>::link(former, link & 3);
  };
  redirect(a, b);
  redirect(b, a);
  link_back(cells, a);
  link_back(cells, b);
}

// Moves the last living cells to the places of dead ones. Returns the number of cells.
template <class Id>
std::size_t close_gaps(Compact_cell<Id>* cells, std::size_t end)
{
  using Numbers = Compact_numbers<Id>;
  for (std::size_t c = 0; c < end; ++c) {
    while (c < end && Numbers::is_dead(cells[c])) {
      --end;
      if (c < end && !Numbers::is_dead(cells[end])) {
        cells[c] = cells[end];
        link_back(cells, Id(c));
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
Numbers_of_cells partition_cells(Compact_cell<Id>* cells, std::size_t end)
{
  using Numbers = Compact_numbers<Id>;
  const std::size_t all = close_gaps(cells, end);
  std::size_t finite = 0, infinite = all;
  while (true) {
    while (finite < infinite && !Numbers::is_infinite(cells[finite]))
      ++finite;
    while (finite < infinite && Numbers::is_infinite(cells[infinite - 1]))
      --infinite;
    if (finite == infinite)
      return {finite, all};
    swap_cells(cells, Id(finite), Id(infinite - 1));
  }
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_PARTITION_CELLS_H
