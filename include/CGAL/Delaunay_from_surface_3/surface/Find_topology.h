// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_FIND_TOPOLOGY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_FIND_TOPOLOGY_H

// The topology of every component of a rotation system: Euler characteristic, boundary loops,
// orientability.
//
// Vertices are visited from neighbour to neighbour. Each gets a turn: whether its list runs against
// that of the component's first vertex. Where v's list goes from w to x, w's list goes from x to v
// if the two run alike, from v to x if not; an edge at which the turns do not fit shows that the
// surface is not orientable.
// Cost: O(n); 28 bytes per vertex besides the lists, for the pairs of darts.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/Search_triangles.h>
#include <CGAL/Delaunay_from_surface_3/surface/Surface_component_topology.h>

#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Links the two darts of every edge. The subgraph itself never needs this; to tell an orientable
// surface from another, and to walk over the triangles in any order, it is the simplest way.
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
  // Grouped by target, as the lists are by source.
  std::vector<Incoming> incoming(surface.number_of_darts());
  std::vector<Index> next(surface.first);
  for (Index v = 0; v < n; ++v)
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      incoming[next[surface.neighbor[dart]]++] = {v, dart};
  std::vector<Index> mate(surface.number_of_darts());
  std::vector<Index>& dart_to = next; // for each u the dart from v to u, while v is looked at
  for (Index v = 0; v < n; ++v) {
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      dart_to[surface.neighbor[dart]] = dart;
    for (Index i = surface.first[v]; i < surface.first[v + 1]; ++i)
      mate[incoming[i].dart] = dart_to[incoming[i].source];
  }
  return mate;
}

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

  // Looks at one triangle at the edge from v to its i-th neighbour.
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

  const Rotation_system<Index>& m_surface;
  std::vector<Index> m_mate;
  std::vector<bool> m_is_seen;
  std::vector<bool> m_is_turned;
  std::vector<bool> m_is_on_loop;
  std::vector<Index> m_stack;
  Surface_topology m_topology;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_FIND_TOPOLOGY_H
