// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CUT_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CUT_GRAPH_H

// Finds a graph along which a surface can be cut open into discs: a search through its triangles
// leaves some edges uncrossed (step 1), of which those that lead nowhere are pruned (step 2).

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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

// Searches the triangles breadth-first, star by star: step 1.
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

// Groups values by a key below n in linear time, as linked lists in flat arrays. It turns what each
// v says of u into what u hears from all v: so the two darts of an edge meet where the cut needs
// it; elsewhere they need not. Cost: two words per value; the array of heads is the caller's.

template <class Index>
class Buckets
{
public:
  static constexpr Index empty = (std::numeric_limits<Index>::max)();

  void reserve(std::size_t number_of_values)
  {
    m_values.reserve(number_of_values);
    m_next.reserve(number_of_values);
  }

  // Adds a value to a bucket. The caller keeps the head of the bucket, which starts as `empty`.
  void add(Index& head, Index value)
  {
    m_values.push_back(value);
    m_next.push_back(head);
    head = static_cast<Index>(m_values.size() - 1);
  }

  template <class Function>
  void for_each(Index head, const Function& function) const
  {
    for (; head != empty; head = m_next[head])
      function(m_values[head]);
  }

private:
  std::vector<Index> m_values;
  std::vector<Index> m_next;
};

// Prunes G to the cut graph: step 2.
//
// Vertices of degree 1 are removed until none is left; then an edge is in the cut graph if and only
// if the degrees of both its ends are positive. The one neighbour of a vertex of degree 1 is the
// exclusive or of its neighbours, so no list is read. The last step marks both darts of a cut edge.
// Invariant: removing a leaf and its edge leaves the complement of G an open disc.
// Bound: with χ = 2 - h - b the sum of (degree - 2) over the cut graph is 2(1 - χ) and no degree is
// below 2. This bounds the degree of the subgraph; the degree of G itself has no bound. On a sphere
// G is pruned to a point.
// Cost: O(n), one bit per vertex and two words per cut edge.

template <class Index>
void prune_cut(const Rotation_system<Index>& surface, Cut_candidate<Index>& cut)
{
  const Index n = surface.number_of_vertices();
  for (Index v = 0; v < n; ++v)
    for (Index leaf = v; cut.degree[leaf] == 1;) {
      const Index next = cut.xor_of_neighbors[leaf];
      cut.degree[leaf] = 0;
      --cut.degree[next];
      cut.xor_of_neighbors[next] ^= leaf;
      leaf = next;
    }

  // Each edge left is marked at one end: the other end is told, and marks it, too.
  Buckets<Index> marked_at;
  std::vector<Index>& heads = cut.xor_of_neighbors; // its values are no longer needed
  heads.assign(n, Buckets<Index>::empty);
  for (Index v = 0; v < n; ++v)
    if (cut.degree[v] != 0)
      for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart) {
        if (!cut.marks[dart])
          continue;
        const Index u = surface.neighbor[dart];
        if (cut.degree[u] != 0)
          marked_at.add(heads[u], v);
        else
          cut.marks[dart] = false;
      }
  std::vector<bool> is_other_end(n, false);
  for (Index v = 0; v < n; ++v) {
    if (heads[v] == Buckets<Index>::empty)
      continue;
    marked_at.for_each(heads[v], [&](Index u) { is_other_end[u] = true; });
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      if (is_other_end[surface.neighbor[dart]])
        cut.marks[dart] = true;
    marked_at.for_each(heads[v], [&](Index u) { is_other_end[u] = false; });
  }
}

// Finds the cut graph. Its edges and the boundary edges are marked at both darts; marks at vertices
// that have degree 0 in the result mean nothing.
template <class Index>
Cut_candidate<Index> find_cut_graph(const Rotation_system<Index>& surface)
{
  Cut_candidate<Index> cut(surface);
  Search_triangles<Index>(surface, cut)();
  prune_cut(surface, cut);
  return cut;
}

// Writes the cut graph without the boundary, each edge once.
template <class Reader, class OutputIterator>
OutputIterator write_cut_graph(const Reader& reader, OutputIterator out)
{
  return with_rotation_system(reader, [&](auto& surface) {
    using Index = typename std::decay_t<decltype(surface)>::Index;
    Cut_candidate<Index> cut = find_cut_graph(surface);
    for (Index v = 0; v < surface.number_of_vertices(); ++v) {
      const Index begin = surface.first[v], end = surface.first[v + 1];
      for (Index dart = begin; dart < end; ++dart) {
        const bool is_boundary = surface.on_boundary[v] && (dart == begin || dart + 1 == end);
        if (cut.degree[v] == 0 || is_boundary || surface.neighbor[dart] < v)
          cut.marks[dart] = false;
      }
    }
    return write_marked(reader, surface, cut.marks, out);
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a cut graph of a triangulated surface. Removing them and the boundary leaves one
open disc of each component that is not a sphere. On a sphere or a disc nothing is written. Boundary
edges are never written.

The cut graph is pruned: no vertex inside the surface has exactly one of its edges. On a component
with Euler characteristic χ that is not a sphere, the degrees in the union of cut graph and boundary
satisfy Σ(deg − 2) = 2(1 − χ). So on a closed surface of genus g > 0 the cut graph has degree at
most 4g.

The parameters, the return value and the exceptions are those of
`bounded_degree_spanning_subgraph()`.

<b>Complexity</b>: linear time, for any genus.
*/
template <class Reader, class EdgeOutputIterator>
EdgeOutputIterator cut_graph(const Triangulated_surface<Reader>& surface, EdgeOutputIterator out)
{
  return internal::write_cut_graph(surface.reader(), out);
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CUT_GRAPH_H
