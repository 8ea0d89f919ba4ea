// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_COMPONENT_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_COMPONENT_TOPOLOGY_H

// This header needs the standard library only.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

describes the topology of a connected component of a surface. Up to homeomorphism, it is determined
by the number of boundary loops, the Euler characteristic, and orientability.
*/
struct Surface_component_topology
{
  std::size_t number_of_vertices = 0;       ///< of this component
  std::size_t number_of_edges = 0;          ///< boundary edges included
  std::size_t number_of_triangles = 0;      ///< of this component
  std::size_t number_of_boundary_loops = 0; ///< b
  bool is_orientable = true;                ///< whether its triangles can be oriented consistently

  /// returns χ: vertices − edges + triangles.
  std::ptrdiff_t euler_characteristic() const
  {
    return std::ptrdiff_t(number_of_vertices) - std::ptrdiff_t(number_of_edges) +
           std::ptrdiff_t(number_of_triangles);
  }

  /// returns h = 2 − χ − b: twice the genus if it is orientable, otherwise the non-orientable
  /// genus.
  std::size_t euler_genus() const
  {
    return std::size_t(2 - euler_characteristic() - std::ptrdiff_t(number_of_boundary_loops));
  }

  /// returns the genus: the number of handles, or of cross-caps if the component is not orientable.
  std::size_t genus() const { return is_orientable ? euler_genus() / 2 : euler_genus(); }

  /// returns the bound on degrees in the subgraph of `bounded_degree_spanning_subgraph()`.
  std::size_t subgraph_degree_bound() const
  {
    const std::size_t h = euler_genus(), b = number_of_boundary_loops;
    if (h == 0 && b <= 1)
      return 3;
    return b == 0 ? 4 * h : 4 * h + 2 * b + 1;
  }

  /// returns the bound on degrees in the tree of `bounded_degree_spanning_tree()`.
  std::size_t tree_degree_bound() const
  {
    const std::size_t h = euler_genus(), b = number_of_boundary_loops;
    if (h == 1 && b == 0)
      return 4; // the projective plane
    return (std::max)(std::size_t(3), 3 * h + 2 * b);
  }

  /// returns the bound on degrees in the tree of `near_minimum_degree_spanning_tree()`. On a sphere
  /// or a disc this is 3. Elsewhere it is the largest of 3 + ⌊(c(x) − 3) / x⌋ over all x, where
  /// c(x) bounds the number of components that are left after removing x vertices: the smaller of
  /// 2x − 2χ and ⌊x (x − 1) / 3⌋, or ⌊x (x + 1) / 3⌋ with boundary.
  std::size_t near_minimum_tree_degree_bound() const
  {
    if (euler_genus() == 0 && number_of_boundary_loops <= 1)
      return 3;
    const std::ptrdiff_t chi = euler_characteristic(), side = number_of_boundary_loops > 0 ? 1 : -1;
    std::ptrdiff_t bound = 4, by_edges = 0;
    // Where 2x − 2χ is the smaller one the quotient falls, or is less than 2.
    for (std::ptrdiff_t x = 2; by_edges < 2 * (x - 1 - chi); ++x) {
      by_edges = x * (x + side) / 3;
      const std::ptrdiff_t c = (std::min)(by_edges, 2 * (x - chi));
      bound = (std::max)(bound, c < 3 ? 0 : 3 + (c - 3) / x);
    }
    return std::size_t(bound);
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is the result of `surface_topology()`.
*/
struct Surface_topology
{
  /// the components that have edges, in the order of their smallest vertex index.
  std::vector<Surface_component_topology> components;

  /// for every vertex index the position of its component in `components`, or `components.size()`
  /// if the vertex is isolated.
  std::vector<std::size_t> component_of_vertex;

  std::size_t number_of_isolated_vertices = 0; ///< vertices without edges, in no component

  /// returns the sum over `components`.
  std::ptrdiff_t euler_characteristic() const
  {
    std::ptrdiff_t sum = 0;
    for (const Surface_component_topology& component : components)
      sum += component.euler_characteristic();
    return sum;
  }

  /// returns the sum over `components`.
  std::size_t number_of_boundary_loops() const
  {
    std::size_t sum = 0;
    for (const Surface_component_topology& component : components)
      sum += component.number_of_boundary_loops;
    return sum;
  }

  /// returns whether every component is orientable.
  bool is_orientable() const
  {
    return std::all_of(components.begin(), components.end(),
                       [](const Surface_component_topology& c) { return c.is_orientable; });
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is the result of `certify_spanning_subgraph()` for a set of edges.
*/
struct Spanning_subgraph_certificate
{
  std::size_t number_of_edges = 0;               ///< repeated ones included
  std::size_t number_of_repeated_edges = 0;      ///< edges that occurred before
  std::size_t number_of_graph_components = 0;    ///< isolated vertices included
  std::size_t number_of_subgraph_components = 0; ///< isolated vertices included
  std::size_t number_of_independent_cycles = 0; ///< edges − vertices + components of the subgraph
  std::size_t maximum_degree = 0;               ///< among all vertices
  std::size_t vertex_of_maximum_degree = 0;     ///< its index
  std::vector<std::size_t> number_of_vertices_of_degree; ///< a histogram of the degrees
  std::size_t largest_degree_bound = 0;    ///< the largest of the components' own bounds
  bool respects_degree_bounds = true;      ///< no degree exceeds the bound of its own component
  bool respects_tree_degree_bounds = true; ///< the same with the bounds for trees
  /// the same with the bounds for trees of nearly minimum degree
  bool respects_near_minimum_tree_degree_bounds = true;

  /// returns whether the vertices of every component of the surface are connected by the edges.
  bool is_spanning() const { return number_of_subgraph_components == number_of_graph_components; }

  /// returns whether the edges are a spanning tree of every component.
  bool is_spanning_forest() const { return is_spanning() && number_of_independent_cycles == 0; }

  /// returns whether everything holds that `bounded_degree_spanning_subgraph()` guarantees.
  bool is_valid_subgraph() const
  {
    return is_spanning() && number_of_repeated_edges == 0 && respects_degree_bounds;
  }

  /// returns whether everything holds that `bounded_degree_spanning_tree()` guarantees.
  bool is_valid_tree() const
  {
    return is_spanning_forest() && number_of_repeated_edges == 0 && respects_tree_degree_bounds;
  }

  /// returns whether everything holds that `near_minimum_degree_spanning_tree()` guarantees, except
  /// what its witnesses prove.
  bool is_valid_near_minimum_tree() const
  {
    return is_valid_tree() && respects_near_minimum_tree_degree_bounds;
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_COMPONENT_TOPOLOGY_H
