// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_NET_HIERARCHY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_NET_HIERARCHY_H

// Nets of a graph, each a maximal independent set of the one before, with the clusters of their
// vertices.
//
// A graph is given by the neighbours of each vertex that have smaller numbers: each edge once, at
// the end that is looked at last.
//
// Invariant: a level's vertices are numbered in the order in which those of the level below are, so
// that a mesh that is coherent in memory gives levels that are. No search through the graph: where
// the mesh is not coherent it would miss the cache at every vertex.
// Cost: every level is linear in its vertices and edges. On the surfaces measured the levels shrink
// by a constant factor (4 to 5) and their edges with them: linear altogether. In other graphs a
// level may keep nearly all its vertices; such a level ends the hierarchy.

#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/core/order/lower_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/core/order/random_net.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists_view.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The members of every cluster, its net vertex first, the others in ascending order.
inline Lists<std::uint32_t> members(const Net& net, const Executor& executor)
{
  using Index = std::uint32_t;
  Lists<Index> lists = in_lists<Index>(
      net.centers.size(),
      Listed_items(
          net.cluster_of.size(), [&](std::size_t v) { return std::size_t(net.cluster_of[v]); },
          [](std::size_t v) { return Index(v); }),
      executor);
  for_each_block(executor, lists.size(), number_of_blocks(executor, lists.size(), 4096),
                 [&](std::size_t begin, std::size_t end, std::size_t) {
                   for (std::size_t c = begin; c < end; ++c) {
                     Index* const first = lists.items.data() + lists.first[c];
                     Index* k = first;
                     while (*k != net.centers[c])
                       ++k;
                     std::copy_backward(first, k, k + 1);
                     *first = net.centers[c];
                   }
                 });
  return lists;
}

// The graph of the clusters: two are neighbours if members of theirs are. An edge is met from each
// of its clusters at most once, so that it is there twice at most. Here those met from the clusters
// first, …, last - 1 are written behind `edges`.
inline void append_contracted(const Lists_view<std::uint32_t>& lower,
                              const Large_vector<std::uint32_t>& cluster_of,
                              const Lists<std::uint32_t>& clusters, std::size_t first,
                              std::size_t last, Large_vector<Numbered_edge>& edges)
{
  using Index = std::uint32_t;
  Large_vector<Index> last_met_by(clusters.size(), Index(clusters.size()));
  const std::size_t last_item = clusters.items.size() - 1;
  for (std::size_t c = first; c < last; ++c) {
    last_met_by[c] = Index(c);
    for (std::size_t k = clusters.first[c]; k < clusters.first[c + 1]; ++k) {
      prefetch(&lower.first[clusters.items[(std::min)(k + prefetch_distance, last_item)]]);
      prefetch(lower.begin(clusters.items[(std::min)(k + near_prefetch_distance, last_item)]));
      const Index v = clusters.items[k];
      for (const Index *u = lower.begin(v), *end = lower.end(v); u != end; ++u) {
        const Index d = cluster_of[*u];
        if (last_met_by[d] == Index(c))
          continue;
        last_met_by[d] = Index(c);
        edges.emplace_back(Index(c), d);
      }
    }
  }
}

inline Lists<std::uint32_t> contracted(const Lists_view<std::uint32_t>& lower,
                                       const Large_vector<std::uint32_t>& cluster_of,
                                       const Lists<std::uint32_t>& clusters,
                                       const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, clusters.size(), 4096);
  std::vector<Large_vector<Numbered_edge>> edges(blocks);
  for_each_block(executor, clusters.size(), blocks,
                 [&](std::size_t first, std::size_t last, std::size_t b) {
                   edges[b].reserve(4 * (last - first)); // on a surface
                   append_contracted(lower, cluster_of, clusters, first, last, edges[b]);
                 });
  return lower_neighbors(edges, clusters.size(), executor);
}

// The levels, finest first. clusters[l] lists the clusters of the vertices of level l; they are the
// vertices of level l + 1. names[l] tells which point a vertex of level l is; at level 0 every
// vertex is its own number, and nothing is stored.
struct Net_hierarchy
{
  std::vector<Lists<std::uint32_t>> clusters;
  std::vector<Large_vector<std::uint32_t>> names;
  std::size_t number_of_coarsest;

  // Nets of the graph with these edges, of which there are some, until at most `coarsest_net` vertices are left,
  // or a net keeps more than the share `net_stall` of them. `block`: see Random_blocks. The nets
  // are the same whatever the executor.
  Net_hierarchy(Edge_source& edges, const Point_array& points, unsigned int seed,
                std::size_t block = Random_blocks::one_of_many, const Executor& executor = Alone())
    : names(1)
    , number_of_coarsest(points.size())
  {
    Split_mix random(seed);
    Lists<std::uint32_t> contracted_edges;
    Lists_view<std::uint32_t> lower = edges.edges();
    while (number_of_coarsest > coarsest_net) {
      const std::size_t level = names.size() - 1;
      const Vertex_points vertices(points, level == 0 ? nullptr : names[level].data());
      Net net = net_of(lower, random(), vertices, block);
      if (double(net.centers.size()) > net_stall * double(number_of_coarsest))
        break;
      clusters.push_back(members(net, executor));
      contracted_edges = contracted(lower, net.cluster_of, clusters.back(), executor);
      lower = contracted_edges;
      edges.give_up();
      number_of_coarsest = lower.size();
      for (std::uint32_t& c : net.centers)
        c = std::uint32_t(point(level, c));
      names.push_back(std::move(net.centers));
    }
  }

  std::size_t number_of_levels() const { return names.size(); }

  std::size_t point(std::size_t level, std::size_t v) const
  {
    return level == 0 ? v : names[level][v];
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_NET_HIERARCHY_H
