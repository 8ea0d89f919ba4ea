// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_SYSTEM_OF_LOOPS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_SYSTEM_OF_LOOPS_H

// Loops of darts as loops of edges. A reader goes from darts to edges in one sweep only, so the
// darts that loops use are noted in one sweep and then looked up.

#include <Delaunay_from_surface_3_meters/Find_loops.h>

#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace meters {

// Writes a system of loops of a closed surface: on every component of genus g > 0 these are 2g closed
// walks through one base vertex such that the component without them is an open disc. What is written
// are std::vectors of edges in order, starting and ending at the base; an edge that a loop passes in
// both directions is there twice. Linear time plus the length of the loops, O(gn).
template <class Reader, class LoopOutputIterator>
LoopOutputIterator
system_of_loops(const CGAL::Delaunay_from_surface_3::Triangulated_surface<Reader>& surface,
                LoopOutputIterator out)
{
  using Edge = typename Reader::Edge;
  return rooms::with_rotation_system(surface.reader(), [&](auto& rotations) {
    using Index = typename std::decay_t<decltype(rotations)>::Index;
    const auto loops = Find_loops<Index>(rotations)();
    rooms::Dart_marks is_used(rotations.number_of_darts(), false);
    for (const auto& loop : loops)
      for (Index dart : loop)
        is_used[dart] = true;
    std::vector<std::pair<Index, Edge>> edge_of_dart;
    surface.reader().for_each_marked(rotations, is_used, [&](Index dart, const Edge& edge) {
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

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_SYSTEM_OF_LOOPS_H
