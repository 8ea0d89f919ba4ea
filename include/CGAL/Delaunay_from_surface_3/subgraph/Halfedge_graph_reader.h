// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A halfedge graph as a rotation system, and marked darts back as edges of the graph.
//
// Invariant: vertex indices are a bijection onto 0 .. n-1 and the list of a vertex follows
// `opposite(next(h))` around it, from the stored halfedge, or from the boundary where there is one. What is outside the definition is
// refused here, by name: loops, edges doubled, faces that are not triangles, vertices that are pinched.
// Cost: one pass over the halfedges, one over the stars; nothing is kept of the halfedges.

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_HALFEDGE_GRAPH_READER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_HALFEDGE_GRAPH_READER_H

#include <CGAL/Delaunay_from_surface_3/subgraph/Refuse_input.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Rotation_system.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Graph, class VertexIndexMap>
class Halfedge_graph_reader
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;

public:
  Halfedge_graph_reader(const Graph& g, VertexIndexMap index)
    : m_graph(g)
    , m_index(index)
  {}

  std::size_t number_of_darts() const { return num_halfedges(m_graph); } // or more

  template <class Index>
  void read(Rotation_system<Index>& surface) const
  {
    count_darts(surface);
    read_stars(surface);
  }

  // Calls function(dart, edge) for every marked dart.
  template <class Index, class Function>
  void for_each_marked(const Rotation_system<Index>& surface, const Dart_marks& marks,
                       const Function& function) const
  {
    for (Vertex v : vertices(m_graph)) {
      const Index i = static_cast<Index>(get(m_index, v));
      Index dart = surface.first[i], end = surface.first[i + 1];
      while (end != dart && !marks[end - 1])
        --end;
      if (dart == end)
        continue;
      Halfedge h = surface.on_boundary[i] ? first_after_border(v) : halfedge(v, m_graph);
      for (; dart != end; ++dart, h = opposite(next(h, m_graph), m_graph))
        if (marks[dart])
          function(dart, edge(h, m_graph));
    }
  }

