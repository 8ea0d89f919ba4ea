// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_READ_DISTINCT_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_READ_DISTINCT_POINTS_H

// The points of a user's range, checked, where only distances between them are asked for.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/samples/Distinct_points.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class PointRange, class NamedParameters>
Distinct_points read_distinct_points(const PointRange& items, const NamedParameters& np)
{
  using Item = typename std::iterator_traits<decltype(std::begin(items))>::value_type;
  const auto point_map = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::point_map), Identity_property_map<const Item>());
  std::vector<Plain_point> points;
  Bbox_3 box;
  for (const auto& item : items) {
    const auto& p = get(point_map, item);
    check_point(p, points.size());
    points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    box += points.back().bbox();
  }
  if (!points.empty() &&
      !std::isfinite(squared_length_between({box.xmin(), box.ymin(), box.zmin()},
                                            {box.xmax(), box.ymax(), box.zmax()})))
    throw Surface_input_error("the points are too far from each other: the square of their "
                              "distance is too large for a double");
  return Distinct_points(points);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_READ_DISTINCT_POINTS_H
