// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H

// Finds the components of a surface with their genus, boundaries and orientability; and certifies a
// spanning subgraph by means that share nothing with its construction: union-find and counting.

#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

describes the topology of a connected component of a surface. Up to homeomorphism, it is determined
by the number of boundary loops, the Euler characteristic, and orientability.
*/
struct Surface_component_topology
{
  std::size_t number_of_vertices = 0;       ///< of this component
  std::size_t number_of_edges = 0;          ///< boundary edges included
  std::size_t number_of_triangles = 0;      ///< of this component
  std::size_t number_of_boundary_loops = 0; ///< b
  bool is_orientable = true;                ///< whether its triangles can be oriented consistently

  /// a k ≥ 3 such that the graph is k-connected: fewer than k vertices never separate it. With
  /// boundary this is meant after closing each loop by a vertex that is joined to all of its
  /// vertices. `surface_topology()` finds 4 if the component is closed, has at least five vertices,
  /// and all its cycles of three edges are triangles; 5 if, besides, each cycle of four edges
  /// surrounds two triangles; otherwise 3. If you know more, set it:
  /// `near_minimum_tree_degree_bound()` uses it, and takes less than 3 for 3.
  std::size_t connectivity = 3;

  /// returns χ: vertices − edges + triangles.
  std::ptrdiff_t euler_characteristic() const
  {
    return std::ptrdiff_t(number_of_vertices) - std::ptrdiff_t(number_of_edges) +
           std::ptrdiff_t(number_of_triangles);
  }

  /// returns h = 2 − χ − b: twice the genus if the component is orientable, otherwise the
  /// non-orientable genus.
  std::size_t euler_genus() const
  {
    return std::size_t(2 - euler_characteristic() - std::ptrdiff_t(number_of_boundary_loops));
  }

  /// returns the genus: the number of handles, or of cross-caps if the component is not orientable.
  std::size_t genus() const { return is_orientable ? euler_genus() / 2 : euler_genus(); }

  /// returns the bound on degrees in the subgraph of `bounded_degree_spanning_subgraph()`.
  std::size_t subgraph_degree_bound() const
  {
    const std::size_t h = euler_genus(), b = number_of_boundary_loops;
    if (h == 0 && b <= 1)
      return 3;
    return b == 0 ? 4 * h : 4 * h + 2 * b + 1;
  }

  /// returns the bound on degrees in the tree of `bounded_degree_spanning_tree()`.
  std::size_t tree_degree_bound() const
  {
    const std::size_t h = euler_genus(), b = number_of_boundary_loops;
    if (h == 1 && b == 0)
      return 4; // the projective plane
    return (std::max)(std::size_t(3), 3 * h + 2 * b);
  }

