// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choi 2002, Fig. 3 (bsg), unrolled into a forward loop: no recursion, nothing to undo.
//
//     while a vertex is still strictly inside:
//         z := a vertex of the cycle C without chord; z1, z2 its neighbours on C; w1..wk its other live neighbours
//         replace z by w1..wk on C;  add z-w1, w1-w2, …, w(k-1)-wk to H      (nothing if k = 0)
//
// Invariant: the live disc is the induced subgraph of the vertices that are not peeled, C is its rim, and
// count[v] is the number of v's neighbours on C for every v of C. So v has count[v] - 2 chords; and a v without chord has
// exactly two neighbours on C, which are z1 and z2: C needs no links. Counts, not marks: when z with k = 0
// goes, the chord z1z2 becomes an edge of C and frees z1 and z2. New vertices join C one at a time,
// each counting those that are there already; joined all at once, edges among them would count twice.
// A vertex gets at most 2 edges of H when it joins and 1 when it is peeled.
// Several discs peel side by side: nothing below ever looks from one into another.
// Cost: two scans of each list, about 12 neighbour visits per vertex; 4 bytes per vertex and the stack, at most
// as long as C.

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUBGRAPH_PEEL_DISCS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUBGRAPH_PEEL_DISCS_H

#include <CGAL/Delaunay_from_surface_3/internal/support/prefetch.h>
#include <CGAL/Delaunay_from_surface_3/internal/subgraph/Opened_surface.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Index>
class Peel_discs
{
public:
  // H's edges are written into `subgraph`, each at one dart; the rim's edges are left to the caller.
  Peel_discs(const Opened_surface<Index>& discs, Dart_marks& subgraph)
    : m_discs(discs)
    , m_subgraph(subgraph)
    , m_state(discs.number_of_vertices(), Index(inside))
  {
  }

  // Peels until no vertex is inside or none can be peeled; returns how many vertices were not reached.
  std::size_t operator()(std::size_t number_of_inner_vertices)
  {
    start(number_of_inner_vertices);
    while (peel_next()) {
    }
    return m_inside;
  }

  // C becomes the rim.
  void start(std::size_t number_of_inner_vertices)
  {
    m_inside = number_of_inner_vertices;
    for (Index v : m_discs.rim)
      m_state[v] = join_cycle(v, none);
    for (Index v : m_discs.rim)
      push_if_free(v);
  }

  // One round of the loop; returns whether a vertex was peeled.
  bool peel_next()
  {
    while (m_inside > 0 && !m_candidates.empty()) {
      const Index z = m_candidates.back();
      m_candidates.pop_back();
      m_state[z] &= ~queued;
      if (m_state[z] == free) {
        peel(z);
        return true;
      }
    }
    return false;
  }

  bool is_on_cycle(Index v) const { return Index(m_state[v] - 1) < peeled - 1; }

private:
  // The state of a vertex: 0 inside; 1 + count on C, with a bit for being on the stack; peeled.
  static constexpr Index peeled = Index(1) << (std::numeric_limits<Index>::digits - 1);
  static constexpr Index queued = peeled >> 1;
  static constexpr Index inside = 0;
  static constexpr Index free = 3; // a count of two: no chord
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // Returns w's state once it stands on C, and counts w at its neighbours there. Adds previous-w to H.
  Index join_cycle(Index w, Index previous)
  {
    const Star<Index> star = m_discs.star(w);
    Index state = 1;
    for (Index i = 0; i < star.size(); ++i) {
      const Index u = star[i];
      if (!is_on_cycle(u)) {
        if (m_state[u] == inside) // never a copy; its star is read soon
          prefetch(&m_discs.surface.first[u]);
        continue;
      }
      ++m_state[u];
      ++state;
      if (u == previous)
        m_subgraph[m_discs.dart(w, i)] = true;
    }
    return state;
  }

  void push_if_free(Index v)
  {
    if (m_state[v] == free) {
      m_state[v] |= queued;
      m_candidates.push_back(v);
    }
  }

  void peel(Index z)
  {
    const Star<Index> star = m_discs.star(z);
    const Index degree = star.size();
    Index i1 = 0;
    while (!is_on_cycle(star[i1]))
      ++i1;
    Index i2 = i1 + 1;
    while (!is_on_cycle(star[i2]))
      ++i2;
    const Index z1 = star[i1], z2 = star[i2];
    m_state[z] = peeled;
    --m_state[z1];
    --m_state[z2];
    // One of the two arcs between z1 and z2 is live, the other was peeled or lies outside.
    Index begin = i1 + 1;
    if (begin == i2 || m_state[star[begin]] != inside)
      begin = i2 + 1 < degree ? i2 + 1 : 0;
    advance_cycle(z, star, begin);
    push_if_free(z1);
    push_if_free(z2);
  }

  // Puts the live neighbours w1..wk of z, which stand in z's list from `begin` on, on C.
  void advance_cycle(Index z, const Star<Index>& star, Index begin)
  {
    m_fan.clear();
    for (Index i = begin; m_state[star[i]] == inside; i = i + 1 < star.size() ? i + 1 : 0) {
      prefetch(m_discs.star(star[i]).first);
      m_fan.push_back(star[i]);
    }
    if (m_fan.empty())
      return;
    m_subgraph[m_discs.dart(z, begin)] = true;
    Index previous = none;
    for (Index w : m_fan) {
      m_state[w] = join_cycle(w, previous);
      previous = w;
    }
    m_inside -= m_fan.size();
    for (Index w : m_fan)
      push_if_free(w);
  }

  const Opened_surface<Index>& m_discs;
  Dart_marks& m_subgraph;
  std::vector<Index> m_state;
  std::vector<Index> m_candidates; // last in, first out
  std::vector<Index> m_fan;
  std::size_t m_inside = 0;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_SUBGRAPH_PEEL_DISCS_H
