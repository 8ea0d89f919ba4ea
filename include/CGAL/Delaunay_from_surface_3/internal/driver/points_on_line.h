// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_POINTS_ON_LINE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_POINTS_ON_LINE_H

// Points at one place or on one line are found before an order is made of them: there the order
// along the line is the best one, and costs least.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The first point that is another one than the first; n if there is none. Linear at worst.
template <class Point>
std::size_t first_different_point(const std::vector<Point>& points)
{
  std::size_t i = 1;
  while (i < points.size() && points[i] == points[0])
    ++i;
  return (std::min)(i, points.size());
}

// Exact. Linear at worst, a few tests as a rule.
template <class GeomTraits, class Point>
bool are_on_one_line(const GeomTraits& gt, const std::vector<Point>& points)
{
  const std::size_t b = first_different_point(points);
  const auto coplanar_orientation = gt.coplanar_orientation_3_object();
  for (std::size_t i = b + 1; i < points.size(); ++i)
    if (coplanar_orientation(points[0], points[b], points[i]) != COLLINEAR)
      return false;
  return true;
}

// One round along the axis in which two different points are farthest from each other; of equal
// points the one with the smallest index first.
template <class Point>
Insertion_order order_along_line(const std::vector<Point>& points)
{
  const auto coordinates = [](const Point& p) {
    return std::array<double, 3>{to_double(p.x()), to_double(p.y()), to_double(p.z())};
  };
  Insertion_order plan;
  if (points.empty())
    return plan;
  const std::size_t other = first_different_point(points);
  std::size_t axis = 0;
  if (other < points.size()) {
    const auto a = coordinates(points[0]), b = coordinates(points[other]);
    for (std::size_t c = 1; c < 3; ++c)
      if (std::abs(b[c] - a[c]) > std::abs(b[axis] - a[axis]))
        axis = c;
  }
  std::vector<std::pair<double, std::size_t>> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    places[i] = {coordinates(points[i])[axis], i};
  if (!std::is_sorted(places.begin(), places.end()))
    std::sort(places.begin(), places.end());
  plan.order.reserve(points.size());
  for (const auto& place : places)
    plan.order.push_back(place.second);
  plan.round_ends.push_back(points.size());
  return plan;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_POINTS_ON_LINE_H
