// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_NET_HIERARCHY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_NET_HIERARCHY_H

// Nets of a graph, each a maximal independent set of the one before, with the cluster of every net
// vertex: itself and the neighbours that chose it.
//
// Invariant: a level's vertices are numbered in the order in which the depth-first search of the
// level below met them, so that what is near in the graph is near in memory.
// Cost: every level is linear in its vertices and edges. On a surface of fixed genus the levels
// shrink by a constant factor (about 4) and their edges with them: linear altogether. On other
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
  for (const auto& st : edge_list) { // first[v + 1] runs from the begin to the end of v's list
    lists.items[lists.first[st.first + 1]++] = st.second;
    lists.items[lists.first[st.second + 1]++] = st.first;
  }
  lists.first.pop_back();
  return lists;
}

// A net and who belongs to whom.
template <class Index>
struct Net
{
  std::vector<Index> visited;    // all vertices in depth-first order
  std::vector<Index> cluster_of; // by vertex: the number of its cluster
  std::size_t number_of_clusters = 0;
};

// A maximal independent set, chosen greedily in depth-first order: a vertex joins the net unless a
// neighbour is in it already; then it joins the cluster of that neighbour. Clusters are numbered in
// the order in which their net vertices were met.
template <class Index>
class Net_of_graph
{
public:
  explicit Net_of_graph(const Lists<Index>& graph)
    : m_graph(graph)
    , m_state(graph.size(), UNSEEN)
  {
    m_net.visited.reserve(graph.size());
    m_net.cluster_of.resize(graph.size());
  }

  Net<Index> operator()()
  {
    for (std::size_t root = 0; root < m_graph.size(); ++root) {
      m_stack.push_back(Index(root));
      while (!m_stack.empty()) {
        const Index v = m_stack.back();
        m_stack.pop_back();
        if (m_state[v] == UNSEEN)
          visit(v);
      }
    }
    return std::move(m_net);
  }

private:
  enum State : unsigned char { UNSEEN, IN_NET, BESIDE_NET };

  void visit(Index v)
  {
    m_state[v] = IN_NET;
    m_net.visited.push_back(v);
    for (const Index *u = m_graph.begin(v), *end = m_graph.end(v); u != end; ++u) {
      if (m_state[*u] == UNSEEN) {
        m_stack.push_back(*u);
      } else if (m_state[*u] == IN_NET && *u != v) { // a loop does not count
        m_state[v] = BESIDE_NET;
        m_net.cluster_of[v] = m_net.cluster_of[*u];
      }
    }
    if (m_state[v] == IN_NET)
      m_net.cluster_of[v] = Index(m_net.number_of_clusters++);
  }

  const Lists<Index>& m_graph;
  std::vector<State> m_state;
  std::vector<Index> m_stack;
  Net<Index> m_net;
};

// The members of every cluster, its net vertex first: those who join it were met later.
template <class Index>
Lists<Index> members(const Net<Index>& net)
{
  Lists<Index> lists;
  lists.first.assign(net.number_of_clusters + 2, 0);
  for (const Index v : net.visited)
    ++lists.first[net.cluster_of[v] + 2];
  for (std::size_t c = 2; c < lists.first.size(); ++c)
    lists.first[c] += lists.first[c - 1];
  lists.items.resize(net.visited.size());
  for (const Index v : net.visited)
    lists.items[lists.first[net.cluster_of[v] + 1]++] = v;
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
      const Net<Index> net = Net_of_graph<Index>(graph)();
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
