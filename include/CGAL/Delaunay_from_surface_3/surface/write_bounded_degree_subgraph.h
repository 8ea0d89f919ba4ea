// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_BOUNDED_DEGREE_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_BOUNDED_DEGREE_SUBGRAPH_H

// Does what all public functions do: reads a surface, marks darts, and writes edges.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_marks.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_rotation_system.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Reader, class Index, class OutputIterator>
OutputIterator write_marked(const Reader& reader, const Rotation_system<Index>& surface,
                            const Dart_marks& marks, OutputIterator out)
{
  reader.for_each_marked(surface, marks, [&](Index, const auto& edge) { *out++ = edge; });
  return out;
}

template <class Reader, class OutputIterator>
OutputIterator write_bounded_degree_subgraph(const Reader& reader, Subgraph_kind kind,
                                             OutputIterator out)
{
  return with_rotation_system(reader, [&](auto& surface) {
    using Index = typename std::decay_t<decltype(surface)>::Index;
    return write_marked(reader, surface, Bounded_degree_marks<Index>(surface, kind)(), out);
  });
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
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_BOUNDED_DEGREE_SUBGRAPH_H
