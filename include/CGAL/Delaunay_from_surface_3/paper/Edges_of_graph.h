// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_EDGES_OF_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_EDGES_OF_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/lower_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/paper/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
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

// The edges of a caller's graph.
template <class Graph, class VertexIndexMap>
class Edges_of_graph final : public Edge_source
{
public:
  // On n vertices. Keeps a reference.
  Edges_of_graph(const Graph& graph, VertexIndexMap index_map, std::size_t n)
    : m_graph(graph)
    , m_index_map(index_map)
    , m_number_of_vertices(n)
  {
  }

  Lists_view<std::uint32_t> edges() override
  {
    if constexpr (std::is_base_of<Lower_neighbor_graph, Graph>::value) {
      return m_graph.lists(); // which stay the caller's
    } else {
      constexpr std::size_t too_many = (std::numeric_limits<std::uint32_t>::max)();
      const std::size_t m = std::size_t(num_edges(m_graph));
      if (m_lower.first.empty() && m > 0 && (std::max)(m_number_of_vertices, m) < too_many)
        m_lower = lower_neighbors(m_graph, m_index_map, m_number_of_vertices);
      return m_lower;
    }
  }
  void give_up() override { m_lower = Lists<std::uint32_t>(); }

private:
  const Graph& m_graph;
  VertexIndexMap m_index_map;
  std::size_t m_number_of_vertices;
  Lists<std::uint32_t> m_lower; // none if there are no edges
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_EDGES_OF_GRAPH_H
