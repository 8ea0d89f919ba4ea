// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_SYSTEM_OF_LOOPS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_SYSTEM_OF_LOOPS_H

// Loops of darts as loops of edges. A reader goes from darts to edges in one sweep only, so the
// darts that loops use are noted in one sweep and then looked up.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Find_loops.h>
#include <CGAL/Delaunay_from_surface_3/surface/with_rotation_system.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Edge, class Reader, class OutputIterator>
OutputIterator write_system_of_loops(const Reader& reader, OutputIterator out)
{
  return with_rotation_system(reader, [&](auto& surface) {
    using Index = typename std::decay_t<decltype(surface)>::Index;
    const auto loops = Find_loops<Index>(surface)();
    Dart_marks is_used(surface.number_of_darts(), false);
    for (const auto& loop : loops)
      for (Index dart : loop)
        is_used[dart] = true;
    std::vector<std::pair<Index, Edge>> edge_of_dart;
    reader.for_each_marked(surface, is_used, [&](Index dart, const Edge& edge) {
      edge_of_dart.emplace_back(dart, edge);
    });
    const auto is_before = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::sort(edge_of_dart.begin(), edge_of_dart.end(), is_before);
    for (const auto& loop : loops) {
      std::vector<Edge> loop_of_edges;
      for (Index dart : loop)
        loop_of_edges.push_back(std::lower_bound(edge_of_dart.begin(), edge_of_dart.end(),
                                                 std::make_pair(dart, Edge()), is_before)
                                    ->second);
      *out++ = std::move(loop_of_edges);
    }
    return out;
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_SYSTEM_OF_LOOPS_H
