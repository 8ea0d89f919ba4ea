// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERT_ALONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERT_ALONE_H

// One piece of a round of Choi 2002, Fig. 1, lines 2b and 2c, by the thread that calls it.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether a cell contains p, its boundary included, or, if it is infinite, p lies beyond its facet.
template <class Id>
bool is_around(const Compact_complex<Id>& complex, const std::array<Id, 4>& v, Id p)
{
  const bool is_infinite = v[3] == complex.infinite;
  for (std::size_t k = is_infinite ? 3 : 0; k < 4; ++k) {
    const double* q[4]; // p in the place of a corner
    for (std::size_t i = 0; i < 4; ++i)
      q[i] = complex.exact_coordinates(i == k ? p : v[i]);
    if (orientation(q[0], q[1], q[2], q[3]) < int(is_infinite))
      return false;
  }
  return true;
}

// The corners of a cell around p, whose zone of conflict is dug. Every cell that contains p is in the
// zone, and if none does, so is one beyond whose facet p lies. Exact; O(cells of the zone).
template <class Id>
std::array<Id, 4> corners_around(const Compact_complex<Id>& complex, const Conflict_zone<Id>& zone,
                                 Id p)
{
  using Complex = Compact_complex<Id>;
  for (const bool is_infinite : {false, true})
    for (std::size_t k = 0; k < zone.number_of_cells; ++k) {
      const Compact_cell<Id>& cell = complex.cell(zone.cells[k]);
      const std::array<Id, 4> v = {Complex::first_vertex(cell), cell.v[1], cell.v[2], cell.v[3]};
      if (Complex::is_infinite(cell) == is_infinite && is_around(complex, v, p))
        return v;
    }
  fail("a point lies in a cell, or beyond a facet of the hull");
}

// Insertion by one thread, of points that may be left out.

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

template <class Id>
class Insert_alone
{
  using Complex = Compact_complex<Id>;
  using Phase = Surface_insertion_phase;

public:
  // Keeps references.
  Insert_alone(Ordered_complex<Id>& points, const Executor&, Watcher& watcher)
    : m_points(points)
    , m_watcher(watcher)
    , m_triangulation(points.complex)
    , m_follows_points(watcher.follows_points())
    , m_leaves_points_out(watcher.leaves_points_out())
    , m_looks_at_corners(watcher.looks_at_corners())
    , m_starts(m_leaves_points_out ? points.vertex_of : std::vector<Id>())
    , m_starting_cells(points.starting_cells(m_leaves_points_out ? m_starts : points.vertex_of))
  {
  }
  Insert_alone(const Insert_alone&) = delete; // m_starting_cells refers to m_starts
  Insert_alone& operator=(const Insert_alone&) = delete;

  // How many points the next piece should have.
  static constexpr std::size_t size_of_piece(std::size_t /* inserted */) { return 256; }
  static constexpr std::size_t number_of_threads() { return 1; }

  // Inserts the points at the places first, …, last - 1; false if the watcher stopped it.
  bool operator()(std::size_t first, std::size_t last)
  {
    if (!m_watcher.go_further(first))
      return false;
    for (std::size_t k = first; k < last; ++k)
      if (!m_points.has_left_out(k))
        insert(k);
    return true;
  }

  // To be called when all is inserted.
  void finish() {}

  const Insertion_counts& counts() const { return m_triangulation.counts(); }

private:
  void insert(std::size_t k)
  {
    const Id p = Complex::vertex_of_point(k);
    Id& vertex = m_points.vertex_of[k];
    if (vertex != p) { // it is none of the first four
      begin(Phase::LOCATION);
      const Id start = m_starting_cells.start(k);
      CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(!Complex::is_dead(m_points.complex.cell(start)));
      const auto location = m_triangulation.locate(p, start); // 2b
      begin(Phase::UPDATE);
      vertex = location.vertex; // that of an equal point, if there is one
      if (vertex == 0 && may_be_left_out(k))
        return insert_if_accepted(k, location.cell);
      if (vertex == 0)
        vertex = m_triangulation.insert(p, location.cell); // 2c
    }
    after_update(k, vertex);
  }

  void after_update(std::size_t k, Id vertex)
  {
    if (m_leaves_points_out)
      m_starts[k] = vertex;
    m_starting_cells.after_update(k, vertex);
  }

  bool may_be_left_out(std::size_t k) const { return m_leaves_points_out && !m_points.is_known(k); }

  void insert_if_accepted(std::size_t k, Id cell)
  {
    const Id p = Complex::vertex_of_point(k);
    const Id v = m_triangulation.insert_if(p, cell, [&](Id nearest) {
      return m_watcher.accepts(name_of(p), name_of(nearest), corners_of(p));
    });
    m_points.vertex_of[k] = v == p ? p : 0;
    after_update(k, v);
  }

  // The caller's number of the point of a vertex.
  std::size_t name_of(Id v) const
  {
    return v == Complex::infinite ? Watcher::none
                                  : m_points.order.order[Complex::point_of_vertex(v)];
  }

  // The corners of a cell that contains p, whose conflict zone is dug.
  Watcher::Corners corners_of(Id p) const
  {
    if (!m_looks_at_corners)
      return {Watcher::none, Watcher::none, Watcher::none, Watcher::none};
    const std::array<Id, 4> v = m_triangulation.cell_of_zone(p);
    return {name_of(v[0]), name_of(v[1]), name_of(v[2]), name_of(v[3])};
  }

  void begin(Phase phase)
  {
    if (m_follows_points)
      m_watcher.phase_begins(phase);
  }

  Ordered_complex<Id>& m_points;
  Watcher& m_watcher;
  Compact_triangulation<Id> m_triangulation;
  const bool m_follows_points, m_leaves_points_out, m_looks_at_corners;
  // By place, where points are left out: the vertex of the point or the nearest one, from which
  // others start. A search through all that were left out before could be as long as there are points.
  std::vector<Id> m_starts;
  Starting_cells<Id> m_starting_cells;
};

template <>
struct Inserter_of<One_thread>
{
  template <class Id>
  using type = Insert_alone<Id>;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERT_ALONE_H
