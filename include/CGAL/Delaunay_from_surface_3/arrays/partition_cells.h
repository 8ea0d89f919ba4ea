// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_PARTITION_CELLS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_PARTITION_CELLS_H

// Puts the cells in place: the finite ones first, then the infinite ones, and none that is dead.
//
// A link names the facet of the neighbour, too. So a cell can be moved at any time: the four links
// that lead back to it are known, and no table from old to new numbers is needed. Several threads
// look for the cells that may have to move, the dead and the infinite ones, which are few where the
// points are those of a surface or fill a volume; one moves them. Linear.

#include <CGAL/Delaunay_from_surface_3/core/interface/Compact_cell.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The cell at place c has been moved there: sets the links of its neighbours.
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

// Those of the cells 0, …, n - 1 for which `is` holds, in ascending order.
template <class Id, class Is>
std::vector<Id> cells_that(const Compact_cell<Id>* cells, std::size_t n, const Is& is,
                           const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, n, 65536);
  std::vector<std::vector<Id>> found(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    for (std::size_t c = first; c < last; ++c)
      if (is(cells[c]))
        found[b].push_back(Id(c));
  });
  for (std::size_t b = 1; b < blocks; ++b)
    found[0].insert(found[0].end(), found[b].begin(), found[b].end());
  return std::move(found[0]);
}

// Moves the last living cells to the places of dead ones. Returns the number of cells.
template <class Id>
std::size_t close_gaps(Compact_cell<Id>* cells, std::size_t end, const Executor& executor)
{
  using Numbers = Compact_numbers<Id>;
  const std::vector<Id> dead = cells_that(
      cells, end, [](const auto& c) { return Numbers::is_dead(c); }, executor);
  const std::size_t all = end - dead.size();
  auto gap = dead.begin();
  for (std::size_t c = all; c < end; ++c)
    if (!Numbers::is_dead(cells[c])) {
      const Id to = *gap++;
      cells[to] = cells[c];
      link_back(cells, to);
    }
  return all;
}

struct Numbers_of_cells
{
  std::size_t finite, all;
};

// Vertices keep their old cells.
template <class Id>
Numbers_of_cells partition_cells(Compact_cell<Id>* cells, std::size_t end, const Executor& executor)
{
  using Numbers = Compact_numbers<Id>;
  const std::size_t all = close_gaps(cells, end, executor);
  const std::vector<Id> infinite = cells_that(
      cells, all, [](const auto& c) { return Numbers::is_infinite(c); }, executor);
  const std::size_t finite = all - infinite.size();
  std::size_t place = finite;
  for (const Id c : infinite) {
    if (c >= finite)
      break;
    while (Numbers::is_infinite(cells[place]))
      ++place;
    swap_cells(cells, c, Id(place++));
  }
  return {finite, all};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_PARTITION_CELLS_H
