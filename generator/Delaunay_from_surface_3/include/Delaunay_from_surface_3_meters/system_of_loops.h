// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_SYSTEM_OF_LOOPS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_SYSTEM_OF_LOOPS_H

#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

// 2g loops through one base vertex, as the paper's cut has them (Choi 2002, §3.2), but found by
// tree and cotree and not by the algorithm of Lazarus et al. 2001 that it names.
//
//     1. a breadth-first tree over the vertices from the base
//     2. a tree over the triangles that crosses no edge of it
//     3. every edge in neither closes a loop with the tree: 2 - χ of them
//
// Invariant: tree, crossed edges and loop edges share out all edges.
// Cost: O(n), and O(gn) to write the loops down; about 90 bytes per vertex besides the lists. For
// comparison with the cut graph only.
namespace meters {

namespace rooms = CGAL::Delaunay_from_surface_3::internal;

template <class Index>
class Find_loops
{
public:
  using Loop = std::vector<Index>; // darts, from the base to the base

  explicit Find_loops(const rooms::Rotation_system<Index>& surface)
    : m_surface(surface)
    , m_mate(rooms::pair_darts(surface))
    , m_to_parent(surface.number_of_vertices(), none)
    , m_is_tree(surface.number_of_darts(), false)
    , m_is_crossed(surface.number_of_darts(), false)
    , m_is_met(surface.number_of_darts(), false)
  {
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      if (surface.on_boundary[v])
        rooms::refuse("a system of loops needs a closed surface, but " + rooms::vertex_name(v) +
                      " is on the boundary");
  }

  std::vector<Loop> operator()()
  {
    std::vector<bool> is_seen(m_surface.number_of_vertices(), false);
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v) {
      if (is_seen[v] || m_surface.degree(v) == 0)
        continue;
      grow_tree(v, is_seen);
      grow_cotree(v);
    }
    std::vector<Loop> loops;
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      for (Index dart = m_surface.first[v]; dart < m_surface.first[v + 1]; ++dart)
        if (!m_is_tree[dart] && !m_is_crossed[dart] && v < m_surface.neighbor[dart])
          loops.push_back(loop_through(v, dart));
    return loops;
  }

  // All loops as one graph, to be pruned and cut along.
  rooms::Cut_candidate<Index> as_cut_candidate(const std::vector<Loop>& loops) const
  {
    rooms::Cut_candidate<Index> candidate(m_surface);
    for (const Loop& loop : loops)
      for (Index dart : loop)
        if (!candidate.marks[dart] && !candidate.marks[m_mate[dart]]) {
          candidate.marks[dart] = true;
          candidate.add_edge(m_surface.neighbor[m_mate[dart]], m_surface.neighbor[dart]);
        }
    return candidate;
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  void grow_tree(Index base, std::vector<bool>& is_seen)
  {
    is_seen[base] = true;
    std::vector<Index> queue(1, base);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Index dart = m_surface.first[queue[i]]; dart < m_surface.first[queue[i] + 1]; ++dart) {
        const Index u = m_surface.neighbor[dart];
        if (is_seen[u])
          continue;
        is_seen[u] = true;
        m_to_parent[u] = m_mate[dart];
        m_is_tree[dart] = m_is_tree[m_mate[dart]] = true;
        queue.push_back(u);
      }
  }

  // A corner stands for its triangle; it has the number of the dart that it follows.
  struct Corner
  {
    Index v;
    Index dart;
  };

  Index next_dart(Index v, Index dart) const
  {
    return dart + 1 < m_surface.first[v + 1] ? dart + 1 : m_surface.first[v];
  }
  Index previous_dart(Index v, Index dart) const
  {
    return dart > m_surface.first[v] ? dart - 1 : m_surface.first[v + 1] - 1;
  }

  // The same triangle at the vertex w at the far end of `dart`, where `third` is its third vertex.
  Corner corner_at_end(Index dart, Index third) const
  {
    const Index w = m_surface.neighbor[dart], back = m_mate[dart];
    const bool follows = m_surface.neighbor[next_dart(w, back)] == third;
    return {w, follows ? back : previous_dart(w, back)};
  }

