// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REDUCE_DEGREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REDUCE_DEGREES_H

// Exchanges edges of spanning trees until the degree of each is at most 3, or at most one more than
// the least possible in its component.
//
//     while the largest degree k of the tree is 4 or more:
//         for every vertex v of degree k: look for an edge between two neighbours of v that closes
//         a cycle through v, and exchange it for an edge at v
//         if there was none anywhere: run a phase of Fürer and Raghavachari (1994), which searches
//         everywhere; if it finds nothing either, stop: it has a witness
//
// Around v on a closed surface the edges between successive neighbours form a cycle, and without v
// the tree has k parts: so there are at least k such edges, of which at most one end may be heavy.
// This finds nearly all exchanges, at the few heavy vertices, which all lie on the cut.
// Bound: an exchange of the first kind, or a phase that finds something, takes one vertex of degree
// k away and makes none. A tree on n vertices has at most (n - 2) / (k - 1) of them, so there are
// at most (n - 2) ln((K - 1) / 2) in all, where K is the largest degree at the start.
// Cost: O(n) if there is anything to do, O(log n) for each corner that is examined, O(1) for each
// heavy vertex whenever all are looked through, and O(n α(n)) for each phase. Each search around a
// vertex resumes where the last one stopped: most corners it passes have the same part of the tree
// on both sides, and exchanges at the vertex only join parts. So all searches around a vertex
// usually cost one turn together; at worst they cost one turn each, since exchanges elsewhere
// divide parts again.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_marks.h>
#include <CGAL/Delaunay_from_surface_3/surface/Exchange_tree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

proves that no spanning tree of a component has a much smaller degree than that of
`near_minimum_degree_spanning_tree()`. Removing some vertices X leaves so many components that every
spanning tree has many edges at one of these vertices.
*/
struct Minimum_degree_witness
{
  std::vector<std::size_t> vertices;    ///< the indices of the vertices X, in no particular order
  std::size_t number_of_components = 0; ///< the number left without X, counted in the surface
  std::size_t tree_degree = 0;          ///< the largest degree of the tree that was found

  /// returns a degree that every spanning tree of the component has or exceeds at some vertex of X.
  /// If c components are left without x vertices, a tree has at least c + x − 1 edges at these.
  std::size_t least_degree() const
  {
    const std::size_t x = vertices.size();
    return x == 0 ? 0 : (number_of_components + x - 1 + x - 1) / x;
  }

  /// returns whether the witness proves that no tree has a degree smaller by more than one.
  bool is_within_one() const { return tree_degree <= least_degree() + 1; }
};

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Runs one phase of Fürer and Raghavachari (1994): finds vertices of the largest degree k in a tree
// T that can be made lighter, or a set of vertices that proves that there are none.
//
//     the vertices of degrees k and k - 1 are bad
//     while an edge uv of the surface joins two components of T without the bad vertices:
//         the path of T from u to v runs through bad vertices
//         if one of them, w, has degree k: add uv, drop an edge at w of this path; no path is
//         followed through w any more
//         else all of them are good from now on, each with uv for its reason; they and the
//         components along the path form one component
//     the bad vertices that are left are the witness
//
// Invariant: a vertex of degree k - 1 that has become good can be brought to k - 2 by exchanges
// within its component, so that u and v can take one more edge when they must: first u and v are
// made lighter by their own reasons, each inside its own component; the two components share no
// vertex, and w is in neither. That holds for the first w. For the next ones T may have changed: an
// exchange is skipped if its path does not run there any more, or an end has become heavy. No
// vertex comes to degree k in any case; and a phase that makes no vertex lighter has not changed T,
// so that its witness holds. Cost: O(m α(m)) for m edges of the component; 20 bytes per vertex of
// the surface, from the first phase on.

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

  // Returns the witness after a phase that found nothing.
  std::vector<Index> witness() const
  {
    std::vector<Index> result;
    for (const Index v : m_order)
      if (!m_node[v].is_good)
        result.push_back(v);
    return result;
  }

  // Returns all vertices of the tree of the last phase.
  const std::vector<Index>& vertices() const { return m_order; }