  /// returns the bound on degrees in the tree of `near_minimum_degree_spanning_tree()`. On a sphere
  /// or a disc this is 3. Elsewhere it is the largest of 3 and 3 + ⌊(c(x) − 3) / x⌋ over all x.
  /// There c(x) bounds the number of components that are left after removing x vertices. With
  /// `connectivity` k it is the smaller of ⌊2 (x − χ) / (k − 2)⌋ and ⌊x (x − 1) / k⌋, or
  /// ⌊x (x + 1) / k⌋ with boundary.
  std::size_t near_minimum_tree_degree_bound() const
  {
    if (euler_genus() == 0 && number_of_boundary_loops <= 1)
      return 3;
    const std::ptrdiff_t chi = euler_characteristic(), side = number_of_boundary_loops > 0 ? 1 : -1;
    const std::ptrdiff_t k = std::ptrdiff_t((std::max)(connectivity, std::size_t(3)));
    std::ptrdiff_t bound = 3, by_edges = 0, by_euler = 1;
    // Once the second is the smaller one, the quotient falls, or is at most 2 / (k − 2).
    for (std::ptrdiff_t x = 2; by_edges < by_euler; ++x) {
      by_edges = x * (x + side) / k;
      by_euler = 2 * (x - chi) / (k - 2);
      const std::ptrdiff_t c = (std::min)(by_edges, by_euler);
      bound = (std::max)(bound, c < 3 ? 0 : 3 + (c - 3) / x);
    }
    return std::size_t(bound);
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is the result of `surface_topology()`.
*/
struct Surface_topology
{
  /// the components that have edges, in the order of their smallest vertex index.
  std::vector<Surface_component_topology> components;

  /// for every vertex index the position of its component in `components`, or `components.size()`
  /// if the vertex is isolated.
  std::vector<std::size_t> component_of_vertex;

  std::size_t number_of_isolated_vertices = 0; ///< vertices without edges, in no component

  /// returns the sum over `components`.
  std::ptrdiff_t euler_characteristic() const
  {
    std::ptrdiff_t sum = 0;
    for (const Surface_component_topology& component : components)
      sum += component.euler_characteristic();
    return sum;
  }

  /// returns the sum over `components`.
  std::size_t number_of_boundary_loops() const
  {
    std::size_t sum = 0;
    for (const Surface_component_topology& component : components)
      sum += component.number_of_boundary_loops;
    return sum;
  }

  /// returns whether every component is orientable.
  bool is_orientable() const
  {
    return std::all_of(components.begin(), components.end(),
                       [](const Surface_component_topology& c) { return c.is_orientable; });
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is the result of `certify_spanning_subgraph()` for a set of edges.
*/
struct Spanning_subgraph_certificate
{
  std::size_t number_of_edges = 0;               ///< repeated ones included
  std::size_t number_of_repeated_edges = 0;      ///< edges that occurred before
  std::size_t number_of_graph_components = 0;    ///< isolated vertices included
  std::size_t number_of_subgraph_components = 0; ///< isolated vertices included
  std::size_t number_of_independent_cycles = 0; ///< edges − vertices + components of the subgraph
  std::size_t maximum_degree = 0;               ///< among all vertices
  std::size_t vertex_of_maximum_degree = 0;     ///< its index
  std::vector<std::size_t> number_of_vertices_of_degree; ///< a histogram of the degrees
  std::size_t largest_degree_bound = 0;    ///< the largest of the components' own bounds
  bool respects_degree_bounds = true;      ///< no degree exceeds the bound of its own component
  bool respects_tree_degree_bounds = true; ///< the same with the bounds for trees
  /// the same with the bounds for trees of nearly minimum degree
  bool respects_near_minimum_tree_degree_bounds = true;

  /// returns whether the vertices of every component of the surface are connected by the edges.
  bool is_spanning() const { return number_of_subgraph_components == number_of_graph_components; }

  /// returns whether the edges are a spanning tree of every component.
  bool is_spanning_forest() const { return is_spanning() && number_of_independent_cycles == 0; }

  /// returns whether everything holds that `bounded_degree_spanning_subgraph()` guarantees.
  bool is_valid_subgraph() const
  {
    return is_spanning() && number_of_repeated_edges == 0 && respects_degree_bounds;
  }

  /// returns whether everything holds that `bounded_degree_spanning_tree()` guarantees.
  bool is_valid_tree() const
  {
    return is_spanning_forest() && number_of_repeated_edges == 0 && respects_tree_degree_bounds;
  }

  /// returns whether everything holds that `near_minimum_degree_spanning_tree()` guarantees, except
  /// what its witnesses prove.
  bool is_valid_near_minimum_tree() const
  {
    return is_valid_tree() && respects_near_minimum_tree_degree_bounds;
  }
};

namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Links the two darts of every edge. The subgraph itself never needs this; to tell whether a
// surface is orientable, and to walk over the triangles in any order, it is the simplest way.
//
// Result: mate[dart] is the other dart of the same edge, for darts numbered as in the rotation
// system.
// Cost: O(n), two passes; 24 bytes per vertex and twice that again while it runs.

template <class Index>
std::vector<Index> pair_darts(const Rotation_system<Index>& surface)
{
  const Index n = surface.number_of_vertices();
  struct Incoming
  {
    Index source;
    Index dart;
  };
  // The incoming darts are grouped by target, as the lists are by source.
  std::vector<Incoming> incoming(surface.number_of_darts());
  std::vector<Index> next(surface.first);
  for (Index v = 0; v < n; ++v)
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      incoming[next[surface.neighbor[dart]]++] = {v, dart};
  std::vector<Index> mate(surface.number_of_darts());
  std::vector<Index>& dart_to = next; // for each u the dart from v to u, for the current v
  for (Index v = 0; v < n; ++v) {
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      dart_to[surface.neighbor[dart]] = dart;
    for (Index i = surface.first[v]; i < surface.first[v + 1]; ++i)
      mate[incoming[i].dart] = dart_to[incoming[i].source];
  }
  return mate;
}

// Finds the topology of every component of a rotation system: Euler characteristic, boundary loops,
// orientability, and whether a count of short cycles proves more than 3-connectivity.
//
// Vertices are visited from neighbour to neighbour. Each gets a turn: whether its list runs against
// the list of the component's first vertex. Where v's list goes from w to x, w's list goes from x
// to v if the two run alike, otherwise from v to x; an edge at which the turns do not fit shows
// that the surface is not orientable.
//
// Each triangle of a closed surface is a cycle of three edges, and each edge lies inside one of
// four, around its two triangles: all of them different if there are five vertices or more. So if
// there are no more cycles than that, these are all. The cycles are counted as by Chiba, Nishizeki
// 1985: each at its highest vertex v, in the order by degree.
// Cost: O(n), and for each edge the smaller degree of its ends: O(n) again for bounded genus. 32
// bytes per vertex besides the lists, for the pairs of darts and the paths.

template <class Index>
class Find_topology
{
public:
  explicit Find_topology(const Rotation_system<Index>& surface)
    : m_surface(surface)
    , m_mate(pair_darts(surface))
    , m_is_seen(surface.number_of_vertices(), false)
    , m_is_turned(surface.number_of_vertices(), false)
    , m_is_on_loop(surface.number_of_vertices(), false)
  {
  }

  Surface_topology operator()()
  {
    const Index n = m_surface.number_of_vertices();
    m_topology.component_of_vertex.assign(n, 0);
    for (Index v = 0; v < n; ++v) {
      if (m_surface.degree(v) == 0)
        ++m_topology.number_of_isolated_vertices;
      else if (!m_is_seen[v])
        visit_component(v);
    }
    for (Index v = 0; v < n; ++v)
      if (m_surface.degree(v) == 0)
        m_topology.component_of_vertex[v] = m_topology.components.size();
    find_connectivity();
    return std::move(m_topology);
  }

private:
  void visit_component(Index root)
  {
    Surface_component_topology component;
    Euler_count count;
    m_is_seen[root] = true;
    m_stack.assign(1, root);
    while (!m_stack.empty()) {
      const Index v = m_stack.back();
      m_stack.pop_back();
      count.add(m_surface, v);
      m_topology.component_of_vertex[v] = m_topology.components.size();
      if (m_surface.on_boundary[v] && !m_is_on_loop[v]) {
        ++component.number_of_boundary_loops;
        walk_loop(v);
      }
      if (!visit_neighbors(v))
        component.is_orientable = false;
    }
    component.number_of_vertices = count.vertices;
    component.number_of_edges = count.darts / 2;
    component.number_of_triangles = count.corners / 3;
    m_topology.components.push_back(component);
  }

  // Returns whether all turns at v are consistent.
  bool visit_neighbors(Index v)
  {
    bool fits = true;
    const Star<Index> star = m_surface.star(v);
    for (Index i = 0; i < star.size(); ++i) {
      const Index w = star[i];
      const bool turn = m_is_turned[v] != lists_run_against(v, i);
      if (!m_is_seen[w]) {
        m_is_seen[w] = true;
        m_is_turned[w] = turn;
        m_stack.push_back(w);
      } else if (m_is_turned[w] != turn)
        fits = false;
    }
    return fits;
  }

  // Returns whether the lists of v and its i-th neighbour run against each other, by one triangle.
  bool lists_run_against(Index v, Index i) const
  {
    const Star<Index> star = m_surface.star(v);
    const Index w = star[i];
    const bool is_last = m_surface.on_boundary[v] && i + 1 == star.size();
    const Index third = is_last ? star[i - 1] : star[i + 1 < star.size() ? i + 1 : 0];
    const Star<Index> other = m_surface.star(w);
    const Index j = m_mate[m_surface.first[v] + i] - m_surface.first[w];
    const bool is_other_last = m_surface.on_boundary[w] && j + 1 == other.size();
    const bool third_follows = !is_other_last && other[j + 1 < other.size() ? j + 1 : 0] == third;
    if (star.size() == 2 && !m_surface.on_boundary[v])
      return false; // the sphere of two triangles
    return third_follows != is_last;
  }

  void walk_loop(Index start)
  {
    for (Index v = start; !m_is_on_loop[v];) {
      m_is_on_loop[v] = true;
      const Star<Index> star = m_surface.star(v);
      v = m_is_on_loop[star[0]] ? star[star.size() - 1] : star[0];
    }
  }

  void find_connectivity()
  {
    std::vector<Short_cycles> cycles(m_topology.components.size());
    std::vector<Index> paths(m_surface.number_of_vertices(), 0);
    const auto is_counted = [](const Surface_component_topology& component) {
      return component.number_of_boundary_loops == 0 && component.number_of_vertices >= 5;
    };
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v) {
      const std::size_t i = m_topology.component_of_vertex[v];
      if (i < cycles.size() && is_counted(m_topology.components[i]))
        count_cycles_below(v, paths, cycles[i]);
    }
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      Surface_component_topology& component = m_topology.components[i];
      if (is_counted(component) && cycles[i].of_three_twice == 2 * component.number_of_triangles)
        component.connectivity = cycles[i].of_four == component.number_of_edges ? 5 : 4;
    }
  }

  struct Short_cycles
  {
    std::size_t of_three_twice = 0, of_four = 0;
  };

  // Counts the cycles whose highest vertex is v. `paths` counts the paths of two edges from v to
  // each vertex; it is 0 before and after.
  void count_cycles_below(Index v, std::vector<Index>& paths, Short_cycles& cycles) const
  {
    const auto is_below = [&, degree = m_surface.degree(v)](Index u) {
      const Index d = m_surface.degree(u);
      return d < degree || (d == degree && u < v);
    };
    for (const Index u : m_surface.star(v))
      if (is_below(u))
        for (const Index w : m_surface.star(u))
          if (is_below(w))
            cycles.of_four += paths[w]++;
    for (const Index u : m_surface.star(v))
      if (is_below(u))
        cycles.of_three_twice += paths[u];
    for (const Index u : m_surface.star(v))
      if (is_below(u))
        for (const Index w : m_surface.star(u))
          paths[w] = 0;
  }

  const Rotation_system<Index>& m_surface;
  std::vector<Index> m_mate;
  std::vector<bool> m_is_seen;
  std::vector<bool> m_is_turned;
  std::vector<bool> m_is_on_loop;
  std::vector<Index> m_stack;
  Surface_topology m_topology;
};

// Holds the bounds of one component. Each is computed once: the last takes O(sqrt(g)) for genus g.
struct Degree_bounds
{
  explicit Degree_bounds(const Surface_component_topology& component)
    : subgraph(component.subgraph_degree_bound())
    , tree(component.tree_degree_bound())
    , near_minimum_tree(component.near_minimum_tree_degree_bound())
  {
  }

  std::size_t subgraph, tree, near_minimum_tree;
};

inline void certify_degrees(const std::vector<std::size_t>& degree,
                            const Surface_topology& topology, Spanning_subgraph_certificate& result)
{
  const std::vector<Degree_bounds> bounds(topology.components.begin(), topology.components.end());
  for (const Degree_bounds& of_component : bounds)
    result.largest_degree_bound = (std::max)(result.largest_degree_bound, of_component.subgraph);
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] >= result.number_of_vertices_of_degree.size())
      result.number_of_vertices_of_degree.resize(degree[v] + 1, 0);
    ++result.number_of_vertices_of_degree[degree[v]];
    if (degree[v] > result.maximum_degree) {
      result.maximum_degree = degree[v];
      result.vertex_of_maximum_degree = v;
    }
    const std::size_t c = topology.component_of_vertex[v];
    if (c == bounds.size())
      continue;
    if (degree[v] > bounds[c].subgraph)
      result.respects_degree_bounds = false;
    if (degree[v] > bounds[c].tree)
      result.respects_tree_degree_bounds = false;
    if (degree[v] > bounds[c].near_minimum_tree)
      result.respects_near_minimum_tree_degree_bounds = false;
  }
}

