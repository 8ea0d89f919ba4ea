// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_EXPLORE_ANNOUNCED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_EXPLORE_ANNOUNCED_H

// Digs while others write: cells that join the zone are announced by the worker's mark, and all
// that was read is kept, to be compared before anything is written (is_still_true()).
//
// A cell is written only as part of the star of some point p, whose number is then its first
// vertex, and p is inserted once: so the first vertex identifies the version. If it is the same
// before and after reading, and not busy, all four vertices belong together. Neighbours of living
// cells are written one by one.
//
// The order of loads is: for a neighbour, the first vertex and then the opposite one; for a cell
// that is validated, the marks, the first vertex and then the neighbours. On x86 loads are not
// reordered; elsewhere the acquire loads forbid it.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Fill_star.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Marks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Adds to a conflict zone the data that was read when it was dug: others may have written since.
struct Announced_zone : Conflict_zone
{
  std::vector<Id> words; // the first vertices of the zone's cells, which tell their versions
  std::vector<Compact_cell> copies; // of the zone's cells
  std::vector<Id> outside_words;    // the same of the cells beyond the facets

  Announced_zone() { make_room(64); }

  // Hides the function of the base, which has the same postcondition. Cells that others were writing
  // may seem to have 3 n + 1 facets.
  void make_room(std::size_t n)
  {
    Conflict_zone::make_room(n);
    facets.resize(3 * n + 8);
    words.resize(this->cells.size());
    copies.resize(this->cells.size());
    outside_words.resize(this->facets.size());
  }
};

// Names the parts of the handshake. Tests leave them out, one at a time.
struct Handshake
{
  static constexpr bool has_fence = true;
  static constexpr bool masks_own_mark = true;
  static constexpr bool compares_neighbors = true;
  static constexpr bool compares_outside = true;
  static constexpr bool heeds_busy = true;
};

// Copies a cell that another worker may be writing. Returns true if the copy is consistent.
inline bool read_cell(const Compact_cell& cell, Compact_cell& copy)
{
  const Id word = load_acquire(cell.v[0]);
  copy.v[0] = word;
  for (unsigned k = 1; k < 4; ++k)
    copy.v[k] = load_relaxed(cell.v[k]);
  for (unsigned k = 0; k < 4; ++k)
    copy.neighbors[k] = load_relaxed(cell.neighbors[k]);
  acquire_fence();
  return !Compact_numbers::is_dead(copy) && load_relaxed(cell.v[0]) == word;
}

template <class Vertex, class Protocol = Handshake>
class Explore_announced
{
protected:
  using Complex = Compact_complex<Vertex>;
  using Cell = Compact_cell;
  using Place = typename Vertex::Place;

public:
  Explore_announced(Announced_zone& zone, Marks& marks, unsigned worker)
    : m_zone(zone)
    , m_bytes(marks.bytes() + worker)
    , m_marks(marks)
    , m_shift(marks.shift())
    , m_worker(worker)
  {
  }

  // Announces the first cell. The zone has the word under which it was found in conflict.
  void mark(const Cell*, Id c) { store_relaxed(own_mark(c), Marks::set); }

  // Returns a copy of cell c, the k-th of the zone.
  const Cell& read(const Cell* cells, Id c, std::size_t k)
  {
    Cell& copy = m_zone.copies[k];
    copy.v[0] = m_zone.words[k];
    for (unsigned i = 1; i < 4; ++i)
      copy.v[i] = load_relaxed(cells[c].v[i]);
    for (unsigned i = 0; i < 4; ++i)
      copy.neighbors[i] = load_relaxed(cells[c].neighbors[i]);
    return copy;
  }

