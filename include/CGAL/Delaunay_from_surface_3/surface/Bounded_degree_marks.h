// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_MARKS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_MARKS_H

// Composes the steps from a rotation system to marks on the darts of a bounded-degree subgraph H.
//
//     1. try the surface as one sphere or one disc, if its counts allow it: peel from one opened
//        face, or from the one boundary loop; all that is reached is connected, so reaching every
//        vertex proves that there is only one component
//     2. otherwise search the triangles, prune to the cut graph, open along it, open a face of
//        every sphere, and peel
//     3. for a tree, drop the cycles
//
// Result: H spans every component, is connected there, and has degree at most 3 on spheres and
// discs, elsewhere at most 4h (closed) or 4h + 2b + 1, where χ = 2 - h - b is the component's
// Euler characteristic and b its number of boundary loops.
// Cost: O(n), with no recursion; 28 bytes per vertex for the rotation system and at most 12 more at
// any time, plus what the copies on the cut need.

#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Open_along_cut.h>
#include <CGAL/Delaunay_from_surface_3/surface/Peel_discs.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Makes H a tree: drops edges until no cycle is left, at the heaviest vertices first.
//
// All cycles of H lie in the rim (the cut graph, the boundary and opened faces); the rest hangs on
// it as trees. So Kruskal's algorithm runs on the rim's edges, each weighted by the larger degree
// in H of its two ends, light edges first; an edge that closes a cycle is dropped.
// Invariant: of all spanning trees of H this is one in which the heaviest vertex keeps as few edges
// as it can.
// Bound: with h = 2 - χ - b, H's degree exceeds max(3, 3h + 2b) at one vertex at most (at two on an
// annulus, on one rim cycle each), and dropping edges there brings it down to 3h + 2b; only on the
// projective plane it remains 4.
// Cost: O(n + r α(r)) for r rim edges; 9 bytes per vertex after all else has been freed.

// Stores an edge of the rim and the dart at which H marks it.
template <class Index>
struct Rim_edge
{
  Index source;
  Index target;
  Index dart;
};

template <class Index>
void drop_cycles(const Opened_surface<Index>& opened, const std::vector<Rim_edge<Index>>& rim_edges,
                 Dart_marks& subgraph)
{
  const Rotation_system<Index>& surface = opened.surface;
  std::vector<Index> degree(surface.number_of_vertices(), 0);
  for (Index v = 0; v < surface.number_of_vertices(); ++v)
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      if (subgraph[dart]) {
        ++degree[v];
        ++degree[opened.origin(surface.neighbor[dart])];
      }
  const auto weight = [&](std::size_t k) {
    return std::size_t((std::max)(degree[rim_edges[k].source], degree[rim_edges[k].target]));
  };
  std::size_t weights = 1;
  for (std::size_t k = 0; k < rim_edges.size(); ++k)
    weights = (std::max)(weights, weight(k) + 1);
  const Lists<Index> by_weight =
      in_lists<Index>(weights, Listed_items(rim_edges.size(), weight,
                                            [](std::size_t k) { return static_cast<Index>(k); }));
  Disjoint_sets<Index> trees(degree.size());
  for (const Index k : by_weight.items)
    if (!trees.unite(rim_edges[k].source, rim_edges[k].target))
      subgraph[rim_edges[k].dart] = false;
}

enum class Subgraph_kind { SUBGRAPH, TREE };

template <class Index>
class Bounded_degree_marks
{
public:
  Bounded_degree_marks(Rotation_system<Index>& surface, Subgraph_kind kind)
    : m_surface(surface)
    , m_opened(surface)
    , m_kind(kind)
  {
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      if (m_surface.degree(v) > 0)
        m_count.add(m_surface, v);
  }

  // Returns the marks: each edge of H, or of the tree, is marked at one of its darts.
  Dart_marks operator()()
  {
    if (m_count.vertices > 0 && !peel_as_one_piece())
      cut_and_peel(find_cut_graph(m_surface));
    return finish();
  }

  // Does the same with a cut graph that the caller provides.
  Dart_marks operator()(Cut_candidate<Index> cut)
  {
    cut_and_peel(std::move(cut));
    return finish();
  }

  // Glues the surface together again: its lists name its own vertices again, no copies.
  void close()
  {
    for (Index& u : m_surface.neighbor)
      u = m_opened.origin(u);
  }

private:
  bool peel_as_one_piece()
  {
    if (!m_count.is_sphere() && !(m_count.is_disc() && boundary_is_one_loop()))
      return false;
    start();
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      if (m_surface.on_boundary[v])
        add_boundary_vertex(v);
    if (m_count.is_sphere())
      open_face(first_vertex_with_edges());
    return peel() == 0;
  }

