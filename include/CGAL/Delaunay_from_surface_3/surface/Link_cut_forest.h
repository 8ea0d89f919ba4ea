// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_LINK_CUT_FOREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_LINK_CUT_FOREST_H

// A forest whose edges come and go, asked for what lies on the path between two vertices
// (Sleator, Tarjan 1985).
//
// Invariant: the forest falls into paths; each is a splay tree, ordered along the path, whose root
// names the vertex above the path's upper end, if there is one. A subtree may have to be read
// backwards.
// Cost: O(log n) for each operation, amortized; 13 bytes per vertex with indices of 32 bits.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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

  // Hangs the root v, which is alone on its path, below w. For building in any order.
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

  // The neighbour of v on the path to another vertex u of its tree.
  Index neighbor_towards(Index v, Index u)
  {
    make_root(v);
    expose(u);
    splay(v);
    return end_of(m_child[1][v], 0);
  }

  // The two neighbours of p on the path between two other vertices u and v of its tree; none if p
  // does not lie there.
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

  // The first (side 0) or last vertex of the subtree at v, which becomes a little flatter.
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

  std::vector<Index> m_up; // in the path's splay tree; of its root: the vertex above the path
  std::vector<Index> m_child[2];
  std::vector<bool> m_is_turned;
  std::vector<Index> m_above; // scratch
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_LINK_CUT_FOREST_H
