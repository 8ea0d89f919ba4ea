// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every public form comes down to: read, mark darts, write edges. A reader (Halfedge_graph_reader,
// Embedding_reader) turns one kind of graph into a rotation system and marked darts back into its edges.
// Indices have 32 bits wherever the number of edges allows.

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_WRITE_BOUNDED_DEGREE_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_WRITE_BOUNDED_DEGREE_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/subgraph/Bounded_degree_marks.h>

#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Calls function(Rotation_system<Index>&) with the index type that fits.
template <class Reader, class Function>
auto with_rotation_system(const Reader& reader, const Function& function)
{
  if (reader.number_of_darts() < (std::size_t(1) << 31)) {
    Rotation_system<std::uint32_t> surface;
    reader.read(surface);
    return function(surface);
  }
  Rotation_system<std::uint64_t> surface;
  reader.read(surface);
  return function(surface);
}

template <class Reader, class OutputIterator>
OutputIterator
write_bounded_degree_subgraph(const Reader& reader, Subgraph_kind kind, OutputIterator out)
{
  return with_rotation_system(reader, [&](auto& surface) {
    using Index = typename std::decay_t<decltype(surface)>::Index;
    return reader.write(surface, Bounded_degree_marks<Index>(surface, kind)(), out);
  });
}

// The cut graph without the boundary: each edge once.
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
    return reader.write(surface, cut.marks, out);
  });
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_WRITE_BOUNDED_DEGREE_SUBGRAPH_H