  bool boundary_is_one_loop() const
  {
    const std::vector<bool>& on_boundary = m_surface.on_boundary;
    const Index first = static_cast<Index>(std::find(on_boundary.begin(), on_boundary.end(), true) -
                                           on_boundary.begin());
    std::size_t length = 0;
    Index previous = first;
    for (Index v = first; length == 0 || v != first; ++length) {
      const Star<Index> star = m_surface.star(v);
      const Index next = length > 0 && star[0] == previous ? star[star.size() - 1] : star[0];
      previous = v;
      v = next;
    }
    return length == m_count.boundary_vertices;
  }

  void cut_and_peel(Cut_candidate<Index> cut)
  {
    start();
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      if (cut.degree[v] > 0)
        add_cut_vertex(v, cut.marks);
    Open_along_cut<Index>(cut, std::move(cut.xor_of_neighbors), m_opened)();
    const std::vector<Index> spheres = std::move(cut.spheres);
    cut = Cut_candidate<Index>(Rotation_system<Index>()); // gives its memory back
    for (Index v : spheres)
      open_face(v);
    if (peel() != 0)
      refuse("the lists of edges do not describe a surface");
  }

  void start()
  {
    m_opened.rim.clear();
    m_rim_edges.clear();
    m_subgraph.assign(m_surface.number_of_darts(), false);
    m_vertices_on_rim = 0;
  }

  // Returns how many vertices were not reached.
  std::size_t peel()
  {
    return Peel_discs<Index>(m_opened, m_subgraph)(m_count.vertices - m_vertices_on_rim);
  }

  Dart_marks finish()
  {
    if (m_kind == Subgraph_kind::TREE)
      drop_cycles(m_opened, m_rim_edges, m_subgraph);
    return std::move(m_subgraph);
  }

  void add_boundary_vertex(Index v)
  {
    m_opened.rim.push_back(v);
    ++m_vertices_on_rim;
    add_rim_edge_once(v, 0);
    add_rim_edge_once(v, m_surface.degree(v) - 1);
  }

  void add_cut_vertex(Index v, const Dart_marks& cut_marks)
  {
    ++m_vertices_on_rim;
    for (Index i = 0; i < m_surface.degree(v); ++i)
      if (cut_marks[m_surface.first[v] + i])
        add_rim_edge_once(v, i);
  }

  // Opens the triangle at the first corner of v.
  void open_face(Index v)
  {
    const Index a = m_surface.star(v)[0], b = m_surface.star(v)[1];
    const Star<Index> star = m_surface.star(a);
    m_opened.rim.insert(m_opened.rim.end(), {v, a, b});
    m_vertices_on_rim += 3;
    add_rim_edge(v, 0);
    add_rim_edge(v, 1);
    add_rim_edge(a, static_cast<Index>(std::find(star.begin(), star.end(), b) - star.begin()));
  }

  void add_rim_edge_once(Index v, Index i)
  {
    if (v < m_surface.star(v)[i])
      add_rim_edge(v, i);
  }

  void add_rim_edge(Index v, Index i)
  {
    const Index dart = m_surface.first[v] + i;
    m_subgraph[dart] = true;
    if (m_kind == Subgraph_kind::TREE)
      m_rim_edges.push_back({v, m_surface.neighbor[dart], dart});
  }

  Index first_vertex_with_edges() const
  {
    Index v = 0;
    while (m_surface.degree(v) == 0)
      ++v;
    return v;
  }

  Rotation_system<Index>& m_surface;
  Opened_surface<Index> m_opened;
  Subgraph_kind m_kind;
  Euler_count m_count;
  Dart_marks m_subgraph;
  std::vector<Rim_edge<Index>> m_rim_edges; // for a tree only
  std::size_t m_vertices_on_rim = 0;
};

template <class Reader, class OutputIterator>
OutputIterator write_bounded_degree_subgraph(const Reader& reader, Subgraph_kind kind,
                                             OutputIterator out)
{
  return with_rotation_system(reader, [&](auto& surface) {
    using Index = typename std::decay_t<decltype(surface)>::Index;
    return write_marked(reader, surface, Bounded_degree_marks<Index>(surface, kind)(), out);
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BOUNDED_DEGREE_MARKS_H
