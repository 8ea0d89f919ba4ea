// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H

// Stores a triangulated surface in flat arrays, on which every step of the subgraphs works.
//
// Invariant: darts first[v] .. first[v+1]-1 are the edges at v in the order in which they stand
// around v, in either direction; neighbor[dart] is the other end. The list of an interior vertex is
// cyclic; the list of a boundary vertex starts and ends with its boundary edges. The graph is
// simple, so an edge is known by its two ends and the darts of an edge need no link to each other.
// Cost: 4 bytes per dart and per vertex; 28 bytes per vertex on a closed surface.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Dart_marks = std::vector<bool>; // one bit per dart

// Refers to the edges around one vertex, in order.
template <class Index>
struct Star
{
  const Index* first;
  const Index* last;

  const Index* begin() const { return first; }
  const Index* end() const { return last; }
  Index size() const { return static_cast<Index>(last - first); }
  Index operator[](Index position) const { return first[position]; }
};

template <class Index_>
struct Rotation_system
{
  using Index = Index_;

  std::vector<Index> first;      // number_of_vertices() + 1 entries
  std::vector<Index> neighbor;   // one per dart
  std::vector<bool> on_boundary; // one bit per vertex

  Index number_of_vertices() const { return static_cast<Index>(on_boundary.size()); }
  std::size_t number_of_darts() const { return neighbor.size(); }
  Index degree(Index v) const { return first[v + 1] - first[v]; }

  Star<Index> star(Index v) const
  {
    return {neighbor.data() + first[v], neighbor.data() + first[v + 1]};
  }

  // Returns the number of triangles at v, one less than the edges if the list is not cyclic.
  Index number_of_corners(Index v) const
  {
    return degree(v) == 0 ? 0 : degree(v) - (on_boundary[v] ? 1 : 0);
  }
};

// The subgraph functions refuse their input with messages that tell what is wrong, and at which
// vertex or edge. Vertices are named by their index, edges by their two ends.

[[noreturn]] inline void refuse(const std::string& what)
{
  throw Surface_input_error(what);
}

inline std::string vertex_name(std::size_t v)
{
  return "vertex " + std::to_string(v);
}

inline std::string edge_name(std::size_t v, std::size_t w)
{
  return "edge (" + std::to_string(v) + ", " + std::to_string(w) + ")";
}

[[noreturn]] inline void refuse_index(std::size_t n, std::size_t index)
{
  refuse("the vertex index map is no bijection onto 0 .. n-1: n is " + std::to_string(n) +
         " and index " + std::to_string(index) + (index < n ? " is there twice" : " is too large"));
}

// Names two edges with the same ends by their positions in the range edges(g).
template <class Graph, class VertexIndexMap>
[[noreturn]] void refuse_multi_edge(const Graph& g, VertexIndexMap index, std::size_t v,
                                    std::size_t w)
{
  std::string positions;
  std::size_t position = 0, found = 0;
  const auto range = edges(g);
  for (auto e = range.first; e != range.second; ++e, ++position) {
    const std::size_t a = get(index, source(*e, g)), b = get(index, target(*e, g));
    if ((a == v && b == w) || (a == w && b == v))
      positions += (found++ == 0 ? "" : found == 2 ? " and " : ", ") + std::to_string(position);
  }
  if (found < 2)
    refuse(edge_name(v, w) + " stands twice in the list of " + vertex_name(v));
  refuse("the graph is not simple: " + edge_name(v, w) + " is there " + std::to_string(found) +
         " times, as edges number " + positions + " of edges(g)");
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H
