// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_PLAN_NET_HIERARCHY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_PLAN_NET_HIERARCHY_H

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

#include <CGAL/Delaunay_from_surface_3/internal/plan/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/core/order/random_net.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// An edge of a graph whose vertices are numbered: the larger number, and the smaller.
template <class Index>
struct Numbered_edge
{
  Index upper, lower;

  Numbered_edge(Index s, Index t)
    : upper((std::max)(s, t))
    , lower((std::min)(s, t))
  {
  }
};

// Edges as items: the list of the upper end gets the lower one.
template <class Index>
class Edges_as_items
{
public:
  Edges_as_items(const Large_vector<Numbered_edge<Index>>& edges)
    : m_edges(&edges)
  {
  }

  std::size_t size() const { return m_edges->size(); }
  std::size_t list(std::size_t k) const { return (*m_edges)[k].upper; }
  Index item(std::size_t k) const { return (*m_edges)[k].lower; }

private:
  const Large_vector<Numbered_edge<Index>>* m_edges;
};

// The neighbours of each of n vertices that have smaller numbers; of edges in blocks.
template <class Index>
Lists<Index> lower_neighbors(const std::vector<Large_vector<Numbered_edge<Index>>>& edges,
                             std::size_t n, const Executor& executor = Alone())
{
  return in_lists<Index>(n, std::vector<Edges_as_items<Index>>(edges.begin(), edges.end()),
                         executor);
}

// The same for the n vertices of a graph. Its number of edges must be an Index.
template <class Index, class Graph, class VertexIndexMap>
Lists<Index> lower_neighbors(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  std::vector<Large_vector<Numbered_edge<Index>>> numbered(1);
  numbered[0].reserve(std::size_t(num_edges(graph)));
  const auto range = edges(graph);
  for (auto e = range.first; e != range.second; ++e)
    numbered[0].emplace_back(Index(get(index_map, source(*e, graph))),
                             Index(get(index_map, target(*e, graph))));
  return lower_neighbors(numbered, n);
}

// The same for a graph that has them.
template <class Index>
Lists<Index> lower_neighbors(const Lower_neighbor_graph& graph, Identity_index_map, std::size_t)
{
  return graph.lists();
}

template <class Index, class FaceRange>
Lists<Index> lower_neighbors(const Graph_of_faces<FaceRange>& graph, Identity_index_map,
                             std::size_t)
{
  return graph.lists();
}

// The members of every cluster, its net vertex first, the others in ascending order.
template <class Index>
Lists<Index> members(const Net<Index>& net, const Executor& executor)
{
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
template <class Index>
void append_contracted(const Lists<Index>& lower, const Large_vector<Index>& cluster_of,
                       const Lists<Index>& clusters, std::size_t first, std::size_t last,
                       Large_vector<Numbered_edge<Index>>& edges)
{
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

template <class Index>
Lists<Index> contracted(const Lists<Index>& lower, const Large_vector<Index>& cluster_of,
                        const Lists<Index>& clusters, const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, clusters.size(), 4096);
  std::vector<Large_vector<Numbered_edge<Index>>> edges(blocks);
  for_each_block(executor, clusters.size(), blocks,
                 [&](std::size_t first, std::size_t last, std::size_t b) {
                   edges[b].reserve(4 * (last - first)); // on a surface
                   append_contracted(lower, cluster_of, clusters, first, last, edges[b]);
                 });
  return lower_neighbors(edges, clusters.size(), executor);
}

// The levels, finest first. clusters[l] lists the clusters of the vertices of level l; they are the
// vertices of level l + 1. points[l] names the vertex of the graph that a vertex of level l is; at
// level 0 every vertex is itself, and nothing is stored.
template <class Index>
struct Net_hierarchy
{
  std::vector<Lists<Index>> clusters;
  std::vector<Large_vector<Index>> points;
  std::size_t number_of_coarsest;

  // Nets of the graph with these lower neighbours until at most `enough` vertices are left, or a
  // net keeps more than the share `stall` of them. `distance(i, j)` is one of vertices of the
  // graph. `block`: see Random_blocks. The nets are the same whatever the executor.
  template <class Distance>
  Net_hierarchy(Lists<Index> lower, std::size_t enough, double stall, unsigned int seed,
                const Distance& distance, std::size_t block = Random_blocks::one_of_many,
                const Executor& executor = Alone())
    : points(1)
    , number_of_coarsest(lower.size())
  {
    Split_mix random(seed);
    while (number_of_coarsest > enough) {
      const std::size_t level = points.size() - 1;
      const Net<Index> net = net_of(
          lower, random(),
          [&](std::size_t v, std::size_t u) { return distance(point(level, v), point(level, u)); },
          block);
      if (double(net.centers.size()) > stall * double(number_of_coarsest))
        break;
      clusters.push_back(members(net, executor));
      points.push_back(net.centers);
      for (Index& c : points.back())
        c = Index(point(level, c));
      lower = contracted(lower, net.cluster_of, clusters.back(), executor);
      number_of_coarsest = lower.size();
    }
  }

  std::size_t number_of_levels() const { return points.size(); }

  std::size_t point(std::size_t level, std::size_t v) const
  {
    return level == 0 ? v : points[level][v];
  }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_PLAN_NET_HIERARCHY_H
