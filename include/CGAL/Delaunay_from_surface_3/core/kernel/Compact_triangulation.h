// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_TRIANGULATION_H

// Insertion (Bowyer 1981; Watson 1981) on numbered cells: walk to a conflict, dig the conflict
// zone, fill the star (Choi 2002, Fig. 1, lines 2b and 2c). Each of the three has a header of its
// own.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Fill_star.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Wide_explore_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Wide_sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/corners_around.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/nearest_vertex.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Id: an unsigned type for the numbers.
template <class Id>
class Compact_triangulation
{
  using Complex = Compact_complex<Id>;
  using Predicates = Compact_predicates<Id>;

public:
  using Location = Compact_location<Id>;

  // Of the vertices of `complex`, which has started. Keeps a reference.
  explicit Compact_triangulation(Complex& complex)
    : m_complex(complex)
  {
  }
  Compact_triangulation(const Compact_triangulation&) = delete;

  // Where vertex p, in no cell yet, goes, from cell `start`.
  Location locate(Id p, Id start) { return walk(p, start); }

  // Puts p where a cell is in conflict with it. Returns p.
  Id insert(Id p, Id cell)
  {
    dig(p, cell);
    fill(p);
    return p;
  }

  // The same if accepts(v) for the vertex v nearest to p; else nothing changes, and v is returned.
  template <class Accepts>
  Id insert_if(Id p, Id cell, const Accepts& accepts)
  {
    dig(p, cell);
    const Id nearest = nearest_vertex_of_zone(m_complex, m_zone, p);
    if (!accepts(nearest)) {
      m_zone.revive(m_complex);
      return nearest;
    }
    fill(p);
    return p;
  }

  // While insert_if() asks: the corners of a cell that contains p.
  std::array<Id, 4> cell_of_zone(Id p) const { return corners_around(m_complex, m_zone, p); }

  const Insertion_counts& counts() const { return m_zone.counts; }

private:
  Location walk(Id p, Id start)
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (m_is_wide)
      return Walk_to_conflict<Wide_sphere_filter>()(m_complex, m_predicates, p, start);
#endif
    return Walk_to_conflict<Sphere_filter>()(m_complex, m_predicates, p, start);
  }

  void dig(Id p, Id cell)
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (m_is_wide) {
      Dig_conflict_zone<Widest_explore_neighbors<Id>>()(m_complex, m_predicates, m_zone, p, cell);
      return;
    }
#endif
    Dig_conflict_zone<Explore_neighbors>()(m_complex, m_predicates, m_zone, p, cell);
  }

  void fill(Id p)
  {
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(m_zone.is_dug(m_complex));
    m_fill_star(m_complex, m_zone, p);
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(m_zone.is_star(m_complex, p));
  }

  Complex& m_complex;
  Conflict_zone<Id> m_zone;
  Predicates m_predicates{m_complex, m_zone.counts};
  Fill_star<Id> m_fill_star;
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  const bool m_is_wide = machine_has_vectors();
#endif
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_TRIANGULATION_H
