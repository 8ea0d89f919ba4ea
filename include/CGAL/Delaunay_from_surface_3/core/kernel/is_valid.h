// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_VALID_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_VALID_H

// Checks a complex by levels: neighbours, Euler's formula at each vertex, orientations, and the
// Delaunay property.

#include <CGAL/Delaunay_from_surface_3/Delaunay_validity_level.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Checks whether the link of each vertex is a sphere, for tetrahedra whose facets are shared by two
// each. The link is a closed surface with as many triangles as the vertex has cells, f, and as many
// vertices as it has neighbours, v. It has 3 f / 2 edges, so v - f / 2 is its Euler characteristic.
// A connected surface has 2 only if it is a sphere. Several components have more together, unless
// they have handles, too; such a link goes unnoticed.
//
// Cells are given by vertex_of(c, k), and vertices are 0, …, n - 1. Cost: linear time, and 24 bytes
// per cell and 20 per vertex if a Number has 32 bits.
template <class Number, class VertexOf>
bool are_links_spheres(std::size_t number_of_cells, std::size_t n, const VertexOf& vertex_of,
                       const Executor& executor)
{
  if (std::uint64_t(number_of_cells) > (std::numeric_limits<Number>::max)() / 6)
    return are_links_spheres<std::uint64_t>(number_of_cells, n, vertex_of, executor);
  Steps step(executor);
  const auto for_each_edge = [&](const auto& f) {
    for (std::size_t c = 0; c < number_of_cells; ++c, step()) {
      const Number v[4] = {vertex_of(c, 0), vertex_of(c, 1), vertex_of(c, 2), vertex_of(c, 3)};
      for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < i; ++j)
          f((std::min)(v[i], v[j]), (std::max)(v[i], v[j]));
    }
  };
  Sort_into_lists<Number> sort(n, 1, executor);
  sort.count([&](std::size_t, Number* numbers) {
    for_each_edge([&](Number v, Number) { ++numbers[v]; });
  });
  const Lists<Number> larger_ends = sort.place([&](std::size_t, Number* places, Number* items) {
    for_each_edge([&](Number v, Number w) { items[places[v]++] = w; });
  });
  std::vector<Number> number_of_neighbors(n, 0), number_of_cells_at(n, 0), met_by(n, Number(n));
  for (std::size_t c = 0; c < number_of_cells; ++c)
    for (unsigned k = 0; k < 4; ++k)
      ++number_of_cells_at[vertex_of(c, k)];
  for (std::size_t v = 0; v < n; ++v)
    for (const Number* w = larger_ends.begin(v); w != larger_ends.end(v); ++w, step())
      if (std::exchange(met_by[std::size_t(*w)], Number(v)) != Number(v)) {
        ++number_of_neighbors[v];
        ++number_of_neighbors[std::size_t(*w)];
      }
  for (std::size_t v = 0; v < n; ++v)
    if (number_of_cells_at[v] > 0 &&
        2 * std::uint64_t(number_of_neighbors[v]) != std::uint64_t(number_of_cells_at[v]) + 4)
      return false;
  return true;
}

// Returns true if no cell is in conflict with the vertex across any of its facets. Neighbours and
// vertices must be valid. Cost: linear.
template <class Vertex>
bool is_delaunay(const Compact_complex<Vertex>& complex)
{
  using Complex = Compact_complex<Vertex>;
  Insertion_counts uncounted;
  Compact_predicates<Vertex> predicates(complex, uncounted);
  for (std::size_t c = 0; c < complex.cells_end(); ++c) {
    const Compact_cell& cell = complex.cell(c);
    for (unsigned k = 0; !Complex::is_dead(cell) && k < 4; ++k) {
      const Id across = complex.cell(cell.neighbors[k] >> 2).v[cell.neighbors[k] & 3];
      if (across != Complex::infinite && predicates.is_in_conflict(cell, across))
        return false;
    }
  }
  return true;
}

template <class Vertex>
bool are_links_spheres(const Compact_complex<Vertex>& complex)
{
  using Complex = Compact_complex<Vertex>;
  std::vector<Id> cells;
  for (std::size_t c = 0; c < complex.cells_end(); ++c)
    if (!Complex::is_dead(complex.cell(c)))
      cells.push_back(Id(c));
  return are_links_spheres<Id>(
      cells.size(), complex.vertices_end(),
      [&](std::size_t i, unsigned k) { return complex.cell(cells[i]).v[k]; }, Alone());
}

template <class Vertex>
bool are_finite_cells_positive(const Compact_complex<Vertex>& complex)
{
  using Complex = Compact_complex<Vertex>;
  const auto at = [&](Id v) { return position_of(complex.exact_place(v)); };
  for (std::size_t c = 0; c < complex.cells_end(); ++c) {
    const Compact_cell& cell = complex.cell(c);
    if (!Complex::is_dead(cell) && !Complex::is_infinite(cell) &&
        orientation(at(cell.v[0]), at(cell.v[1]), at(cell.v[2]), at(cell.v[3])) <= 0)
      return false;
  }
  return true;
}

// Checks as much as the level says, but not whether cells overlap. Cost: linear.
template <class Vertex>
bool is_valid(const Compact_complex<Vertex>& complex, Delaunay_validity_level level)
{
  using Level = Delaunay_validity_level;
  return complex.is_valid() && (level < Level::EULER || are_links_spheres(complex)) &&
         (level < Level::ORIENTATION || are_finite_cells_positive(complex)) &&
         (level < Level::DELAUNAY || is_delaunay(complex));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_IS_VALID_H
