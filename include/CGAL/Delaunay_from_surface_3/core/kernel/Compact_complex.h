// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_COMPLEX_H

// A complex holds cells and vertices as numbers, with the invariants of Built.h. The working memory
// of an insertion is in Dig_conflict_zone.h.
//
// Vertices have coordinates before they are in any cell. The numbers of duplicates stay unused.
//
// Coordinates are scaled by a power of 2. If that rounds some, because they are so small, the
// complex keeps the points' own coordinates, too, which the exact predicates use.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A vertex with a weight, behind its coordinates, so that one vector has all four.
struct Weighted_vertex
{
  using Place = Weighted_place;
  using Exact_place = Place;
  static constexpr bool has_weight = true;
  static constexpr std::size_t size = 4;

  double coordinates[4];
  Id cell; // any cell of the vertex, or for a hidden one a cell that it was in, or that hid it
  Id label;
};

// What the exact predicates use beside the vertices, by point.
template <class Vertex>
struct Exact_coordinates
{
  using type = std::vector<std::array<double, Vertex::size>>; // empty if none are rounded
};

template <class Vertex_>
class Compact_complex : public Compact_numbers
{
public:
  using Cell = Compact_cell;
  using Vertex = Vertex_;
  using Place = typename Vertex::Place;
  using Exact_place = typename Vertex::Exact_place;
  using Coordinates_of_point = std::array<double, Vertex::size>; // with the weight, if it has one
  using Own_coordinates = typename Exact_coordinates<Vertex>::type;
  using Numbers = Compact_numbers;
  using Numbers::dead;
  using Numbers::encode;
  using Numbers::infinite;
  using Numbers::is_dead;
  using Numbers::max_cells;
  using Numbers::max_vertices;
  using Numbers::point_of_vertex;
  using Numbers::vertex_of_point;

  // The infinite vertex is so far away that the filter leaves every sphere test with it undecided:
  // all others lie within 2^59, so a determinant is less than 2^600, but its bound exceeds 2^700.
  static constexpr double far = 0x1p150;

  static constexpr std::size_t cells_of_gigabyte = (std::size_t(1) << 30) / sizeof(Cell);

  // Makes a complex without vertices.
  Compact_complex() = default;

  // Makes the vertices of n points, in no cell yet. Several threads may call coordinates(i), which
  // returns the coordinates of the i-th point.
  template <class Coordinates>
  Compact_complex(std::size_t n, const Coordinates& coordinates, const Executor& executor = Alone())
    : m_number_of_vertices(n + 1)
  {
    if (m_number_of_vertices > max_vertices)
      throw Too_many_cells();
    m_vertices.reserve(m_number_of_vertices, 0);
    m_vertices.touch(infinite, infinite + 1);
    m_vertices[infinite] = Vertex{{far, 0, 0}, 0, 0};
    if constexpr (Vertex::has_weight)
      m_vertices[infinite].coordinates[3] = n > 0 ? coordinates(0)[3] : 0; // of usual size
    for_each_block(executor, n, number_of_blocks(executor, n, 4096),
                   [&](std::size_t first, std::size_t last, std::size_t) {
                     m_vertices.touch(vertex_of_point(first), vertex_of_point(last));
                     for (std::size_t i = first; i < last; ++i)
                       m_vertices[vertex_of_point(i)] = vertex_at(coordinates(i));
                   });
  }

  // Limits the cells, dead ones included, to n: if there would be more, Too_many_cells is thrown.
  void limit_cells(std::size_t n) { m_most_cells = n; }

  // Adds a vertex, in no cell yet, and returns its number. The vertices may move in memory.
  Id add_vertex(const Coordinates_of_point& p)
  {
    if (m_number_of_vertices == max_vertices)
      throw Too_many_cells();
    if (m_number_of_vertices == m_vertices.capacity())
      m_vertices.reserve(m_number_of_vertices + m_number_of_vertices / 2 + 16,
                         m_number_of_vertices);
    m_vertices[m_number_of_vertices] = vertex_at(p);
    return Id(m_number_of_vertices++);
  }
  void add_own_coordinates(const Coordinates_of_point& p) { m_own_coordinates.push_back(p); }

  // Gives vertex v the number of an earlier vertex that is not needed. Cells are left alone.
  void renumber_vertex(Id v, Id number)
  {
    m_vertices[number] = m_vertices[v];
    if (is_rounded())
      m_own_coordinates[point_of_vertex(number)] = own_coordinates(v);
  }

