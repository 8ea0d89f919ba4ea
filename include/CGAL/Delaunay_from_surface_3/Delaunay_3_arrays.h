// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_3_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Arrays

is a 3D Delaunay triangulation as arrays of numbers, returned by `delaunay_3_arrays()`, or a regular
one, returned by `regular_3_arrays()`. It contains no object of CGAL.

\code{.cpp}
const auto arrays = CGAL::delaunay_3_arrays(points);
for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
  const auto [a, b, d, e] = arrays.vertices(c);          // indices into points, positively oriented
  for (int i = 0; i < 4; ++i)
    if (!arrays.is_infinite(arrays.neighbors(c)[i])) {}  // the tetrahedron opposite to vertex i
}
\endcode

The first cells are the tetrahedra. From number `number_of_simplices()` on follow the infinite
cells, one for each facet of the convex hull. The last vertex of an infinite cell is `none`. A point
beyond the facet of the other three forms a positively oriented tetrahedron when it replaces `none`.
Neighbour i shares the facet opposite to vertex i. Of several equal points, the one with the
smallest index is the vertex. Points with weights are equal if their weights are, too; those that
are hidden have no vertex, but `none`.

If all points lie in a plane, on a line, or coincide, the dimension d is 2, 1 or 0. A cell then has
d + 1 vertices and neighbours, and the remaining entries are `none`. In a plane all triangles have
the same orientation.

Objects can be copied and moved; an object that was moved from is empty.

<b>Memory</b>: 32 bytes per cell with `std::int32_t`, and 4 per point.

\tparam Index a signed integer type; `delaunay_3_arrays()` makes arrays of `std::int32_t`
*/
template <class Index = std::int32_t>
class Delaunay_3_arrays
{
  static_assert(std::numeric_limits<Index>::is_integer && std::numeric_limits<Index>::is_signed,
                "an index can be -1");

public:
  /// the infinite vertex, an entry without vertex or neighbour, or the vertex of a hidden point.
  static constexpr Index none = -1;

  /// constructs the triangulation of no points, whose dimension is -1.
  Delaunay_3_arrays() = default;

  /// \cond
  Delaunay_3_arrays(const Delaunay_3_arrays& other)
    : m_dimension(other.m_dimension)
    , m_number_of_simplices(other.m_number_of_simplices)
    , m_number_of_cells(other.m_number_of_cells)
    , m_stride(other.m_stride)
    , m_vertices(copied(other.m_vertices, m_stride * m_number_of_cells))
    , m_neighbors(copied(other.m_neighbors, other.m_neighbors.data() ? 4 * m_number_of_cells : 0))
    , m_vertices_of_points(other.m_vertices_of_points)
  {
  }
  Delaunay_3_arrays(Delaunay_3_arrays&& other) noexcept { swap(other); }
  Delaunay_3_arrays& operator=(Delaunay_3_arrays other) noexcept
  {
    swap(other);
    return *this;
  }
  ~Delaunay_3_arrays() = default;

  using Entries = Delaunay_from_surface_3::internal::Page_array<Index>;

  // Each cell: four vertices, four neighbours.
  Delaunay_3_arrays(int dimension, std::size_t number_of_simplices, std::size_t number_of_cells,
                    Entries&& cells, std::vector<Index>&& vertices_of_points)
    : m_dimension(dimension)
    , m_number_of_simplices(number_of_simplices)
    , m_number_of_cells(number_of_cells)
    , m_vertices(std::move(cells))
    , m_vertices_of_points(std::move(vertices_of_points))
  {
    m_vertices.release(m_stride * m_number_of_cells, m_vertices.capacity());
  }
  /// \endcond

  /// \name Numbers
  ///@{

  /// returns the dimension: 3, less if all points lie in a plane, and -1 if there are none.
  int dimension() const { return m_dimension; }

  /// returns the number of points that were given.
  std::size_t number_of_points() const { return m_vertices_of_points.size(); }

