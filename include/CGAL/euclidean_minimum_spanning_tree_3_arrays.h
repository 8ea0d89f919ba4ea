// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_ARRAYS_H
#define CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/Delaunay_from_surface_3/arrays/spanning_trees.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Arrays

writes the edges of a Euclidean minimum spanning tree of the vertices of arrays: a spanning tree whose
edges have the smallest sum of lengths (\cgalCite{choi-dtsm-02}, §3.1). A point that equals one with a
smaller index is not a vertex, and has no edges.

\code{.cpp}
std::vector<std::array<std::int32_t, 2>> tree;
CGAL::euclidean_minimum_spanning_tree_3(arrays, points, std::back_inserter(tree));
\endcode

Lengths are compared exactly. Among edges of the same length, those between points with smaller indices
come first.

<b>Complexity</b>: \f$O(m \log m)\f$ for m edges of the triangulation. While it runs, it holds 4 bytes
for each edge of each tetrahedron, 24 for each edge that is not clearly the longest of a triangle, and
some 8 per point.

\param arrays the Delaunay triangulation of the points
\param points the points of the arrays, in the same order; any range that `delaunay_3_arrays()`
takes
\param out accepts `std::array<Index, 2>` for each edge, from the shortest to the longest, each with
the smaller index first

\return the output iterator past the last edge written

\pre The points have no weights, and lie in no periodic box.

\throws Surface_input_error if a coordinate is not a finite number, if the arrays are of another number
of points, or if weights hide a point
\throws std::length_error if there are more than 700 million tetrahedra

\sa `delaunay_3_arrays()`
*/
template <class Index, class PointRange, class OutputIterator>
OutputIterator euclidean_minimum_spanning_tree_3(const Delaunay_3_arrays<Index>& arrays,
                                                 const PointRange& points, OutputIterator out)
{
  using namespace Delaunay_from_surface_3::internal;
  Read_coordinates<PointRange> read(points);
  check_number_of_points(arrays, read.size());
  refuse_hidden_points(arrays, "spanning tree needs all points");
  if (arrays.dimension() < 1)
    return out;
  std::vector<Measured_edge<std::uint32_t>> tree;
  {
    const Rounding_to_nearest rounding;
    const Lengths_between lengths(read.points());
    const Index* const corners = arrays.vertices_data();
    tree = edges_of_simplices(
        arrays.number_of_simplices(), std::size_t(arrays.dimension()) + 1, read.size(),
        [&](std::size_t c, std::size_t k) { return corners[c * arrays.stride() + k]; }, lengths,
        Alone());
    keep_minimum_spanning_forest(tree, read.size(), lengths);
  }
  for (const auto& e : tree)
    *out++ = std::array<Index, 2>{Index(e.ends[0]), Index(e.ends[1])};
  return out;
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_ARRAYS_H
