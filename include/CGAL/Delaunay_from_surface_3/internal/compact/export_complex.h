// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXPORT_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXPORT_COMPLEX_H

// Writes the cells into an empty triangulation through the public interface of its data structure.
//
// Cells are made in ascending order, each linked with those made before it, so that a compact cell
// is read once and its memory can go back to the system while CGAL's grows. Linear.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/internal/support/prefetch.h>

#include <CGAL/Triangulation_hierarchy_3.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Tr>
std::true_type has_upper_levels(const Triangulation_hierarchy_3<Tr>*);
std::false_type has_upper_levels(const void*);

// The cells alone. Returns their handles by cell. Links to cells that are not made yet go to
// `scratch` and are set when these are made: which ones they are cannot be predicted.
template <class Tds, class Id, class Vertex>
Large_vector<typename Tds::Cell_handle> export_cells(Tds& tds, Compact_complex<Id>& complex,
                                                     const std::vector<Vertex>& vertices,
                                                     typename Tds::Cell_handle scratch)
{
  constexpr std::size_t release_interval = std::size_t(1) << 16;
  Large_vector<typename Tds::Cell_handle> cells(complex.cells_end(), scratch);
  const std::size_t last = cells.size() - 1;
  // So many cells ahead handles, and then what they lead to, are fetched. The distances were chosen
  // by trial; no measurement of them is kept.
  constexpr std::size_t handles_ahead = 24, cells_ahead = 8;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Id link : complex.cell((std::min)(c + handles_ahead, last)).links)
      prefetch(&cells[link >> 2]);
    for (const Id link : complex.cell((std::min)(c + cells_ahead, last)).links)
      prefetch(&*cells[link >> 2]);
    const Compact_cell<Id>& cell = complex.cell(c);
    if (Compact_complex<Id>::is_dead(cell))
      continue;
    const auto made = tds.create_cell(vertices[cell.v[0]], vertices[cell.v[1]], vertices[cell.v[2]],
                                      vertices[cell.v[3]]);
    cells[c] = made;
    for (int i = 0; i < 4; ++i) {
      const auto neighbor = cells[cell.links[i] >> 2];
      made->set_neighbor(i, neighbor);
      neighbor->set_neighbor(int(cell.links[i] & 3), made);
    }
    if (c % release_interval == 0)
      complex.release_cells_before(c);
  }
  complex.deallocate_cells();
  return cells;
}

// Fills `tr`, empty, and gives up the memory of `complex`. point(v) leads to the point of vertex v, or
// to none if that vertex is in no cell. The vertices are made in the order in which in_order(1), … first
// names them. Returns the handles by vertex, that of the infinite vertex first, and none where there is
// no vertex.
template <class Triangulation, class Id, class PointOf, class In_order>
std::vector<typename Triangulation::Vertex_handle>
export_complex(Triangulation& tr, Compact_complex<Id>& complex, const PointOf& point,
               const In_order& in_order)
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  auto& tds = tr.tds();
  std::vector<Vertex_handle> vertices(complex.vertices_end());
  vertices[0] = tr.infinite_vertex();
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    const std::size_t v = in_order(k);
    const auto* const p = vertices[v] == Vertex_handle() ? point(v) : nullptr;
    if (p != nullptr) {
      vertices[v] = tds.create_vertex();
      vertices[v]->set_point(*p);
    }
  }
  Large_vector<Id> cell_of(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    cell_of[v] = complex.vertex(v).cell;
  complex.deallocate_vertices();
  const auto only_cell = vertices[0]->cell(); // of the empty triangulation
  tds.set_dimension(3);
  const auto cells = export_cells(tds, complex, vertices, only_cell);
  tds.delete_cell(only_cell);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (vertices[v] != Vertex_handle())
      vertices[v]->set_cell(cells[cell_of[v]]);
  return vertices;
}

// Fills the upper levels of a triangulation with `Fast_location`: vertices that are inserted again
// where they are pass the draw of their level.
template <class Triangulation>
void fill_upper_levels(Triangulation& tr,
                       const std::vector<typename Triangulation::Vertex_handle>& vertices)
{
  using Has_upper_levels = decltype(has_upper_levels(static_cast<Triangulation*>(nullptr)));
  if constexpr (Has_upper_levels::value) {
    for (std::size_t v = 1; v < vertices.size(); ++v) {
      if (vertices[v] == typename Triangulation::Vertex_handle())
        continue;
      const auto c = vertices[v]->cell();
      const auto p = vertices[v]->point(); // a copy: the insertion assigns it
      tr.insert(p, Triangulation::VERTEX, c, c->index(vertices[v]), 0);
    }
  } else {
    (void)tr, (void)vertices;
  }
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_EXPORT_COMPLEX_H
