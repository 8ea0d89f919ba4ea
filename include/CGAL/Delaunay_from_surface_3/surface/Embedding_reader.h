// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EMBEDDING_READER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EMBEDDING_READER_H

// A Boost graph with the cyclic orders of its edges as a rotation system, and marked darts back as
// edges.
//
// Invariant: as Rotation_system.h says; the lists are the user's, unchanged. What is outside the
// definition is refused by name: loops, doubled edges, edges that are missing from a list, boundary
// edges that do not stand at the ends of a list, lists that disagree on a triangle
// (Check_triangles.h).
// Cost: two passes over the lists. Edges are not paired: in a simple graph the ends name the edge.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Check_triangles.h>
#include <CGAL/Delaunay_from_surface_3/surface/Refuse_input.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Graph, class Embedding, class VertexIndexMap, class EdgeIsBoundaryMap>
class Embedding_reader
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;

public:
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;

  Embedding_reader(const Graph& g, Embedding embedding, VertexIndexMap index,
                   EdgeIsBoundaryMap is_boundary)
    : m_graph(g)
    , m_embedding(embedding)
    , m_index(index)
    , m_is_boundary(is_boundary)
  {
  }

  std::size_t number_of_darts() const { return 2 * std::size_t(num_edges(m_graph)); }
  std::size_t number_of_vertices() const { return num_vertices(m_graph); }

  std::pair<std::size_t, std::size_t> ends(const Edge& e) const
  {
    return {get(m_index, source(e, m_graph)), get(m_index, target(e, m_graph))};
  }

  template <class Index>
  void read(Rotation_system<Index>& surface) const
  {
    const std::size_t n = num_vertices(m_graph);
    refuse_bad_indices(n);
    surface.on_boundary.assign(n, false);
    surface.first.assign(n + 1, 0);
    std::size_t darts = 0;
    for_each_vertex([&](Vertex v, std::size_t i) {
      surface.first[i + 1] = static_cast<Index>(list_size(v));
      darts += list_size(v);
    });
    if (darts != number_of_darts())
      refuse_lists();
    for (std::size_t v = 0; v < n; ++v)
      surface.first[v + 1] += surface.first[v];
    surface.neighbor.resize(darts);
    std::vector<Index> last_seen_by(n, (std::numeric_limits<Index>::max)());
    for_each_vertex([&](Vertex v, std::size_t) { read_list(v, surface, last_seen_by); });
    Check_triangles<Index>{surface}();
  }

  // Calls function(dart, edge) for every marked dart.
  template <class Index, class Function>
  void for_each_marked(const Rotation_system<Index>& surface, const Dart_marks& marks,
                       const Function& function) const
  {
    for_each_vertex([&](Vertex v, std::size_t i) {
      Index dart = surface.first[i];
      for (const auto& e : get(m_embedding, v)) {
        if (marks[dart])
          function(dart, e);
        ++dart;
      }
    });
  }

private:
  template <class Function>
  void for_each_vertex(const Function& function) const
  {
    const auto range = vertices(m_graph);
    for (auto v = range.first; v != range.second; ++v)
      function(*v, static_cast<std::size_t>(get(m_index, *v)));
  }

  std::size_t list_size(Vertex v) const
  {
    const auto& list = get(m_embedding, v);
    return static_cast<std::size_t>(std::distance(std::begin(list), std::end(list)));
  }

  void refuse_bad_indices(std::size_t n) const
  {
    std::vector<bool> is_taken(n, false);
    for_each_vertex([&](Vertex, std::size_t i) {
      if (i >= n || is_taken[i])
        refuse_index(n, i);
      is_taken[i] = true;
    });
  }

  template <class Index>
  void read_list(Vertex v, Rotation_system<Index>& surface, std::vector<Index>& last_seen_by) const
  {
    const Index i = static_cast<Index>(get(m_index, v));
    const Index begin = surface.first[i], end = surface.first[i + 1];
    Index dart = begin, boundary_edges = 0;
    for (const auto& e : get(m_embedding, v)) {
      const Vertex a = source(e, m_graph), b = target(e, m_graph);
      if (a != v && b != v)
        refuse("the list of " + vertex_name(i) + " has " +
               edge_name(get(m_index, a), get(m_index, b)) + ", which does not end there");
      const Index u = static_cast<Index>(get(m_index, a == v ? b : a));
      if (u == i)
        refuse("the graph is not simple: " + edge_name(i, i) + " is a loop");
      if (last_seen_by[u] == i)
        refuse_multi_edge(m_graph, m_index, i, u);
      last_seen_by[u] = i;
      surface.neighbor[dart] = u;
      if (get(m_is_boundary, e)) {
        ++boundary_edges;
        if (dart != begin && dart + 1 != end)
          refuse("boundary " + edge_name(i, u) + " stands inside the list of " + vertex_name(i) +
                 ", not at an end");
        surface.on_boundary[i] = true;
      }
      ++dart;
    }
    if (boundary_edges == 1)
      refuse("the list of " + vertex_name(i) + " does not start and end with a boundary edge");
    if (begin != end && end - begin < 2)
      refuse(edge_name(i, surface.neighbor[begin]) + " lies in no triangle");
  }

  // The lists do not hold every edge twice: finds an edge of which that is true.
  [[noreturn]] void refuse_lists() const
  {
    using Ends = std::pair<std::size_t, std::size_t>;
    std::vector<Ends> darts, edges_of_graph;
    for_each_vertex([&](Vertex v, std::size_t i) {
      for (const auto& e : get(m_embedding, v))
        darts.emplace_back(
            i, get(m_index, source(e, m_graph) == v ? target(e, m_graph) : source(e, m_graph)));
    });
    std::sort(darts.begin(), darts.end());
    const auto twice = std::adjacent_find(darts.begin(), darts.end());
    if (twice != darts.end())
      refuse_multi_edge(m_graph, m_index, twice->first, twice->second);
    const auto range = edges(m_graph);
    for (auto e = range.first; e != range.second; ++e) {
      const Ends ends(get(m_index, source(*e, m_graph)), get(m_index, target(*e, m_graph)));
      for (const Ends& dart : {ends, Ends(ends.second, ends.first)})
        if (!std::binary_search(darts.begin(), darts.end(), dart))
          refuse(edge_name(dart.first, dart.second) + " is missing from the list of " +
                 vertex_name(dart.first));
      edges_of_graph.emplace_back(std::minmax(ends.first, ends.second));
    }
    std::sort(edges_of_graph.begin(), edges_of_graph.end());
    const auto twin = std::adjacent_find(edges_of_graph.begin(), edges_of_graph.end());
    if (twin != edges_of_graph.end())
      refuse_multi_edge(m_graph, m_index, twin->first, twin->second);
    refuse("the lists have edges that the graph does not have");
  }

  const Graph& m_graph;
  Embedding m_embedding;
  VertexIndexMap m_index;
  EdgeIsBoundaryMap m_is_boundary;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EMBEDDING_READER_H
