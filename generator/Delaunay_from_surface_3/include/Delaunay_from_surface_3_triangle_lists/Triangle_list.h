// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_TRIANGLE_LIST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_TRIANGLE_LIST_H

#include <CGAL/surface_of.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Combinatorial surfaces: triangle lists without geometry, built by surgery.
namespace triangle_lists {

using Triangle = std::array<int, 3>;

// Triangles are unordered: non-orientable surfaces are written the same way.
struct Triangle_list
{
  int n = 0;
  std::vector<Triangle> triangles;
};

inline std::pair<int, int> ends(int a, int b)
{
  return {std::min(a, b), std::max(a, b)};
}

inline Triangle_list tetrahedron()
{
  return {4, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
}

// The 6-vertex projective plane: the icosahedron with opposite points identified.
inline Triangle_list projective_plane()
{
  return {6,
          {{0, 1, 2},
           {0, 2, 3},
           {0, 3, 4},
           {0, 4, 5},
           {0, 5, 1},
           {1, 2, 4},
           {2, 3, 5},
           {3, 4, 1},
           {4, 5, 2},
           {5, 1, 3}}};
}

inline Triangle_list grid_torus(int rows, int columns)
{
  Triangle_list torus{rows * columns, {}};
  const auto at = [&](int r, int c) { return (r % rows) * columns + c % columns; };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      torus.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
      torus.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
    }
  return torus;
}

// A square grid; glued left to right with a twist it is a Möbius band.
inline Triangle_list grid_band(int rows, int columns, bool is_twisted)
{
  Triangle_list band{rows * columns, {}};
  const auto at = [&](int r, int c) {
    return c < columns ? r * columns + c : (is_twisted ? rows - 1 - r : r) * columns;
  };
  for (int r = 0; r + 1 < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      band.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
      band.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
    }
  return band;
}

inline Triangle_list nested_triangles(int levels)
{
  Triangle_list sphere{3 * levels, {}};
  sphere.triangles.push_back({0, 1, 2});
  for (int l = 0; l + 1 < levels; ++l)
    for (int c = 0; c < 3; ++c) {
      const int a = 3 * l + c, b = 3 * l + (c + 1) % 3;
      sphere.triangles.push_back({a, b, b + 3});
      sphere.triangles.push_back({a, b + 3, a + 3});
    }
  sphere.triangles.push_back({3 * levels - 3, 3 * levels - 2, 3 * levels - 1});
  return sphere;
}

inline Triangle_list double_wheel(int rim)
{
  Triangle_list sphere{rim + 2, {}};
  for (int c = 0; c < rim; ++c) {
    sphere.triangles.push_back({c, (c + 1) % rim, rim});
    sphere.triangles.push_back({c, (c + 1) % rim, rim + 1});
  }
  return sphere;
}

// Triangles around vertex 0.
inline Triangle_list fan(int triangles)
{
  Triangle_list disc{triangles + 2, {}};
  for (int c = 1; c <= triangles; ++c)
    disc.triangles.push_back({0, c, c + 1});
  return disc;
}

// A polygon cut into triangles by random chords.
template <class Random>
Triangle_list polygon_with_chords(int corners, Random& random)
{
  Triangle_list disc{corners, {}};
  std::vector<std::pair<int, int>> ranges{{0, corners - 1}};
  while (!ranges.empty()) {
    const auto [a, b] = ranges.back();
    ranges.pop_back();
    if (b - a < 2)
      continue;
    const int c = std::uniform_int_distribution<int>(a + 1, b - 1)(random);
    disc.triangles.push_back({a, c, b});
    ranges.emplace_back(a, c);
    ranges.emplace_back(c, b);
  }
  return disc;
}

// Removes a triangle of each and glues along the hole: simple again if both are.
template <class Random>
Triangle_list connected_sum(Triangle_list a, Triangle_list b, Random& random)
{
  const auto take = [&](Triangle_list& s) {
    const std::size_t i =
        std::uniform_int_distribution<std::size_t>(0, s.triangles.size() - 1)(random);
    const Triangle t = s.triangles[i];
    s.triangles.erase(s.triangles.begin() + std::ptrdiff_t(i));
    return t;
  };
  const Triangle ta = take(a), tb = take(b);
  std::vector<int> name(std::size_t(b.n), -1);
  for (int i = 0; i < 3; ++i)
    name[std::size_t(tb[i])] = ta[i];
  for (int& v : name)
    if (v < 0)
      v = a.n++;
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({name[t[0]], name[t[1]], name[t[2]]});
  return a;
}

inline Triangle_list disjoint_union(Triangle_list a, const Triangle_list& b)
{
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + a.n, t[1] + a.n, t[2] + a.n});
  a.n += b.n;
  return a;
}

