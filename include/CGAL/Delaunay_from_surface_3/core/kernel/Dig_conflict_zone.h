// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DIG_CONFLICT_ZONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DIG_CONFLICT_ZONE_H

// Digs the conflict zone, the first half of Choi 2002, Fig. 1, line 2c: finds the cells in conflict
// with the new point, and the boundary of the space that they fill (Bowyer 1981; Watson 1981). The
// cells are connected, so they are dug out breadth first from one of them; the list of the cells
// found is the queue.
//
// Invariant: exactly the cells found are marked, as dead or, beside other threads, as the worker's.
// Cost: O(cells in conflict).

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Describes a facet of the zone's boundary: `outside` is the cell beyond it, encoded as a
// neighbour, and (p, corners) is positive for the new point p.
struct Zone_facet
{
  Id outside;
  Id corners[3];
};

// Holds the working memory of one insertion, which the next one reuses. Threads share the complex,
// but each has a zone of its own.
struct Conflict_zone
{
  // The first number_of_cells and number_of_facets are valid; the rest is room. The cells are in
  // conflict, in the order in which they were found, or after the fill the cells of the star.
  std::vector<Id> cells;
  std::vector<Zone_facet> facets;
  std::size_t number_of_cells = 0;
  std::size_t number_of_facets = 0;

  std::vector<Id> free_cells; // dead, and in no zone
  Insertion_counts counts;

  Conflict_zone() { make_room(64); }

  // Makes room for a zone of n cells, which has at most 2 n + 2 facets, and for four more of
  // either. Both arrays grow together: has_room(), asked at every cell, looks at one number.
  void make_room(std::size_t n)
  {
    cells.resize(n + 4);
    facets.resize(2 * n + 8);
    m_room = n;
  }
  bool has_room(std::size_t n) const { return n <= m_room; }
  std::size_t room() const { return m_room; }

  // Takes one cell for each facet, for the star: the zone's own dead cells first, then free ones,
  // then new ones. Cells left over become free. The complex may move its cells in memory.
  template <class Complex>
  void take_cells_of_star(Complex& complex)
  {
    if (!has_room(number_of_facets))
      make_room(2 * number_of_facets);
    while (number_of_cells < number_of_facets)
      cells[number_of_cells++] = take_cell(complex);
    for (std::size_t k = number_of_facets; k < number_of_cells; ++k)
      free_cells.push_back(cells[k]);
    number_of_cells = number_of_facets;
  }

  // Undoes the dig of a thread that is alone: the cells live again.
  template <class Complex>
  void revive(Complex& complex)
  {
    for (std::size_t k = 0; k < number_of_cells; ++k)
      complex.cell(cells[k]).v[0] = Compact_numbers::first_vertex(complex.cell(cells[k]));
    counts.cells_destroyed -= number_of_cells;
    counts.cells_created -= number_of_facets;
  }

  // Returns true after a dig if the zone's cells are dead and the cells around are not. Its facets
  // make a sphere, in which every edge belongs to two, so their number is even.
  template <class Complex>
  bool is_dug(const Complex& complex) const
  {
    for (std::size_t k = 0; k < number_of_cells; ++k)
      if (!Complex::is_dead(complex.cell(cells[k])))
        return false;
    for (std::size_t f = 0; f < number_of_facets; ++f)
      if (Complex::is_dead(complex.cell(facets[f].outside >> 2)))
        return false;
    return number_of_cells > 0 && number_of_facets >= 4 && number_of_facets % 2 == 0;
  }

  // Returns true after a fill if all cells live, have vertex p, and lead to neighbours that lead
  // back.
  template <class Complex>
  bool is_star(const Complex& complex, Id p) const
  {
    for (std::size_t k = 0; k < number_of_cells; ++k) {
      const Compact_cell& cell = complex.cell(cells[k]);
      if (Complex::is_dead(cell) || std::find(cell.v, cell.v + 4, p) == cell.v + 4)
        return false;
      for (unsigned i = 0; i < 4; ++i)
        if (complex.cell(cell.neighbors[i] >> 2).neighbors[cell.neighbors[i] & 3] !=
            Complex::encode(cells[k], i))
          return false;
    }
    return true;
  }

private:
  template <class Complex>
  Id take_cell(Complex& complex)
  {
    if (free_cells.empty())
      return complex.new_cell();
    const Id c = free_cells.back();
    free_cells.pop_back();
    return c;
  }

