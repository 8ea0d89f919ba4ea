// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_CONFLICT_ZONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_CONFLICT_ZONE_H

// The working memory of one insertion, kept for the next: all that a thread that inserts has for
// itself. The complex is shared, this is not.

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A facet of the zone's boundary: the link of the cell outside, and the corners, such that
// (p, corners) is positive for p in the zone.
template <class Id>
struct Zone_facet
{
  Id outside;
  Id corners[3];
};

template <class Id>
struct Conflict_zone
{
  // The first number_of_cells and number_of_facets are filled; the rest is room. The cells are
  // those in conflict, in the order in which they were found; after the fill, those of the star.
  std::vector<Id> cells;
  std::vector<Zone_facet<Id>> facets;
  std::size_t number_of_cells = 0;
  std::size_t number_of_facets = 0;

  std::vector<Id> free_cells; // dead, and in no zone
  Insertion_counts counts;

  Conflict_zone() { make_room(64); }

  // For a zone of n cells, which has at most 2 n + 2 facets; four of either can be written beyond.
  // Both arrays grow together: has_room() is asked at every cell, and looks at one number.
  void make_room(std::size_t n)
  {
    cells.resize(n + 4);
    facets.resize(2 * n + 8);
    m_room = n;
  }
  bool has_room(std::size_t n) const { return n <= m_room; }
  std::size_t room() const { return m_room; }

  // Takes as many cells as there are facets, for the star: first the dead ones, then free ones,
  // then new ones. The complex may move its cells.
  void take_cells_of_star(Compact_complex<Id>& complex)
  {
    if (!has_room(number_of_facets))
      make_room(2 * number_of_facets);
    while (number_of_cells < number_of_facets)
      cells[number_of_cells++] = take_cell(complex);
    for (std::size_t k = number_of_facets; k < number_of_cells; ++k)
      free_cells.push_back(cells[k]);
    number_of_cells = number_of_facets;
  }

  // The cells were dug out by Explore_alone, and live again.
  void revive(Compact_complex<Id>& complex)
  {
    for (std::size_t k = 0; k < number_of_cells; ++k)
      complex.cell(cells[k]).v[0] = Compact_complex<Id>::first_vertex(complex.cell(cells[k]));
    counts.cells_destroyed -= number_of_cells;
    counts.cells_created -= number_of_facets;
  }

  // After the dig: whether its cells are dead, and those around it not. These surround it as a
  // sphere, whose edges belong to two facets each.
  bool is_dug(const Compact_complex<Id>& complex) const
  {
    using Complex = Compact_complex<Id>;
    for (std::size_t k = 0; k < number_of_cells; ++k)
      if (!Complex::is_dead(complex.cell(cells[k])))
        return false;
    for (std::size_t f = 0; f < number_of_facets; ++f)
      if (Complex::is_dead(complex.cell(facets[f].outside >> 2)))
        return false;
    return number_of_cells > 0 && number_of_facets >= 4 && number_of_facets % 2 == 0;
  }

  // After the fill: whether all its cells live, have vertex p, and lead to neighbours that lead
  // back.
  bool is_star(const Compact_complex<Id>& complex, Id p) const
  {
    using Complex = Compact_complex<Id>;
    for (std::size_t k = 0; k < number_of_cells; ++k) {
      const Compact_cell<Id>& cell = complex.cell(cells[k]);
      if (Complex::is_dead(cell) || std::find(cell.v, cell.v + 4, p) == cell.v + 4)
        return false;
      for (unsigned i = 0; i < 4; ++i)
        if (complex.cell(cell.links[i] >> 2).links[cell.links[i] & 3] != Complex::link(cells[k], i))
          return false;
    }
    return true;
  }

private:
  Id take_cell(Compact_complex<Id>& complex)
  {
    if (free_cells.empty())
      return complex.new_cell();
    const Id c = free_cells.back();
    free_cells.pop_back();
    return c;
  }

  std::size_t m_room = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_CONFLICT_ZONE_H
