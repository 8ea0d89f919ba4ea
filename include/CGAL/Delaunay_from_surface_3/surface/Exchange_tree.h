// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EXCHANGE_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EXCHANGE_TREE_H

// Maintains a spanning forest of a surface's edges while edges are exchanged one for another.
//
// Invariant: an edge of the forest is marked at both its darts; degrees and the links of
// Link_cut_forest are those of the marked edges.
// Cost: building takes O(n), an exchange O(log n) amortized. Looking up the dart to a neighbour
// takes O(d log d) once, and 8 d bytes, for each vertex with many (d) edges in the surface.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Represents a forest whose edges come and go, and answers which vertices lie on the path between
// two others (Sleator, Tarjan 1985).
//
// Invariant: the forest is divided into paths; each is a splay tree, ordered along the path, whose
// root names the vertex above the path's upper end, if there is one. A subtree that is marked as
// turned is to be read backwards.
// Cost: O(log n) for each operation, amortized; 13 bytes per vertex with indices of 32 bits.

template <class Index>
class Link_cut_forest
{
public:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  explicit Link_cut_forest(std::size_t n)
    : m_up(n, none)
    , m_child{std::vector<Index>(n, none), std::vector<Index>(n, none)}
    , m_is_turned(n, false)
  {
  }

  // Hangs the root v, which is alone on its path, below w. This builds a forest in any order.
  void hang(Index v, Index w) { m_up[v] = w; }

  void link(Index v, Index w)
  {
    make_root(v);
    m_up[v] = w;
  }

  void cut(Index v, Index w)
  {
    make_root(v);
    expose(w);
    m_up[m_child[0][w]] = none;
    m_child[0][w] = none;
  }

  // Returns the neighbour of v on the path to another vertex u of its tree.
  Index neighbor_towards(Index v, Index u)
  {
    make_root(v);
    expose(u);
    splay(v);
    return end_of(m_child[1][v], 0);
  }

  // Returns the two neighbours of p on the path between two other vertices u and v of its tree, or
  // twice `none` if p does not lie there.
  std::pair<Index, Index> neighbors_on_path(Index p, Index u, Index v)
  {
    make_root(u);
    expose(v);
    splay(p);
    if (m_up[p] != none)
      return {none, none};
    const Index before = m_child[0][p], after = m_child[1][p];
    return {end_of(before, 1), end_of(after, 0)};
  }

private:
  bool is_path_root(Index v) const
  {
    return m_up[v] == none || (m_child[0][m_up[v]] != v && m_child[1][m_up[v]] != v);
  }

  void make_root(Index v)
  {
    expose(v);
    m_is_turned[v] = !m_is_turned[v];
  }

  // Makes the path from the root of its tree to v one splay tree, with v at the top.
  void expose(Index v)
  {
    Index below = none;
    for (Index w = v; w != none; w = m_up[w]) {
      splay(w);
      m_child[1][w] = below;
      below = w;
    }
    splay(v);
  }

  // Returns the first (side 0) or last vertex of the subtree at v, which gets a little flatter.
  Index end_of(Index v, int side)
  {
    for (push_turn(v); m_child[side][v] != none; push_turn(v))
      v = m_child[side][v];
    splay(v);
    return v;
  }

  void push_turn(Index v)
  {
    if (!m_is_turned[v])
      return;
    m_is_turned[v] = false;
    std::swap(m_child[0][v], m_child[1][v]);
    for (int side : {0, 1})
      if (m_child[side][v] != none)
        m_is_turned[m_child[side][v]] = !m_is_turned[m_child[side][v]];
  }

  void splay(Index v)
  {
    m_above.assign(1, v);
    while (!is_path_root(m_above.back()))
      m_above.push_back(m_up[m_above.back()]);
    for (; !m_above.empty(); m_above.pop_back())
      push_turn(m_above.back());
    while (!is_path_root(v)) {
      const Index w = m_up[v];
      if (!is_path_root(w))
        rotate(side_of(v, w) == side_of(w, m_up[w]) ? w : v);
      rotate(v);
    }
  }

  int side_of(Index v, Index parent) const { return m_child[1][parent] == v ? 1 : 0; }

  void rotate(Index v)
  {
    const Index w = m_up[v], above = m_up[w];
    const int side = side_of(v, w);
    if (!is_path_root(w))
      m_child[side_of(w, above)][above] = v;
    m_up[v] = above;
    const Index between = m_child[1 - side][v];
    m_child[side][w] = between;
    if (between != none)
      m_up[between] = w;
    m_child[1 - side][v] = w;
    m_up[w] = v;
  }