  std::size_t m_room = 0;
};

// A step of the search for the conflict zone (Choi 2002, Fig. 1, line 2c) looks at the neighbours
// of a cell in conflict: those also in conflict join the zone, and the facets towards the others
// join its boundary.
//
// Branches could not be predicted, so there are none: each neighbour and facet is written behind
// the end, and the end moves on or not.

// Has a bit for each neighbour of a cell in conflict.
struct Neighborhood
{
  unsigned open;      // not known to be in conflict before
  unsigned inside;    // open, and in conflict
  unsigned undecided; // open, but the filter cannot tell

  unsigned bounding() const { return open & ~inside; } // valid when all is decided
};

// Combines the signs of the filter, which was asked about the neighbours `filtered`.
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Neighborhood neighborhood(unsigned open,
                                                                     unsigned filtered,
                                                                     const Sphere_signs& signs)
{
  const unsigned decided = filtered & (signs.inside | signs.outside);
  return {open, signs.inside & filtered, open & ~decided};
}

// Reads cells where they are, since no other thread writes. Cells that join the zone become dead.
struct Explore_alone
{
  static void mark(Compact_cell* cells, Id c) { cells[c].v[0] |= Compact_numbers::dead; }
  static const Compact_cell& read(const Compact_cell* cells, Id c, std::size_t) { return cells[c]; }
  static const Compact_cell& neighbor(const Compact_cell* cells, const Compact_cell& cell,
                                      unsigned k)
  {
    return cells[cell.neighbors[k] >> 2];
  }
  static constexpr bool is_still_true(const Compact_cell*, std::size_t) { return true; }
  static constexpr bool is_torn() { return false; }
};

// Explores in scalar code, for any machine.
struct Explore_neighbors : Explore_alone
{
  // Tests the cell's neighbours. Infinite cells are left undecided.
  template <class Vertex>
  static Neighborhood around(const Compact_cell* cells, const Vertex* vertices,
                             const Compact_cell& cell, typename Vertex::Place p)
  {
    using Complex = Compact_complex<Vertex>;
    using Place = typename Vertex::Place;
    unsigned open = 0, infinite = Complex::is_infinite(cell) ? 15 : 0;
    Place v[4], opposite[4];
    for (unsigned k = 0; k < 4; ++k) {
      const Compact_cell& neighbor = cells[cell.neighbors[k] >> 2];
      const Id e = neighbor.v[cell.neighbors[k] & 3] & Id(~Complex::dead);
      open |= unsigned(!Complex::is_dead(neighbor)) << k;
      infinite |= unsigned(e == Complex::infinite) << k;
      opposite[k] = Place(vertices[e].coordinates);
      v[k] = Place(vertices[cell.v[k] & Id(~Complex::dead)].coordinates);
    }
    const unsigned filtered = open & ~infinite;
    if (filtered == 0)
      return {open, 0, open};
    const Sphere_signs signs = Sphere_filter::neighbors(v, opposite, p, filtered);
    return neighborhood(open, filtered, signs);
  }

  // Appends the neighbours in conflict, which become dead, and the facets of the boundary. There is
  // room for four more of either.
  static void note(Compact_cell* cells, const Compact_cell& cell, const Neighborhood& around,
                   Conflict_zone& zone)
  {
    Id* next = zone.cells.data() + zone.number_of_cells;
    Zone_facet* facet = zone.facets.data() + zone.number_of_facets;
    const Id v[4] = {Compact_numbers::first_vertex(cell), cell.v[1], cell.v[2], cell.v[3]};
    for (unsigned k = 0; k < 4; ++k) {
      const Id neighbor = cell.neighbors[k], joins = Id(around.inside >> k & 1);
      cells[neighbor >> 2].v[0] |= Id(joins << (std::numeric_limits<Id>::digits - 1));
      *next = neighbor >> 2;
      next += joins;
      *facet = {neighbor, {v[facet_corners[k][0]], v[facet_corners[k][1]], v[facet_corners[k][2]]}};
      facet += around.bounding() >> k & 1;
    }
    zone.number_of_cells = std::size_t(next - zone.cells.data());
    zone.number_of_facets = std::size_t(facet - zone.facets.data());
  }
};