private:
  Halfedge first_after_border(Vertex v) const
  {
    Halfedge h = halfedge(v, m_graph);
    while (!is_border(h, m_graph))
      h = opposite(next(h, m_graph), m_graph);
    return opposite(next(h, m_graph), m_graph);
  }

  template <class Index>
  void count_darts(Rotation_system<Index>& surface) const
  {
    const auto range = vertices(m_graph);
    const std::size_t n = static_cast<std::size_t>(std::distance(range.first, range.second));
    surface.on_boundary.assign(n, false);
    surface.first.assign(n + 1, 0);
    refuse_bad_indices(n);
    std::size_t inner_halfedges = 0;
    for (Halfedge h : halfedges(m_graph)) {
      ++surface.first[get(m_index, target(h, m_graph)) + 1];
      inner_halfedges += is_border(h, m_graph) ? 0 : 1;
    }
    const auto all_faces = faces(m_graph);
    if (inner_halfedges != 3 * std::size_t(std::distance(all_faces.first, all_faces.second)))
      refuse_face();
    for (std::size_t v = 0; v < n; ++v)
      surface.first[v + 1] += surface.first[v];
    surface.neighbor.resize(surface.first[n]);
  }

  void refuse_bad_indices(std::size_t n) const
  {
    std::vector<bool> is_taken(n, false);
    for (Vertex v : vertices(m_graph)) {
      const std::size_t i = static_cast<std::size_t>(get(m_index, v));
      if (i >= n || is_taken[i])
        refuse_index(n, i);
      is_taken[i] = true;
    }
  }

  // A walk around one vertex that is being read.
  template <class Index>
  struct Walk
  {
    Index v;
    Index dart;         // where the next edge goes
    Index after_border; // where the list of a boundary vertex will start
    Halfedge start;
    Halfedge h;
  };

  // Several stars are walked in turn: where the mesh lies in memory in no good order, their
  // cache misses overlap, which makes this two to three times as fast.
  template <class Index>
  void read_stars(Rotation_system<Index>& surface) const
  {
    std::vector<Index> last_seen_by(surface.number_of_vertices(), (std::numeric_limits<Index>::max)());
    std::array<Walk<Index>, 8> walks;
    std::size_t size = 0;
    const auto range = vertices(m_graph);
    auto next_vertex = range.first;
    const auto fill = [&] {
      while (size < walks.size() && next_vertex != range.second)
        size += start_walk(*next_vertex++, surface, walks[size]) ? 1 : 0;
    };
    for (fill(); size > 0; fill())
      for (std::size_t k = 0; k < size;) {
        if (take_step(walks[k], surface)) {
          ++k;
          continue;
        }
        finish_walk(walks[k], surface, last_seen_by);
        walks[k] = walks[--size];
      }
  }

  template <class Index>
  bool start_walk(Vertex v, const Rotation_system<Index>& surface, Walk<Index>& walk) const
  {
    const Index i = static_cast<Index>(get(m_index, v));
    const Halfedge start = halfedge(v, m_graph);
    walk = {i, surface.first[i], surface.first[i], start, start};
    if (start != boost::graph_traits<Graph>::null_halfedge())
      return true;
    if (surface.degree(i) != 0)
      refuse(vertex_name(i) + " has edges, but no halfedge of its own");
    return false; // isolated
  }

  // Notes one edge; returns whether there are more.
  template <class Index>
  bool take_step(Walk<Index>& walk, Rotation_system<Index>& surface) const
  {
    if (walk.dart == surface.first[walk.v + 1])
      refuse("the halfedges around " + vertex_name(walk.v) + " do not close");
    const Index u = static_cast<Index>(get(m_index, source(walk.h, m_graph)));
    surface.neighbor[walk.dart++] = u;
    if (is_border(walk.h, m_graph)) {
      if (is_border(opposite(walk.h, m_graph), m_graph))
        refuse(edge_name(walk.v, u) + " lies in no triangle");
      if (surface.on_boundary[walk.v])
        refuse(vertex_name(walk.v) + " is pinched: two boundaries run through it");
      surface.on_boundary[walk.v] = true;
      walk.after_border = walk.dart;
    }
    walk.h = opposite(next(walk.h, m_graph), m_graph);
    return walk.h != walk.start;
  }

  template <class Index>
  void finish_walk(const Walk<Index>& walk, Rotation_system<Index>& surface,
                   std::vector<Index>& last_seen_by) const
  {
    const Index v = walk.v, begin = surface.first[v], end = surface.first[v + 1];
    if (walk.dart != end)
      refuse(vertex_name(v) + " is pinched: its edges form more than one fan");
    for (Index u : surface.star(v)) {
      if (u == v)
        refuse("the graph is not simple: " + edge_name(v, v) + " is a loop");
      if (last_seen_by[u] == v)
        refuse_multi_edge(m_graph, m_index, v, u);
      last_seen_by[u] = v;
    }
    if (surface.on_boundary[v])
      std::rotate(surface.neighbor.begin() + begin, surface.neighbor.begin() + walk.after_border,
                  surface.neighbor.begin() + end);
  }

  // The count of halfedges does not fit triangles: finds a face that is to blame.
  [[noreturn]] void refuse_face() const
  {
    for (Halfedge h : halfedges(m_graph))
      if (!is_border(h, m_graph) && next(next(next(h, m_graph), m_graph), m_graph) != h)
        refuse("the face at " +
               edge_name(get(m_index, source(h, m_graph)), get(m_index, target(h, m_graph))) +
               " is not a triangle");
    refuse("the faces of the graph do not match its halfedges");
  }

  const Graph& m_graph;
  VertexIndexMap m_index;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_HALFEDGE_GRAPH_READER_H
