// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_WRITE_ANNOUNCED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_WRITE_ANNOUNCED_H

// Writes stars while others read. The first store to a cell makes it busy, the last one tells its
// new version; a facet's outer link is set when there is something to see behind it.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Fill_star.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Id>
class Write_announced
{
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;
  using Vertex = Compact_vertex<Id>;

public:
  // Labels of n vertices. The memory is cleared page by page, where it is used: a worker sees few
  // vertices besides those of its own patches.
  explicit Write_announced(std::size_t n)
    : m_labels(static_cast<Id*>(std::calloc(n, sizeof(Id))))
  {
    if (m_labels == nullptr)
      throw std::bad_alloc();
  }

  Id& label(Vertex*, Id v) { return m_labels.get()[v]; }
  void forget_labels(const Complex& complex)
  {
    std::memset(m_labels.get(), 0, complex.vertices_end() * sizeof(Id));
  }

  static void open(Cell& cell, Id p, const Zone_facet<Id>& facet)
  {
    store_relaxed(cell.v[0], Id(p | Complex::dead));
    release_fence();
    for (unsigned k = 0; k < 3; ++k)
      store_relaxed(cell.v[k + 1], facet.corners[k]);
    store_relaxed(cell.links[0], facet.outside);
  }
  static void set_outer_link(Id& link, Id to) { store_release(link, to); }
  static void set_link(Id& link, Id to) { store_relaxed(link, to); }
  static void close(Cell& cell, Id p) { store_release(cell.v[0], p); }

  // Who destroys a cell stores later than who made it: so the cell stored last is alive.
  static void set_cell(Vertex* vertices, Id v, Id c) { store_relaxed(vertices[v].cell, c); }

  // The infinite vertex, only ever the last corner, gets none: all workers would write it.
  void set_cell_of_corners(Vertex* vertices, const Id* corners, Id c)
  {
    set_cell(vertices, corners[0], c);
    set_cell(vertices, corners[1], c);
    Id& cell = vertices[corners[2]].cell;
    store_relaxed(*(corners[2] == Complex::infinite ? &m_cell_of_infinite_vertex : &cell), c);
  }

private:
  struct Free
  {
    void operator()(Id* labels) const { std::free(labels); }
  };

  std::unique_ptr<Id[], Free> m_labels;
  Id m_cell_of_infinite_vertex; // not read
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_WRITE_ANNOUNCED_H
