// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_WIDE_EXPLORE_ANNOUNCED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_WIDE_EXPLORE_ANNOUNCED_H

// Explore_announced.h in vectors, for ids of 32 bits. The only place where words that others write
// are read four at a time. A processor with such vectors loads each word of them whole; their order
// is that of the comment there, since x86 does not reorder loads. The compiler could: `volatile` or
// a barrier stands where that would matter.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Wide_explore_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Explore_announced.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Protocol = Handshake>
class Wide_explore_announced : public Explore_announced<std::uint32_t, Protocol>
{
  using Base = Explore_announced<std::uint32_t, Protocol>;
  using Id = std::uint32_t;
  using Wide = Wide_explore_neighbors;
  using Base::m_cell;
  using Base::m_is_torn;
  using Base::m_words;
  using Base::m_zone;
  using typename Base::Cell;
  using typename Base::Complex;

public:
  using Base::Base;

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS const Cell& read(const Cell* cells, Id c, std::size_t k)
  {
    const __m128i links = Wide::load(cells[c].links);
    Wide::store(m_cell.v, Wide::load(cells[c].v));
    Wide::store(m_cell.links, links);
    Wide::store(m_zone.links[k].of, links);
    m_cell.v[0] = m_zone.words[k];
    return m_cell;
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS Neighborhood around(const Cell* cells,
                                                              const Compact_vertex<Id>* vertices,
                                                              const Cell& cell, const double* p)
  {
    const Id l0 = cell.links[0], l1 = cell.links[1], l2 = cell.links[2], l3 = cell.links[3];
    const Cell &n0 = cells[l0 >> 2], &n1 = cells[l1 >> 2], &n2 = cells[l2 >> 2],
               &n3 = cells[l3 >> 2];
    const Id w0 = load_acquire(n0.v[0]), w1 = load_acquire(n1.v[0]), w2 = load_acquire(n2.v[0]),
             w3 = load_acquire(n3.v[0]);
    const Id unmarked = Id(~Complex::dead);
    const Id e0 = load_relaxed(n0.v[l0 & 3]) & unmarked, e1 = load_relaxed(n1.v[l1 & 3]) & unmarked,
             e2 = load_relaxed(n2.v[l2 & 3]) & unmarked, e3 = load_relaxed(n3.v[l3 & 3]) & unmarked;
    const __m128i words = _mm_setr_epi32(int(w0), int(w1), int(w2), int(w3));
    Wide::store(m_words, words);
    m_own_lanes = std::uint32_t(this->lane(l0 >> 2)) | std::uint32_t(this->lane(l1 >> 2)) << 8 |
                  std::uint32_t(this->lane(l2 >> 2)) << 16 |
                  std::uint32_t(this->lane(l3 >> 2)) << 24;
    const unsigned open = 15 & ~bits_of_bytes(m_own_lanes);
    m_is_torn |= Protocol::heeds_busy && Wide::signs_of(words) != 0;
    if (m_is_torn)
      return {open, 0, open};
    const double* const v[4] = {vertices[cell.v[0]].coordinates, vertices[cell.v[1]].coordinates,
                                vertices[cell.v[2]].coordinates, vertices[cell.v[3]].coordinates};
    const double* const opposite[4] = {vertices[e0].coordinates, vertices[e1].coordinates,
                                       vertices[e2].coordinates, vertices[e3].coordinates};
    const Sphere_signs signs = Wide_sphere_filter::signs(v, opposite, p);
    return neighborhood(open, open, signs);
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS Zone_ends<Id>
  note(Cell*, const Cell& cell, const Neighborhood& around, Zone_ends<Id> ends)
  {
    const unsigned inside = around.inside, bounding = around.bounding();
    const std::uint32_t own_lanes = m_own_lanes | bytes_of_bits(inside);
    for (unsigned k = 0; k < 4; ++k)
      this->lane(cell.links[k] >> 2) = std::uint8_t(own_lanes >> 8 * k);
    const __m128i words = Wide::load(m_words);
    Wide::store(m_zone.words.data() + (ends.cell - m_zone.cells.data()), Wide::pack(words, inside));
    Wide::store(ends.cell, Wide::pack(_mm_srli_epi32(Wide::load(cell.links), 2), inside));
    ends.cell += __builtin_popcount(inside);
    Wide::store(m_zone.outside_words.data() + (ends.facet - m_zone.facets.data()),
                Wide::pack(words, bounding));
    ends.facet = Wide::write_facets(ends.facet, bounding, Wide::load_eight(cell.v));
    return ends;
  }

  bool is_still_true(const Cell* cells, std::size_t n) const
  {
    return this->compare(cells, n, Wide_difference());
  }

private:
  // The lowest bits of four bytes, and back.
  static unsigned bits_of_bytes(std::uint32_t bytes) { return bytes * 0x01020408 >> 24; }
  static std::uint32_t bytes_of_bits(unsigned bits) { return bits * 0x00204081 & 0x01010101; }

  std::uint32_t m_own_lanes = 0; // of the neighbours, a byte each

  // Every processor of 64 bits has these vectors.
  struct Wide_difference
  {
    std::uint64_t bits = 0;
    __m128i of_links = _mm_setzero_si128();
    void add(std::uint64_t d) { bits |= d; }
    void add_links(const Id* now, const Id* then)
    {
      const __m128i difference =
          _mm_xor_si128(_mm_loadu_si128(reinterpret_cast<const __m128i*>(now)),
                        _mm_loadu_si128(reinterpret_cast<const __m128i*>(then)));
      of_links = _mm_or_si128(of_links, difference);
    }
    bool is_zero() const
    {
      const __m128i zero = _mm_cmpeq_epi8(of_links, _mm_setzero_si128());
      return bits == 0 && _mm_movemask_epi8(zero) == 0xffff;
    }
  };
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_WIDE_EXPLORE_ANNOUNCED_H
