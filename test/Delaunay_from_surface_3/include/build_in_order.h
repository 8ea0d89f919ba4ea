// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_BUILD_IN_ORDER_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_BUILD_IN_ORDER_H

// The core, without an adapter.

#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace tests {

namespace core = CGAL::Delaunay_from_surface_3::core;

template <class Point>
std::unique_ptr<core::Built>
build_in_order(const std::vector<Point>& points,
               const CGAL::Delaunay_from_surface_3::Insertion_order& order,
               bool uses_starting_places = true)
{
  const auto coordinates = CGAL::Delaunay_from_surface_3::internal::rounded_coordinates(points);
  core::Given_points source(core::Point_array(coordinates.data(), points.size()));
  const core::Order_view view = core::view_of(order);
  core::Build_options options;
  options.given = &view;
  options.cells_per_point = core::Build_options::any_number;
  options.uses_starting_places = uses_starting_places;
  core::Observer nobody;
  return core::build(source, options, nobody, core::Alone());
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_BUILD_IN_ORDER_H
