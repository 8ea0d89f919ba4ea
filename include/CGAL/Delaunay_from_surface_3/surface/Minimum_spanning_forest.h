// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_SPANNING_FOREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_SPANNING_FOREST_H

// Runs Kruskal's algorithm on edges between points: Choi 2002, §3.1, "a minimum spanning tree
// algorithm". If F contains the Euclidean minimum spanning tree of S, then this tree is the minimum
// spanning tree of F.

#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Holds an edge between the points ends[0] < ends[1], and its place in a list of the caller.
struct Measured_edge
{
  std::array<std::size_t, 2> ends;
  std::size_t place;
  double squared_length; // rounded
};

inline Measured_edge measured_edge(std::size_t s, std::size_t t, std::size_t place)
{
  return {{(std::min)(s, t), (std::max)(s, t)}, place, 0};
}

// Compares lengths exactly. `points[i]` points to point i.
template <class Point, class GeomTraits>
class Compare_lengths
{
public:
  Compare_lengths(const std::vector<const Point*>& points, const GeomTraits& gt)
    : m_points(points)
    , m_compare_distance(gt.compare_distance_3_object())
  {
  }

  // A squared length computed from doubles is off by at most six roundings if nothing underflows:
  // so a larger difference decides the comparison, otherwise the kernel does.
  Comparison_result operator()(const Measured_edge& a, const Measured_edge& b) const
  {
    const double x = a.squared_length, y = b.squared_length;
    if (has_doubles && (std::min)(x, y) > 1e-280 && (std::max)(x, y) < 1e280 &&
        std::abs(x - y) > 1e-14 * (std::max)(x, y))
      return x < y ? SMALLER : LARGER;
    return m_compare_distance(*m_points[a.ends[0]], *m_points[a.ends[1]], *m_points[b.ends[0]],
                              *m_points[b.ends[1]]);
  }

  double squared_length(const Measured_edge& e) const
  {
    const Point &p = *m_points[e.ends[0]], &q = *m_points[e.ends[1]];
    const double x = to_double(p.x()) - to_double(q.x()), y = to_double(p.y()) - to_double(q.y()),
                 z = to_double(p.z()) - to_double(q.z());
    return x * x + y * y + z * z;
  }

private:
  using FT = std::decay_t<decltype(std::declval<const Point&>().x())>;
  static constexpr bool has_doubles = std::is_same<FT, double>::value;

  const std::vector<const Point*>& m_points;
  decltype(std::declval<const GeomTraits&>().compare_distance_3_object()) m_compare_distance;
};

// Keeps only the edges of the minimum spanning forest, sorted from the shortest on; edges of the
// same length come in the order of the numbers of their ends. Takes O(m log m) for m edges.
template <class Point, class GeomTraits>
void keep_minimum_spanning_forest(std::vector<Measured_edge>& edges,
                                  const std::vector<const Point*>& points, const GeomTraits& gt)
{
  const Compare_lengths<Point, GeomTraits> compare(points, gt);
  for (Measured_edge& e : edges)
    e.squared_length = compare.squared_length(e);
  std::sort(edges.begin(), edges.end(), [&](const Measured_edge& a, const Measured_edge& b) {
    const Comparison_result c = compare(a, b);
    return c == SMALLER || (c == EQUAL && a.ends < b.ends);
  });
  Disjoint_sets<std::size_t> trees(points.size());
  const auto is_superfluous = [&](const Measured_edge& e) {
    return !trees.unite(e.ends[0], e.ends[1]);
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_superfluous), edges.end());
}

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
  \pre there are n points
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    std::vector<const Point*> points;
    points.reserve(m_points->size());
    for (const Point& p : *m_points)
      points.push_back(&p);
    std::vector<typename boost::graph_traits<Graph>::edge_descriptor> all;
    std::vector<internal::Measured_edge> forest;
    for (auto [e, end] = edges(graph); e != end; ++e) {
      forest.push_back(internal::measured_edge(std::size_t(get(index_map, source(*e, graph))),
                                               std::size_t(get(index_map, target(*e, graph))),
                                               all.size()));
      CGAL_precondition(forest.back().ends[1] < points.size());
      all.push_back(*e);
    }
    internal::keep_minimum_spanning_forest(forest, points, typename Kernel_traits<Point>::Kernel());
    for (const internal::Measured_edge& e : forest)
      *out++ = all[e.place];
    return out;
  }

private:
  const std::vector<Point>* m_points;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_MINIMUM_SPANNING_FOREST_H