private:
  struct Node
  {
    Index parent; // in T
    Index depth;  // in T
    Index set;    // leads to the vertex of its component nearest the root, as in disjoint sets
    Index reason; // an edge in m_reasons
    bool is_good;
    bool is_closed; // had degree k, and was tried
  };

  void read_tree(Index root)
  {
    m_node.resize(m_tree.surface().number_of_vertices()); // often no phase is run at all
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

  // Returns the uppermost vertex of v's component.
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

// Counts the work for benchmarks.
struct Reduction_counts
{
  std::size_t exchanges_nearby = 0;
  std::size_t corners = 0; // examined for these exchanges
  std::size_t phases = 0;
  std::size_t phases_in_vain = 0; // each has a witness
};

template <class Index>
class Reduce_degrees
{
public:
  // `marks` has each edge of the forest at one of its darts.
  Reduce_degrees(const Rotation_system<Index>& surface, Dart_marks& marks)
    : m_surface(surface)
    , m_tree(surface, marks)
    , m_phase(m_tree)
    , m_next_corner(surface.number_of_vertices(), 0)
    , m_is_met(surface.number_of_vertices(), false)
  {
  }

  // `witnesses` gets one for every component whose tree keeps a degree of 4 or more.
  Reduction_counts operator()(std::vector<Minimum_degree_witness>& witnesses)
  {
    m_witnesses = &witnesses;
    const Index n = m_surface.number_of_vertices();
    std::vector<bool> is_met(n, false);
    m_tree.take_risen();
    for (Index root = 0; root < n; ++root)
      if (!is_met[root] && m_surface.degree(root) > 0) {
        m_heavy.clear();
        m_tree.for_each_from(root, is_met, [&](Index v, Index) {
          if (m_tree.degree(v) > 3)
            m_heavy.push_back(v);
        });
        reduce(root);
      }
    m_tree.mark_once();
    return m_counts;
  }

private:
  void reduce(Index root)
  {
    for (Index k = find_heaviest(); k > 3; k = find_heaviest()) {
      const std::size_t before = m_counts.exchanges_nearby;
      for (const Index v : m_heavy)
        if (m_tree.degree(v) == k && exchange_near(v))
          ++m_counts.exchanges_nearby;
      if (m_counts.exchanges_nearby > before)
        continue;
      ++m_counts.phases;
      if (m_phase(root, k) == 0) {
        ++m_counts.phases_in_vain;
        add_witness(k);
        return;
      }
    }
  }

  // Brings m_heavy up to date and returns the largest degree.
  Index find_heaviest()
  {
    const std::vector<Index> risen = m_tree.take_risen();
    m_heavy.insert(m_heavy.end(), risen.begin(), risen.end());
    Index k = 3;
    const auto is_light = [&](Index v) {
      k = (std::max)(k, m_tree.degree(v));
      return m_tree.degree(v) < 4;
    };
    m_heavy.erase(std::remove_if(m_heavy.begin(), m_heavy.end(), is_light), m_heavy.end());
    return k;
  }

  // Examines all corners of v, starting after the one that was examined last.
  bool exchange_near(Index v)
  {
    const Index corners = m_surface.number_of_corners(v);
    Index& next = m_next_corner[v];
    for (Index looks = 0; looks < corners; ++looks) {
      const Index i = next;
      next = i + 1 < corners ? i + 1 : 0;
      ++m_counts.corners;
      if (exchange_at_corner(v, i))
        return true;
    }
    return false;
  }

  // Exchanges an edge at v, of degree k, for the edge between the neighbours a and b at a corner,
  // if these lie in different parts of the tree without v. If one of them is v's neighbour in the
  // tree, dropping that edge leaves its degree unchanged, so it may be heavy.
  bool exchange_at_corner(Index v, Index i)
  {
    const Star<Index> star = m_surface.star(v);
    const Index a = star[i], b = star[i + 1 < star.size() ? i + 1 : 0];
    const Index k = m_tree.degree(v);
    const bool is_a_light = m_tree.degree(a) + 2 <= k, is_b_light = m_tree.degree(b) + 2 <= k;
    if (!is_a_light && !is_b_light)
      return false;
    const Index p = m_tree.neighbor_towards(v, a), q = m_tree.neighbor_towards(v, b);
    if (p == q)
      return false;
    if (is_a_light && is_b_light)
      m_tree.exchange(v, m_tree.degree(p) < m_tree.degree(q) ? q : p, a, b);
    else if (is_b_light && p == a)
      m_tree.exchange(v, a, a, b);
    else if (is_a_light && q == b)
      m_tree.exchange(v, b, a, b);
    else
      return false;
    return true;
  }

  void add_witness(Index k)
  {
    const std::vector<Index> x = m_phase.witness();
    for (const Index v : x)
      m_is_met[v] = true;
    Minimum_degree_witness witness;
    witness.vertices.assign(x.begin(), x.end());
    witness.tree_degree = k;
    for (const Index v : m_phase.vertices())
      if (!m_is_met[v]) {
        ++witness.number_of_components;
        meet_from(v);
      }
    for (const Index v : m_phase.vertices())
      m_is_met[v] = false;
    m_witnesses->push_back(std::move(witness));
  }

  // Searches the surface, not the tree, so that the witness depends on no earlier step.
  void meet_from(Index root)
  {
    m_stack.assign(1, root);
    m_is_met[root] = true;
    while (!m_stack.empty()) {
      const Index v = m_stack.back();
      m_stack.pop_back();
      for (const Index u : m_surface.star(v))
        if (!m_is_met[u]) {
          m_is_met[u] = true;
          m_stack.push_back(u);
        }
    }
  }

  const Rotation_system<Index>& m_surface;
  Exchange_tree<Index> m_tree;
  Degree_phase<Index> m_phase;
  std::vector<Index> m_next_corner; // the corner of each vertex that is examined next
  std::vector<bool> m_is_met;
  std::vector<Index> m_heavy; // vertices of degree 4 and more in the current component
  std::vector<Index> m_stack;
  std::vector<Minimum_degree_witness>* m_witnesses = nullptr;
  Reduction_counts m_counts;
};

// Returns whether no vertex has more than three marked edges; each is marked at one of its darts.
template <class Index>
bool has_degree_of_3(const Rotation_system<Index>& surface, const Dart_marks& marks)
{
  std::vector<unsigned char> degree(surface.number_of_vertices(), 0);
  bool result = true;
  const auto count = [&](Index v) { result = result && ++degree[v] <= 3; };
  for (Index v = 0; v < surface.number_of_vertices(); ++v)
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      if (marks[dart]) {
        count(v);
        count(surface.neighbor[dart]);
      }
  return result;
}

template <class Index>
Dart_marks near_minimum_degree_marks(Rotation_system<Index>& surface,
                                     std::vector<Minimum_degree_witness>& witnesses)
{
  Dart_marks marks;
  {
    Bounded_degree_marks<Index> find_tree(surface, Subgraph_kind::TREE);
    marks = find_tree();
    find_tree.close();
  }
  if (!has_degree_of_3(surface, marks))
    Reduce_degrees<Index>(surface, marks)(witnesses);
  return marks;
}

template <class Reader, class OutputIterator>
OutputIterator write_near_minimum_degree_tree(const Reader& reader, OutputIterator out,
                                              std::vector<Minimum_degree_witness>& witnesses)
{
  return with_rotation_system(reader, [&](auto& surface) {
    return write_marked(reader, surface, near_minimum_degree_marks(surface, witnesses), out);
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REDUCE_DEGREES_H
