// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H
#define CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H

// Choi 2002, §3.1: the Euclidean minimum spanning tree is "a subset of its Delaunay triangulation",
// "constructed by computing D(S) and running a minimum spanning tree algorithm on the edges".

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_spanning_forest.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cstddef>
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

// The tree, as edges between these numbers, from the shortest on.
template <class Triangulation>
std::vector<Measured_edge>
euclidean_minimum_spanning_tree(const Triangulation& tr,
                                const Numbered_vertices<Triangulation>& numbered)
{
  std::vector<Measured_edge> tree;
  for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
    tree.push_back(measured_edge(numbered.number[e->first->vertex(e->second)],
                                 numbered.number[e->first->vertex(e->third)], 0));
  keep_minimum_spanning_forest(tree, numbered.points, tr.geom_traits());
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

<b>Complexity</b>: \f$O(m \log m)\f$ for m edges of the triangulation.

\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`. `Gt` must be a %CGAL kernel
with exact predicates, or derived from one, because its `Compare_distance_3` must compare the
distances of two pairs of points.
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
  const Numbered_vertices<Delaunay_triangulation_3<Gt, Tds, Lp, Slds>> numbered(tr);
  for (const Measured_edge& e : euclidean_minimum_spanning_tree(tr, numbered))
    *out++ = std::make_pair(numbered.vertices[e.ends[0]], numbered.vertices[e.ends[1]]);
  return out;
}

} // namespace CGAL

#endif // CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H
