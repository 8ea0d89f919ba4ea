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
    using Complex = Compact_complex<Id>;
    auto* const cells = complex.cells();
    auto* const vertices = complex.vertices();
    const double* const coordinates = vertices[p].coordinates;
    zone.cells[0] = first;
    explore.mark(cells, first);
    Zone_ends<Id> ends = {zone.cells.data() + 1, zone.facets.data()};
    const Id* full = last_with_room(zone);
    for (const Id* next = zone.cells.data(); next != ends.cell; ++next) {
      if (ends.cell > full) {
        const std::size_t k = std::size_t(next - zone.cells.data());
        set_ends(zone, ends);
        if (!explore.is_still_true(cells, k))
          return false;
        zone.make_room(2 * zone.room());
        next = zone.cells.data() + k;
        ends = {zone.cells.data() + zone.number_of_cells,
                zone.facets.data() + zone.number_of_facets};
        full = last_with_room(zone);
      }
      if (next + 1 != ends.cell)
        for (const Id& link : cells[next[1]].links) // others may write it
          prefetch(&Complex::cell_of_link(cells, load_relaxed(link)));
      const Compact_cell<Id>& cell =
          explore.read(cells, *next, std::size_t(next - zone.cells.data()));
      auto around = explore.around(cells, vertices, cell, coordinates);
      if (around.undecided != 0)
        around.inside |=
            undecided_conflicts(complex, predicates, cell, around.undecided, p, explore);
      ends = explore.note(cells, cell, around, ends);
      if (explore.is_torn())
        break;
    }
    set_ends(zone, ends);
    if (explore.is_torn())
      return false;
    zone.counts.sphere_tests += zone.number_of_cells - 1 + zone.number_of_facets;
    zone.counts.cells_destroyed += zone.number_of_cells;
    zone.counts.cells_created += zone.number_of_facets;
    return true;
  }

private:
  template <class Zone>
  static auto last_with_room(const Zone& zone)
  {
    return zone.cells.data() + zone.room() - 4;
  }

  template <class Zone, class Id>
  static void set_ends(Zone& zone, const Zone_ends<Id>& ends)
  {
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
