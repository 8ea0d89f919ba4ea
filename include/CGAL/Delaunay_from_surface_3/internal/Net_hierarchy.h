// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_NET_HIERARCHY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_NET_HIERARCHY_H

// Nets of a graph, each a maximal independent set of the one before, with the cluster of every net
// vertex: itself and the neighbours that chose it.
//
// Invariant: a level's vertices are numbered in the order in which those of the level below are, so
// that a mesh that is coherent in memory gives levels that are. No search through the graph: where
// the mesh is not coherent it would miss the cache at every vertex.
// Cost: every level is linear in its vertices and edges. On a surface of fixed genus the levels
// shrink by a constant factor (4 to 5) and their edges with them: linear altogether. On other
// graphs a level may keep nearly all its vertices; such a level ends the hierarchy.

#include <CGAL/Delaunay_from_surface_3/internal/prefetch.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Lists of numbers, one after the other: that of i is items[first[i]], …, items[first[i+1] - 1].
template <class Index>
struct Lists
{
  std::vector<Index> first;
  std::vector<Index> items;

  std::size_t size() const { return first.size() - 1; }
  const Index* begin(std::size_t i) const { return items.data() + first[i]; }
  const Index* end(std::size_t i) const { return items.data() + first[i + 1]; }
};

// The neighbours of every vertex, by counting sort. Twice the number of edges must be an Index.
template <class Index, class Graph, class VertexIndexMap>
Lists<Index> neighbor_lists(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  std::vector<std::pair<Index, Index>> edge_list;
  edge_list.reserve(std::size_t(num_edges(graph)));
  Lists<Index> lists;
  lists.first.assign(n + 2, 0);
  const auto range = edges(graph);
  for (auto e = range.first; e != range.second; ++e) {
    const Index s = Index(get(index_map, source(*e, graph)));
    const Index t = Index(get(index_map, target(*e, graph)));
    edge_list.emplace_back(s, t);
    ++lists.first[s + 2], ++lists.first[t + 2];
  }
  for (std::size_t v = 2; v < lists.first.size(); ++v)
    lists.first[v] += lists.first[v - 1];
  lists.items.resize(2 * edge_list.size());
  // first[v + 1] runs from the begin to the end of v's list
  const auto next_of = [&lists](Index v) { return lists.items.data() + lists.first[v + 1]; };
  for (std::size_t k = 0; k < edge_list.size(); ++k) {
    const auto& ahead = edge_list[(std::min)(k + 16, edge_list.size() - 1)];
    prefetch(next_of(ahead.first));
    prefetch(next_of(ahead.second));
    const auto [s, t] = edge_list[k];
    lists.items[lists.first[s + 1]++] = t;
    lists.items[lists.first[t + 1]++] = s;
  }
  lists.first.pop_back();
  return lists;
}

// A net and who belongs to whom.
template <class Index>
struct Net
{
  std::vector<Index> cluster_of; // by vertex: the number of its cluster
  std::size_t number_of_clusters = 0;
};

// A maximal independent set, chosen greedily in the order of the numbers: a vertex joins the net
// unless a neighbour is in it already; then it joins the cluster of that neighbour. Clusters are
// numbered as their net vertices are. One pass over the lists, in the order in which they lie in
// memory; all that is looked up beyond them is a byte and a number of each neighbour.
template <class Index>
Net<Index> net_of(const Lists<Index>& graph)
{
  Net<Index> net;
  net.cluster_of.resize(graph.size());
  std::vector<char> is_in_net(graph.size(), false);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const Index* const end = graph.end(v);
    const Index* const center =
        std::find_if(graph.begin(v), end, [&](Index u) { return is_in_net[u] != 0; });
    is_in_net[v] = center == end;
    net.cluster_of[v] = center == end ? Index(net.number_of_clusters++) : net.cluster_of[*center];
  }
  return net;
}

// The members of every cluster in ascending order. Its net vertex is the first: those who join it
// come later.
template <class Index>
Lists<Index> members(const Net<Index>& net)
{
  Lists<Index> lists;
  lists.first.assign(net.number_of_clusters + 2, 0);
  for (const Index c : net.cluster_of)
    ++lists.first[c + 2];
  for (std::size_t c = 2; c < lists.first.size(); ++c)
    lists.first[c] += lists.first[c - 1];
  lists.items.resize(net.cluster_of.size());
  for (std::size_t v = 0; v < net.cluster_of.size(); ++v)
    lists.items[lists.first[net.cluster_of[v] + 1]++] = Index(v);
  lists.first.pop_back();
  return lists;
}

// The graph of the clusters: two are neighbours if members of theirs are. Every edge once.
template <class Index>
Lists<Index> contracted(const Lists<Index>& graph, const std::vector<Index>& cluster_of,
                        const Lists<Index>& clusters)
{
  Lists<Index> coarse;
  coarse.first.reserve(clusters.size() + 1);
  coarse.first.push_back(0);
  const Index none = Index(clusters.size());
  std::vector<Index> last_met_by(clusters.size(), none);
  const std::size_t last = clusters.items.size() - 1;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    last_met_by[c] = Index(c);
    for (std::size_t k = clusters.first[c]; k < clusters.first[c + 1]; ++k) {
      prefetch(&graph.first[clusters.items[(std::min)(k + 16, last)]]);
      prefetch(graph.begin(clusters.items[(std::min)(k + 8, last)]));
      const Index v = clusters.items[k];
      for (const Index *u = graph.begin(v), *end = graph.end(v); u != end; ++u) {
        const Index d = cluster_of[*u];
        if (last_met_by[d] == Index(c))
          continue;
        last_met_by[d] = Index(c);
        coarse.items.push_back(d);
      }
    }
    coarse.first.push_back(Index(coarse.items.size()));
  }
  return coarse;
}

// The levels, finest first. clusters[l] lists the clusters of the vertices of level l; they are the
// vertices of level l + 1. points[l] names the vertex of the graph that a vertex of level l is; at
// level 0 every vertex is itself, and nothing is stored.
template <class Index>
struct Net_hierarchy
{
  std::vector<Lists<Index>> clusters;
  std::vector<std::vector<Index>> points;
  std::size_t number_of_coarsest;

  // Nets of `graph` until at most `enough` vertices are left, or a net keeps more than the share
  // `stall` of them.
  Net_hierarchy(Lists<Index> graph, std::size_t enough, double stall)
    : points(1)
    , number_of_coarsest(graph.size())
  {
    while (number_of_coarsest > enough) {
      const Net<Index> net = net_of(graph);
      if (double(net.number_of_clusters) > stall * double(number_of_coarsest))
        break;
      clusters.push_back(members(net));
      points.push_back(net_points());
      graph = contracted(graph, net.cluster_of, clusters.back());
      number_of_coarsest = graph.size();
    }
  }

  std::size_t number_of_levels() const { return points.size(); }

  std::size_t point(std::size_t level, std::size_t v) const
  {
    return level == 0 ? v : points[level][v];
  }

private:
  // The points of the clusters made last.
  std::vector<Index> net_points() const
  {
    const Lists<Index>& finest = clusters.back();
    std::vector<Index> result(finest.size());
    for (std::size_t c = 0; c < result.size(); ++c)
      result[c] = Index(point(points.size() - 1, *finest.begin(c)));
    return result;
  }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_NET_HIERARCHY_H
