// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXPLORE_NEIGHBORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXPLORE_NEIGHBORS_H

// One step of the search for the conflict zone (Choi 2002, Fig. 1, line 2c): the neighbours of a
// cell in conflict that are in conflict too join the zone, the facets towards the others join its
// boundary.
//
// Which it is cannot be predicted, so there are no branches: what is found is written behind the
// end, and the end moves on or not.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Wide_sphere_filter.h>

#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// A facet of the boundary: the link of the cell outside, and the corners, such that (p, corners) is
// positive for p in the zone.
template <class Id>
struct Hole_facet
{
  Id outside;
  Id corners[3];
};

// Where the next cell in conflict and the next facet of the boundary are written. There is room for
// four more of either.
template <class Id>
struct Zone_ends
{
  Id* cell;
  Hole_facet<Id>* facet;
};

// A bit for each neighbour of a cell in conflict.
struct Neighborhood
{
  unsigned open;      // not known to be in conflict before
  unsigned inside;    // of these: in conflict
  unsigned undecided; // of these: the filter cannot tell
};

// Scalar code for any machine and any Id.
struct Explore_neighbors
{
  // Of the cell's neighbours. Infinite cells are left undecided.
  template <class Id>
  static Neighborhood around(const Compact_cell<Id>* cells, const Compact_vertex<Id>* vertices,
                             const Compact_cell<Id>& cell, const double* p)
  {
    using Complex = Compact_complex<Id>;
    unsigned open = 0, infinite = Complex::is_infinite(cell) ? 15 : 0;
    const double *v[4], *opposite[4];
    for (unsigned k = 0; k < 4; ++k) {
      const Compact_cell<Id>& neighbor = cells[cell.links[k] >> 2];
      const Id e = neighbor.v[cell.links[k] & 3] & Id(~Complex::doomed);
      open |= unsigned(!Complex::is_doomed(neighbor)) << k;
      infinite |= unsigned(e == Complex::infinite) << k;
      opposite[k] = vertices[e].coordinates;
      v[k] = vertices[cell.v[k] & Id(~Complex::doomed)].coordinates;
    }
    const unsigned filtered = open & ~infinite;
    if (filtered == 0)
      return {open, 0, open};
    const Sphere_signs signs = Sphere_filter::neighbors(v, opposite, p, filtered);
    return {open, signs.inside & filtered,
            (open & infinite) | (filtered & ~(signs.inside | signs.outside))};
  }

  // Writes down the neighbours `inside`, and the facets `bounding`.
  template <class Id>
  static Zone_ends<Id> note(Compact_cell<Id>* cells, const Compact_cell<Id>& cell, unsigned inside,
                            unsigned bounding, Zone_ends<Id> ends)
  {
    const Id v[4] = {Compact_complex<Id>::first_vertex(cell), cell.v[1], cell.v[2], cell.v[3]};
    for (unsigned k = 0; k < 4; ++k) {
      const Id link = cell.links[k], joins = Id(inside >> k & 1);
      cells[link >> 2].v[0] |= Id(joins << (std::numeric_limits<Id>::digits - 1));
      *ends.cell = link >> 2;
      ends.cell += joins;
      *ends.facet = {link,
                     {v[facet_corners[k][0]], v[facet_corners[k][1]], v[facet_corners[k][2]]}};
      ends.facet += bounding >> k & 1;
    }
    return ends;
  }
};

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_WIDE_FILTER

#define CGAL_DELAUNAY_FROM_SURFACE_3_WIDE __attribute__((target("avx2,popcnt")))

// The same in vectors, for ids of 32 bits; see Wide_sphere_filter.h.
struct Wide_explore_neighbors
{
  using Id = std::uint32_t;
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

  static bool is_supported()
  {
    return Wide_sphere_filter::is_supported() && __builtin_cpu_supports("popcnt");
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_WIDE static Neighborhood
  around(const Cell* cells, const Compact_vertex<Id>* vertices, const Cell& cell, const double* p)
  {
    const Id l0 = cell.links[0], l1 = cell.links[1], l2 = cell.links[2], l3 = cell.links[3];
    const Cell &n0 = cells[l0 >> 2], &n1 = cells[l1 >> 2], &n2 = cells[l2 >> 2],
               &n3 = cells[l3 >> 2];
    const Id unmarked = Id(~Complex::doomed);
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
    return {open, signs.inside & filtered,
            (open & infinite) | (filtered & ~(signs.inside | signs.outside))};
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_WIDE static Zone_ends<Id>
  note(Cell* cells, const Cell& cell, unsigned inside, unsigned bounding, Zone_ends<Id> ends)
  {
    const __m128i links = load(cell.links);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(ends.cell),
                     _mm_shuffle_epi8(_mm_srli_epi32(links, 2), load(packed[inside])));
    ends.cell += _mm_popcnt_u32(inside);
    for (unsigned k = 0; k < 4; ++k)
      cells[cell.links[k] >> 2].v[0] |= inside << (31 - k) & Complex::doomed;
    const __m128i v =
        _mm_and_si128(load(cell.v), _mm_setr_epi32(int(~Complex::doomed), -1, -1, -1));
    // lane 0: the link; lanes 1, 2, 3: the facet_corners
    write(ends, bounding & 1, v, links);
    write(ends, bounding >> 1 & 1, _mm_shuffle_epi32(v, _MM_SHUFFLE(3, 0, 2, 0)),
          _mm_shuffle_epi32(links, 1));
    write(ends, bounding >> 2 & 1, _mm_shuffle_epi32(v, _MM_SHUFFLE(3, 1, 0, 0)),
          _mm_shuffle_epi32(links, 2));
    write(ends, bounding >> 3 & 1, _mm_shuffle_epi32(v, _MM_SHUFFLE(0, 1, 2, 0)),
          _mm_shuffle_epi32(links, 3));
    return ends;
  }

private:
  CGAL_DELAUNAY_FROM_SURFACE_3_WIDE static unsigned signs_of(__m128i v)
  {
    return unsigned(_mm_movemask_ps(_mm_castsi128_ps(v)));
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_WIDE static __m128i load(const void* four_ids)
  {
    return _mm_loadu_si128(static_cast<const __m128i*>(four_ids));
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_WIDE static void write(Zone_ends<Id>& ends, unsigned is_bounding,
                                                      __m128i corners, __m128i link)
  {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(ends.facet), _mm_blend_epi32(corners, link, 1));
    ends.facet += is_bounding;
  }

  // packed[m] moves the ids of the bits of m to the front.
  static constexpr std::uint32_t i0 = 0x03020100, i1 = 0x07060504, i2 = 0x0b0a0908, i3 = 0x0f0e0d0c;
  static constexpr std::uint32_t packed[16][4] = {
      {},       {i0},         {i1},         {i0, i1},        {i2},     {i0, i2},
      {i1, i2}, {i0, i1, i2}, {i3},         {i0, i3},        {i1, i3}, {i0, i1, i3},
      {i2, i3}, {i0, i2, i3}, {i1, i2, i3}, {i0, i1, i2, i3}};
};

#undef CGAL_DELAUNAY_FROM_SURFACE_3_WIDE

// The widest there is for these ids, where the machine has vectors.
template <class Id>
using Widest_explore_neighbors =
    std::conditional_t<std::is_same<Id, Wide_explore_neighbors::Id>::value, Wide_explore_neighbors,
                       Explore_neighbors>;

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_WIDE_FILTER

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXPLORE_NEIGHBORS_H
