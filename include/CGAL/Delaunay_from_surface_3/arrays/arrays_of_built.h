// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_BUILT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_BUILT_H

// Turns the core's complex into arrays.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Big_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The following makes the arrays of points that lie in one plane, on one line, or at one place.
//
// To points in a plane one point is added, the apex, off the plane. The sphere through a triangle
// and the apex cuts the plane in the circle of the triangle, so the cells at the apex are the
// triangles of the Delaunay triangulation in the plane, infinite ones included, each with the apex
// on top. CGAL's perturbation of points on one circle is the same in both: raising the apex changes
// no sign, as the other four points of a test lie in one plane. So the kernel does not know planes.

// Writes the triangles at the apex, the last vertex of the complex, as rows of eight entries: three
// vertices by `names`, three neighbours; infinite triangles come last. Returns the number of finite
// ones, and of all.
template <class Index>
std::pair<std::size_t, std::size_t>
triangles_at(const Built& built, const std::vector<Index>& names, Page_array<Index>& rows)
{
  using Numbers = Compact_numbers;
  const Id apex = built.vertex_of[built.number_of_places - 1];
  const auto place_of_apex = [&](std::size_t c) { // 4 if c is dead or has no apex
    const Id* const v = built.cells[c].v;
    return Numbers::is_dead(built.cells[c]) ? std::ptrdiff_t(4) : std::find(v, v + 4, apex) - v;
  };
  std::vector<Index> numbers(built.cells_end, -1);
  std::size_t finite = 0, all = 0;
  for (const bool is_infinite : {false, true}) {
    for (std::size_t c = 0; c < built.cells_end; ++c)
      if (place_of_apex(c) < 4 && Numbers::is_infinite(built.cells[c]) == is_infinite)
        numbers[c] = Index(all++);
    finite = is_infinite ? finite : all;
  }
  rows.allocate(8 * all);
  std::fill(rows.data(), rows.data() + 8 * all, Index(-1));
  for (std::size_t c = 0; c < built.cells_end; ++c)
    if (numbers[c] >= 0) {
      Index* const row = rows.data() + 8 * std::size_t(numbers[c]);
      for (std::size_t k = 0; k < 3; ++k) {
        const unsigned corner = facet_corners[place_of_apex(c)][k];
        row[k] = names[built.cells[c].v[corner]];
        row[4 + k] = numbers[built.cells[c].neighbors[corner] >> 2];
      }
    }
  return {finite, all};
}

// Returns the segments between the points `line`, indices in their order along a line, as rows of
// eight: the finite segments first, then the infinite one at each end.
template <class Index>
Page_array<Index> segments_of(const std::vector<Index>& line)
{
  const std::size_t n = line.size();
  Page_array<Index> rows;
  rows.allocate(8 * (n + 1));
  std::fill(rows.data(), rows.data() + 8 * (n + 1), Index(-1));
  for (std::size_t k = 0; k + 1 < n; ++k) {
    Index* const row = rows.data() + 8 * k;
    row[0] = line[k], row[1] = line[k + 1];
    row[4] = k + 2 < n ? Index(k + 1) : Index(n);
    row[5] = k > 0 ? Index(k - 1) : Index(n - 1);
  }
  Index* const first = rows.data() + 8 * (n - 1); // before the first point, and after the last
  Index* const last = first + 8;
  first[0] = line.front(), first[4] = Index(n), first[5] = 0;
  last[0] = line.back(), last[4] = Index(n - 1), last[5] = Index(n - 2);
  return rows;
}

// Returns whether b is hidden by a and c, points with weights and a < b < c on a line: raised to its
// squared distance from b less its weight, b is above the segment that joins the others. As in CGAL,
// a point on the segment is not hidden.
inline bool is_hidden_between(const std::array<double, 4>& a, const std::array<double, 4>& b,
                              const std::array<double, 4>& c)
{
  const Weighted_place ends[2] = {Weighted_place(a.data()), Weighted_place(c.data())};
  const Big_differences<2, Weighted_place> from_b(ends, Weighted_place(b.data()));
  const auto &before = from_b.rows[0], &after = from_b.rows[1];
  const auto along = sign_of(after.x) != 0   ? &Row<Big_integer>::x
                     : sign_of(after.y) != 0 ? &Row<Big_integer>::y
                                             : &Row<Big_integer>::z;
  return sign_of(before.w * (after.*along) - after.w * (before.*along)) < 0; // c is ahead of b
}

