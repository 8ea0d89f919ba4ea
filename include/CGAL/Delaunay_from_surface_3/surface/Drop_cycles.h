// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DROP_CYCLES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DROP_CYCLES_H

// The tree variant: drops edges of H until no cycle is left, at the heaviest vertices first.
//
// All cycles of H lie in the rim (the cut graph, the boundary and opened faces); the rest hangs on
// it as trees. So: Kruskal on the rim's edges, each weighted by the larger degree in H of its two
// ends, light edges first; what closes a cycle is dropped.
// Invariant: of all spanning trees of H this is one in which the heaviest vertex keeps as few edges
// as it can.
// Bound: with h = 2 - χ - b, H's degree exceeds max(3, 3h + 2b) at one vertex at most (at two on an
// annulus, on one rim cycle each), and dropping at that vertex brings it down to 3h + 2b; only on
// the projective plane 4 remain.
// Cost: O(n + r α(r)) for r rim edges; 9 bytes per vertex after all else has been freed.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/surface/Opened_surface.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// An edge of the rim, by the dart at which H marks it.
template <class Index>
struct Rim_edge
{
  Index source;
  Index target;
  Index dart;
};

template <class Index>
class Drop_cycles
{
public:
  Drop_cycles(const Opened_surface<Index>& opened, Dart_marks& subgraph)
    : m_opened(opened)
    , m_subgraph(subgraph)
  {
  }

  void operator()(const std::vector<Rim_edge<Index>>& rim_edges)
  {
    count_degrees();
    Disjoint_sets<Index> trees(m_degree.size());
    for (const Rim_edge<Index>& edge : light_edges_first(rim_edges))
      if (!trees.unite(edge.source, edge.target))
        m_subgraph[edge.dart] = false;
  }

private:
  void count_degrees()
  {
    const Rotation_system<Index>& surface = m_opened.surface;
    m_degree.assign(surface.number_of_vertices(), 0);
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
        if (m_subgraph[dart]) {
          ++m_degree[v];
          ++m_degree[m_opened.origin(surface.neighbor[dart])];
        }
  }

  Index weight(const Rim_edge<Index>& edge) const
  {
    return (std::max)(m_degree[edge.source], m_degree[edge.target]);
  }

  // Sorted by counting.
  std::vector<Rim_edge<Index>> light_edges_first(const std::vector<Rim_edge<Index>>& edges) const
  {
    std::vector<std::size_t> begin_of_weight(1, 0);
    for (const Rim_edge<Index>& edge : edges) {
      if (begin_of_weight.size() < std::size_t(weight(edge)) + 2)
        begin_of_weight.resize(std::size_t(weight(edge)) + 2, 0);
      ++begin_of_weight[weight(edge) + 1];
    }
    for (std::size_t w = 1; w < begin_of_weight.size(); ++w)
      begin_of_weight[w] += begin_of_weight[w - 1];
    std::vector<Rim_edge<Index>> sorted(edges.size());
    for (const Rim_edge<Index>& edge : edges)
      sorted[begin_of_weight[weight(edge)]++] = edge;
    return sorted;
  }

  const Opened_surface<Index>& m_opened;
  Dart_marks& m_subgraph;
  std::vector<Index> m_degree;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DROP_CYCLES_H
