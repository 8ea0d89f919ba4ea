// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_SPANNING_FOREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_SPANNING_FOREST_H

// Runs Kruskal's algorithm on edges between points: Choi 2002, §3.1, "a minimum spanning tree
// algorithm". If F contains the Euclidean minimum spanning tree of S, then this tree is the minimum
// spanning tree of F.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The lengths of edges between points of a kernel, which compares those that are nearly equal.
// point(i) is a reference to point i.
template <class PointOf, class GeomTraits>
class Lengths_by_kernel
{
  using Coordinate = std::decay_t<decltype(std::declval<const PointOf&>()(0).x())>;

public:
  static constexpr bool has_doubles = std::is_same<Coordinate, double>::value;

  Lengths_by_kernel(const PointOf& point, const GeomTraits& gt)
    : m_point(point)
    , m_compare_distance(gt.compare_distance_3_object())
  {
  }

  // 0, which is never clearly less, if the coordinates are no doubles.
  double squared_length(std::size_t i, std::size_t j) const
  {
    if constexpr (has_doubles) {
      const auto &p = m_point(i), &q = m_point(j);
      const double x = p.x() - q.x(), y = p.y() - q.y(), z = p.z() - q.z();
      return x * x + y * y + z * z;
    }
    return 0;
  }

  void prefetch_point(std::size_t) const {}

  template <class Edge>
  int compare(const Edge& a, const Edge& b) const
  {
    return int(m_compare_distance(m_point(a.ends[0]), m_point(a.ends[1]), m_point(b.ends[0]),
                                  m_point(b.ends[1])));
  }

private:
  PointOf m_point;
  decltype(std::declval<const GeomTraits&>().compare_distance_3_object()) m_compare_distance;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a minimum spanning forest, one tree per connected component, with the smallest
sum of edge lengths. If the surface contains a Euclidean minimum spanning tree of its points
(`contains_euclidean_minimum_spanning_tree()`), and no two vertices have the same point, the forest
is such a tree: its degree is at most 12, and its edges are Delaunay (\cgalCite{choi-dtsm-02},
§3.1). Otherwise nothing bounds its degree.

A graph has no lengths, so the points must be given. Your own traits class passes them on:

\code{.cpp}
struct My_traits : CGAL::Tracing_traits_3
{
  using Surface_subgraph = CGAL::Delaunay_from_surface_3::Minimum_spanning_forest<Point>;
  const std::vector<Point>& points; // by the vertices of the surface
  Surface_subgraph surface_subgraph_object() const { return Surface_subgraph(points); }
};
\endcode

<b>Complexity</b>: \f$O(n + m \log m)\f$ for n vertices and m edges. Lengths are compared exactly;
edges of the same length are taken in the order of the indices of their vertices.

\tparam Point a point of a %CGAL kernel with exact predicates

\cgalModels{SurfaceSubgraph}
*/
template <class Point>
class Minimum_spanning_forest
{
public:
  /// keeps a reference to `points`: `points[i]` is the point of the vertex with index i.
  explicit Minimum_spanning_forest(const std::vector<Point>& points)
    : m_points(&points)
  {
  }

  /*!
  writes edges of `graph` that span it without a cycle, the shortest first.

  \tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  \tparam EdgeOutputIterator accepts edge descriptors of `Graph`

  \return the output iterator past the last edge written
  \throws Surface_input_error if an edge leads to a vertex that was removed, or has no point
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    const auto point = [this](std::size_t i) -> const Point& { return (*m_points)[i]; };
    std::vector<typename boost::graph_traits<Graph>::edge_descriptor> all;
    std::vector<core::Measured_edge<std::size_t>> forest;
    for (auto [e, end] = edges(graph); e != end; ++e) {
      const std::size_t s = internal::index_of_end(index_map, source(*e, graph), m_points->size());
      const std::size_t t = internal::index_of_end(index_map, target(*e, graph), m_points->size());
      forest.push_back({{s, t}, all.size(), 0});
      all.push_back(*e);
    }
    using Kernel = typename Kernel_traits<Point>::Kernel;
    core::keep_minimum_spanning_forest(
        forest, m_points->size(),
        internal::Lengths_by_kernel<decltype(point), Kernel>(point, Kernel()));
    for (const auto& e : forest)
      *out++ = all[e.place];
    return out;
  }

private:
  const std::vector<Point>* m_points;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_SPANNING_FOREST_H
