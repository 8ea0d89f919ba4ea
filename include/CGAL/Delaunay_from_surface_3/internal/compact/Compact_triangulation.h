// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_TRIANGULATION_H

// Bowyer and Watson's insertion on numbered cells (Choi 2002, Fig. 1, lines 2b and 2c).
//
// Instead of the cell that contains a point, a cell in conflict with it is looked for: near a good
// starting cell that is nearly at once. From there the conflict zone is dug out breadth first; the
// queue of cells is the list of those that die, and their places are taken by the new ones.
//
// The signs come from Compact_predicates.h; the tests of all neighbours of a cell at once from the
// first filter, wide where the machine has vectors.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Explore_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Star_filler.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Wide_sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/prefetch.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Id: an unsigned type for the numbers. Predicates: as Perturbed_predicates.
template <class Id, class Predicates>
class Compact_triangulation
{
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

public:
  // Where a point goes: a cell in conflict with it, or else (cell unused) the vertex at its place.
  struct Place
  {
    Id cell;
    Id vertex; // 0: none
  };

  // For `n` points. `predicates` take indices of points.
  Compact_triangulation(const Predicates& predicates, std::size_t n)
    : m_complex(n)
    , m_tests(predicates, m_complex)
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_WIDE_FILTER
    , m_is_wide(Wide_explore_neighbors::is_supported())
#endif
  {
    m_tests.reserve(n);
    make_room(256);
  }

  Complex& complex()
  {
    return m_complex;
  }
  const Complex& complex() const
  {
    return m_complex;
  }
  const Compact_counts& counts() const
  {
    return m_tests.counts();
  }

  // The index of the point at vertex v, finite.
  std::size_t point_of(std::size_t v) const
  {
    return m_tests.point_of(v);
  }

  // Begins with four points; a cell of them in this order is positively oriented.
  std::array<Id, 4> start(const std::array<std::size_t, 4>& points,
                          const std::array<std::array<double, 3>, 4>& coordinates)
  {
    std::array<Id, 4> v;
    for (std::size_t k = 0; k < 4; ++k)
      v[k] = add_vertex(points[k], coordinates[k]);
    m_complex.start(v);
    return v;
  }

  // Where point i goes, near cell `start`.
  Place locate(std::size_t i, const std::array<double, 3>& coordinates, Id start) const
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_WIDE_FILTER
    if (m_is_wide)
      return walk<Wide_sphere_filter>(i, coordinates.data(), start);
#endif
    return walk<Sphere_filter>(i, coordinates.data(), start);
  }

  // Makes point i a vertex. `before(first, last)` is given the cells in conflict.
  template <class Before>
  Id insert(std::size_t i, const std::array<double, 3>& coordinates, Id cell, const Before& before)
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_WIDE_FILTER
    if (m_is_wide)
      dig<Widest_explore_neighbors<Id>>(i, coordinates.data(), cell);
    else
#endif
      dig<Explore_neighbors>(i, coordinates.data(), cell);
    before(m_zone.data(), m_zone.data() + m_zone_size);
    const Id p = add_vertex(i, coordinates);
    fill(p);
    return p;
  }

