// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_EXPLORE_NEIGHBORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_EXPLORE_NEIGHBORS_H

// Explore_neighbors.h in vectors, for ids of 32 bits.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Explore_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Wide_sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Wide_explore_neighbors : Explore_alone
{
  using Id = std::uint32_t;
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Neighborhood
  around(const Cell* cells, const Compact_vertex<Id>* vertices, const Cell& cell, const double* p)
  {
    const Id l0 = cell.links[0], l1 = cell.links[1], l2 = cell.links[2], l3 = cell.links[3];
    const Cell &n0 = cells[l0 >> 2], &n1 = cells[l1 >> 2], &n2 = cells[l2 >> 2],
               &n3 = cells[l3 >> 2];
    const Id unmarked = Id(~Complex::dead);
    const Id e0 = n0.v[l0 & 3] & unmarked, e1 = n1.v[l1 & 3] & unmarked,
             e2 = n2.v[l2 & 3] & unmarked, e3 = n3.v[l3 & 3] & unmarked;
    const unsigned open =
        15 & ~signs_of(_mm_setr_epi32(int(n0.v[0]), int(n1.v[0]), int(n2.v[0]), int(n3.v[0])));
    const unsigned infinite =
        Complex::is_infinite(cell)
            ? 15
            : signs_of(_mm_cmpeq_epi32(_mm_setr_epi32(int(e0), int(e1), int(e2), int(e3)),
                                       _mm_setzero_si128()));
    const unsigned filtered = open & ~infinite;
    if (filtered == 0)
      return {open, 0, open};
    const double* const v[4] = {vertices[cell.v[0] & unmarked].coordinates,
                                vertices[cell.v[1]].coordinates, vertices[cell.v[2]].coordinates,
                                vertices[cell.v[3]].coordinates};
    const double* const opposite[4] = {vertices[e0].coordinates, vertices[e1].coordinates,
                                       vertices[e2].coordinates, vertices[e3].coordinates};
    const Sphere_signs signs = Wide_sphere_filter::signs(v, opposite, p);
    return neighborhood(open, filtered, signs);
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Zone_ends<Id>
  note(Cell* cells, const Cell& cell, unsigned inside, unsigned bounding, Zone_ends<Id> ends)
  {
    const __m128i links = load(cell.links);
    store(ends.cell, pack(_mm_srli_epi32(links, 2), inside));
    ends.cell += __builtin_popcount(inside);
    for (unsigned k = 0; k < 4; ++k)
      cells[cell.links[k] >> 2].v[0] |= inside << (31 - k) & Complex::dead;
    const __m128i v = _mm_and_si128(load(cell.v), _mm_setr_epi32(int(~Complex::dead), -1, -1, -1));
    ends.facet = write_facets(ends.facet, bounding, v, links);
    return ends;
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

  // Those of four ids that `wanted` names, to the front.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static __m128i pack(__m128i ids, unsigned wanted)
  {
    return _mm_shuffle_epi8(ids, load(packed[wanted]));
  }

  // Lane 0 of `first`, the others of `rest`.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static __m128i with_first_of(__m128i first,
                                                                              __m128i rest)
  {
    return reinterpret_cast<__m128i>(lanes_of<4, 1, 2, 3>(reinterpret_cast<Four_words>(rest),
                                                          reinterpret_cast<Four_words>(first)));
  }

  // The facets `bounding` of the cell with these vertices and links. Returns where the next one
  // goes. Lane 0: the link; lanes 1, 2, 3: the facet_corners.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Zone_facet<Id>*
  write_facets(Zone_facet<Id>* to, unsigned bounding, __m128i v, __m128i links)
  {
    store(to, with_first_of(links, v));
    to += bounding & 1;
    store(to, with_first_of(_mm_shuffle_epi32(links, 1),
                            _mm_shuffle_epi32(v, _MM_SHUFFLE(3, 0, 2, 0))));
    to += bounding >> 1 & 1;
    store(to, with_first_of(_mm_shuffle_epi32(links, 2),
                            _mm_shuffle_epi32(v, _MM_SHUFFLE(3, 1, 0, 0))));
    to += bounding >> 2 & 1;
    store(to, with_first_of(_mm_shuffle_epi32(links, 3),
                            _mm_shuffle_epi32(v, _MM_SHUFFLE(0, 1, 2, 0))));
    return to + (bounding >> 3 & 1);
  }

private:
  // packed[m] moves the ids of the bits of m to the front.
  static constexpr std::uint32_t i0 = 0x03020100, i1 = 0x07060504, i2 = 0x0b0a0908, i3 = 0x0f0e0d0c;
  static constexpr std::uint32_t packed[16][4] = {
      {},       {i0},         {i1},         {i0, i1},        {i2},     {i0, i2},
      {i1, i2}, {i0, i1, i2}, {i3},         {i0, i3},        {i1, i3}, {i0, i1, i3},
      {i2, i3}, {i0, i2, i3}, {i1, i2, i3}, {i0, i1, i2, i3}};
};

// The widest search for these ids, where the machine has vectors.
template <class Id>
using Widest_explore_neighbors =
    std::conditional_t<std::is_same<Id, Wide_explore_neighbors::Id>::value, Wide_explore_neighbors,
                       Explore_neighbors>;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WIDE_EXPLORE_NEIGHBORS_H
