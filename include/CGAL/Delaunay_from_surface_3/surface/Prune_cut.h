// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PRUNE_CUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PRUNE_CUT_H

// Step 2 of the cut: prune G to the cut graph.
//
// Vertices of degree 1 are removed until none is left; then an edge is in the cut graph if and only
// if both its ends still have a degree. The one neighbour of a vertex of degree 1 is the exclusive
// or of its neighbours, so no list is looked at. The last step puts the mark of a cut edge on both
// its darts.
// Invariant: removing a leaf and its edge leaves the complement of G an open disc.
// Bound: with χ = 2 - h - b the sum of (degree - 2) over the cut graph is 2(1 - χ) and no degree is
// below 2. This is what bounds the degree of the subgraph; G itself has no bound. A sphere prunes
// to a point.
// Cost: O(n), one bit per vertex and two words per cut edge.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Buckets.h>
#include <CGAL/Delaunay_from_surface_3/surface/Search_triangles.h>

#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
class Prune_cut
{
public:
  Prune_cut(const Rotation_system<Index>& surface, Cut_candidate<Index>& candidate)
    : m_surface(surface)
    , m_candidate(candidate)
  {
  }

  void operator()()
  {
    remove_leaves();
    mark_both_darts();
  }

private:
  bool is_on_cut(Index v) const { return m_candidate.degree[v] != 0; }

  void remove_leaves()
  {
    std::vector<Index>& degree = m_candidate.degree;
    std::vector<Index>& neighbors = m_candidate.xor_of_neighbors;
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      for (Index leaf = v; degree[leaf] == 1;) {
        const Index next = neighbors[leaf];
        degree[leaf] = 0;
        --degree[next];
        neighbors[next] ^= leaf;
        leaf = next;
      }
  }

  void mark_both_darts()
  {
    Buckets<Index> marked_at;
    std::vector<Index>& heads = m_candidate.xor_of_neighbors; // no longer needed as such
    heads.assign(heads.size(), Buckets<Index>::empty);
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      if (is_on_cut(v))
        keep_cut_edges(v, heads, marked_at);
    std::vector<bool> is_other_end(m_surface.number_of_vertices(), false);
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v) {
      if (heads[v] == Buckets<Index>::empty)
        continue;
      marked_at.for_each(heads[v], [&](Index u) { is_other_end[u] = true; });
      for (Index dart = m_surface.first[v]; dart < m_surface.first[v + 1]; ++dart)
        if (is_other_end[m_surface.neighbor[dart]])
          m_candidate.marks[dart] = true;
      marked_at.for_each(heads[v], [&](Index u) { is_other_end[u] = false; });
    }
  }

  void keep_cut_edges(Index v, std::vector<Index>& heads, Buckets<Index>& marked_at)
  {
    for (Index dart = m_surface.first[v]; dart < m_surface.first[v + 1]; ++dart) {
      if (!m_candidate.marks[dart])
        continue;
      const Index u = m_surface.neighbor[dart];
      if (is_on_cut(u))
        marked_at.add(heads[u], v);
      else
        m_candidate.marks[dart] = false;
    }
  }

  const Rotation_system<Index>& m_surface;
  Cut_candidate<Index>& m_candidate;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_PRUNE_CUT_H
