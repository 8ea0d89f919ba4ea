// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_COMPLEX_H

// Cells and vertices as numbers. A cell is 32 bytes (with ids of 32 bits), half a cache line.
//
// Invariants: vertices of a cell are in positive orientation (with the infinite vertex in the place
// of a point beyond the hull); the infinite vertex is vertex 0, and only ever the last of a cell.
// A link names a neighbour and, in its two lowest bits, which of the neighbour's facets is shared.
// Cells that are not in use carry the mark `doomed`.

#include <CGAL/Delaunay_from_surface_3/internal/support/Page_array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Id>
struct Compact_cell
{
  Id v[4];
  Id links[4];
};

template <class Id>
struct alignas(32) Compact_vertex
{
  double coordinates[3];
  Id cell;  // any cell of the vertex
  Id label; // scratch of the update that owns the vertex
};

// The corners of facet i, such that (p, corners) is positive for p on the inner side, and the
// infinite vertex stays the last.
constexpr unsigned char facet_corners[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}};

template <class Id>
class Compact_complex
{
  static_assert(std::numeric_limits<Id>::is_integer && !std::numeric_limits<Id>::is_signed,
                "ids are unsigned");

public:
  using Cell = Compact_cell<Id>;
  using Vertex = Compact_vertex<Id>;

  static constexpr Id infinite = 0;
  static constexpr Id doomed = Id(Id(1) << (std::numeric_limits<Id>::digits - 1)); // of v[0]
  static constexpr std::size_t max_vertices = doomed;
  static constexpr std::size_t max_cells = std::size_t((std::numeric_limits<Id>::max)() >> 2) + 1;

  // With the infinite vertex only, and room for n more and their cells on a surface.
  explicit Compact_complex(std::size_t n)
  {
    m_vertices.reserve((std::min)(n + 1, max_vertices), 0);
    m_cells.reserve((std::min)(7 * n + 64, max_cells), 0);
    add_vertex({0, 0, 0});
  }

  Cell* cells() { return m_cells.data(); }
  Vertex* vertices() { return m_vertices.data(); }
  Cell& cell(std::size_t c) { return m_cells[c]; }
  const Cell& cell(std::size_t c) const { return m_cells[c]; }
  Vertex& vertex(std::size_t v) { return m_vertices[v]; }
  const Vertex& vertex(std::size_t v) const { return m_vertices[v]; }
  std::size_t number_of_vertices() const { return m_number_of_vertices; } // the infinite one too
  std::size_t cells_end() const { return m_cells_end; }                   // those not in use too
  std::size_t number_of_cells() const { return m_cells_end - m_free.size(); }

  static bool is_doomed(const Cell& c) { return (c.v[0] & doomed) != 0; }
  static Id first_vertex(const Cell& c) { return Id(c.v[0] & Id(~doomed)); }
  static bool is_infinite(const Cell& c) { return c.v[3] == infinite; }
  static Id link(Id cell, unsigned facet) { return Id(Id(cell << 2) | facet); }

  Id add_vertex(const std::array<double, 3>& coordinates)
  {
    if (m_number_of_vertices == max_vertices)
      throw std::length_error("Compact_delaunay_3: more vertices than ids");
    if (m_number_of_vertices == m_vertices.capacity())
      m_vertices.reserve(2 * m_number_of_vertices + 1, m_number_of_vertices);
    Vertex& v = m_vertices[m_number_of_vertices];
    for (int i = 0; i < 3; ++i)
      v.coordinates[i] = coordinates[std::size_t(i)];
    v.cell = v.label = 0;
    return Id(m_number_of_vertices++);
  }

  // A cell that is not in use.
  Id take_cell()
  {
    if (!m_free.empty()) {
      const Id c = m_free.back();
      m_free.pop_back();
      return c;
    }
    if (m_cells_end == max_cells)
      throw std::length_error("Compact_delaunay_3: more cells than ids");
    if (m_cells_end == m_cells.capacity())
      m_cells.reserve((std::min)(m_cells_end + m_cells_end / 2 + 1, max_cells), m_cells_end);
    return Id(m_cells_end++);
  }

  // `c` is doomed.
  void give_back_cell(Id c) { m_free.push_back(c); }

  // Makes the cell of four vertices, positively oriented, and the infinite ones around it.
  void start(const std::array<Id, 4>& v)
  {
    std::array<Id, 5> cells;
    for (Id& c : cells)
      c = take_cell();
    for (unsigned i = 0; i < 4; ++i) {
      cell(cells[4]).v[i] = v[i];
      cell(cells[i]) = {{v[i ^ 1], v[i ^ 2], v[i ^ 3], infinite}, {0, 0, 0, 0}};
      vertex(v[i]).cell = cells[4];
    }
    vertex(infinite).cell = cells[0];
    for (const Id c : cells)
      for (const Id d : cells)
        if (c != d)
          link_if_adjacent(c, d);
  }

  // For the export, which reads cells in ascending order and once.
  void release_cells_before(std::size_t c) { m_cells.release_front(c); }
  void deallocate_cells() { m_cells.deallocate(); }
  void deallocate_vertices() { m_vertices.deallocate(); }

private:
  void link_if_adjacent(Id c, Id d)
  {
    const unsigned i = lonely_vertex(cell(c), cell(d)), j = lonely_vertex(cell(d), cell(c));
    if (i < 4 && j < 4)
      cell(c).links[i] = link(d, j);
  }

  // The only vertex of c that d has not; 4 if there are more.
  static unsigned lonely_vertex(const Cell& c, const Cell& d)
  {
    unsigned lonely = 4, count = 0;
    for (unsigned i = 0; i < 4; ++i)
      if (c.v[i] != d.v[0] && c.v[i] != d.v[1] && c.v[i] != d.v[2] && c.v[i] != d.v[3])
        lonely = i, ++count;
    return count == 1 ? lonely : 4;
  }

  Page_array<Cell> m_cells;
  Page_array<Vertex> m_vertices;
  std::size_t m_cells_end = 0;
  std::size_t m_number_of_vertices = 0;
  std::vector<Id> m_free;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_COMPLEX_H