  // Marks the triangle at its three corners; returns the other two.
  std::pair<Corner, Corner> meet(Corner c)
  {
    const Index second = next_dart(c.v, c.dart);
    const Corner a = corner_at_end(c.dart, m_surface.neighbor[second]);
    const Corner b = corner_at_end(second, m_surface.neighbor[c.dart]);
    m_is_met[c.dart] = m_is_met[a.dart] = m_is_met[b.dart] = true;
    return {a, b};
  }

  void grow_cotree(Index base)
  {
    std::vector<Corner> queue(1, Corner{base, m_surface.first[base]});
    meet(queue[0]);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Corner c = queue[i];
      const Corner a = meet(c).first;
      cross(c.v, c.dart, queue);
      cross(c.v, next_dart(c.v, c.dart), queue);
      // The third edge, from a: the one of a's two sides that does not lead to c.v.
      const bool starts = m_surface.neighbor[a.dart] == c.v;
      cross(a.v, starts ? next_dart(a.v, a.dart) : a.dart, queue);
    }
  }

  // Goes over the edge at v to whichever of its triangles has not been met.
  void cross(Index v, Index dart, std::vector<Corner>& queue)
  {
    if (m_is_tree[dart])
      return;
    for (Index corner : {dart, previous_dart(v, dart)}) {
      if (m_is_met[corner])
        continue;
      m_is_crossed[dart] = m_is_crossed[m_mate[dart]] = true;
      queue.push_back({v, corner});
      meet(queue.back());
    }
  }

  Loop loop_through(Index v, Index dart) const
  {
    Loop loop;
    for (Index u = v; m_to_parent[u] != none; u = m_surface.neighbor[m_to_parent[u]])
      loop.push_back(m_mate[m_to_parent[u]]);
    std::reverse(loop.begin(), loop.end());
    loop.push_back(dart);
    for (Index u = m_surface.neighbor[dart]; m_to_parent[u] != none;
         u = m_surface.neighbor[m_to_parent[u]])
      loop.push_back(m_to_parent[u]);
    return loop;
  }

  const rooms::Rotation_system<Index>& m_surface;
  std::vector<Index> m_mate;
  std::vector<Index> m_to_parent; // the dart towards the base
  rooms::Dart_marks m_is_tree;
  rooms::Dart_marks m_is_crossed;
  rooms::Dart_marks m_is_met; // corners, by dart
};

// Loops of darts as loops of edges. A reader goes from darts to edges in one sweep only, so the
// darts that loops use are noted in one sweep and then looked up.

// Writes a system of loops of a closed surface: on every component of genus g > 0 these are 2g closed
// walks through one base vertex such that the component without them is an open disc. What is written
// are std::vectors of edges in order, starting and ending at the base; an edge that a loop passes in
// both directions is there twice. Linear time plus the length of the loops, O(gn).
template <class Reader, class LoopOutputIterator>
LoopOutputIterator
system_of_loops(const CGAL::Delaunay_from_surface_3::Triangulated_surface<Reader>& surface,
                LoopOutputIterator out)
{
  using Edge = typename Reader::Edge;
  return rooms::with_rotation_system(surface.reader(), [&](auto& rotations) {
    using Index = typename std::decay_t<decltype(rotations)>::Index;
    const auto loops = Find_loops<Index>(rotations)();
    rooms::Dart_marks is_used(rotations.number_of_darts(), false);
    for (const auto& loop : loops)
      for (Index dart : loop)
        is_used[dart] = true;
    std::vector<std::pair<Index, Edge>> edge_of_dart;
    surface.reader().for_each_marked(rotations, is_used, [&](Index dart, const Edge& edge) {
      edge_of_dart.emplace_back(dart, edge);
    });
    const auto is_before = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::sort(edge_of_dart.begin(), edge_of_dart.end(), is_before);
    for (const auto& loop : loops) {
      std::vector<Edge> loop_of_edges;
      for (Index dart : loop)
        loop_of_edges.push_back(std::lower_bound(edge_of_dart.begin(), edge_of_dart.end(),
                                                 std::make_pair(dart, Edge()), is_before)
                                    ->second);
      *out++ = std::move(loop_of_edges);
    }
    return out;
  });
}

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_SYSTEM_OF_LOOPS_H