private:
  Id add_vertex(std::size_t i, const std::array<double, 3>& coordinates)
  {
    const Id v = m_complex.add_vertex(coordinates);
    m_tests.add_vertex(i);
    return v;
  }

  // --- line 2b: a cell in conflict -------------------------------------------------------------

  // Walks towards p until a cell is in conflict with it. The cell that contains p is, unless p is
  // one of its vertices; in a Delaunay triangulation no such walk runs in a circle.
  template <class Filter>
  Place walk(std::size_t i, const double* p, Id c) const
  {
    for (;;) {
      ++m_tests.counts().cells_tested_to_start;
      const Cell& cell = m_complex.cell(c);
      if (Complex::is_infinite(cell)) {
        const int sign = m_tests.beyond_sign(cell, p);
        const Id w = sign == 0 ? m_tests.vertex_at(cell, i) : Id(0);
        if (w != 0 || sign > 0 || (sign == 0 && m_tests.is_beyond_exactly(cell, i, p)))
          return {c, w};
        c = cell.links[3] >> 2;
        continue;
      }
      const double* const v[4] = {m_tests.coordinates(cell.v[0]), m_tests.coordinates(cell.v[1]),
                                  m_tests.coordinates(cell.v[2]), m_tests.coordinates(cell.v[3])};
      const Cell_view view = Filter::view(v, p);
      if (view.sphere > 0)
        return {c, 0};
      if (view.sphere == 0) {
        if (const Id w = m_tests.vertex_at(cell, i))
          return {c, w};
        if (m_tests.is_in_close_sphere(cell, i, p))
          return {c, 0};
      }
      c = cell.links[m_tests.facet_towards(cell, view, i)] >> 2;
    }
  }

  // --- line 2c: the conflict zone and its boundary ---------------------------------------------

  // Fills m_zone with the cells in conflict, marked, and m_facets with their boundary.
  template <class Explore>
  void dig(std::size_t i, const double* p, Id first)
  {
    m_zone[0] = first;
    m_zone_size = 1;
    m_number_of_facets = 0;
    m_complex.cell(first).v[0] |= Complex::doomed;
    for (std::size_t k = 0; k < m_zone_size; ++k) {
      if (m_room < m_zone_size + 4)
        make_room(2 * m_room);
      if (k + 1 < m_zone_size)
        for (const Id link : m_complex.cell(m_zone[k + 1]).links)
          prefetch(&m_complex.cell(link >> 2));
      dig_at<Explore>(m_complex.cell(m_zone[k]), i, p);
    }
    m_tests.counts().sphere_tests += m_zone_size - 1 + m_number_of_facets;
  }

  // Tests the neighbours of a cell in conflict.
  template <class Explore>
  void dig_at(const Cell& cell, std::size_t i, const double* p)
  {
    Neighborhood around = Explore::around(m_complex.cells(), m_complex.vertices(), cell, p);
    if (around.undecided != 0)
      around.inside |= undecided_conflicts(cell, around.undecided, i, p);
    const Zone_ends<Id> ends = Explore::note(
        m_complex.cells(), cell, around.inside, around.open & ~around.inside,
        Zone_ends<Id>{m_zone.data() + m_zone_size, m_facets.data() + m_number_of_facets});
    m_zone_size = std::size_t(ends.cell - m_zone.data());
    m_number_of_facets = std::size_t(ends.facet - m_facets.data());
  }

  // Of the neighbours that the filter left undecided, those in conflict.
  unsigned undecided_conflicts(const Cell& cell, unsigned undecided, std::size_t i, const double* p)
  {
    unsigned inside = 0;
    for (unsigned k = 0; k < 4; ++k)
      if (undecided >> k & 1) {
        const Cell& neighbor = m_complex.cell(cell.links[k] >> 2);
        const bool is_filtered = !Complex::is_infinite(cell) && !Complex::is_infinite(neighbor);
        inside |= unsigned(is_filtered ? m_tests.is_in_close_sphere(neighbor, i, p)
                                       : m_tests.is_in_conflict(neighbor, i, p))
                  << k;
      }
    return inside;
  }

  // For a zone of `cells` cells, which has at most 2 `cells` + 2 facets. Both arrays grow together:
  // the zone alone tells when there is no room.
  void make_room(std::size_t cells)
  {
    m_zone.resize(cells);
    m_facets.resize(2 * cells + 8);
    m_room = cells;
  }

  // --- line 2c: the star -----------------------------------------------------------------------

  // The new cells take the places of the dead, and free ones when these are used up.
  void fill(Id p)
  {
    const std::size_t destroyed = m_zone_size, created = m_number_of_facets;
    m_tests.counts().cells_destroyed += destroyed;
    m_tests.counts().cells_created += created;
    if (m_room < created)
      make_room(2 * created);
    while (m_zone_size < created)
      m_zone[m_zone_size++] = m_complex.take_cell();
    for (std::size_t k = created; k < destroyed; ++k)
      m_complex.give_back_cell(m_zone[k]);
    m_filler(m_complex, p, m_facets.data(), m_zone.data(), created);
  }

  Complex m_complex; // before what refers to it
  Compact_predicates<Id, Predicates> m_tests;
  bool m_is_wide = false;
  std::vector<Id> m_zone;
  std::size_t m_zone_size = 0;
  std::size_t m_room = 0; // what make_room() was asked for: asked at every cell
  std::vector<Hole_facet<Id>> m_facets;
  std::size_t m_number_of_facets = 0;
  Star_filler<Id> m_filler;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_TRIANGULATION_H