  Neighborhood around(const Cell* cells, const Vertex* vertices, const Cell& cell, Place p)
  {
    unsigned open = 0, infinite = Complex::is_infinite(cell) ? 15 : 0;
    Place v[4], opposite[4];
    for (unsigned k = 0; k < 4; ++k) {
      const Cell& neighbor = cells[cell.neighbors[k] >> 2];
      const Id word = load_acquire(neighbor.v[0]);
      const Id e = load_relaxed(neighbor.v[cell.neighbors[k] & 3]) & Id(~Complex::dead);
      m_words[k] = word;
      m_is_torn |= Protocol::heeds_busy && (word & Complex::dead) != 0;
      open |= unsigned(load_relaxed(own_mark(cell.neighbors[k] >> 2)) == 0) << k;
      infinite |= unsigned(e == Complex::infinite) << k;
      opposite[k] = Place(vertices[e].coordinates);
      v[k] = Place(vertices[cell.v[k]].coordinates);
    }
    const unsigned filtered = open & ~infinite;
    if (m_is_torn || filtered == 0)
      return {open, 0, open};
    const Sphere_signs signs = Sphere_filter::neighbors(v, opposite, p, filtered);
    return neighborhood(open, filtered, signs);
  }

  // Returns the k-th neighbour of the cell that around() saw last, as a consistent copy, unchanged
  // since; if this fails, is_torn() holds.
  const Cell& neighbor(const Cell* cells, const Cell& cell, unsigned k)
  {
    m_is_torn |=
        !read_cell(cells[cell.neighbors[k] >> 2], m_neighbor) || m_neighbor.v[0] != m_words[k];
    return m_neighbor;
  }

  void note(Cell*, const Cell& cell, const Neighborhood& around, Announced_zone& zone)
  {
    std::size_t &n = zone.number_of_cells, &f = zone.number_of_facets;
    for (unsigned k = 0; k < 4; ++k) {
      const Id neighbor = cell.neighbors[k], joins = Id(around.inside >> k & 1);
      std::uint8_t& own = own_mark(neighbor >> 2);
      store_relaxed(own, std::uint8_t(load_relaxed(own) | joins * Marks::set));
      zone.words[n] = m_words[k];
      zone.cells[n] = neighbor >> 2;
      n += joins;
      zone.outside_words[f] = m_words[k];
      zone.facets[f] = {
          neighbor,
          {cell.v[facet_corners[k][0]], cell.v[facet_corners[k][1]], cell.v[facet_corners[k][2]]}};
      f += around.bounding() >> k & 1;
    }
  }

  bool is_torn() const { return m_is_torn; }

  // Returns true if all that was read still holds, for the zone's first n cells and for the cells
  // beyond its facets, and no other worker has announced any of them.
  bool is_still_true(const Cell* cells, std::size_t n) const
  {
    return compare(cells, n, Difference());
  }

protected:
  std::uint8_t& own_mark(std::size_t cell) const { return m_bytes[cell << m_shift]; }

  // Collects the differences between words as they were read and as they are now.
  struct Difference
  {
    std::uint64_t bits = 0;
    void add(std::uint64_t d) { bits |= d; }
    void add_cell(const Cell& now, const Cell& then)
    {
      bits |= load_acquire(now.v[0]) ^ then.v[0];
      if (Protocol::compares_neighbors)
        for (unsigned i = 0; i < 4; ++i)
          bits |= load_relaxed(now.neighbors[i]) ^ then.neighbors[i];
    }
    bool is_zero() const { return bits == 0; }
  };

