// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_EXPLORE_ANNOUNCED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_EXPLORE_ANNOUNCED_H

// Digs while others write: what joins the zone is announced in the worker's lane, and what was read
// is kept, to be compared before anything is written (is_still_true()).
//
// A cell is written only as part of the star of some point p, whose number is its first vertex
// then, and p is inserted once: so the first vertex tells the version. If it is the same before and
// after, and not busy, all four vertices belong together. Links of living cells change one by one.
//
// Order of loads: of a neighbour the first vertex, then the opposite one; when validating, of a
// cell the lanes, the first vertex, the links. On x86 loads are not reordered; elsewhere the
// acquire loads forbid it.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Explore_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Announced_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Lanes.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The parts of the handshake. Tests leave them out, one at a time.
struct Handshake
{
  static constexpr bool has_fence = true;
  static constexpr bool masks_own_lane = true;
  static constexpr bool compares_links = true;
  static constexpr bool compares_outside = true;
  static constexpr bool heeds_busy = true;
};

// Copies a cell that another may be writing. Returns whether the copy is consistent.
template <class Id>
bool read_cell(const Compact_cell<Id>& cell, Compact_cell<Id>& copy)
{
  const Id word = load_acquire(cell.v[0]);
  copy.v[0] = word;
  for (unsigned k = 1; k < 4; ++k)
    copy.v[k] = load_relaxed(cell.v[k]);
  for (unsigned k = 0; k < 4; ++k)
    copy.links[k] = load_relaxed(cell.links[k]);
  acquire_fence();
  return !Compact_complex<Id>::is_dead(copy) && load_relaxed(cell.v[0]) == word;
}

template <class Id, class Protocol = Handshake>
class Explore_announced
{
protected:
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

public:
  Explore_announced(Announced_zone<Id>& zone, Lanes& lanes, unsigned worker)
    : m_zone(zone)
    , m_lanes(lanes.bytes() + worker)
    , m_shift(lanes.shift())
    , m_all_lanes(lanes)
    , m_worker(worker)
  {
  }

  // Of the first cell: the word under which it was found in conflict stands in the zone.
  void mark(const Cell*, Id c) { store_relaxed(lane(c), std::uint8_t(1)); }

  // A copy of cell c, the k-th of the zone.
  const Cell& read(const Cell* cells, Id c, std::size_t k)
  {
    m_cell.v[0] = m_zone.words[k];
    for (unsigned i = 1; i < 4; ++i)
      m_cell.v[i] = load_relaxed(cells[c].v[i]);
    for (unsigned i = 0; i < 4; ++i)
      m_zone.links[k].of[i] = m_cell.links[i] = load_relaxed(cells[c].links[i]);
    return m_cell;
  }

  Neighborhood around(const Cell* cells, const Compact_vertex<Id>* vertices, const Cell& cell,
                      const double* p)
  {
    unsigned open = 0, infinite = Complex::is_infinite(cell) ? 15 : 0;
    const double *v[4], *opposite[4];
    for (unsigned k = 0; k < 4; ++k) {
      const Cell& neighbor = cells[cell.links[k] >> 2];
      const Id word = load_acquire(neighbor.v[0]);
      const Id e = load_relaxed(neighbor.v[cell.links[k] & 3]) & Id(~Complex::dead);
      m_words[k] = word;
      m_is_torn |= Protocol::heeds_busy && (word & Complex::dead) != 0;
      open |= unsigned(load_relaxed(lane(cell.links[k] >> 2)) == 0) << k;
      infinite |= unsigned(e == Complex::infinite) << k;
      opposite[k] = vertices[e].coordinates;
      v[k] = vertices[cell.v[k]].coordinates;
    }
    const unsigned filtered = open & ~infinite;
    if (m_is_torn || filtered == 0)
      return {open, 0, open};
    const Sphere_signs signs = Sphere_filter::neighbors(v, opposite, p, filtered);
    return neighborhood(open, filtered, signs);
  }

  // The k-th neighbour of the cell looked around last, of one piece and as it was then; else
  // is_torn().
  const Cell& neighbor(const Cell* cells, const Cell& cell, unsigned k)
  {
    m_is_torn |= !read_cell(cells[cell.links[k] >> 2], m_neighbor) || m_neighbor.v[0] != m_words[k];
    return m_neighbor;
  }

  Zone_ends<Id> note(Cell*, const Cell& cell, const Neighborhood& around, Zone_ends<Id> ends)
  {
    for (unsigned k = 0; k < 4; ++k) {
      const Id link = cell.links[k], joins = Id(around.inside >> k & 1);
      std::uint8_t& own = lane(link >> 2);
      store_relaxed(own, std::uint8_t(load_relaxed(own) | joins));
      m_zone.words[ends.cell - m_zone.cells.data()] = m_words[k];
      *ends.cell = link >> 2;
      ends.cell += joins;
      m_zone.outside_words[ends.facet - m_zone.facets.data()] = m_words[k];
      *ends.facet = {
          link,
          {cell.v[facet_corners[k][0]], cell.v[facet_corners[k][1]], cell.v[facet_corners[k][2]]}};
      ends.facet += around.bounding() >> k & 1;
    }
    return ends;
  }

  bool is_torn() const { return m_is_torn; }

  // Whether all that was read still holds, of the zone's first n cells and of those beyond its
  // facets, and nobody else has announced them.
  bool is_still_true(const Cell* cells, std::size_t n) const
  {
    return compare(cells, n, Difference());
  }

protected:
  std::uint8_t& lane(std::size_t cell) const { return m_lanes[cell << m_shift]; }

  // Between words as they were read and as they are: 0 if there is none.
  struct Difference
  {
    std::uint64_t bits = 0;
    void add(std::uint64_t d) { bits |= d; }
    void add_links(const Id* now, const Id* then)
    {
      for (unsigned i = 0; i < 4; ++i)
        bits |= load_relaxed(now[i]) ^ then[i];
    }
    bool is_zero() const { return bits == 0; }
  };

  // Branches once.
  template <class Differences>
  bool compare(const Cell* cells, std::size_t n, Differences difference) const
  {
    const unsigned own = Protocol::masks_own_lane ? m_worker : Lanes::most_workers;
    return with_other_lanes(m_all_lanes, own, [&](auto others) {
      const Id* const zone = m_zone.cells.data();
      const Id* const words = m_zone.words.data();
      const Links<Id>* const links = m_zone.links.data();
      for (std::size_t k = 0; k < n; ++k) {
        const Cell& cell = cells[zone[k]];
        difference.add(others(zone[k]));
        difference.add(load_acquire(cell.v[0]) ^ words[k]);
        if (Protocol::compares_links)
          difference.add_links(cell.links, links[k].of);
      }
      const Zone_facet<Id>* const facets = m_zone.facets.data();
      const Id* const outside_words = m_zone.outside_words.data();
      const std::size_t number = Protocol::compares_outside ? m_zone.number_of_facets : 0;
      for (std::size_t f = 0; f < number; ++f) {
        const Id outside = facets[f].outside >> 2;
        difference.add(others(outside));
        difference.add(load_acquire(cells[outside].v[0]) ^ outside_words[f]);
      }
      return difference.is_zero();
    });
  }

  Announced_zone<Id>& m_zone;
  std::uint8_t* m_lanes; // the worker's
  unsigned m_shift;
  const Lanes& m_all_lanes;
  unsigned m_worker;
  bool m_is_torn = false;
  alignas(32) Cell m_cell;
  Id m_words[4]; // of its neighbours
  Cell m_neighbor;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_EXPLORE_ANNOUNCED_H
