// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EMBEDDING_READER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EMBEDDING_READER_H

// Reads a Boost graph with the cyclic orders of its edges as a rotation system, and turns marked
// darts back into edges.
//
// Invariant: see Rotation_system.h; the lists are the user's, unchanged. Input outside the
// definition is refused, and the message names the fault: a loop, a doubled edge, an edge missing
// from a list, a boundary edge that does not stand at an end of a list, or lists that disagree on
// a triangle (Check_triangles).
// Cost: two passes over the lists. Edges are not paired: in a simple graph the ends name the edge.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Checks that lists which are given, not derived from faces, describe triangles: where v's list
// has a next to b, a's list must have b next to v, and b's list must have v next to a.
//
// Each triangle is looked up from its heaviest corner only (by degree, then index) in the lists of
// the other two corners. If all of these are found, and there are equally many heaviest, middle and
// lightest corners, then no corner is left over.
// Cost: the sum over the edges of the smaller degree of its two ends, O(n) on surfaces of bounded
// genus (Chiba, Nishizeki 1985), one list with a million entries included; no memory.

template <class Index>
struct Check_triangles
{
  const Rotation_system<Index>& surface;

  void operator()() const
  {
    std::size_t corners[3] = {0, 0, 0}; // by the number of heavier ones among the other two
    for (Index v = 0; v < surface.number_of_vertices(); ++v) {
      if (surface.degree(v) == 2 && !surface.on_boundary[v])
        check_pair_of_triangles(v);
      for_each_corner(v, [&](Index a, Index b) {
        const int heavier = (is_heavier(a, v) ? 1 : 0) + (is_heavier(b, v) ? 1 : 0);
        ++corners[heavier];
        if (heavier == 0) {
          require_corner(a, v, b);
          require_corner(b, v, a);
        }
      });
    }
    if (corners[0] != corners[1] || corners[0] != corners[2])
      refuse_lonely_corner();
  }

private:
  template <class Function>
  void for_each_corner(Index v, const Function& function) const
  {
    const Star<Index> star = surface.star(v);
    for (Index i = 0; i + 1 < star.size(); ++i)
      function(star[i], star[i + 1]);
    if (star.size() > 0 && !surface.on_boundary[v])
      function(star[star.size() - 1], star[0]);
  }

  bool is_heavier(Index a, Index b) const
  {
    const Index da = surface.degree(a), db = surface.degree(b);
    return da > db || (da == db && a > b);
  }

  bool has_corner(Index v, Index a, Index b) const
  {
    const Star<Index> star = surface.star(v);
    if (star.size() == 0) // other lists may still lead to v
      return false;
    const Index last = star.size() - 1;
    for (Index i = 0; i < last; ++i)
      if ((star[i] == a && star[i + 1] == b) || (star[i] == b && star[i + 1] == a))
        return true;
    return !surface.on_boundary[v] &&
           ((star[last] == a && star[0] == b) || (star[last] == b && star[0] == a));
  }

  // Refuses the lists unless w's list shows the triangle v, a, w, which v's list shows.
  void require_corner(Index w, Index v, Index a) const
  {
    if (!has_corner(w, v, a))
      refuse("inconsistent lists: around " + vertex_name(v) + " the edges to " + vertex_name(w) +
             " and " + vertex_name(a) + " are neighbours, but in the list of " + vertex_name(w) +
             " the edges to " + vertex_name(v) + " and " + vertex_name(a) + " are not");
  }

  // Refuses v, an inner vertex with two edges, unless it belongs to a sphere of two triangles.
  void check_pair_of_triangles(Index v) const
  {
    for (Index u : surface.star(v))
      if (surface.degree(u) != 2 || surface.on_boundary[u])
        refuse("inconsistent lists: " + vertex_name(v) +
               " has two edges and none is marked as boundary");
  }

  [[noreturn]] void refuse_lonely_corner() const
  {
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      for_each_corner(v, [&](Index a, Index b) {
        require_corner(a, v, b);
        require_corner(b, v, a);
      });
    refuse("inconsistent lists: a triangle is listed twice at a vertex");
  }
};

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
    refuse_bad_indices(vertices(m_graph), m_index, n);
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

  // Finds an edge that the lists do not hold exactly twice, and refuses them by its name.
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
