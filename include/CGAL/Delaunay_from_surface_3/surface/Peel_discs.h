// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PEEL_DISCS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PEEL_DISCS_H

// Computes bsg(G, C) of Choi 2002, Fig. 3, which was inspired by a proof of Thomassen. The
// recursion is unrolled into a forward loop, with nothing to undo.
//
//     H := C                                                                          (line 1)
//     while a vertex is strictly inside C:
//         z := a vertex of C without a chord                                          (line 2)
//         z1, …, zm := the neighbours of z in G, in their cyclic order, z1 and zm on C   (line 3)
//         G := G - z, and replace z by z2, …, z(m-1) on C
//         add z z2 and z2 z3, …, z(m-2) z(m-1) to H                         (nothing if m = 2)
//
// Line by line, and where this differs from the paper:
//   line 1  The caller marks H := C, the rims of the discs (Bounded_degree_marks::add_rim_edge).
//           The loop does not go on until |V(G)| = 3: with no vertex inside, all further z have
//           m = 2.
//   line 2  is peel_next(). A triangle C is no special case: it has no chord, and while a vertex is
//           inside and the surface is simple, none of its corners has degree two.
//   line 3  peel() finds z1 and zm, advance_cycle() goes on to C', join_cycle() updates the chords.
//           On its way out of the recursion the paper puts C into H and takes z1 z2 and z(m-1) zm
//           out again. Here these two are never added, so z1 z and zm z need no work either. A list
//           may run either way around: it does not matter which end of the arc is z1.
//
// Invariant: G is the induced subgraph of the vertices that are not peeled, C is its rim, and
// count[v] is the number of v's neighbours on C for every v of C. So v has count[v] - 2 chords; and
// a v without chord has exactly two neighbours on C, which are z1 and zm: C needs no links. Counts
// replace the paper's marks (Lemma 8): when a z with m = 2 is peeled, the chord z1 zm becomes an
// edge of C and frees z1 and zm. New vertices join C one at a time, each counting those that are
// there already; if all joined at once, edges among them would count twice. A vertex gets at most 2
// edges of H when it joins C and 1 when it is peeled, hence degree 3 (Lemma 7).
// Several discs are peeled side by side: no step looks from one into another.
// Cost: two scans of each list, about 12 neighbour visits per vertex (Lemma 8); 4 bytes per vertex
// and a stack at most as long as C.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>
#include <CGAL/Delaunay_from_surface_3/surface/Open_along_cut.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
class Peel_discs
{
public:
  // H's edges are marked in `subgraph`, each at one dart; the caller marks the rim's edges.
  Peel_discs(const Opened_surface<Index>& discs, Dart_marks& subgraph)
    : m_discs(discs)
    , m_subgraph(subgraph)
    , m_state(discs.number_of_vertices(), Index(inside))
  {
  }

  // Peels until no vertex is inside or none can be peeled; returns how many vertices were not
  // reached.
  std::size_t operator()(std::size_t number_of_inner_vertices)
  {
    start(number_of_inner_vertices);
    while (peel_next()) {
    }
    return m_inside;
  }

  // Makes the rim C: line 1.
  void start(std::size_t number_of_inner_vertices)
  {
    m_inside = number_of_inner_vertices;
    for (Index v : m_discs.rim)
      m_state[v] = join_cycle(v, none);
    for (Index v : m_discs.rim)
      push_if_free(v);
  }

  // Does one round of the loop, line 2; returns whether a vertex was peeled.
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
  // The state of a vertex is 0 inside, 1 + count on C, with a bit if it is on the stack, or peeled.
  static constexpr Index peeled = Index(1) << (std::numeric_limits<Index>::digits - 1);
  static constexpr Index queued = peeled >> 1;
  static constexpr Index inside = 0;
  static constexpr Index free = 3; // a count of two: no chord
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // Returns the state that zj has on C, and counts zj at its neighbours there. Adds the edge from
  // the previous vertex, z(j-1) zj, to H.
  Index join_cycle(Index zj, Index previous)
  {
    const Star<Index> star = m_discs.star(zj);
    Index state = 1;
    for (Index i = 0; i < star.size(); ++i) {
      const Index u = star[i];
      if (!is_on_cycle(u)) {
        if (m_state[u] == inside) // its star will be read soon; a copy on the rim has none
          prefetch(m_discs.surface.first.data() + u);
        continue;
      }
      ++m_state[u];
      ++state;
      if (u == previous)
        m_subgraph[m_discs.dart(zj, i)] = true;
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

  // Peels z: line 3.
  void peel(Index z)
  {
    const Star<Index> star = m_discs.star(z);
    const Index degree = star.size();
    Index i1 = 0;
    while (!is_on_cycle(star[i1]))
      ++i1;
    Index im = i1 + 1;
    while (!is_on_cycle(star[im]))
      ++im;
    const Index z1 = star[i1], zm = star[im];
    m_state[z] = peeled;
    --m_state[z1];
    --m_state[zm];
    // One of the two arcs between z1 and zm is in G; the other was peeled or lies outside.
    Index i2 = i1 + 1;
    if (i2 == im || m_state[star[i2]] != inside)
      i2 = im + 1 < degree ? im + 1 : 0;
    advance_cycle(z, star, i2);
    push_if_free(z1);
    push_if_free(zm);
  }

  // Puts z2, …, z(m-1) on C; they stand in z's list from i2 on.
  void advance_cycle(Index z, const Star<Index>& star, Index i2)
  {
    m_fan.clear();
    for (Index i = i2; m_state[star[i]] == inside; i = i + 1 < star.size() ? i + 1 : 0) {
      prefetch(m_discs.star(star[i]).first);
      m_fan.push_back(star[i]);
    }
    if (m_fan.empty())
      return;
    m_subgraph[m_discs.dart(z, i2)] = true;
    Index previous = none;
    for (Index zj : m_fan) {
      m_state[zj] = join_cycle(zj, previous);
      previous = zj;
    }
    m_inside -= m_fan.size();
    for (Index zj : m_fan)
      push_if_free(zj);
  }

  const Opened_surface<Index>& m_discs;
  Dart_marks& m_subgraph;
  std::vector<Index> m_state;
  std::vector<Index> m_candidates; // last in, first out
  std::vector<Index> m_fan;        // z2, …, z(m-1)
  std::size_t m_inside = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PEEL_DISCS_H