template <class Index>
bool is_edge(const Rotation_system<Index>& surface, std::size_t v, std::size_t w)
{
  const std::size_t n = surface.number_of_vertices();
  if (v >= n || w >= n)
    return false;
  if (surface.degree(Index(w)) < surface.degree(Index(v)))
    std::swap(v, w);
  const Star<Index> star = surface.star(Index(v));
  return std::find(star.begin(), star.end(), Index(w)) != star.end();
}

template <class Reader, class Index, class EdgeRange>
Spanning_subgraph_certificate certify_edges(const Reader& reader,
                                            const Rotation_system<Index>& surface,
                                            const EdgeRange& subgraph_edges)
{
  const Surface_topology topology = Find_topology<Index>(surface)();
  const std::size_t n = surface.number_of_vertices();
  Spanning_subgraph_certificate result;
  Disjoint_sets<std::size_t> components(n);
  result.number_of_subgraph_components = n;
  std::vector<std::size_t> degree(n, 0);
  std::vector<std::pair<std::size_t, std::size_t>> sorted;
  for (const auto& e : subgraph_edges) {
    const auto [v, w] = reader.ends(e);
    if (!is_edge(surface, v, w))
      refuse(edge_name(v, w) + " is not in the surface");
    sorted.push_back(std::minmax(v, w));
    result.number_of_subgraph_components -= components.unite(v, w);
    ++degree[v];
    ++degree[w];
  }
  std::sort(sorted.begin(), sorted.end());
  result.number_of_edges = sorted.size();
  result.number_of_repeated_edges =
      std::size_t(std::distance(std::unique(sorted.begin(), sorted.end()), sorted.end()));
  result.number_of_graph_components =
      topology.components.size() + topology.number_of_isolated_vertices;
  result.number_of_independent_cycles =
      result.number_of_edges + result.number_of_subgraph_components - n;
  certify_degrees(degree, topology, result);
  return result;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

finds the components of a triangulated surface, and the Euler characteristic, boundary loops,
orientability and genus of each, and a lower bound on its connectivity
(\ref bds_connected, \cgalCite{cn-asla-85}).

<b>Complexity</b>: linear time, and for each edge the smaller degree of its ends, which is linear
time again on surfaces of bounded genus.

\param surface the surface, from `surface_of()`

\throws Surface_input_error as described for `surface_of()`
*/
template <class Reader>
Surface_topology surface_topology(const Triangulated_surface<Reader>& surface)
{
  return internal::with_rotation_system(surface.reader(), [](auto& rotations) {
    using Index = typename std::decay_t<decltype(rotations)>::Index;
    return internal::Find_topology<Index>(rotations)();
  });
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SURFACE_TOPOLOGY_H
