// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_EXPORT_BUILT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_EXPORT_BUILT_H

// From the core's complex to the caller's triangulation.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/door/export_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Fills `tr`, which is empty, with what was built of the points, and gives up its memory. Returns the
// vertices by point, none for those that were left out. They are made in the order of insertion or in
// that of the input. Linear.
template <class Triangulation, class Id>
std::vector<typename Triangulation::Vertex_handle>
export_built(Built<Id>& built, const std::vector<typename Triangulation::Point>& points,
             bool creates_in_input_order, Triangulation& tr, const Executor& executor)
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  const std::size_t n = built.order.size;
  const std::size_t* const order = built.order.order;
  const auto point = [&](std::size_t v) -> const typename Triangulation::Point* {
    const std::size_t k = Compact_numbers<Id>::point_of_vertex(v);
    prefetch(&points[order[(std::min)(k + prefetch_distance, n - 1)]]);
    return built.vertex_of[k] == v ? &points[order[k]] : nullptr;
  };
  const auto places = creates_in_input_order ? inverse(order, n) : std::vector<std::size_t>();
  const Creation_order<Id> in_order = {creates_in_input_order ? &places : nullptr, built.vertex_of};
  auto handles = export_complex(tr, built, point, in_order, executor);
  fill_upper_levels(tr, handles);
  handles.front() = {}; // points that were left out have no vertex, nor that at infinity

  std::vector<Vertex_handle> vertices(n);
  for_each_block(executor, n, number_of_blocks(executor, n, 4096),
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   for (std::size_t k = first; k < last; ++k)
                     vertices[order[k]] = handles[built.vertex_of[k]];
                 });
  return vertices;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_EXPORT_BUILT_H
