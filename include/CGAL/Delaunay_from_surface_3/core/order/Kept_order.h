// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_KEPT_ORDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_KEPT_ORDER_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_source.h>
#include <CGAL/Delaunay_from_surface_3/core/order/is_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/view_of_order.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The order of the last call, for points that have moved a little: the caller keeps it from call to
// call. Where there is none yet, or it is one of fewer or more points, or it costs too much by now,
// a new one is made and kept.
class Kept_order final : public Order_source
{
public:
  // Keeps a reference.
  Kept_order(Insertion_order& kept, std::unique_ptr<Order_source> source)
    : m_kept(kept)
    , m_source(std::move(source))
  {
  }

  Order_view make(const Point_array& points, const Executor& executor) override
  {
    m_is_given = !m_is_spent && m_kept.order.size() == points.size();
    if (!m_is_given)
      m_kept = copy_of(m_source->make(points, executor));
    else if (!is_order(m_kept, points.size()))
      throw Surface_input_error("what is given as the order of the points is none");
    return view_of(m_kept);
  }
  std::size_t cells_per_point() const override { return m_source->cells_per_point(); }
  bool is_spread() const override { return m_source->is_spread(); }
  bool go_on() override
  {
    m_is_spent = true;
    return m_is_given || m_source->go_on(); // a given order is followed by the first of the source
  }

private:
  Insertion_order& m_kept;
  std::unique_ptr<Order_source> m_source;
  bool m_is_given = false; // by the caller
  bool m_is_spent = false; // the given order costs too much
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_KEPT_ORDER_H
