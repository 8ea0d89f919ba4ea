// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_COMPACT_CELL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_COMPACT_CELL_H

// A cell and a vertex as numbers. A cell is 32 bytes (with ids of 32 bits), half a cache line.
//
// One vertex, one number: that of the i-th point in the order of insertion is i + 1; 0 is the
// infinite vertex.
//
// Invariants: vertices of a cell are in positive orientation (with the infinite vertex in the place
// of a point beyond the hull); the infinite vertex is only ever the last of a cell. A link names a
// neighbour and, in its two lowest bits, which of the neighbour's facets is shared: 4 · cell +
// facet, as in TetGen's and HXT's meshes (Si 2015; Marot, Pellerin, Remacle 2019). A cell that is
// destroyed is `dead`, and so is one that is not in use; that mark is the highest bit of its first
// vertex.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

template <class Id>
struct Compact_cell
{
  Id v[4];
  Id links[4];
};

// `label` belongs to the insertion under way (Fill_star.h). It lies here, in bytes that alignment
// would leave empty, beside the coordinates that were just read. In an array of its own, as many
// threads need it (Write_announced.h), it takes longer.
template <class Id>
struct alignas(32) Compact_vertex
{
  double coordinates[3];
  Id cell; // any cell of the vertex
  Id label;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The corners of facet i, such that (p, corners) is positive for p on the inner side, and the
// infinite vertex stays the last.
inline constexpr unsigned char facet_corners[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}};

// Ids of 64 bits number more than an address space of 32 bits holds.
constexpr std::size_t at_most_all(std::uint64_t n)
{
  return n < (std::numeric_limits<std::size_t>::max)() ? std::size_t(n)
                                                       : (std::numeric_limits<std::size_t>::max)();
}

// What the numbers say.
template <class Id>
struct Compact_numbers
{
  static_assert(std::numeric_limits<Id>::is_integer && !std::numeric_limits<Id>::is_signed,
                "ids are unsigned");

  static constexpr Id infinite = 0;
  static constexpr Id dead = Id(Id(1) << (std::numeric_limits<Id>::digits - 1)); // of v[0]
  static constexpr std::size_t max_vertices = at_most_all(dead);
  static constexpr std::size_t max_cells = at_most_all(((std::numeric_limits<Id>::max)() >> 2) + 1);

  static Id vertex_of_point(std::size_t i) { return Id(i + 1); }
  static std::size_t point_of_vertex(std::size_t v) { return v - 1; }

  static bool is_dead(const Compact_cell<Id>& c) { return (c.v[0] & dead) != 0; }
  static Id first_vertex(const Compact_cell<Id>& c) { return Id(c.v[0] & Id(~dead)); }
  static bool is_infinite(const Compact_cell<Id>& c) { return c.v[3] == infinite; }
  static Id link(Id cell, unsigned facet) { return Id(Id(cell << 2) | facet); }

  // cells[link >> 2]; of a cell of 32 bytes the number times 4 is the address divided by 8, which
  // saves an operation.
  template <class Cell>
  static Cell& cell_of_link(Cell* cells, Id link)
  {
    using Byte = std::conditional_t<std::is_const<Cell>::value, const char, char>;
    return *reinterpret_cast<Cell*>(reinterpret_cast<Byte*>(cells) +
                                    std::size_t(link & Id(~Id(3))) * (sizeof(Cell) / 4));
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_COMPACT_CELL_H
