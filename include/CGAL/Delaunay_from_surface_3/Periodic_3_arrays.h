// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PERIODIC_3_ARRAYS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PERIODIC_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Arrays

holds a triangulation of points in a periodic box as arrays of numbers, made by
`periodic_delaunay_3_arrays()`. Corner k of tetrahedron c is the point with index `vertices(c)[k]`,
moved by `offsets(c)[k]` periods:

\code{.cpp}
const auto arrays = CGAL::periodic_delaunay_3_arrays(points, box);
for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t a = 0; a < 3; ++a)
      corners[c][k][a] = points[arrays.vertices(c)[k]][a] + arrays.offsets(c)[k][a] * box[a];
\endcode

Each tetrahedron stands for all its copies, and is kept as the one whose first corner has the offset
(0, 0, 0): that of the smallest index or, of several copies of one point, the lexicographically
smallest. Neighbour i is the tetrahedron, or the one of which a copy lies, beyond the facet opposite to
corner i. Without a period along some axis there is a hull: there the neighbour is `none`. There are no
infinite cells.

The members that are not described here are those of `Delaunay_3_arrays`. But it is no
`Delaunay_3_arrays`: functions that take one place each point once.

<b>Memory</b>: 24 bytes per tetrahedron more than `Delaunay_3_arrays`.

\tparam Index a signed integer type

\sa `Delaunay_3_arrays`
*/
template <class Index = std::int32_t>
class Periodic_3_arrays : private Delaunay_3_arrays<Index>
{
  using Base = Delaunay_3_arrays<Index>;

public:
  using Base::dimension;
  using Base::drop_neighbors;
  using Base::is_infinite;
  using Base::neighbors;
  using Base::neighbors_data;
  using Base::none;
  using Base::number_of_cells;
  using Base::number_of_points;
  using Base::number_of_simplices;
  using Base::number_of_vertices;
  using Base::separate;
  using Base::stride;
  using Base::vertex_of_point;
  using Base::vertices;
  using Base::vertices_data;
  using Base::vertices_of_points;

  /// a number of periods along each axis.
  using Offset = std::array<std::int16_t, 3>;

  /// constructs the triangulation of no points.
  Periodic_3_arrays() = default;

  /// \cond SKIP_IN_MANUAL
  Periodic_3_arrays(Delaunay_3_arrays<Index>&& arrays, std::vector<std::array<Offset, 4>>&& offsets,
                    std::size_t number_of_copies, bool is_simplicial_complex)
    : Base(std::move(arrays))
    , m_offsets(std::move(offsets))
    , m_number_of_copies(number_of_copies)
    , m_is_simplicial_complex(is_simplicial_complex)
  {
  }
  /// \endcond

  /// returns the offsets of the corners of tetrahedron `c`, from the points as they were given.
  const std::array<Offset, 4>& offsets(std::size_t c) const { return m_offsets[c]; }

  /// returns the offsets of all tetrahedra, 12 numbers for each.
  const std::int16_t* offsets_data() const
  {
    return m_offsets.empty() ? nullptr : m_offsets[0][0].data();
  }

  /// returns whether the indices alone determine each edge: no edge joins a point to its own copy,
  /// and no two edges have the same ends. Then the tetrahedra are a simplicial complex, as in a
  /// `Periodic_3_Delaunay_triangulation_3` in one sheet.
  bool is_simplicial_complex() const { return m_is_simplicial_complex; }

  /// returns how many copies of points were inserted beside the points.
  std::size_t number_of_copies() const { return m_number_of_copies; }

private:
  std::vector<std::array<Offset, 4>> m_offsets;
  std::size_t m_number_of_copies = 0;
  bool m_is_simplicial_complex = true;
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PERIODIC_3_ARRAYS_H
