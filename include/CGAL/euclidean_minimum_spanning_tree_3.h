// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H
#define CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H

// Choi 2002, §3.1: the Euclidean minimum spanning tree is "a subset of its Delaunay triangulation",
// "constructed by computing D(S) and running a minimum spanning tree algorithm on the edges".

#include <CGAL/Delaunay_from_surface_3/arrays/spanning_trees.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_spanning_forest.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The finite vertices of a triangulation, numbered from the lexicographically smallest on, so that
// a number does not depend on the order in which they were inserted.
template <class Triangulation>
struct Numbered_vertices
{
  using Vertex = typename Triangulation::Vertex_handle;
  using Point = typename Triangulation::Point;

  explicit Numbered_vertices(const Triangulation& tr)
    : number(0, tr.number_of_vertices() + 1)
  {
    const auto compare = tr.geom_traits().compare_xyz_3_object();
    for (const Vertex v : tr.finite_vertex_handles())
      vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end(),
              [&](Vertex v, Vertex w) { return compare(v->point(), w->point()) == SMALLER; });
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      number[vertices[i]] = i;
      points.push_back(&vertices[i]->point());
    }
  }

  std::vector<Vertex> vertices;
  std::vector<const Point*> points;
  Unique_hash_map<Vertex, std::size_t> number;
};

// Those of a copy of points whose coordinates are doubles.
template <class Point, class GeomTraits>
class Lengths_by_doubles : public Lengths_between
{
public:
  Lengths_by_doubles(const std::vector<const Point*>& points, const GeomTraits&)
    : Lengths_by_doubles(coordinates_of(points))
  {
  }
  Lengths_by_doubles(const Lengths_by_doubles&) = delete;
  Lengths_by_doubles& operator=(const Lengths_by_doubles&) = delete;

private:
  explicit Lengths_by_doubles(std::vector<double>&& coordinates)
    : Lengths_between(Point_array(coordinates.data(), coordinates.size() / 3))
    , m_coordinates(std::move(coordinates))
  {
  }
  static std::vector<double> coordinates_of(const std::vector<const Point*>& points)
  {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Point* const p : points)
      coordinates.insert(coordinates.end(), {p->x(), p->y(), p->z()});
    return coordinates;
  }

  std::vector<double> m_coordinates;
};

// The lengths of edges between points; `points[i]` points to point i.
template <class Point, class GeomTraits>
using Lengths_of_points =
    std::conditional_t<Lengths_by_kernel<Point, GeomTraits>::has_doubles,
                       Lengths_by_doubles<Point, GeomTraits>, Lengths_by_kernel<Point, GeomTraits>>;

// Returns the corners of its cells, or the ends of its edges if it has none, by numbers of vertices.
template <class Triangulation>
std::vector<std::uint32_t> corners_of_simplices(const Triangulation& tr,
                                                const Numbered_vertices<Triangulation>& numbered)
{
  std::vector<std::uint32_t> corners;
  const auto add = [&](auto vertex) { corners.push_back(std::uint32_t(numbered.number[vertex])); };
  corners.reserve(tr.dimension() == 3 ? 4 * std::size_t(tr.number_of_cells()) : 0);
  if (tr.dimension() == 3)
    for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
      for (int k = 0; k < 4; ++k)
        add(c->vertex(k));
  else
    for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e) {
      add(e->first->vertex(e->second));
      add(e->first->vertex(e->third));
    }
  return corners;
}

template <class Triangulation, class Lengths>
std::vector<Measured_edge>
euclidean_minimum_spanning_tree(const Triangulation& tr,
                                const Numbered_vertices<Triangulation>& numbered,
                                const Lengths& lengths)
{
  const std::size_t n = numbered.vertices.size(), size = tr.dimension() == 3 ? 4 : 2;
  const std::vector<std::uint32_t> corners = corners_of_simplices(tr, numbered);
  auto tree = edges_of_simplices(
      corners.size() / size, size, n,
      [&](std::size_t c, std::size_t k) { return corners[size * c + k]; }, lengths, Alone());
  keep_minimum_spanning_forest(tree, n, lengths);
  return tree;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/*!
\ingroup PkgDelaunayFromSurface3Trees

writes the edges of a Euclidean minimum spanning tree of the vertices of a Delaunay triangulation: a
spanning tree whose edges have the smallest sum of lengths (\cgalCite{choi-dtsm-02}, §3.1). Its
degree is at most 12. The triangulation may be of any dimension; the tree of collinear points is
their chain, and the tree of one point or none has no edge.

Lengths are compared exactly. Among edges of the same length, those between lexicographically
smaller points come first. So the tree does not depend on the order in which the points were
inserted.

<b>Complexity</b>: \f$O(m \log m)\f$ for m edges of the triangulation. Edges that are the longest of
a triangle are left out before the others are sorted.

\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`. `Gt` must be a %CGAL kernel
with exact predicates, or derived from one. Unless coordinates are of type `double`, its
`Compare_distance_3` compares the distances of two pairs of points.
\tparam OutputIterator a model of `OutputIterator` that accepts
`std::pair<Vertex_handle, Vertex_handle>`

\param tr the triangulation
\param out receives the edges, from the shortest to the longest, each with its lexicographically
smaller end first

\return the output iterator past the last edge written

Example: \ref Delaunay_from_surface_3/euclidean_minimum_spanning_tree.cpp

\sa `contains_euclidean_minimum_spanning_tree()`
\sa `Delaunay_from_surface_3::Minimum_spanning_forest`
*/
template <class Gt, class Tds, class Lp, class Slds, class OutputIterator>
OutputIterator
euclidean_minimum_spanning_tree_3(const Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                  OutputIterator out)
{
  using namespace Delaunay_from_surface_3::internal;
  using Triangulation = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;
  const Numbered_vertices<Triangulation> numbered(tr);
  const auto tree = [&] {
    const Rounding_to_nearest rounding;
    const Lengths_of_points<typename Triangulation::Point, Gt> lengths(numbered.points,
                                                                       tr.geom_traits());
    return euclidean_minimum_spanning_tree(tr, numbered, lengths);
  }();
  for (const Measured_edge& e : tree)
    *out++ = std::make_pair(numbered.vertices[e.ends[0]], numbered.vertices[e.ends[1]]);
  return out;
}

} // namespace CGAL

#endif // CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H
