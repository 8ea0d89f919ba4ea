// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DEGREE_PHASE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DEGREE_PHASE_H

// One phase of Fürer and Raghavachari (1994): finds vertices of the largest degree k in a tree T
// that can be made lighter, or a set of vertices that shows that there are none.
//
//     bad vertices: those of degree k, and of degree k - 1
//     while an edge uv of the surface joins two components of T without the bad vertices:
//         the path of T from u to v runs through bad vertices
//         if one of them, w, has degree k: add uv, drop an edge at w of this path; no path is
//         followed through w any more
//         else all of them are good from now on, each with uv for its reason; the components and
//         what lies between are one component
//     the bad vertices that are left are the witness
//
// Invariant: a vertex of degree k - 1 that has become good can be brought to k - 2 by exchanges
// within its component, so that u and v can take one edge more when it comes to that: first u is
// made lighter, by its own reason, and v by its, each inside its own component; these two share no
// vertex, and w is in neither. That holds for the first w. For the next ones T may have changed: an
// exchange is left out if its path does not run there any more, or an end has become heavy. No
// vertex comes to degree k in any case; and a phase that makes none lighter has tried nothing, so
// that its witness holds. Cost: O(m α(m)) for m edges of the component; 20 bytes per vertex of the
// surface, from the first phase on.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Exchange_tree.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
class Degree_phase
{
public:
  explicit Degree_phase(Exchange_tree<Index>& tree)
    : m_tree(tree)
  {
  }

  // Returns how many vertices of degree k, the largest in the tree of `root`, were made lighter.
  std::size_t operator()(Index root, Index k)
  {
    m_k = k;
    m_successes = 0;
    read_tree(root);
    m_good.clear();
    for (const Index v : m_order)
      if (m_tree.degree(v) + 2 <= k)
        m_good.push_back(v);
    for (const Index v : m_good)
      m_node[v].is_good = true;
    for (std::size_t i = 0; i < m_good.size(); ++i) { // freed vertices are appended
      const Index v = m_good[i];
      for (const Index u : m_tree.surface().star(v))
        if (m_node[u].is_good)
          join(v, u);
    }
    return m_successes;
  }

  // After a phase that found nothing.
  std::vector<Index> witness() const
  {
    std::vector<Index> result;
    for (const Index v : m_order)
      if (!m_node[v].is_good)
        result.push_back(v);
    return result;
  }

  // All vertices of the tree that was looked at last.
  const std::vector<Index>& vertices() const { return m_order; }

private:
  struct Node
  {
    Index parent; // in T, as are depths
    Index depth;
    Index set;    // of disjoint sets: the way to the vertex of its component nearest the root
    Index reason; // an edge in m_reasons
    bool is_good;
    bool is_closed; // was of degree k, and tried
  };

  void read_tree(Index root)
  {
    m_node.resize(m_tree.surface().number_of_vertices()); // by the first phase; often there is none
    m_is_met.resize(m_node.size(), false);
    m_order.clear();
    m_reasons.clear();
    m_tree.for_each_from(root, m_is_met, [&](Index v, Index parent) {
      m_order.push_back(v);
      m_node[v] = {parent, v == parent ? 0 : m_node[parent].depth + 1, v, none, false, false};
    });
    for (const Index v : m_order)
      m_is_met[v] = false;
  }

  // The uppermost vertex of v's component.
  Index top(Index v)
  {
    while (m_node[v].set != v) {
      m_node[v].set = m_node[m_node[v].set].set;
      v = m_node[v].set;
    }
    return v;
  }

  // Makes one component of all that the path from u to v meets, up to a vertex of degree k, which
  // is made lighter if possible.
  void join(Index u, Index v)
  {
    bool has_reason = false;
    for (Index a = top(u), b = top(v); a != b; a = top(a), b = top(b)) {
      if (m_node[a].depth < m_node[b].depth)
        std::swap(a, b);
      const Index above = m_node[a].parent; // on the path, as a is not above b
      if (!m_node[above].is_good) {
        if (m_node[above].is_closed)
          return;
        if (m_tree.degree(above) == m_k) {
          m_node[above].is_closed = true;
          m_successes += improve(above, {u, v}) ? 1 : 0;
          return;
        }
        if (!has_reason)
          m_reasons.emplace_back(u, v);
        has_reason = true;
        m_node[above].reason = static_cast<Index>(m_reasons.size() - 1);
        m_node[above].is_good = true;
        m_good.push_back(above);
      }
      m_node[a].set = above;
    }
  }

  bool improve(Index w, std::pair<Index, Index> edge)
  {
    struct Step
    {
      Index vertex;
      std::pair<Index, Index> edge;
    };
    std::vector<Step> steps(1, Step{w, edge});
    while (!steps.empty()) {
      const Step step = steps.back();
      const auto [u, v] = step.edge;
      const Index heavy = m_tree.degree(u) + 2 > m_k ? u : v;
      if (m_tree.degree(heavy) + 2 > m_k) {
        if (m_node[heavy].reason == none || steps.size() > m_reasons.size())
          return false;
        steps.push_back(Step{heavy, m_reasons[m_node[heavy].reason]});
      } else {
        if (!m_tree.exchange_at(step.vertex, u, v))
          return false;
        steps.pop_back();
      }
    }
    return true;
  }

  static constexpr Index none = (std::numeric_limits<Index>::max)();

  Exchange_tree<Index>& m_tree;
  std::vector<Node> m_node;
  std::vector<bool> m_is_met;
  std::vector<Index> m_order;
  std::vector<Index> m_good;
  std::vector<std::pair<Index, Index>> m_reasons;
  std::size_t m_successes = 0;
  Index m_k = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DEGREE_PHASE_H
