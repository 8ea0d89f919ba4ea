// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_INSERT_BY_THREADS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_INSERT_BY_THREADS_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Starting_cells.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Fewer points of a tile are one thread's affair.
constexpr std::size_t least_points_for_threads = 10000;

// Inserts all vertices behind the first ones, which are in cells, in rounds that end there; each worker
// starts from the one it inserted before. Returns by place, that is vertex less 1, the vertices, of equal
// points that of any of them. check() is called now and then, and may throw.
template <class Id, class Check>
std::vector<Id> insert_by_threads(Compact_complex<Id>& complex, std::size_t first,
                                  const std::vector<std::size_t>& round_ends,
                                  const Executor& executor, const Check& check)
{
  std::vector<Id> vertex_of(complex.vertices_end() - 1, 0);
  std::iota(vertex_of.begin(), vertex_of.begin() + std::ptrdiff_t(first), Id(1));
  Parallel_triangulation<Id> workers(complex, executor);
  std::size_t place = first;
  for (const std::size_t end : round_ends)
    while (place < first + end) {
      const std::size_t next = (std::min)(first + end, place + workers.size_of_piece(place));
      workers.insert_round(place, next, vertex_of,
                           Starting_cells<Id>(complex, vertex_of, nullptr, 1),
                           [](std::size_t) { return true; });
      place = next;
      check();
    }
  workers.finish();
  return vertex_of;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_INSERT_BY_THREADS_H