  // Collects all differences, to branch only once.
  template <class Differences>
  bool compare(const Cell* cells, std::size_t n, Differences difference) const
  {
    const unsigned own = Protocol::masks_own_mark ? m_worker : Marks::most_workers;
    return with_other_marks(m_marks, own, [&](auto others) {
      const Id* const zone = m_zone.cells.data();
      const Cell* const copies = m_zone.copies.data();
      for (std::size_t k = 0; k < n; ++k) {
        difference.add(others(zone[k]));
        difference.add_cell(cells[zone[k]], copies[k]);
      }
      const Zone_facet* const facets = m_zone.facets.data();
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

  Announced_zone& m_zone;
  std::uint8_t* m_bytes; // the worker's
  const Marks& m_marks;
  unsigned m_shift, m_worker;
  Id m_words[4]; // first vertices of the cell's neighbours
  Cell m_neighbor;
  bool m_is_torn = false;
};

// The following does the same as Explore_announced, in vectors. Only here are words that others
// write read four or eight at a time. A processor with such vectors loads each word of them whole,
// in the order described above, since x86 does not reorder loads. The compiler could; therefore
// marks, first vertices, and all that is compared in the end are loaded as `volatile`.

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

// Also has the first vertices of the neighbours, and where the worker's own marks are, and these.
struct Announced_neighborhood : Neighborhood
{
  __m128i words, own;
  std::uint8_t* marks[4];
};

template <class Vertex, class Protocol = Handshake>
class Wide_explore_announced : public Explore_announced<Vertex, Protocol>
{
  using Base = Explore_announced<Vertex, Protocol>;
  using Wide = Wide_explore_neighbors;
  using Base::m_is_torn;
  using Base::m_words;
  using Base::m_zone;
  using Base::own_mark;
  using typename Base::Cell;
  using typename Base::Complex;
  using typename Base::Place;

public:
  using Base::Base;

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS const Cell& read(const Cell* cells, Id c, std::size_t k)
  {
    Eight_words cell = Wide::load_eight(cells[c].v);
    cell[0] = m_zone.words[k];
    Cell& copy = m_zone.copies[k];
    __builtin_memcpy(&copy, &cell, sizeof cell);
    return copy;
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS Announced_neighborhood around(const Cell* cells,
                                                                        const Vertex* vertices,
                                                                        const Cell& cell, Place p)
  {
    const Id n0 = cell.neighbors[0], n1 = cell.neighbors[1], n2 = cell.neighbors[2],
             n3 = cell.neighbors[3];
    const Cell &c0 = cells[n0 >> 2], &c1 = cells[n1 >> 2], &c2 = cells[n2 >> 2],
               &c3 = cells[n3 >> 2];
    const Id w0 = load_acquire(c0.v[0]), w1 = load_acquire(c1.v[0]), w2 = load_acquire(c2.v[0]),
             w3 = load_acquire(c3.v[0]);
    const Id unmarked = Id(~Complex::dead);
    const Id e0 = load_relaxed(c0.v[n0 & 3]) & unmarked, e1 = load_relaxed(c1.v[n1 & 3]) & unmarked,
             e2 = load_relaxed(c2.v[n2 & 3]) & unmarked, e3 = load_relaxed(c3.v[n3 & 3]) & unmarked;
    const __m128i words = _mm_setr_epi32(int(w0), int(w1), int(w2), int(w3));
    Wide::store(m_words, words);
    std::uint8_t &m0 = own_mark(n0 >> 2), &m1 = own_mark(n1 >> 2), &m2 = own_mark(n2 >> 2),
                 &m3 = own_mark(n3 >> 2);
    const __m128i own = _mm_insert_epi8(
        _mm_insert_epi8(_mm_insert_epi8(_mm_cvtsi32_si128(m0), m1, 1), m2, 2), m3, 3);
    const unsigned open = 15 & ~unsigned(_mm_movemask_epi8(own));
    m_is_torn |= Protocol::heeds_busy && Wide::signs_of(words) != 0;
    if (m_is_torn)
      return {{open, 0, open}, words, own, {&m0, &m1, &m2, &m3}};
    const Place v[4] = {
        Place(vertices[cell.v[0]].coordinates), Place(vertices[cell.v[1]].coordinates),
        Place(vertices[cell.v[2]].coordinates), Place(vertices[cell.v[3]].coordinates)};
    const Place opposite[4] = {Place(vertices[e0].coordinates), Place(vertices[e1].coordinates),
                               Place(vertices[e2].coordinates), Place(vertices[e3].coordinates)};
    const Sphere_signs signs = Wide_sphere_filter::signs(v, opposite, p);
    return {neighborhood(open, open, signs), words, own, {&m0, &m1, &m2, &m3}};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS void
  note(Cell*, const Cell& cell, const Announced_neighborhood& around, Announced_zone& zone)
  {
    const __m128i own =
        _mm_or_si128(around.own, _mm_cvtsi32_si128(int(bytes_of_bits(around.inside))));
    *around.marks[0] = std::uint8_t(_mm_extract_epi8(own, 0));
    *around.marks[1] = std::uint8_t(_mm_extract_epi8(own, 1));
    *around.marks[2] = std::uint8_t(_mm_extract_epi8(own, 2));
    *around.marks[3] = std::uint8_t(_mm_extract_epi8(own, 3));
    Wide::store(zone.words.data() + zone.number_of_cells, Wide::pack(around.words, around.inside));
    Wide::store(zone.outside_words.data() + zone.number_of_facets,
                Wide::pack(around.words, around.bounding()));
    Wide::append(zone, around, Wide::load_eight(cell.v), Wide::load(cell.neighbors));
  }

  bool is_still_true(const Cell* cells, std::size_t n) const
  {
    return this->compare(cells, n, Wide_difference());
  }

private:
  // Spreads four bits to four marks.
  static std::uint32_t bytes_of_bits(unsigned bits)
  {
    return (bits * 0x00204081 & 0x01010101) * Marks::set;
  }

  // Every x86 processor of 64 bits has these vectors.
  struct Wide_difference
  {
    std::uint64_t bits = 0;
    __m128i of_cells = _mm_setzero_si128();
    void add(std::uint64_t d) { bits |= d; }
    void add_cell(const Cell& now, const Cell& then)
    {
      add_four(now.v, then.v);
      if (Protocol::compares_neighbors)
        add_four(now.neighbors, then.neighbors);
    }
    void add_four(const Id* now, const Id* then)
    {
      // `volatile`: the compiler must not load it before the marks.
      const __m128i current = *reinterpret_cast<const volatile __m128i*>(now);
      const __m128i before = _mm_loadu_si128(reinterpret_cast<const __m128i*>(then));
      of_cells = _mm_or_si128(of_cells, _mm_xor_si128(current, before));
    }
    bool is_zero() const
    {
      const __m128i zero = _mm_cmpeq_epi8(of_cells, _mm_setzero_si128());
      return bits == 0 && _mm_movemask_epi8(zero) == 0xffff;
    }
  };
};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

// Writes stars while others read. The first store to a cell makes it busy, and the last one gives
// its new version; the cell beyond a facet gets the new one as its neighbour only when that can be
// seen.

template <class Vertex>
class Write_announced
{
  using Complex = Compact_complex<Vertex>;
  using Cell = Compact_cell;
  using Label = decltype(Vertex::label);

public:
  // Makes labels for n vertices. The memory is cleared page by page when it is used: a worker sees
  // few vertices besides those of its own patches.
  explicit Write_announced(std::size_t n)
    : m_labels(static_cast<Label*>(std::calloc(n, sizeof(Label))))
  {
    if (m_labels == nullptr)
      throw std::bad_alloc();
  }

  Label& label(Vertex*, Id v) { return m_labels.get()[v]; }
  void forget_labels(const Complex& complex)
  {
    std::memset(m_labels.get(), 0, complex.vertices_end() * sizeof(Label));
  }

  static void open(Cell& cell, Id p, const Zone_facet& facet)
  {
    store_relaxed(cell.v[0], Id(p | Complex::dead));
    release_fence();
    for (unsigned k = 0; k < 3; ++k)
      store_relaxed(cell.v[k + 1], facet.corners[k]);
    store_relaxed(cell.neighbors[0], facet.outside);
  }
  static void set_outer_neighbor(Id& neighbor, Id to) { store_release(neighbor, to); }
  static void set_neighbor(Id& neighbor, Id to) { store_relaxed(neighbor, to); }
  static void close(Cell& cell, Id p) { store_release(cell.v[0], p); }

  // A worker that destroys a cell stores later than its maker: so the cell that is stored last is
  // alive, unless the vertex has lost its last cell to others with larger weights. Then it is dead,
  // or was made anew without the vertex.
  static void set_cell(Vertex* vertices, Id v, Id c) { store_relaxed(vertices[v].cell, c); }

  // The infinite vertex can only be the last corner. It gets no cell, since all workers would write
  // it.
  void set_cell_of_corners(Vertex* vertices, const Id* corners, Id c)
  {
    set_cell(vertices, corners[0], c);
    set_cell(vertices, corners[1], c);
    Id& cell = vertices[corners[2]].cell;
    store_relaxed(*(corners[2] == Complex::infinite ? &m_cell_of_infinite_vertex : &cell), c);
  }

private:
  struct Free
  {
    void operator()(Label* labels) const { std::free(labels); }
  };

  std::unique_ptr<Label[], Free> m_labels;
  Id m_cell_of_infinite_vertex; // not read
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_EXPLORE_ANNOUNCED_H