// Puts a vertex into each of `count` random triangles, one after the other ("stacked").
template <class Random>
void insert_vertices(Triangle_list& s, int count, Random& random)
{
  for (; count > 0; --count) {
    const std::size_t i =
        std::uniform_int_distribution<std::size_t>(0, s.triangles.size() - 1)(random);
    const Triangle t = s.triangles[i];
    s.triangles[i] = {t[0], t[1], s.n};
    s.triangles.push_back({t[1], t[2], s.n});
    s.triangles.push_back({t[2], t[0], s.n++});
  }
}

// Tries `count` random edge flips; one that would double an edge is left out.
template <class Random>
void flip_edges(Triangle_list& s, int count, Random& random)
{
  std::map<std::pair<int, int>, std::vector<std::size_t>> at_edge;
  const auto for_edges = [&](std::size_t i, const auto& function) {
    for (int k = 0; k < 3; ++k)
      function(ends(s.triangles[i][k], s.triangles[i][(k + 1) % 3]));
  };
  const auto link = [&](std::size_t i) { for_edges(i, [&](auto e) { at_edge[e].push_back(i); }); };
  const auto unlink = [&](std::size_t i) {
    for_edges(i, [&](auto e) {
      auto& list = at_edge[e];
      list.erase(std::find(list.begin(), list.end(), i));
      if (list.empty())
        at_edge.erase(e);
    });
  };
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    link(i);
  for (; count > 0; --count) {
    const std::size_t i =
        std::uniform_int_distribution<std::size_t>(0, s.triangles.size() - 1)(random);
    const int k = std::uniform_int_distribution<int>(0, 2)(random);
    const int a = s.triangles[i][k], b = s.triangles[i][(k + 1) % 3],
              c = s.triangles[i][(k + 2) % 3];
    const auto& pair = at_edge[ends(a, b)];
    if (pair.size() != 2)
      continue;
    const std::size_t j = pair[0] == i ? pair[1] : pair[0];
    const int d = s.triangles[j][0] + s.triangles[j][1] + s.triangles[j][2] - a - b;
    if (c == d || at_edge.count(ends(c, d)))
      continue;
    unlink(i);
    unlink(j);
    s.triangles[i] = {a, c, d};
    s.triangles[j] = {b, c, d};
    link(i);
    link(j);
  }
}

// Removes the star of a vertex, or one triangle, away from all boundary; returns whether there was
// room.
template <class Random>
bool puncture(Triangle_list& s, Random& random)
{
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : s.triangles)
    for (int k = 0; k < 3; ++k)
      ++uses[ends(t[k], t[(k + 1) % 3])];
  std::vector<bool> on_boundary(std::size_t(s.n), false);
  for (const auto& use : uses)
    if (use.second == 1)
      on_boundary[use.first.first] = on_boundary[use.first.second] = true;
  const bool whole_star = std::uniform_int_distribution<int>(0, 1)(random) == 0;
  std::vector<Triangle> order = s.triangles;
  std::shuffle(order.begin(), order.end(), random);
  for (const Triangle& seed : order) {
    const auto is_hole = [&](const Triangle& t) {
      return whole_star ? t[0] == seed[0] || t[1] == seed[0] || t[2] == seed[0] : t == seed;
    };
    const bool has_room = std::all_of(order.begin(), order.end(), [&](const Triangle& t) {
      return !is_hole(t) || (!on_boundary[t[0]] && !on_boundary[t[1]] && !on_boundary[t[2]]);
    });
    if (!has_room)
      continue;
    // What is left must still be a surface: every vertex of the hole keeps a triangle.
    std::vector<Triangle> rest;
    std::copy_if(order.begin(), order.end(), std::back_inserter(rest),
                 [&](const Triangle& t) { return !is_hole(t); });
    std::vector<int> kept(std::size_t(s.n), 0);
    for (const Triangle& t : rest)
      for (int v : t)
        ++kept[v];
    const bool is_surface = std::all_of(order.begin(), order.end(), [&](const Triangle& t) {
      return !is_hole(t) || std::all_of(t.begin(), t.end(), [&](int v) {
        return kept[v] > 0 || (whole_star && v == seed[0]);
      });
    });
    if (!is_surface)
      continue;
    s.triangles = rest;
    if (whole_star) { // the last vertex takes the name of the one that is gone
      for (Triangle& t : s.triangles)
        for (int& v : t)
          v = v == s.n - 1 ? seed[0] : v;
      --s.n;
    }
    return true;
  }
  return false;
}

template <class Random>
void shuffle_names(Triangle_list& s, Random& random)
{
  std::vector<int> name(std::size_t(s.n), 0);
  std::iota(name.begin(), name.end(), 0);
  std::shuffle(name.begin(), name.end(), random);
  for (Triangle& t : s.triangles)
    for (int& v : t)
      v = name[v];
  std::shuffle(s.triangles.begin(), s.triangles.end(), random);
}

// A triangle list as a Boost graph with cyclic orders; each list starts anywhere and runs in either
// direction.

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_TRIANGLE_LIST_H
