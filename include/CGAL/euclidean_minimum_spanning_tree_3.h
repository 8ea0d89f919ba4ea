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

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The finite vertices of a triangulation, numbered as they lie in memory. Called with two numbers, tells
// whether the first has the lexicographically smaller point: ties are broken by that.
template <class Triangulation>
class Numbered_vertices
{
public:
  using Vertex = typename Triangulation::Vertex_handle;
  using Point = typename Triangulation::Point;

  explicit Numbered_vertices(const Triangulation& tr)
    : m_triangulation(tr)
    , m_number(0, tr.number_of_vertices() + 1)
  {
    for (const Vertex v : tr.finite_vertex_handles()) {
      m_number[v] = m_vertices.size();
      m_vertices.push_back(v);
    }
  }

  std::size_t size() const { return m_vertices.size(); }
  Vertex operator[](std::size_t i) const { return m_vertices[i]; }
  const Point& point(std::size_t i) const { return m_vertices[i]->point(); }
  bool operator()(std::size_t i, std::size_t j) const
  {
    return m_triangulation.geom_traits().compare_xyz_3_object()(point(i), point(j)) == SMALLER;
  }

  // Calls use(lengths) with the lengths of edges, of a copy of the points if coordinates are doubles.
  template <class Use>
  auto with_lengths(const Use& use) const
  {
    const auto point_of = [this](std::size_t i) -> const Point& { return point(i); };
    using By_kernel = Lengths_by_kernel<decltype(point_of), typename Triangulation::Geom_traits>;
    const Rounding_to_nearest rounding;
    if constexpr (By_kernel::has_doubles) {
      std::vector<double> coordinates;
      coordinates.reserve(3 * size());
      for (const Vertex v : m_vertices)
        coordinates.insert(coordinates.end(), {v->point().x(), v->point().y(), v->point().z()});
      return use(Lengths_between(Point_array(coordinates.data(), size())));
    } else {
      return use(By_kernel(point_of, m_triangulation.geom_traits()));
    }
  }

  template <class Lengths>
  std::vector<Measured_edge<std::uint32_t>> minimum_spanning_tree(const Lengths& lengths) const
  {
    const Triangulation& tr = m_triangulation;
    const auto number = [&](Vertex v) { return std::uint32_t(m_number[v]); };
    std::vector<std::array<std::uint32_t, 4>> simplices; // cells, or edges if there are no cells
    if (tr.dimension() == 3) {
      simplices.reserve(std::size_t(tr.number_of_cells()));
      for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
        simplices.push_back({number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)),
                             number(c->vertex(3))});
    } else {
      for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
        simplices.push_back(
            {number(e->first->vertex(e->second)), number(e->first->vertex(e->third))});
    }
    auto tree = edges_of_simplices(
        simplices.size(), tr.dimension() == 3 ? 4 : 2, size(),
        [&](std::size_t c, std::size_t k) { return simplices[c][k]; }, lengths, Alone());
    keep_minimum_spanning_forest(tree, size(), lengths, Alone(), std::cref(*this));
    return tree;
  }

private:
  const Triangulation& m_triangulation;
  std::vector<Vertex> m_vertices;
  Unique_hash_map<Vertex, std::size_t> m_number;
};

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
  const Numbered_vertices<Triangulation> vertices(tr);
  const auto tree = vertices.with_lengths(
      [&](const auto& lengths) { return vertices.minimum_spanning_tree(lengths); });
  for (const auto& e : tree)
    *out++ = std::make_pair(vertices[e.ends[0]], vertices[e.ends[1]]);
  return out;
}

} // namespace CGAL

#endif // CGAL_EUCLIDEAN_MINIMUM_SPANNING_TREE_3_H