  Own_coordinates& all_own_coordinates() { return m_own_coordinates; }
  const Own_coordinates& all_own_coordinates() const { return m_own_coordinates; }

  // Removes the vertices from this one on, which must be in no cell.
  void drop_vertices(std::size_t end)
  {
    m_number_of_vertices = end;
    m_own_coordinates.resize((std::min)(m_own_coordinates.size(), end - 1));
  }
  const Coordinates_of_point& own_coordinates(Id v) const
  {
    return m_own_coordinates[point_of_vertex(v)];
  }

  // Keeps the coordinates of the points before they were scaled. To be called if that rounded any.
  void keep_own_coordinates(Own_coordinates&& coordinates)
  {
    m_own_coordinates = std::move(coordinates);
  }
  bool is_rounded() const
  {
    if constexpr (core::is_rounded<Place>) // each exact place tells
      return false;
    else
      return !m_own_coordinates.empty();
  }

  // The size of rows up to which doubles round nothing (lattice_sign()); 0 if the vertices are on no
  // lattice, or if that is not known.
  double exact_size() const { return m_exact_size; }
  void set_exact_size(double size) { m_exact_size = size; }

  // Return where a vertex has its coordinates, and where a finite one has exact ones, up to a power
  // of 2 that all have in common.
  Place place(Id v) const { return Place(vertex(v).coordinates); }
  Exact_place exact_place(Id v) const
  {
    if constexpr (core::is_rounded<Place>)
      return m_own_coordinates.place(point_of_vertex(v));
    else
      return is_rounded() ? Place(own_coordinates(v).data()) : place(v);
  }
  const double* exact_coordinates(Id v) const { return coordinates_of(exact_place(v)); }

  Cell* cells() { return m_cells.data(); }
  const Cell* cells() const { return m_cells.data(); }
  Vertex* vertices() { return m_vertices.data(); }
  const Vertex* vertices() const { return m_vertices.data(); }
  Cell& cell(std::size_t c) { return m_cells[c]; }
  const Cell& cell(std::size_t c) const { return m_cells[c]; }
  Vertex& vertex(std::size_t v) { return m_vertices[v]; }
  const Vertex& vertex(std::size_t v) const { return m_vertices[v]; }
  std::size_t vertices_end() const { return m_number_of_vertices; } // counts 0 and unused ones, too
  std::size_t cells_end() const { return m_cells_end; }             // counts dead ones, too

  // Returns the number of a fresh cell. The cells may move in memory.
  Id new_cell()
  {
    if (m_cells_end >= m_cells_ready)
      make_ready();
    return Id(m_cells_end++);
  }

  // Makes room for n cells, or for as many as are allowed if these are fewer; throws Too_many_cells
  // if there is room for these already. The cells may move in memory.
  void make_room(std::size_t n)
  {
    if (n > m_most_cells && m_cells.capacity() >= m_most_cells)
      throw Too_many_cells();
    m_cells.reserve((std::min)(n, m_most_cells), m_cells_end);
  }
  std::size_t capacity() const { return m_cells.capacity(); }
  void make_room_for_vertices(std::size_t n)
  {
    m_vertices.reserve((std::min)(n, max_vertices), m_number_of_vertices);
  }

  // Returns the next capacity after n, much larger, since cells that move are touched anew.
  static std::size_t more_room(std::size_t n)
  {
    return n < cells_of_gigabyte / 4 ? 4 * n + 1 : n + n / 2 + 1;
  }

  // Tells where the cells end, dead ones included, if not only new_cell() hands them out.
  void use_cells(std::size_t end) { m_cells_end = end; }
  void touch_cells(std::size_t first, std::size_t last) { m_cells.touch(first, last); }

  // Makes the first cells: the one of four vertices, which must be positively oriented, and the
  // infinite ones around it. Makes room for the 6.5 to 7.5 cells per point that surfaces have.
  // Lattices and smooth surfaces without noise have up to 15 for a time; since pages that nobody
  // writes take no memory, there is room for these, too, unless that is more than a gigabyte.
  void start(const std::array<Id, 4>& v)
  {
    const std::size_t few = 8 * m_number_of_vertices + 64, many = 16 * m_number_of_vertices + 64;
    m_cells.reserve((std::min)(many < cells_of_gigabyte ? many : few, m_most_cells), 0);
    std::array<Id, 5> cells;
    for (Id& c : cells)
      c = new_cell();
    for (unsigned i = 0; i < 4; ++i) {
      cell(cells[4]).v[i] = v[i];
      cell(cells[i]) = {{v[i ^ 1], v[i ^ 2], v[i ^ 3], infinite}, {0, 0, 0, 0}};
      vertex(v[i]).cell = cells[4];
    }
    vertex(infinite).cell = cells[0];
    for (const Id c : cells)
      for (const Id d : cells)
        if (c != d)
          join_if_adjacent(c, d);
  }

