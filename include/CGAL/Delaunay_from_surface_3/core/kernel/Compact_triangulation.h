// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_TRIANGULATION_H

// Insertion by one thread, of points that may be left out.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/corners_around.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/nearest_vertex.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

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

public:
  using Location = Compact_location<Id>;

  // Of the vertices of `complex`, which has started. Keeps a reference.
  explicit Compact_triangulation(Complex& complex)
    : m_complex(complex)
    , m_inserter(complex)
  {
  }

  // Where vertex p, in no cell yet, goes, from cell `start`.
  Location locate(Id p, Id start) { return m_inserter.walk(p, start, Read_alone()); }

  // Puts p where a cell is in conflict with it. Returns p.
  Id insert(Id p, Id cell)
  {
    m_inserter.dig(p, cell);
    fill(p);
    return p;
  }

  // The same if accepts(v) for the vertex v nearest to p; else nothing changes, and v is returned.
  template <class Accepts>
  Id insert_if(Id p, Id cell, const Accepts& accepts)
  {
    m_inserter.dig(p, cell);
    const Id nearest = nearest_vertex_of_zone(m_complex, m_inserter.zone, p);
    if (!accepts(nearest)) {
      m_inserter.zone.revive(m_complex);
      return nearest;
    }
    fill(p);
    return p;
  }

  // While insert_if() asks: the corners of a cell that contains p.
  std::array<Id, 4> cell_of_zone(Id p) const
  {
    return corners_around(m_complex, m_inserter.zone, p);
  }

  const Insertion_counts& counts() const { return m_inserter.zone.counts; }

private:
  void fill(Id p)
  {
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(m_inserter.zone.is_dug(m_complex));
    m_inserter.fill(p);
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(m_inserter.zone.is_star(m_complex, p));
  }

  Complex& m_complex;
  Inserter<Alone_with_complex<Id>> m_inserter;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_TRIANGULATION_H
