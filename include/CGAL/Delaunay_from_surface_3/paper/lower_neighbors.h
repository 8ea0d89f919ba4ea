// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOWER_NEIGHBORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOWER_NEIGHBORS_H

#include <CGAL/Delaunay_from_surface_3/core/order/lower_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/paper/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The neighbours of each of the n vertices of a graph that have smaller numbers. Its number of
// edges must have 32 bits.
template <class Graph, class VertexIndexMap>
Lists<std::uint32_t> lower_neighbors(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  using Index = std::uint32_t;
  std::vector<Large_vector<Numbered_edge>> numbered(1);
  numbered[0].reserve(std::size_t(num_edges(graph)));
  const auto range = edges(graph);
  for (auto e = range.first; e != range.second; ++e)
    numbered[0].emplace_back(Index(get(index_map, source(*e, graph))),
                             Index(get(index_map, target(*e, graph))));
  return lower_neighbors(numbered, n);
}

// The same for a graph that has them.
inline Lists<std::uint32_t> lower_neighbors(const Lower_neighbor_graph& graph, Identity_index_map,
                                            std::size_t)
{
  return graph.lists();
}

template <class FaceRange>
Lists<std::uint32_t> lower_neighbors(const Graph_of_faces<FaceRange>& graph, Identity_index_map,
                                     std::size_t)
{
  return graph.lists();
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOWER_NEIGHBORS_H