  // Returns true if vertex v is in its cell; a hidden one is in none.
  bool is_in_cell(Id v) const
  {
    const Cell& c = cell(vertex(v).cell);
    return !is_dead(c) && std::find(c.v, c.v + 4, v) != c.v + 4;
  }

  // Returns true if the neighbour across each facet leads back, and has the same corners in the
  // opposite direction, and if the cell of each vertex in use is alive and contains it. Linear.
  bool is_valid() const
  {
    for (std::size_t c = 0; c < m_cells_end; ++c)
      for (unsigned i = 0; !is_dead(cell(c)) && i < 4; ++i) {
        const Id there = cell(c).neighbors[i];
        if (!is_in_cell(cell(c).v[i]) || std::size_t(there >> 2) >= m_cells_end ||
            is_dead(cell(there >> 2)) ||
            cell(there >> 2).neighbors[there & 3] != encode(Id(c), i) ||
            !is_same_facet(cell(c), i, cell(there >> 2), there & 3))
          return false;
      }
    if (Vertex::has_weight) // those that are hidden are in no cell
      return true;
    for (std::size_t v = 0; v < m_number_of_vertices; ++v)
      if (vertex(v).cell != 0 && !is_in_cell(Id(v)))
        return false;
    return true;
  }

  // The export reads each cell once, and releases memory when it is not read any more.
  Page_array<Cell>& memory_of_cells() { return m_cells; }
  Page_array<Vertex>& memory_of_vertices() { return m_vertices; }

private:
  static Vertex vertex_at(const Coordinates_of_point& p)
  {
    if constexpr (Vertex::has_weight)
      return {{p[0], p[1], p[2], p[3]}, 0, 0};
    else
      return {{p[0], p[1], p[2]}, 0, 0};
  }

  // Prepares the cells from m_cells_end on whose pages are taken together.
  void make_ready()
  {
    if (m_cells_end >= m_most_cells)
      throw Too_many_cells();
    if (m_cells_end == m_cells.capacity())
      m_cells.reserve((std::min)(more_room(m_cells_end), m_most_cells), m_cells_end);
    m_cells_ready = (std::min)(m_cells.end_of_pages(m_cells_end), m_most_cells);
    m_cells.touch(m_cells_end, m_cells_ready);
  }

  void join_if_adjacent(Id c, Id d)
  {
    const unsigned i = lonely_vertex(cell(c), cell(d)), j = lonely_vertex(cell(d), cell(c));
    if (i < 4 && j < 4)
      cell(c).neighbors[i] = encode(d, j);
  }

  // Returns the index of the only vertex of c that d does not have; 4 if there is not exactly one.
  static unsigned lonely_vertex(const Cell& c, const Cell& d)
  {
    unsigned lonely = 4, count = 0;
    for (unsigned i = 0; i < 4; ++i)
      if (std::find(d.v, d.v + 4, c.v[i]) == d.v + 4)
        lonely = i, ++count;
    return count == 1 ? lonely : 4;
  }

  // Returns true if facet i of c and facet j of d have the same corners in opposite directions.
  static bool is_same_facet(const Cell& c, unsigned i, const Cell& d, unsigned j)
  {
    for (unsigned r = 0; r < 3; ++r) {
      bool is_same = true;
      for (unsigned k = 0; k < 3; ++k)
        is_same = is_same && c.v[facet_corners[i][k]] == d.v[facet_corners[j][(r + 3 - k) % 3]];
      if (is_same)
        return true;
    }
    return false;
  }

  Page_array<Cell> m_cells;
  Page_array<Vertex> m_vertices;
  Own_coordinates m_own_coordinates;
  double m_exact_size = 0;
  std::size_t m_most_cells = max_cells;
  std::size_t m_cells_end = 0;
  std::size_t m_cells_ready = 0; // up to here cells are prepared
  std::size_t m_number_of_vertices = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_COMPLEX_H
