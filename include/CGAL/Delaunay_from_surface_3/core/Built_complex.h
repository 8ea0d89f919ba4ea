// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILT_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILT_COMPLEX_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Watcher.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/view_of_order.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The core's side of what build() makes.
template <class Id>
class Built_complex final : public Built<Id>
{
public:
  // Keeps an order that has no other owner.
  Order_view keep(Insertion_order&& order)
  {
    m_order = std::move(order);
    return view_of(m_order);
  }

  // The complex of the points in the order, and its first four.
  void start(const Point_array& points, const double* apex, Watcher& watcher,
             const Executor& executor)
  {
    m_points = Ordered_complex<Id>(points, this->order, apex, watcher, executor);
    this->has_apex = apex != nullptr;
    show();
  }

  Ordered_complex<Id>& points() { return m_points; }

  // To be called when cells have come.
  void show()
  {
    this->vertex_of = m_points.vertex_of.data();
    this->number_of_places = m_points.vertex_of.size();
    this->cells = m_points.complex.cells();
    this->cells_end = m_points.complex.cells_end();
    this->vertices = m_points.complex.vertices();
    this->vertices_end = m_points.complex.vertices_end();
  }

  void release_cells(std::size_t first, std::size_t last) override
  {
    m_points.complex.memory_of_cells().release(first, last);
  }
  void give_up_cells() override { m_points.complex.memory_of_cells().deallocate(); }
  void give_up_vertices() override { m_points.complex.memory_of_vertices().deallocate(); }
  Compact_cell<Id>* take_cells(std::size_t& capacity) override
  {
    return m_points.complex.memory_of_cells().give_away(capacity);
  }

private:
  Ordered_complex<Id> m_points;
  Insertion_order m_order;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILT_COMPLEX_H
