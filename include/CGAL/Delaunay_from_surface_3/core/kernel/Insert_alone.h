// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERT_ALONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERT_ALONE_H

// Inserts a chunk of a round of Choi 2002, Fig. 1, lines 2b and 2c, in the thread that calls it.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Vertex>
class Insert_alone
{
  using Complex = Compact_complex<Vertex>;
  using Phase = Surface_insertion_phase;

public:
  // Keeps references.
  Insert_alone(Ordered_complex<Vertex>& points, const Executor&, Observer& observer)
    : m_points(points)
    , m_observer(observer)
    , m_inserter(points.complex)
    , m_follows_points(observer.follows_points())
    , m_starting_cells(points.starting_cells())
  {
  }

  // Returns how many points the next chunk should have.
  static constexpr std::size_t size_of_chunk(std::size_t /* inserted */) { return 256; }
  static constexpr std::size_t number_of_threads() { return 1; }

  // Inserts the points at the places first, …, last - 1; returns false if the observer stopped it.
  bool operator()(std::size_t first, std::size_t last)
  {
    if (!m_observer.go_further(first))
      return false;
    for (std::size_t k = first; k < last; ++k) {
      const Id p = Complex::vertex_of_point(k);
      Id& vertex = m_points.vertices[k];
      if (vertex != p) { // it is not one of the first four
        begin(Phase::LOCATION);
        const Id start = m_starting_cells.start(k);
        CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(!Complex::is_dead(m_points.complex.cell(start)));
        const auto location = m_inserter.walk(p, start, Read_alone()); // 2b
        begin(Phase::UPDATE);
        vertex = location.vertex;              // the vertex of an equal point, if there is one
        if (Vertex::has_weight && vertex == p) // hidden; other walks start there
          m_points.complex.vertex(p).cell = location.cell;
        if (vertex == 0) { // 2c
          m_inserter.dig(p, location.cell);
          CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(m_inserter.zone.is_dug(m_points.complex));
          m_inserter.fill(p);
          CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(
              m_inserter.zone.is_star(m_points.complex, p));
          vertex = p;
        }
      }
      m_starting_cells.after_update(k, vertex);
    }
    return true;
  }

  // To be called when all points are inserted.
  void finish() {}

  const Insertion_counts& counts() const { return m_inserter.zone.counts; }

private:
  void begin(Phase phase)
  {
    if (m_follows_points)
      m_observer.phase_begins(phase, 0);
  }

  Ordered_complex<Vertex>& m_points;
  Observer& m_observer;
  Inserter<Alone_with_complex<Vertex>> m_inserter;
  const bool m_follows_points;
  Starting_cells<Vertex> m_starting_cells;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERT_ALONE_H