// Takes hidden points out of `line`, where points are in their order; they have no vertices.
template <class Index>
void remove_hidden(std::vector<Index>& line, const Point_array& points, const double* weights,
                   std::vector<Index>& vertices_of_points)
{
  const auto place = [&](Index i) {
    const double* const p = points[std::size_t(i)];
    return std::array<double, 4>{p[0], p[1], p[2], weights[i]};
  };
  std::size_t end = 0;
  for (const Index c : line) {
    while (end > 1 && is_hidden_between(place(line[end - 2]), place(line[end - 1]), place(c)))
      vertices_of_points[std::size_t(line[--end])] = Delaunay_3_arrays<Index>::none;
    line[end++] = c;
  }
  line.resize(end);
  for (Index& v : vertices_of_points)
    if (v >= 0)
      v = vertices_of_points[std::size_t(v)];
}

// Makes the arrays of points on a line or at one place, without weights if these are null. Throws if
// an Index cannot number the cells.
template <class Index>
Delaunay_3_arrays<Index> arrays_on_line(const Point_array& points, const double* weights = nullptr)
{
  using Arrays = Delaunay_3_arrays<Index>;
  const std::size_t n = points.size();
  if (n >= std::size_t((std::numeric_limits<Index>::max)()))
    throw Too_many_cells();
  const auto point = [&](Index i) {
    const double* const p = points[std::size_t(i)];
    return std::array<double, 3>{p[0], p[1], p[2]};
  };
  const auto is_lighter = [&](Index i, Index j) {
    return weights != nullptr && weights[i] < weights[j];
  };
  std::vector<Index> sorted(n);
  std::iota(sorted.begin(), sorted.end(), Index(0));
  std::sort(sorted.begin(), sorted.end(), [&](Index i, Index j) {
    const auto p = point(i), q = point(j);
    return p != q ? p < q : is_lighter(j, i) || (!is_lighter(i, j) && i < j);
  });
  std::vector<Index> line, vertices_of_points(n);
  for (const Index i : sorted) { // of points at one place, the heaviest first
    if (line.empty() || point(line.back()) != point(i))
      line.push_back(i);
    vertices_of_points[std::size_t(i)] = is_lighter(i, line.back()) ? Arrays::none : line.back();
  }
  if (weights != nullptr)
    remove_hidden(line, points, weights, vertices_of_points);
  if (line.size() > 1)
    return Arrays(1, line.size() - 1, line.size() + 1, segments_of(line),
                  std::move(vertices_of_points));
  if (line.empty())
    return Arrays();
  Page_array<Index> rows; // a vertex, and the infinite one
  rows.allocate(16);
  std::fill(rows.data(), rows.data() + 16, Arrays::none);
  rows[0] = line.front();
  rows[4] = 1, rows[12] = 0;
  return Arrays(0, 1, 2, std::move(rows), std::move(vertices_of_points));
}

// The following puts the cells in place: finite ones first, then infinite ones, and no dead ones.
//
// Cells know the facets of their neighbours, too, so they can be moved at any time: the four places
// that name a cell are known, and no table from old to new numbers is needed. Several threads
// look for the cells that may have to move, the dead and the infinite ones, which are few if the
// points lie on a surface or fill a volume; one thread moves them. Linear.

// Tells its neighbours that a cell has been moved to place c.
inline void tell_neighbors(Compact_cell* cells, Id c)
{
  for (unsigned i = 0; i < 4; ++i) {
    const Id there = cells[c].neighbors[i];
    cells[there >> 2].neighbors[there & 3] = Compact_numbers::encode(c, i);
  }
}

inline void swap_cells(Compact_cell* cells, Id a, Id b)
{
  std::swap(cells[a], cells[b]);
  // A cell at `here` that names itself as a neighbour meant the other cell.
  const auto redirect = [&](Id here, Id former) {
    for (Id& neighbor : cells[here].neighbors)
      if ((neighbor >> 2) == here)
        neighbor = Compact_numbers::encode(former, neighbor & 3);
  };
  redirect(a, b);
  redirect(b, a);
  tell_neighbors(cells, a);
  tell_neighbors(cells, b);
}

// Returns the cells among 0, …, n - 1 for which `is` holds, in ascending order.
template <class Is>
std::vector<Id> cells_that(const Compact_cell* cells, std::size_t n, const Is& is,
                           const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, n, 65536);
  std::vector<std::vector<Id>> found(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    for (std::size_t c = first; c < last; ++c)
      if (is(cells[c]))
        found[b].push_back(Id(c));
  });
  for (std::size_t b = 1; b < blocks; ++b)
    found[0].insert(found[0].end(), found[b].begin(), found[b].end());
  return std::move(found[0]);
}

// Moves the last living cells to the places of dead ones. Returns the number of cells.
inline std::size_t close_gaps(Compact_cell* cells, std::size_t end, const Executor& executor)
{
  using Numbers = Compact_numbers;
  const std::vector<Id> dead = cells_that(
      cells, end, [](const auto& c) { return Numbers::is_dead(c); }, executor);
  const std::size_t all = end - dead.size();
  auto gap = dead.begin();
  for (std::size_t c = all; c < end; ++c)
    if (!Numbers::is_dead(cells[c])) {
      const Id to = *gap++;
      cells[to] = cells[c];
      tell_neighbors(cells, to);
    }
  return all;
}