// The following does the same as Explore_neighbors, in vectors.

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

// Also has the neighbours themselves, and their first vertices.
struct Wide_neighborhood : Neighborhood
{
  Compact_cell* cells[4];
  __m128i first;
};

struct Wide_explore_neighbors : Explore_alone
{
  using Numbers = Compact_numbers;
  using Cell = Compact_cell;

  // Leaves infinite cells undecided, because their infinite vertex is far away.
  template <class Vertex>
  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Wide_neighborhood
  around(Cell* cells, const Vertex* vertices, const Cell& cell, typename Vertex::Place p)
  {
    using Place = typename Vertex::Place;
    const Id n0 = cell.neighbors[0], n1 = cell.neighbors[1], n2 = cell.neighbors[2],
             n3 = cell.neighbors[3];
    Cell &c0 = Numbers::cell_of_neighbor(cells, n0), &c1 = Numbers::cell_of_neighbor(cells, n1),
         &c2 = Numbers::cell_of_neighbor(cells, n2), &c3 = Numbers::cell_of_neighbor(cells, n3);
    const Id unmarked = Id(~Numbers::dead);
    const Id e0 = c0.v[n0 & 3] & unmarked, e1 = c1.v[n1 & 3] & unmarked,
             e2 = c2.v[n2 & 3] & unmarked, e3 = c3.v[n3 & 3] & unmarked;
    const __m128i first = _mm_setr_epi32(int(c0.v[0]), int(c1.v[0]), int(c2.v[0]), int(c3.v[0]));
    const unsigned open = 15 & ~signs_of(first);
    const Place v[4] = {
        Place(vertices[cell.v[0] & unmarked].coordinates), Place(vertices[cell.v[1]].coordinates),
        Place(vertices[cell.v[2]].coordinates), Place(vertices[cell.v[3]].coordinates)};
    const Place opposite[4] = {Place(vertices[e0].coordinates), Place(vertices[e1].coordinates),
                               Place(vertices[e2].coordinates), Place(vertices[e3].coordinates)};
    const Sphere_signs signs = Wide_sphere_filter::signs(v, opposite, p);
    return {neighborhood(open, open, signs), {&c0, &c1, &c2, &c3}, first};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static void
  note(Cell*, const Cell& cell, const Wide_neighborhood& around, Conflict_zone& zone)
  {
    const auto first = reinterpret_cast<Four_words>(
        _mm_or_si128(around.first, load(of_masks[around.inside].dead)));
    for (unsigned k = 0; k < 4; ++k)
      around.cells[k]->v[0] = first[k];
    append(zone, around,
           load_eight(cell.v) & Eight_words{~Numbers::dead, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u},
           load(cell.neighbors));
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static unsigned signs_of(__m128i v)
  {
    return unsigned(_mm_movemask_ps(_mm_castsi128_ps(v)));
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static __m128i load(const void* four_ids)
  {
    return _mm_loadu_si128(static_cast<const __m128i*>(four_ids));
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static void store(void* four_ids, __m128i v)
  {
    _mm_storeu_si128(static_cast<__m128i*>(four_ids), v);
  }

  // Moves the ids that `wanted` names, out of four, to the front.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static __m128i pack(__m128i ids, unsigned wanted)
  {
    return _mm_shuffle_epi8(ids, load(of_masks[wanted].packed));
  }

  // Loads eight words, such as the vertices and neighbours of a cell.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Eight_words load_eight(const Id* words)
  {
    Eight_words v;
    __builtin_memcpy(&v, words, sizeof v);
    return v;
  }

  // Appends the neighbours in conflict of a cell, and the facets towards the others.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static void
  append(Conflict_zone& zone, const Neighborhood& around, Eight_words cell, __m128i neighbors)
  {
    const unsigned inside = around.inside, bounding = around.bounding();
    store(zone.cells.data() + zone.number_of_cells, pack(_mm_srli_epi32(neighbors, 2), inside));
    Zone_facet* const to = zone.facets.data() + zone.number_of_facets;
    for (unsigned half = 0; half < 2; ++half) {
      const Eight_words two = words_of(cell, load_eight(of_masks[bounding].facets[half]));
      __builtin_memcpy(static_cast<void*>(to + 2 * half), &two, sizeof two);
    }
    zone.number_of_cells += unsigned(__builtin_popcount(inside));
    zone.number_of_facets += unsigned(__builtin_popcount(bounding));
  }

private:
  // Says how to treat the neighbours whose bits a mask has.
  struct Of_mask
  {
    Id packed[4];    // moves their ids to the front, and puts 0 behind them
    Id dead[4];      // marks their first vertices
    Id facets[2][8]; // selects the words of the cell that make the facets towards them
  };

  static constexpr Of_mask of_mask(unsigned mask)
  {
    constexpr Id none = 0x80808080;
    Of_mask of = {{none, none, none, none}, {}, {}};
    for (unsigned k = 0, n = 0; k < 4; ++k)
      if (mask >> k & 1) {
        of.packed[n] = 0x03020100 + 0x04040404 * k;
        of.dead[k] = Numbers::dead;
        Id* const facet = of.facets[n / 2] + n % 2 * 4;
        facet[0] = 4 + k;
        for (unsigned i = 0; i < 3; ++i)
          facet[1 + i] = facet_corners[k][i];
        ++n;
      }
    return of;
  }
  static const Of_mask of_masks[16];
};

inline constexpr Wide_explore_neighbors::Of_mask Wide_explore_neighbors::of_masks[16] = {
    of_mask(0),  of_mask(1),  of_mask(2),  of_mask(3), of_mask(4),  of_mask(5),
    of_mask(6),  of_mask(7),  of_mask(8),  of_mask(9), of_mask(10), of_mask(11),
    of_mask(12), of_mask(13), of_mask(14), of_mask(15)};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

// Explore says how cells are read and their neighbours tested: in scalar code or in vectors, alone
// or beside others that write (Explore_announced.h).
template <class Explore>
struct Dig_conflict_zone
{
  // Digs the zone of vertex p from the cell `first`, which is in conflict with it. Returns false if
  // another thread was in the way.
  template <class Vertex, class Predicates, class Zone>
  bool operator()(Compact_complex<Vertex>& complex, Predicates& predicates, Zone& zone, Id p,
                  Id first, Explore explore = Explore()) const
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
        for (const Id& neighbor : complex.cell(zone.cells[k + 1]).neighbors)
          prefetch(&complex.cell(load_relaxed(neighbor) >> 2)); // others may write it
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

  // Tests the neighbours of a cell in conflict.
  template <class Vertex, class Predicates, class Zone>
  static void look_around(Compact_complex<Vertex>& complex, Predicates& predicates, Zone& zone,
                          Id p, const Compact_cell& cell, Explore& explore)
  {
    auto around = explore.around(complex.cells(), complex.vertices(), cell, complex.place(p));
    if (around.undecided != 0)
      around.inside |= undecided_conflicts(complex, predicates, cell, around.undecided, p, explore);
    explore.note(complex.cells(), cell, around, zone);
  }

  // Returns which of the undecided neighbours are in conflict.
  template <class Vertex, class Predicates>
  CGAL_DELAUNAY_FROM_SURFACE_3_APART static unsigned
  undecided_conflicts(const Compact_complex<Vertex>& complex, Predicates& predicates,
                      const Compact_cell& cell, unsigned undecided, Id p, Explore& explore)
  {
    using Complex = Compact_complex<Vertex>;
    unsigned inside = 0;
    for (unsigned k = 0; k < 4; ++k)
      if (undecided >> k & 1) {
        const Compact_cell& neighbor = explore.neighbor(complex.cells(), cell, k);
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
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DIG_CONFLICT_ZONE_H
