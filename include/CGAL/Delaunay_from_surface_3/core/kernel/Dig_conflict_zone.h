// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DIG_CONFLICT_ZONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DIG_CONFLICT_ZONE_H

// Choi 2002, Fig. 1, line 2c, first half: the cells in conflict with the new point, and the
// boundary of what they fill (Bowyer 1981; Watson 1981). They are connected, so they are dug out
// breadth first from one of them; the queue is the list of the cells found.
//
// Invariant: the cells found are dead, no others have died.
// Cost: O(cells in conflict).

#include <CGAL/Delaunay_from_surface_3/core/kernel/Conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Explore_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/inlining.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Explore: how cells are read and their neighbours looked at, scalar or in vectors, and beside
// others who write (Explore_announced.h) or alone.
template <class Explore>
struct Dig_conflict_zone
{
  // Fills the zone of point p from the cell `first`, which is in conflict with it. Returns whether
  // that succeeded: alone it does.
  template <class Id, class Predicates, class Zone>
  bool operator()(Compact_complex<Id>& complex, Predicates& predicates, Zone& zone, Id p, Id first,
                  Explore explore = Explore()) const
  {
    zone.cells[0] = first;
    zone.number_of_cells = 1;
    zone.number_of_facets = 0;
    explore.mark(complex.cells(), first);
    for (std::size_t k = 0; k < zone.number_of_cells; ++k) {
      if (!zone.has_room(zone.number_of_cells + 4)) {
        if (!explore.is_still_true(complex.cells(), k))
          return false;
        grow(zone);
      }
      if (k + 1 < zone.number_of_cells)
        for (const Id& link : complex.cell(zone.cells[k + 1]).links)
          prefetch(&complex.cell(load_relaxed(link) >> 2)); // others may write it
      look_around(complex, predicates, zone, p, explore.read(complex.cells(), zone.cells[k], k),
                  explore);
      if (explore.is_torn())
        return false;
    }
    zone.counts.sphere_tests += zone.number_of_cells - 1 + zone.number_of_facets;
    zone.counts.cells_destroyed += zone.number_of_cells;
    zone.counts.cells_created += zone.number_of_facets;
    return true;
  }

private:
  template <class Zone>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART static void grow(Zone& zone)
  {
    zone.make_room(2 * zone.room());
  }

  // Tests the neighbours of a cell in conflict. The ends are kept in the zone: in registers, around
  // a loop that holds all of this, one thread gains a little, and two lose more.
  template <class Id, class Predicates, class Zone>
  static void look_around(Compact_complex<Id>& complex, Predicates& predicates, Zone& zone, Id p,
                          const Compact_cell<Id>& cell, Explore& explore)
  {
    auto around =
        explore.around(complex.cells(), complex.vertices(), cell, complex.vertex(p).coordinates);
    if (around.undecided != 0)
      around.inside |= undecided_conflicts(complex, predicates, cell, around.undecided, p, explore);
    const Zone_ends<Id> ends =
        explore.note(complex.cells(), cell, around,
                     Zone_ends<Id>{zone.cells.data() + zone.number_of_cells,
                                   zone.facets.data() + zone.number_of_facets});
    zone.number_of_cells = std::size_t(ends.cell - zone.cells.data());
    zone.number_of_facets = std::size_t(ends.facet - zone.facets.data());
  }

  // Of the neighbours that the filter left undecided, those in conflict.
  template <class Id, class Predicates>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART static unsigned
  undecided_conflicts(const Compact_complex<Id>& complex, Predicates& predicates,
                      const Compact_cell<Id>& cell, unsigned undecided, Id p, Explore& explore)
  {
    using Complex = Compact_complex<Id>;
    unsigned inside = 0;
    for (unsigned k = 0; k < 4; ++k)
      if (undecided >> k & 1) {
        const Compact_cell<Id>& neighbor = explore.neighbor(complex.cells(), cell, k);
        if (explore.is_torn())
          break;
        const bool is_filtered = !Complex::is_infinite(cell) && !Complex::is_infinite(neighbor);
        inside |= unsigned(is_filtered ? predicates.is_in_close_sphere(neighbor, p)
                                       : predicates.is_in_conflict(neighbor, p))
                  << k;
      }
    return inside;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DIG_CONFLICT_ZONE_H
