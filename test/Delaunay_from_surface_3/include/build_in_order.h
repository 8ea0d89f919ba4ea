// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_BUILD_IN_ORDER_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_BUILD_IN_ORDER_H

// The core, without an adapter.

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Order_of_core.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace tests {

namespace core = CGAL::Delaunay_from_surface_3::internal;

// An order that is there, and may cost anything.
class Given_order final : public core::Order_source
{
public:
  explicit Given_order(CGAL::Delaunay_from_surface_3::Insertion_order order)
    : m_order(std::move(order))
  {
  }
  core::Order_view make(const core::Point_array&, const core::Executor&) override
  {
    return core::view_of(m_order);
  }
  std::size_t cells_per_point() const override { return any_number; }
  bool go_on() override { return false; }

private:
  CGAL::Delaunay_from_surface_3::Insertion_order m_order;
};

template <class Point>
std::unique_ptr<core::Built>
build_in_order(const std::vector<Point>& points,
               const CGAL::Delaunay_from_surface_3::Insertion_order& order,
               bool uses_starting_places = true)
{
  const auto coordinates = core::rounded_coordinates(points);
  Given_order orders(order);
  core::Watcher nobody;
  core::Given_points source(core::Point_array(coordinates.data(), points.size()));
  return core::build<core::One_thread>(source, orders, {false, uses_starting_places}, nobody,
                                       core::Alone());
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_BUILD_IN_ORDER_H
