// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REDUCE_DEGREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REDUCE_DEGREES_H

// Exchanges edges of spanning trees until each has a largest degree of 3, or of at most one more
// than any spanning tree of its component.
//
//     while the largest degree k of the tree is 4 or more:
//         for every vertex v of degree k: look for an edge between two neighbours of v that closes
//         a cycle through v, and exchange it for an edge at v
//         if there was none anywhere: a phase of Fürer and Raghavachari (1994), which looks
//         everywhere; if that finds nothing either, stop: it has a witness
//
// Around v on a closed surface the edges between successive neighbours form a cycle, and without v
// the tree has k parts: so there are k such edges at least, of which one end at most may be heavy.
// Nearly all exchanges are found so, at the few heavy vertices, which all lie on the cut.
// Bound: an exchange of the first kind, and a phase that finds something, takes one vertex of degree k away and makes
// none. A tree on n vertices has at most (n - 2) / (k - 1) of them, so there are at most
// (n - 2) ln((K - 1) / 2) in all, where K is the largest degree at the start.
// Cost: O(n) if there is anything to do, O(log n) for each corner of a vertex that is looked at,
// O(1) for each heavy vertex whenever all are looked through, and O(n α(n)) for each phase. A look
// goes around the vertex from where the last one ended: most corners passed have the same part of
// the tree on both sides, and exchanges at the vertex only join parts. So many looks take one turn
// together; they could take one each, since exchanges elsewhere divide parts again.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Degree_phase.h>
#include <CGAL/Delaunay_from_surface_3/surface/Exchange_tree.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_degree_witness.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What was done, to be measured.
struct Reduction_counts
{
  std::size_t exchanges_nearby = 0;
  std::size_t corners = 0; // that were looked at for these
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

  // Looks at all corners of v, from the one after the last that was looked at.
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

  // Exchanges an edge at v, of degree k, for that between the neighbours a and b at a corner, if
  // these lie in different parts of the tree without v. Where one of them hangs on v its degree
  // does not change.
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

  // In the surface, not in the tree: a witness owes nothing to the search.
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
  std::vector<Index> m_next_corner; // of each vertex, to be looked at next
  std::vector<bool> m_is_met;
  std::vector<Index> m_heavy; // of degree 4 and more, in the component at hand
  std::vector<Index> m_stack;
  std::vector<Minimum_degree_witness>* m_witnesses = nullptr;
  Reduction_counts m_counts;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REDUCE_DEGREES_H
