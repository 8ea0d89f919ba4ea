// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REFUSE_INPUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REFUSE_INPUT_H

// The messages with which the subgraph functions refuse their input: what is wrong, and at which
// vertex or edge. Vertices are named by their index, edges by their two ends.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_REFUSE_INPUT_H
