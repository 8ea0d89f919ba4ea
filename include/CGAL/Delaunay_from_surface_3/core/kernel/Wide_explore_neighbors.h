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

// With the cells themselves, and their first vertices.
struct Wide_neighborhood : Neighborhood
{
  Compact_cell<std::uint32_t>* cells[4];
  __m128i first;
};

struct Wide_explore_neighbors : Explore_alone
{
  using Id = std::uint32_t;
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

  // Infinite cells are left undecided: their vertex is far.
  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Wide_neighborhood
  around(Cell* cells, const Compact_vertex<Id>* vertices, const Cell& cell, const double* p)
  {
    const Id l0 = cell.links[0], l1 = cell.links[1], l2 = cell.links[2], l3 = cell.links[3];
    Cell &n0 = Complex::cell_of_link(cells, l0), &n1 = Complex::cell_of_link(cells, l1),
         &n2 = Complex::cell_of_link(cells, l2), &n3 = Complex::cell_of_link(cells, l3);
    const Id unmarked = Id(~Complex::dead);
    const Id e0 = n0.v[l0 & 3] & unmarked, e1 = n1.v[l1 & 3] & unmarked,
             e2 = n2.v[l2 & 3] & unmarked, e3 = n3.v[l3 & 3] & unmarked;
    const __m128i first = _mm_setr_epi32(int(n0.v[0]), int(n1.v[0]), int(n2.v[0]), int(n3.v[0]));
    const unsigned open = 15 & ~signs_of(first);
    const double* const v[4] = {vertices[cell.v[0] & unmarked].coordinates,
                                vertices[cell.v[1]].coordinates, vertices[cell.v[2]].coordinates,
                                vertices[cell.v[3]].coordinates};
    const double* const opposite[4] = {vertices[e0].coordinates, vertices[e1].coordinates,
                                       vertices[e2].coordinates, vertices[e3].coordinates};
    const Sphere_signs signs = Wide_sphere_filter::signs(v, opposite, p);
    return {neighborhood(open, open, signs), {&n0, &n1, &n2, &n3}, first};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Zone_ends<Id>
  note(Cell*, const Cell& cell, const Wide_neighborhood& around, Zone_ends<Id> ends)
  {
    const auto first = reinterpret_cast<Four_words>(
        _mm_or_si128(around.first, load(of_masks[around.inside].dead)));
    for (unsigned k = 0; k < 4; ++k)
      around.cells[k]->v[0] = first[k];
    store(ends.cell, pack(_mm_srli_epi32(load(cell.links), 2), around.inside));
    ends.cell += __builtin_popcount(around.inside);
    ends.facet = write_facets(ends.facet, around.bounding(),
                              load_eight(cell.v) &
                                  Eight_words{~Complex::dead, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u});
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
    return _mm_shuffle_epi8(ids, load(of_masks[wanted].packed));
  }

  // Vertices and links of a cell.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Eight_words load_eight(const Id* words)
  {
    Eight_words v;
    __builtin_memcpy(&v, words, sizeof v);
    return v;
  }

  // The facets `bounding` of a cell. Returns where the next one goes.
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Zone_facet<Id>*
  write_facets(Zone_facet<Id>* to, unsigned bounding, Eight_words cell)
  {
    for (unsigned half = 0; half < 2; ++half) {
      const Eight_words two = words_of(cell, load_eight(of_masks[bounding].facets[half]));
      __builtin_memcpy(static_cast<void*>(to + 2 * half), &two, sizeof two);
    }
    return to + __builtin_popcount(bounding);
  }

private:
  // What to do with the neighbours of the bits of a mask.
  struct Of_mask
  {
    Id packed[4];    // moves their ids to the front, and 0 behind them
    Id dead[4];      // marks their first vertices
    Id facets[2][8]; // which words of the cell the facets towards them are, one after the other
  };

  static constexpr Of_mask of_mask(unsigned mask)
  {
    constexpr Id none = 0x80808080;
    Of_mask of = {{none, none, none, none}, {}, {}};
    for (unsigned k = 0, n = 0; k < 4; ++k)
      if (mask >> k & 1) {
        of.packed[n] = 0x03020100 + 0x04040404 * k;
        of.dead[k] = Complex::dead;
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
