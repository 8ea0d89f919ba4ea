// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_HALFEDGE_GRAPH_READER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_HALFEDGE_GRAPH_READER_H

// Reads a halfedge graph as a rotation system, and turns marked darts back into edges of the graph.
//
// Invariant: vertex indices are a bijection onto 0 .. n-1 and the list of a vertex follows
// `opposite(next(h))` around it, from the stored halfedge, or from the boundary where there is one.
// Input outside the definition is refused here, and the message names the fault: a loop, a doubled
// edge, a face that is no triangle, a pinched vertex.
// Cost: one pass over the halfedges and one over the stars; no halfedges are stored.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Graph, class VertexIndexMap>
class Halfedge_graph_reader
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;

public:
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;

  Halfedge_graph_reader(const Graph& g, VertexIndexMap index)
    : m_graph(g)
    , m_index(index)
  {
  }

  // Returns an upper bound if some elements are removed.
  std::size_t number_of_darts() const { return num_halfedges(m_graph); }
  std::size_t number_of_vertices() const { return num_vertices(m_graph); }

  std::pair<std::size_t, std::size_t> ends(Edge e) const
  {
    return {get(m_index, source(e, m_graph)), get(m_index, target(e, m_graph))};
  }

  template <class Index>
  void read(Rotation_system<Index>& surface) const
  {
    count_darts(surface);
    read_stars(surface);
  }

  // Calls function(dart, edge) for every marked dart, in no particular order.
  template <class Index, class Function>
  void for_each_marked(const Rotation_system<Index>& surface, const Dart_marks& marks,
                       const Function& function) const
  {
    const auto start = [&](Vertex v, Walk<Index>& walk) {
      const Index i = static_cast<Index>(get(m_index, v));
      walk.dart = surface.first[i];
      walk.end = surface.first[i + 1];
      while (walk.end != walk.dart && !marks[walk.end - 1])
        --walk.end;
      if (walk.dart != walk.end)
        walk.h = surface.on_boundary[i] ? first_after_border(v) : halfedge(v, m_graph);
      return walk.dart != walk.end;
    };
    const auto look = [&](Walk<Index>& walk) {
      walk.following = opposite(next(walk.h, m_graph), m_graph);
    };
    const auto step = [&](const Walk<Index>& walk) {
      if (marks[walk.dart])
        function(walk.dart, edge(walk.h, m_graph));
      return walk.dart + 1 != walk.end;
    };
    walk_stars<Index>(start, look, step, [](const Walk<Index>&) {});
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
    refuse_bad_indices(range, m_index, n);
    std::size_t inner_halfedges = 0;
    for (Halfedge h : halfedges(m_graph)) {
      ++surface.first[index_of_end(m_index, target(h, m_graph), n) + 1];
      inner_halfedges += is_border(h, m_graph) ? 0 : 1;
    }
    const auto all_faces = faces(m_graph);
    if (inner_halfedges != 3 * std::size_t(std::distance(all_faces.first, all_faces.second)))
      refuse_face();
    for (std::size_t v = 0; v < n; ++v)
      surface.first[v + 1] += surface.first[v];
    surface.neighbor.resize(surface.first[n]);
  }

  // Holds the state of a walk around one vertex.
  template <class Index>
  struct Walk
  {
    Index v;
    Index dart; // belongs to the edge of h
    Index end;
    Index after_border; // the list of a boundary vertex will start here
    Halfedge start;
    Halfedge h;
    Halfedge following;
    bool is_border; // whether h is a border halfedge
  };

  // Walks around every vertex for which start() returns true, until step() returns false. Several
  // walks go side by side, and all look at the graph before any goes on, so that their cache misses
  // overlap where the order of the mesh in memory is bad.
  template <class Index, class Start, class Look, class Step, class Finish>
  void walk_stars(const Start& start, const Look& look, const Step& step,
                  const Finish& finish) const
  {
    constexpr std::size_t walks_at_once = 8; // measure_subgraphs times it
    std::array<Walk<Index>, walks_at_once> walks;
    std::size_t size = 0;
    const auto range = vertices(m_graph);
    auto next_vertex = range.first;
    const auto fill = [&] {
      while (size < walks.size() && next_vertex != range.second)
        size += start(*next_vertex++, walks[size]) ? 1 : 0;
    };
    for (fill(); size > 0; fill()) {
      for (std::size_t k = 0; k < size; ++k)
        look(walks[k]);
      for (std::size_t k = 0; k < size;) {
        if (step(walks[k])) {
          walks[k].h = walks[k].following;
          ++walks[k].dart;
          ++k;
          continue;
        }
        finish(walks[k]);
        walks[k] = walks[--size];
      }
    }
  }

  template <class Index>
  void read_stars(Rotation_system<Index>& surface) const
  {
    std::vector<Index> last_seen_by; // for long lists only
    walk_stars<Index>([&](Vertex v, Walk<Index>& walk) { return start_walk(v, surface, walk); },
                      [&](Walk<Index>& walk) { look(walk, surface); },
                      [&](Walk<Index>& walk) { return take_step(walk, surface); },
                      [&](const Walk<Index>& walk) { finish_walk(walk, surface, last_seen_by); });
  }

  template <class Index>
  bool start_walk(Vertex v, const Rotation_system<Index>& surface, Walk<Index>& walk) const
  {
    const Index i = static_cast<Index>(get(m_index, v));
    const Halfedge start = halfedge(v, m_graph);
    walk.v = i;
    walk.dart = walk.after_border = surface.first[i];
    walk.end = surface.first[i + 1];
    walk.start = walk.h = start;
    if (start == boost::graph_traits<Graph>::null_halfedge()) {
      if (surface.degree(i) > 0)
        refuse(vertex_name(i) + " has edges, but no halfedge of its own");
      return false;
    }
    if (target(start, m_graph) != v || surface.degree(i) == 0) // 0 if the halfedge is removed
      refuse(vertex_name(i) + " has a halfedge that does not lead to it");
    return true;
  }

  // Notes one edge, without branches, which would delay the next look.
  template <class Index>
  void look(Walk<Index>& walk, Rotation_system<Index>& surface) const
  {
    surface.neighbor[walk.dart] = static_cast<Index>(get(m_index, source(walk.h, m_graph)));
    walk.is_border = is_border(walk.h, m_graph);
    walk.following = opposite(next(walk.h, m_graph), m_graph);
  }

  // Returns whether there are more edges.
  template <class Index>
  bool take_step(Walk<Index>& walk, Rotation_system<Index>& surface) const
  {
    if (walk.is_border) {
      if (is_border(opposite(walk.h, m_graph), m_graph))
        refuse(edge_name(walk.v, surface.neighbor[walk.dart]) + " lies in no triangle");
      if (surface.on_boundary[walk.v])
        refuse(vertex_name(walk.v) + " is pinched: two boundaries run through it");
      surface.on_boundary[walk.v] = true;
      walk.after_border = walk.dart + 1;
    }
    const bool is_last = walk.dart + 1 == walk.end;
    if (is_last != (walk.following == walk.start))
      refuse(is_last ? "the halfedges around " + vertex_name(walk.v) + " do not close"
                     : vertex_name(walk.v) + " is pinched: its edges form more than one fan");
    return !is_last;
  }

  template <class Index>
  void finish_walk(const Walk<Index>& walk, Rotation_system<Index>& surface,
                   std::vector<Index>& last_seen_by) const
  {
    const Index v = walk.v;
    refuse_repeated_neighbor(v, surface.star(v), surface.number_of_vertices(), last_seen_by);
    if (surface.on_boundary[v])
      std::rotate(surface.neighbor.begin() + surface.first[v],
                  surface.neighbor.begin() + walk.after_border,
                  surface.neighbor.begin() + walk.end);
  }

  // Compares the entries of a short list pair by pair, which touches no other memory.
  template <class Index>
  void refuse_repeated_neighbor(Index v, const Star<Index>& star, Index n,
                                std::vector<Index>& last_seen_by) const
  {
    const bool is_short = star.size() <= 12;
    if (!is_short && last_seen_by.empty())
      last_seen_by.assign(n, (std::numeric_limits<Index>::max)());
    for (Index i = 0; i < star.size(); ++i) {
      const Index u = star[i];
      if (u == v)
        refuse("the graph is not simple: " + edge_name(v, v) + " is a loop");
      if (u >= n)
        refuse(vertex_name(v) + " has a halfedge that was removed");
      const bool is_repeated =
          is_short ? std::find(star.begin(), star.begin() + i, u) != star.begin() + i
                   : last_seen_by[u] == v;
      if (is_repeated)
        refuse_multi_edge(m_graph, m_index, v, u);
      if (!is_short)
        last_seen_by[u] = v;
    }
  }

  // Refuses a graph whose count of halfedges does not fit triangles: finds a face that is to blame.
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_HALFEDGE_GRAPH_READER_H