  std::vector<Index> m_up; // the parent in the splay tree; at its root, the vertex above the path
  std::vector<Index> m_child[2];
  std::vector<bool> m_is_turned;
  std::vector<Index> m_above; // scratch
};

template <class Index>
class Exchange_tree
{
public:
  // `marks` has each edge at one of its darts.
  Exchange_tree(const Rotation_system<Index>& surface, Dart_marks& marks)
    : m_surface(surface)
    , m_marks(marks)
    , m_degree(surface.number_of_vertices(), 0)
    , m_forest(surface.number_of_vertices())
  {
    Dart_marks once(marks.size(), false);
    once.swap(marks);
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
        if (once[dart])
          set_edge(v, surface.neighbor[dart], true);
    std::vector<bool> is_met(surface.number_of_vertices(), false);
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      if (!is_met[v])
        for_each_from(v, is_met, [&](Index u, Index parent) {
          if (u != parent)
            m_forest.hang(u, parent);
        });
  }

  const Rotation_system<Index>& surface() const { return m_surface; }
  Index degree(Index v) const { return m_degree[v]; }

  // Calls function(u, parent) for all vertices of the tree of `root`, each after its parent; the
  // root counts as its own parent. `is_met` is false for all of them before, and true after.
  template <class Function>
  void for_each_from(Index root, std::vector<bool>& is_met, const Function& function) const
  {
    std::vector<std::pair<Index, Index>> stack(1, {root, root});
    is_met[root] = true;
    while (!stack.empty()) {
      const auto [v, parent] = stack.back();
      stack.pop_back();
      function(v, parent);
      for (Index dart = m_surface.first[v]; dart < m_surface.first[v + 1]; ++dart)
        if (m_marks[dart] && !is_met[m_surface.neighbor[dart]]) {
          is_met[m_surface.neighbor[dart]] = true;
          stack.emplace_back(m_surface.neighbor[dart], v);
        }
    }
  }

  Index neighbor_towards(Index v, Index u) { return m_forest.neighbor_towards(v, u); }

  // Adds the edge uv and drops one of the two edges at p on the path from u to v: the one whose
  // other end is heavier. Returns false if p does not lie on the path.
  bool exchange_at(Index p, Index u, Index v)
  {
    const auto [a, b] = m_forest.neighbors_on_path(p, u, v);
    if (a == Link_cut_forest<Index>::none)
      return false;
    exchange(p, m_degree[a] < m_degree[b] ? b : a, u, v);
    return true;
  }

  // Drops the edge pq and adds uv, which closes a cycle through pq.
  void exchange(Index p, Index q, Index u, Index v)
  {
    m_forest.cut(p, q);
    m_forest.link(u, v);
    set_edge(p, q, false);
    set_edge(u, v, true);
  }

  // Returns the vertices that have come to degree 4 since the last call, some of them repeatedly.
  std::vector<Index> take_risen() { return std::exchange(m_risen, {}); }

  // Leaves each edge marked at one dart.
  void mark_once()
  {
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      for (Index dart = m_surface.first[v]; dart < m_surface.first[v + 1]; ++dart)
        if (m_surface.neighbor[dart] < v)
          m_marks[dart] = false;
  }

private:
  void set_edge(Index v, Index w, bool is_in)
  {
    for (const auto& [from, to] : {std::pair<Index, Index>(v, w), std::pair<Index, Index>(w, v)}) {
      m_marks[dart_between(from, to)] = is_in;
      if (!is_in)
        --m_degree[from];
      else if (++m_degree[from] == 4)
        m_risen.push_back(from);
    }
  }

  // Returns the dart from v to w. A vertex may have millions of edges, many of them in the tree.
  std::size_t dart_between(Index v, Index w)
  {
    constexpr Index short_star = 64;
    const Star<Index> star = m_surface.star(v);
    if (star.size() <= short_star)
      return std::size_t(std::find(star.begin(), star.end(), w) - m_surface.neighbor.data());
    std::vector<std::pair<Index, Index>>& sorted = m_sorted_stars[v];
    if (sorted.empty()) {
      for (Index dart = m_surface.first[v]; dart < m_surface.first[v + 1]; ++dart)
        sorted.emplace_back(m_surface.neighbor[dart], dart);
      std::sort(sorted.begin(), sorted.end());
    }
    return std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(w, Index(0)))->second;
  }

  const Rotation_system<Index>& m_surface;
  Dart_marks& m_marks;
  std::unordered_map<Index, std::vector<std::pair<Index, Index>>> m_sorted_stars; // neighbour, dart
  std::vector<Index> m_degree;
  std::vector<Index> m_risen;
  Link_cut_forest<Index> m_forest;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_EXCHANGE_TREE_H
