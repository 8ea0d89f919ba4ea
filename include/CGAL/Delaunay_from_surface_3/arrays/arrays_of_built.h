// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_BUILT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_BUILT_H

// From the core's complex to arrays.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/arrays/flat_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/partition_cells.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// By vertex: the smallest index of its points.
template <class Index, class Id>
std::vector<Index> names_of_vertices(const Built<Id>& built, const Executor& executor)
{
  std::vector<Index> names(built.number_of_places + 1, Index(-1));
  const std::size_t n = built.order.size, blocks = number_of_blocks(executor, n, 4096);
  std::vector<std::vector<std::size_t>> others(blocks); // whose vertex is that of another point
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    for (std::size_t k = first; k < last; ++k)
      if (std::size_t(built.vertex_of[k]) == Compact_numbers<Id>::vertex_of_point(k))
        names[k + 1] = Index(built.order.order[k]);
      else
        others[b].push_back(k);
  });
  for (const std::vector<std::size_t>& places : others)
    for (const std::size_t k : places) {
      Index& name = names[built.vertex_of[k]];
      name = (std::min)(name, Index(built.order.order[k]));
    }
  return names; // that of the infinite vertex, 0, and of an apex is -1
}

// By point: the name of its vertex.
template <class Index, class Id>
std::vector<Index> vertices_of_points(const Built<Id>& built, const std::vector<Index>& names,
                                      const Executor& executor)
{
  const std::size_t n = built.order.size;
  std::vector<Index> vertices(n);
  for_each_block(executor, n, number_of_blocks(executor, n, 4096),
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   for (std::size_t k = first; k < last; ++k)
                     vertices[built.order.order[k]] = names[built.vertex_of[k]];
                 });
  return vertices;
}

// The arrays of points in a plane: the triangles at the apex.
template <class Index, class Id>
Delaunay_3_arrays<Index> arrays_at_apex(const Built<Id>& built, const Executor& executor)
{
  using Arrays = Delaunay_3_arrays<Index>;
  const std::vector<Index> names = names_of_vertices<Index>(built, executor);
  typename Arrays::Entries rows;
  const auto [finite, all] = triangles_at(built, names, rows);
  return Arrays(2, finite, all, std::move(rows), vertices_of_points(built, names, executor));
}

// Vertices get these names, and links become the numbers of neighbours: -1 from `end` on.
template <class Index, class Id>
void rename_vertices(Compact_cell<Id>* first, Compact_cell<Id>* last,
                     const std::vector<Index>& names, Index end)
{
  for (Compact_cell<Id>* cell = first; cell != last; ++cell) {
    for (std::size_t k = 0; k < 4; ++k) { // in a vector
      const auto neighbor = Index(cell->links[k] >> 2);
      cell->links[k] = Id(neighbor < end ? neighbor : Index(-1));
    }
    for (std::size_t k = 0; k < 4; ++k)
      cell->v[k] = Id(names[cell->v[k]]);
  }
}

// The arrays of points in space, of all cells or of finite ones alone. Vertices become indices of
// points, and links the numbers of neighbours; the memory of the cells is kept.
template <class Index, class Id>
Delaunay_3_arrays<Index> arrays_in_space(Built<Id>& built, const Executor& executor,
                                         bool keeps_infinite)
{
  using Arrays = Delaunay_3_arrays<Index>;
  built.give_up_vertices();
  const Numbers_of_cells numbers = partition_cells(built.cells, built.cells_end, executor);
  const std::vector<Index> names = names_of_vertices<Index>(built, executor);
  const std::size_t number = keeps_infinite ? numbers.all : numbers.finite;
  for_each_block(executor, number, number_of_blocks(executor, number, 65536),
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   rename_vertices(built.cells + first, built.cells + last, names, Index(number));
                 });
  std::size_t capacity = 0;
  Compact_cell<Id>* const cells = built.take_cells(capacity);
  return Arrays(3, numbers.finite, number,
                typename Arrays::Entries(Page_array<Compact_cell<Id>>(cells, capacity)),
                vertices_of_points(built, names, executor));
}

// The arrays of what was built of the points, with an apex if they lie in a plane; empty after a
// stop. Throws a std::length_error if the cells are more than an Index can number. Linear, by as
// many threads as the executor has; to leave infinite cells out costs nothing here.
template <class Index>
Delaunay_3_arrays<Index> arrays_of_built(Built<std::make_unsigned_t<Index>>& built,
                                         Point_source& source, const Executor& executor,
                                         bool keeps_infinite = true)
{
  if (built.outcome == Insertion_outcome::TOO_FEW_IDS)
    throw Too_few_ids(std::numeric_limits<std::make_unsigned_t<Index>>::digits);
  if (built.outcome == Insertion_outcome::COMPLETE && !built.has_apex)
    return arrays_in_space<Index>(built, executor, keeps_infinite);
  Delaunay_3_arrays<Index> arrays;
  if (built.outcome == Insertion_outcome::COMPLETE)
    arrays = arrays_at_apex<Index>(built, executor);
  else if (built.outcome == Insertion_outcome::FLAT)
    arrays = arrays_on_line<Index>(source.points());
  if (!keeps_infinite)
    arrays.drop_infinite_cells();
  return arrays;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_BUILT_H
