// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SEARCH_TRIANGLES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SEARCH_TRIANGLES_H

// Searches the triangles breadth-first, star by star: step 1 of the cut.
//
// Vertices are taken in breadth-first order. When v is taken, every triangle of its star that the
// search has not met is joined to one that it has met, across the edges at v between the two; so
// all of v's star is met.
// Invariant: a triangle has been met if and only if one of its corners has been taken. So no
// marks for triangles are needed, and no links between the darts of an edge: whether the search
// crosses an edge is settled when the first of its ends is taken.
// Result: the edges that are not crossed (boundary edges among them) form a graph G; removed from
// the surface they leave one open disc per component. G is represented by its degrees, the
// exclusive or of each vertex's neighbours (all that pruning needs) and one mark per edge, at the
// end that was taken first.
// Cost: one pass over the lists; 8 bytes per vertex, one bit per dart, and the front of the search.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Counts the elements of a surface, or of one component, for its Euler characteristic: vertices -
// edges + triangles.

struct Euler_count
{
  std::size_t vertices = 0;
  std::size_t darts = 0;   // two per edge
  std::size_t corners = 0; // three per triangle
  std::size_t boundary_vertices = 0;

  template <class Index>
  void add(const Rotation_system<Index>& surface, Index v)
  {
    ++vertices;
    darts += surface.degree(v);
    corners += surface.number_of_corners(v);
    boundary_vertices += surface.on_boundary[v] ? 1 : 0;
  }

  std::ptrdiff_t characteristic() const
  {
    return std::ptrdiff_t(vertices) - std::ptrdiff_t(darts / 2) + std::ptrdiff_t(corners / 3);
  }

  // These tell what a connected surface with these counts is; a disc has one boundary loop.
  bool is_sphere() const { return characteristic() == 2 && boundary_vertices == 0; }
  bool is_disc() const { return characteristic() == 1 && boundary_vertices > 0; }
};

// Holds the graph G of edges that were not crossed, and later the cut graph that it is pruned to.
template <class Index>
struct Cut_candidate
{
  std::vector<Index> degree;
  std::vector<Index> xor_of_neighbors;
  Dart_marks marks;
  std::vector<Index> spheres; // one vertex of every component that is a sphere

  explicit Cut_candidate(const Rotation_system<Index>& surface)
    : degree(surface.number_of_vertices(), 0)
    , xor_of_neighbors(surface.number_of_vertices(), 0)
    , marks(surface.number_of_darts(), false)
  {
  }

  void add_edge(Index v, Index w)
  {
    ++degree[v];
    ++degree[w];
    xor_of_neighbors[v] ^= w;
    xor_of_neighbors[w] ^= v;
  }
};

template <class Index>
class Search_triangles
{
public:
  Search_triangles(const Rotation_system<Index>& surface, Cut_candidate<Index>& candidate)
    : m_surface(surface)
    , m_candidate(candidate)
    , m_is_seen(surface.number_of_vertices(), false)
    , m_is_taken(surface.number_of_vertices(), false)
  {
  }

  void operator()()
  {
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      if (!m_is_seen[v] && m_surface.degree(v) > 0)
        search_component(v);
  }

private:
  void search_component(Index root)
  {
    Euler_count count;
    m_is_seen[root] = true;
    m_front.assign(1, root);
    while (!m_front.empty()) {
      m_next_front.clear();
      for (Index v : m_front) {
        count.add(m_surface, v);
        take(v, v == root);
        m_is_taken[v] = true;
      }
      m_front.swap(m_next_front);
    }
    if (count.is_sphere())
      m_candidate.spheres.push_back(root);
  }

  // Takes v, whose corner i is the triangle v, star[i], star[i+1]; edge i leads there from i-1.
  void take(Index v, bool is_root)
  {
    const Star<Index> star = m_surface.star(v);
    const Index degree = star.size();
    const bool is_open = m_surface.on_boundary[v];
    const auto at = [degree](Index i) { return i < degree ? i : i - degree; };
    const auto is_met = [&](Index i) { return m_is_taken[star[i]] || m_is_taken[star[at(i + 1)]]; };
    Index start = 0; // a triangle that has been met; at the root the first one counts as such
    while (!is_root && !is_met(start))
      ++start;
    // From there on, edges `begin` .. i lead across the triangles that had not been met between two
    // that had: the middle one of these edges is not crossed.
    Index begin = start + 1;
    for (Index i = begin; i < (is_open ? degree - 1 : start + degree + 1); ++i)
      if (i == start + degree || is_met(at(i))) {
        leave(v, star, at(begin + (i - begin) / 2));
        begin = i + 1;
      }
    if (is_open) {
      leave(v, star, 0);
      leave(v, star, degree - 1);
    }
    for (Index u : star)
      see(u);
  }

  void leave(Index v, const Star<Index>& star, Index i)
  {
    if (m_is_taken[star[i]])
      return; // this edge was settled when that end was taken
    m_candidate.add_edge(v, star[i]);
    m_candidate.marks[m_surface.first[v] + i] = true;
  }

  void see(Index u)
  {
    if (!m_is_seen[u]) {
      m_is_seen[u] = true;
      m_next_front.push_back(u);
    }
  }

  const Rotation_system<Index>& m_surface;
  Cut_candidate<Index>& m_candidate;
  std::vector<bool> m_is_seen;
  std::vector<bool> m_is_taken;
  std::vector<Index> m_front;
  std::vector<Index> m_next_front;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SEARCH_TRIANGLES_H
