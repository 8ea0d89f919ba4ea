// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXPLORE_NEIGHBORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXPLORE_NEIGHBORS_H

// One step of the search for the conflict zone (Choi 2002, Fig. 1, line 2c): the neighbours of a
// cell in conflict that are in conflict too join the zone, the facets towards the others join its
// boundary.
//
// Which it is cannot be predicted, so there are no branches: what is found is written behind the
// end, and the end moves on or not.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/inlining.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Where the next cell in conflict and the next facet of the boundary are written. There is room for
// four more of either.
template <class Id>
struct Zone_ends
{
  Id* cell;
  Zone_facet<Id>* facet;
};

// A bit for each neighbour of a cell in conflict.
struct Neighborhood
{
  unsigned open;      // not known to be in conflict before
  unsigned inside;    // of these: in conflict
  unsigned undecided; // of these: the filter cannot tell

  unsigned bounding() const { return open & ~inside; } // when all is decided
};

// By the signs of the filter, which was asked about those `filtered`.
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Neighborhood neighborhood(unsigned open,
                                                                     unsigned filtered,
                                                                     const Sphere_signs& signs)
{
  const unsigned decided = filtered & (signs.inside | signs.outside);
  return {open, signs.inside & filtered, open & ~decided};
}

// Scalar code for any machine and any Id, where no other thread writes: cells are read where they
// are, and marked as dead when they join the zone.
struct Explore_alone
{
  template <class Id>
  static void mark(Compact_cell<Id>* cells, Id c)
  {
    cells[c].v[0] |= Compact_complex<Id>::dead;
  }
  template <class Id>
  static const Compact_cell<Id>& read(const Compact_cell<Id>* cells, Id c, std::size_t)
  {
    return cells[c];
  }
  template <class Id>
  static const Compact_cell<Id>& neighbor(const Compact_cell<Id>* cells,
                                          const Compact_cell<Id>& cell, unsigned k)
  {
    return cells[cell.links[k] >> 2];
  }
  template <class Id>
  static constexpr bool is_still_true(const Compact_cell<Id>*, std::size_t)
  {
    return true;
  }
  static constexpr bool is_torn() { return false; }
};

struct Explore_neighbors : Explore_alone
{
  // What is known of the cell's neighbours. Infinite cells are left undecided.
  template <class Id>
  static Neighborhood around(const Compact_cell<Id>* cells, const Compact_vertex<Id>* vertices,
                             const Compact_cell<Id>& cell, const double* p)
  {
    using Complex = Compact_complex<Id>;
    unsigned open = 0, infinite = Complex::is_infinite(cell) ? 15 : 0;
    const double *v[4], *opposite[4];
    for (unsigned k = 0; k < 4; ++k) {
      const Compact_cell<Id>& neighbor = cells[cell.links[k] >> 2];
      const Id e = neighbor.v[cell.links[k] & 3] & Id(~Complex::dead);
      open |= unsigned(!Complex::is_dead(neighbor)) << k;
      infinite |= unsigned(e == Complex::infinite) << k;
      opposite[k] = vertices[e].coordinates;
      v[k] = vertices[cell.v[k] & Id(~Complex::dead)].coordinates;
    }
    const unsigned filtered = open & ~infinite;
    if (filtered == 0)
      return {open, 0, open};
    const Sphere_signs signs = Sphere_filter::neighbors(v, opposite, p, filtered);
    return neighborhood(open, filtered, signs);
  }

  // Writes down the neighbours inside, and the facets that bound.
  template <class Id>
  static Zone_ends<Id> note(Compact_cell<Id>* cells, const Compact_cell<Id>& cell,
                            const Neighborhood& around, Zone_ends<Id> ends)
  {
    const Id v[4] = {Compact_complex<Id>::first_vertex(cell), cell.v[1], cell.v[2], cell.v[3]};
    for (unsigned k = 0; k < 4; ++k) {
      const Id link = cell.links[k], joins = Id(around.inside >> k & 1);
      cells[link >> 2].v[0] |= Id(joins << (std::numeric_limits<Id>::digits - 1));
      *ends.cell = link >> 2;
      ends.cell += joins;
      *ends.facet = {link,
                     {v[facet_corners[k][0]], v[facet_corners[k][1]], v[facet_corners[k][2]]}};
      ends.facet += around.bounding() >> k & 1;
    }
    return ends;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_EXPLORE_NEIGHBORS_H
