// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H

// Stores a triangulated surface in flat arrays, on which every step of the subgraphs works. Like the
// steps, this header needs no other library: Python's module is built without them.
//
// Invariant: darts first[v] .. first[v+1]-1 are the edges at v in the order in which they stand
// around v, in either direction; neighbor[dart] is the other end. The list of an interior vertex is
// cyclic; the list of a boundary vertex starts and ends with its boundary edges. The graph is
// simple, so an edge is known by its two ends and the darts of an edge need no link to each other.
// Cost: 4 bytes per dart and per vertex; 28 bytes per vertex on a closed surface.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
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

// Refuses a map that is no bijection from these vertices onto 0 .. n-1.
template <class VertexRange, class VertexIndexMap>
void refuse_bad_indices(const VertexRange& range, VertexIndexMap index, std::size_t n)
{
  std::vector<bool> is_taken(n, false);
  for (auto v = range.first; v != range.second; ++v) {
    const std::size_t i = static_cast<std::size_t>(get(index, *v));
    if (i >= n || is_taken[i])
      refuse("the vertex index map is no bijection onto 0 .. n-1: n is " + std::to_string(n) +
             " and index " + std::to_string(i) +
             (i < n ? " is there twice" : " is too large; remedy: call collect_garbage() first"));
    is_taken[i] = true;
  }
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

// A reader (Halfedge_graph_reader, Embedding_reader, Face_reader) turns one kind of surface into a
// rotation system, and marked darts back into its edges.

// Reads the surface and calls function(Rotation_system<Index>&), with indices of 32 bits wherever
// the numbers of edges and vertices allow.
template <class Reader, class Function>
auto with_rotation_system(const Reader& reader, const Function& function)
{
  // Cutting the surface open makes copies of vertices, fewer than there are darts; so half of the
  // 32-bit numbers are left for the copies.
  if ((std::max)(reader.number_of_darts(), reader.number_of_vertices()) < (std::size_t(1) << 31)) {
    Rotation_system<std::uint32_t> surface;
    reader.read(surface);
    return function(surface);
  }
  Rotation_system<std::uint64_t> surface;
  reader.read(surface);
  return function(surface);
}

// Writes the edges that are marked.
template <class Reader, class Index, class OutputIterator>
OutputIterator write_marked(const Reader& reader, const Rotation_system<Index>& surface,
                            const Dart_marks& marks, OutputIterator out)
{
  reader.for_each_marked(surface, marks, [&](Index, const auto& edge) { *out++ = edge; });
  return out;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is a triangulated surface as the functions on subgraphs take it, independent of the user's data
structure. It is returned by `surface_of()`, is small, and refers to the arguments of that function.

\tparam Reader chosen by `surface_of()`
*/
template <class Reader>
class Triangulated_surface
{
public:
  /// the type of edges: the descriptor of the mesh or graph, or a pair of indices for a soup.
  using edge_descriptor = typename Reader::Edge;

  /// \cond
  explicit Triangulated_surface(Reader reader)
    : m_reader(std::move(reader))
  {
  }

  const Reader& reader() const { return m_reader; }
  /// \endcond

private:
  Reader m_reader;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_ROTATION_SYSTEM_H
