// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_OTHER_TREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_OTHER_TREES_H

// What one would take from Boost.Graph to span a surface: no bound on the degree.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/depth_first_search.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <vector>

namespace subgraphs {

/// The minimum spanning tree by edge length.
template <class Mesh, class EdgeOutputIterator>
void minimum_spanning_tree(const Mesh& mesh, EdgeOutputIterator out)
{
  std::vector<double> lengths(num_edges(mesh));
  for (auto e : edges(mesh))
    lengths[e.idx()] = CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
  boost::kruskal_minimum_spanning_tree(
    mesh, out,
    boost::weight_map(boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)))
      .vertex_index_map(get(boost::vertex_index, mesh)));
}

template <class EdgeOutputIterator>
struct Tree_edge_writer : boost::default_dfs_visitor
{
  EdgeOutputIterator out;

  explicit Tree_edge_writer(EdgeOutputIterator o)
    : out(o)
  {}

  template <class HalfedgeDescriptor, class Mesh>
  void tree_edge(HalfedgeDescriptor h, const Mesh& mesh)
  {
    *out++ = edge(halfedge(h, mesh), mesh);
  }
};

/// A depth-first tree of every component.
template <class Mesh, class EdgeOutputIterator>
void depth_first_tree(const Mesh& mesh, EdgeOutputIterator out)
{
  std::vector<boost::default_color_type> colors(num_vertices(mesh));
  boost::depth_first_search(
    mesh, Tree_edge_writer<EdgeOutputIterator>(out),
    boost::make_iterator_property_map(colors.begin(), get(boost::vertex_index, mesh)));
}

} // namespace subgraphs

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_OTHER_TREES_H