struct Numbers_of_cells
{
  std::size_t finite, all;
};

// Puts the cells in place. The cells stored at vertices are not updated.
inline Numbers_of_cells partition_cells(Compact_cell* cells, std::size_t end,
                                        const Executor& executor)
{
  using Numbers = Compact_numbers;
  const std::size_t all = close_gaps(cells, end, executor);
  const std::vector<Id> infinite = cells_that(
      cells, all, [](const auto& c) { return Numbers::is_infinite(c); }, executor);
  const std::size_t finite = all - infinite.size();
  std::size_t place = finite;
  for (const Id c : infinite) {
    if (c >= finite)
      break;
    while (Numbers::is_infinite(cells[place]))
      ++place;
    swap_cells(cells, c, Id(place++));
  }
  return {finite, all};
}

// Returns, for each vertex, the smallest index of its points; vertex 0, which is also that of hidden
// points, and an apex have the name -1.
template <class Index>
std::vector<Index> names_of_vertices(const Built& built, const Executor& executor)
{
  std::vector<Index> names(built.number_of_places + 1, Index(-1));
  const std::size_t n = built.order.size, blocks = number_of_blocks(executor, n, 4096);
  std::vector<std::vector<std::size_t>> others(blocks); // they share the vertex of another point
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    for (std::size_t k = first; k < last; ++k)
      if (std::size_t(built.vertex_of[k]) == Compact_numbers::vertex_of_point(k))
        names[k + 1] = Index(built.order.order[k]);
      else
        others[b].push_back(k);
  });
  for (const std::vector<std::size_t>& places : others)
    for (const std::size_t k : places) { // -1 is the least of all
      Index& name = names[built.vertex_of[k]];
      name = (std::min)(name, Index(built.order.order[k]));
    }
  return names;
}

// Returns, for each point, the name of its vertex, -1 if it is hidden.
template <class Index>
std::vector<Index> vertices_of_points(const Built& built, const std::vector<Index>& names,
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

// Makes the arrays of points in a plane from the triangles at the apex.
template <class Index>
Delaunay_3_arrays<Index> arrays_at_apex(const Built& built, const Executor& executor)
{
  using Arrays = Delaunay_3_arrays<Index>;
  const std::vector<Index> names = names_of_vertices<Index>(built, executor);
  typename Arrays::Entries rows;
  const auto [finite, all] = triangles_at(built, names, rows);
  return Arrays(2, finite, all, std::move(rows), vertices_of_points(built, names, executor));
}

// Replaces vertices by these names, and neighbours by their numbers, or -1 from `end` on.
template <class Index>
void rename_vertices(Compact_cell* first, Compact_cell* last, const std::vector<Index>& names,
                     Index end)
{
  for (Compact_cell* cell = first; cell != last; ++cell) {
    for (Id& link : cell->neighbors) // in a vector
      link = Id(Index(link >> 2) < end ? Index(link >> 2) : Index(-1));
    for (Id& v : cell->v)
      v = Id(names[v]);
  }
}

// Makes the arrays of points in space, with all cells or with finite ones alone. Vertices become
// indices of points, and neighbours their numbers; the arrays reuse the memory of the cells.
template <class Index>
Delaunay_3_arrays<Index> arrays_in_space(Built& built, const Executor& executor,
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
  auto of_points = vertices_of_points(built, names, executor);
  const Memory_of_cells memory = built.take_cells();
  return Arrays(3, numbers.finite, number,
                typename Arrays::Entries(Page_array<Compact_cell>(memory.cells, memory.capacity)),
                std::move(of_points));
}

// Makes the arrays of the complex that was built, with an apex if the points lie in a plane; empty
// after a stop. Throws a std::length_error if there are more cells than an Index can number.
// Linear, with as many threads as the executor has; leaving out infinite cells costs nothing here.
template <class Index, class Source>
Delaunay_3_arrays<Index> arrays_of_built(Built& built, Source& source, const Executor& executor,
                                         bool keeps_infinite = true)
{
  static_assert(sizeof(Index) == sizeof(Id), "the arrays are made in the memory of the cells");
  if (built.outcome == Insertion_outcome::TOO_MANY_CELLS)
    throw Too_many_cells();
  if (built.outcome == Insertion_outcome::COMPLETE && !built.has_apex)
    return arrays_in_space<Index>(built, executor, keeps_infinite);
  Delaunay_3_arrays<Index> arrays;
  if (built.outcome == Insertion_outcome::COMPLETE)
    arrays = arrays_at_apex<Index>(built, executor);
  else if (built.outcome == Insertion_outcome::FLAT)
    arrays = arrays_on_line<Index>(source.points(), weights_of(source));
  if (!keeps_infinite)
    arrays.drop_infinite_cells();
  return arrays;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_BUILT_H