  /// returns the number of distinct points, without hidden ones, in linear time.
  std::size_t number_of_vertices() const
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < number_of_points(); ++i)
      count += vertex_of_point(i) == Index(i);
    return count;
  }

  /// returns the number of tetrahedra, or of simplices of lower dimension.
  std::size_t number_of_simplices() const { return m_number_of_simplices; }

  /// returns the number of cells, infinite ones included.
  std::size_t number_of_cells() const { return m_number_of_cells; }
  ///@}

  /// \name Cells
  ///@{

  /// returns the vertices of cell `c`: indices of points.
  std::array<Index, 4> vertices(std::size_t c) const { return entries(vertices_data(), c); }

  /// returns the neighbours of cell `c`. \pre The neighbours have not been dropped.
  std::array<Index, 4> neighbors(std::size_t c) const { return entries(neighbors_data(), c); }

  /// returns whether `c` is an infinite cell or `none`.
  bool is_infinite(Index c) const { return c < 0 || std::size_t(c) >= m_number_of_simplices; }

  /// returns the smallest index of a point equal to point `i`, or `none` if it is hidden.
  Index vertex_of_point(std::size_t i) const { return m_vertices_of_points[i]; }
  ///@}

  /// \name Arrays
  /// Entry k of cell c stands at place `c * stride() + k`.
  ///@{

  /// returns the vertices of all cells.
  const Index* vertices_data() const { return m_vertices.data(); }

  /// returns the neighbours of all cells, or a null pointer if they have been dropped.
  const Index* neighbors_data() const
  {
    if (m_stride == 4)
      return m_neighbors.data();
    return m_vertices.data() == nullptr ? nullptr : m_vertices.data() + 4;
  }

  /// returns 8 at first, since vertices and neighbours of a cell are stored side by side; 4 after
  /// `separate()` or `drop_neighbors()`.
  std::size_t stride() const { return m_stride; }

  /// returns the vertex of each point, `none` for hidden ones.
  const std::vector<Index>& vertices_of_points() const { return m_vertices_of_points; }
  ///@}

  /// \name Reducing
  /// These functions take linear time and free memory.
  ///@{

  /// removes the infinite cells; as neighbours they are replaced by `none`.
  void drop_infinite_cells()
  {
    m_number_of_cells = m_number_of_simplices;
    const auto end = Index(m_number_of_simplices);
    if (Index* const neighbors = const_cast<Index*>(neighbors_data()))
      for (std::size_t c = 0; c < m_number_of_cells; ++c)
        for (std::size_t k = 0; k < 4; ++k) {
          const Index neighbor = neighbors[c * m_stride + k];
          neighbors[c * m_stride + k] = neighbor < end ? neighbor : none; // in vectors
        }
    m_vertices.release(m_stride * m_number_of_cells, m_vertices.capacity());
    m_neighbors.release(4 * m_number_of_cells, m_neighbors.capacity());
  }

  /// removes the neighbours; the vertices become one array without gaps.
  void drop_neighbors()
  {
    close_gaps();
    m_neighbors.deallocate();
  }

  /// makes vertices and neighbours two arrays without gaps; this temporarily takes 16 bytes per
  /// cell.
  void separate()
  {
    if (m_stride == 4)
      return;
    m_neighbors.allocate(4 * m_number_of_cells);
    for (std::size_t c = 0; c < m_number_of_cells; ++c)
      std::copy_n(neighbors_data() + 8 * c, 4, m_neighbors.data() + 4 * c);
    close_gaps();
  }
  ///@}

private:
  static Entries copied(const Entries& entries, std::size_t n)
  {
    Entries copy;
    copy.allocate(n);
    std::copy_n(entries.data(), n, copy.data());
    return copy;
  }

  void swap(Delaunay_3_arrays& other) noexcept
  {
    std::swap(m_dimension, other.m_dimension);
    std::swap(m_number_of_simplices, other.m_number_of_simplices);
    std::swap(m_number_of_cells, other.m_number_of_cells);
    std::swap(m_stride, other.m_stride);
    m_vertices.swap(other.m_vertices);
    m_neighbors.swap(other.m_neighbors);
    m_vertices_of_points.swap(other.m_vertices_of_points);
  }

  std::array<Index, 4> entries(const Index* data, std::size_t c) const
  {
    const Index* const e = data + c * m_stride;
    return {e[0], e[1], e[2], e[3]};
  }

  void close_gaps()
  {
    Index* const data = m_vertices.data();
    for (std::size_t c = 1; m_stride == 8 && c < m_number_of_cells; ++c)
      std::copy_n(data + 8 * c, 4, data + 4 * c);
    m_stride = 4;
    m_vertices.release(4 * m_number_of_cells, m_vertices.capacity());
  }

  int m_dimension = -1;
  std::size_t m_number_of_simplices = 0, m_number_of_cells = 0, m_stride = 8;
  Entries m_vertices;  // and neighbours, as long as the stride is 8
  Entries m_neighbors; // if the stride is 4; none if they have been dropped
  std::vector<Index> m_vertices_of_points;
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_3_ARRAYS_H
