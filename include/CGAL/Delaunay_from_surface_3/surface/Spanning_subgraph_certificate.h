// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SPANNING_SUBGRAPH_CERTIFICATE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SPANNING_SUBGRAPH_CERTIFICATE_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SPANNING_SUBGRAPH_CERTIFICATE_H
