// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ROUNDED_COORDINATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ROUNDED_COORDINATES_H

#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// x, y and z of one point after the other, as doubles near them.
template <class Point>
Large_vector<double> rounded_coordinates(const std::vector<Point>& points)
{
  Large_vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point& p : points) {
    coordinates.push_back(to_double(p.x()));
    coordinates.push_back(to_double(p.y()));
    coordinates.push_back(to_double(p.z()));
  }
  return coordinates;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ROUNDED_COORDINATES_H
