// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOWER_NEIGHBOR_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOWER_NEIGHBOR_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Represents a graph on 0, …, n-1 in the form from which nets are made: it lists for each vertex
// the neighbours with smaller numbers, so that every edge is there once. It also models
// boost::VertexListGraph and boost::EdgeListGraph.
class Lower_neighbor_graph
{
public:
  using vertex_descriptor = std::size_t;
  using edge_descriptor = std::pair<std::size_t, std::size_t>; // the larger number, and the smaller
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag
  {
  };
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using vertex_iterator = boost::counting_iterator<std::size_t>;

  // Walks through the lists, vertex by vertex.
  class edge_iterator : public boost::iterator_facade<edge_iterator, edge_descriptor,
                                                      std::forward_iterator_tag, edge_descriptor>
  {
  public:
    edge_iterator() = default;
    edge_iterator(const Lower_neighbor_graph& graph, std::size_t k)
      : m_graph(&graph)
      , m_k(k)
    {
      skip_ends();
    }

  private:
    friend class boost::iterator_core_access;

    edge_descriptor dereference() const { return {m_upper, m_graph->lists().items[m_k]}; }
    bool equal(const edge_iterator& other) const { return m_k == other.m_k; }
    void increment()
    {
      ++m_k;
      skip_ends();
    }
    void skip_ends()
    {
      while (m_k < m_graph->number_of_edges() && m_graph->lists().first[m_upper + 1] <= m_k)
        ++m_upper;
    }

    const Lower_neighbor_graph* m_graph = nullptr;
    std::size_t m_upper = 0, m_k = 0;
  };

  // Makes a graph without vertices.
  Lower_neighbor_graph() = default;

  // Makes a graph on `number_of_vertices` vertices, without edges.
  explicit Lower_neighbor_graph(std::size_t number_of_vertices)
    : m_number_of_vertices(number_of_vertices)
  {
  }

  // Makes a graph with these lists.
  explicit Lower_neighbor_graph(Lists<std::uint32_t> lists)
    : m_lists(std::move(lists))
    , m_number_of_vertices(m_lists.size())
  {
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  std::size_t number_of_edges() const { return m_lists.items.size(); }
  const Lists<std::uint32_t>& lists() const { return m_lists; }

private:
  Lists<std::uint32_t> m_lists; // empty if there are no edges
  std::size_t m_number_of_vertices = 0;
};

// Adds the faces from which the edges come, for subgraphs that need more than edges. Keeps a
// reference to the faces.
template <class FaceRange>
class Graph_of_faces : public Lower_neighbor_graph
{
public:
  Graph_of_faces(Lower_neighbor_graph graph, const FaceRange& faces)
    : Lower_neighbor_graph(std::move(graph))
    , m_faces(&faces)
  {
  }

  const FaceRange& faces_of_soup() const { return *m_faces; }

private:
  const FaceRange* m_faces;
};

inline auto vertices(const Lower_neighbor_graph& graph)
{
  using Iterator = Lower_neighbor_graph::vertex_iterator;
  return std::make_pair(Iterator(0), Iterator(graph.number_of_vertices()));
}

inline auto edges(const Lower_neighbor_graph& graph)
{
  using Iterator = Lower_neighbor_graph::edge_iterator;
  return std::make_pair(Iterator(graph, 0), Iterator(graph, graph.number_of_edges()));
}

inline std::size_t num_vertices(const Lower_neighbor_graph& graph)
{
  return graph.number_of_vertices();
}

inline std::size_t num_edges(const Lower_neighbor_graph& graph)
{
  return graph.number_of_edges();
}

inline std::size_t source(const std::pair<std::size_t, std::size_t>& e, const Lower_neighbor_graph&)
{
  return e.first;
}

inline std::size_t target(const std::pair<std::size_t, std::size_t>& e, const Lower_neighbor_graph&)
{
  return e.second;
}

// The index of a vertex is the vertex itself.
using Identity_index_map = boost::typed_identity_property_map<std::size_t>;

inline Identity_index_map get(boost::vertex_index_t, const Lower_neighbor_graph&)
{
  return {};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOWER_NEIGHBOR_GRAPH_H
