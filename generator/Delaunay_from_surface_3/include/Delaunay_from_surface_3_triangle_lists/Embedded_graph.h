// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangle list as a Boost graph with cyclic orders; each list starts anywhere and runs in either
// direction.

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_EMBEDDED_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_EMBEDDED_GRAPH_H

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <CGAL/surface_of.h>

#include <boost/graph/adjacency_list.hpp>

#include <map>
#include <utility>
#include <vector>

namespace triangle_lists {

struct Embedded_graph
{
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_index_t, int>>;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;

  Graph graph;
  std::vector<std::vector<Edge>> lists;
  std::vector<char> is_boundary; // by edge index

  auto embedding() const
  {
    return boost::make_iterator_property_map(lists.begin(), get(boost::vertex_index, graph));
  }
  auto boundary_map() const
  {
    return boost::make_iterator_property_map(is_boundary.begin(), get(boost::edge_index, graph));
  }
  auto index_map() const { return get(boost::vertex_index, graph); }
  auto surface() const { return CGAL::surface_of(graph, embedding(), index_map(), boundary_map()); }
};

template <class Random>
Embedded_graph embed(const Triangle_list& s, Random& random)
{
  Embedded_graph result;
  result.graph = Embedded_graph::Graph(std::size_t(s.n));
  std::map<std::pair<int, int>, std::pair<Embedded_graph::Edge, int>>
      edge; // and its number of triangles
  std::vector<std::multimap<int, int>> link(s.n);
  for (const Triangle& t : s.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      link[a].emplace(b, c);
      link[a].emplace(c, b);
      if (!edge.count(ends(a, b)))
        edge[ends(a, b)] = {add_edge(a, b, int(edge.size()), result.graph).first, 0};
      ++edge[ends(a, b)].second;
    }
  result.is_boundary.assign(edge.size(), 0);
  for (const auto& e : edge)
    result.is_boundary[get(boost::edge_index, result.graph, e.second.first)] = e.second.second == 1;
  result.lists.resize(s.n);
  for (int v = 0; v < s.n; ++v) {
    if (link[v].empty())
      continue;
    std::vector<int> walk;
    for (const auto& l : link[v])
      if (link[v].count(l.first) == 1)
        walk.assign(1, l.first);
    const bool is_open = !walk.empty();
    if (!is_open)
      walk.assign(1, link[v].begin()->first);
    for (int previous = -1;;) {
      const auto range = link[v].equal_range(walk.back());
      int next = -1;
      for (auto l = range.first; l != range.second; ++l)
        if (l->second != previous && next < 0)
          next = l->second;
      if (next < 0 || next == walk.front())
        break;
      previous = walk.back();
      walk.push_back(next);
    }
    if (!is_open)
      std::rotate(walk.begin(),
                  walk.begin() + std::uniform_int_distribution<std::ptrdiff_t>(
                                     0, std::ptrdiff_t(walk.size()) - 1)(random),
                  walk.end());
    if (std::uniform_int_distribution<int>(0, 1)(random))
      std::reverse(walk.begin(), walk.end());
    for (int u : walk)
      result.lists[v].push_back(edge[ends(u, v)].first);
  }
  return result;
}

} // namespace triangle_lists

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_EMBEDDED_GRAPH_H
