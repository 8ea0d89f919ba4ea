// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_DOUBLE_COORDINATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_DOUBLE_COORDINATES_H

// Coordinates of any number type, as doubles where they are doubles.

#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Coordinate_intervals = std::array<std::pair<double, double>, 3>;

// Whether a point holds intervals around its coordinates. Points of lazy kernels do; to ask these
// for a coordinate would make a number of it first.
template <class Point>
using Interval_of_x = decltype(std::declval<const Point&>().approx().x().pair());

template <class Point>
constexpr bool has_intervals = is_detected<Interval_of_x, Point>;

// Whether every number of the type is a double.
template <class FT>
constexpr bool is_at_most_double = std::is_floating_point<FT>::value &&
                                   sizeof(FT) <= sizeof(double);

// Intervals that contain the coordinates.
template <class Point>
Coordinate_intervals coordinate_intervals(const Point& p)
{
  if constexpr (has_intervals<Point>) {
    const auto q = p.approx();
    return {q.x().pair(), q.y().pair(), q.z().pair()};
  } else {
    return {CGAL::to_interval(p.x()), CGAL::to_interval(p.y()), CGAL::to_interval(p.z())};
  }
}

// The double that is equal to x, if there is one. A lazy number is computed exactly by the
// comparison, and its interval is the narrowest after it.
template <class FT>
std::optional<double> equal_double(const FT& x)
{
  if (const double d = CGAL::to_double(x); is_finite_number(d) && FT(d) == x)
    return d;
  const std::pair<double, double> interval = CGAL::to_interval(x);
  if (interval.first == interval.second)
    return interval.first;
  return std::nullopt;
}

// The coordinates of p if they are all doubles.
template <class Point>
std::optional<std::array<double, 3>> double_coordinates(const Point& p)
{
  using FT = std::decay_t<decltype(p.x())>;
  if constexpr (is_at_most_double<FT>) {
    return {{double(p.x()), double(p.y()), double(p.z())}};
  } else {
    const Coordinate_intervals intervals = coordinate_intervals(p);
    std::array<double, 3> coordinates;
    for (std::size_t c = 0; c < 3; ++c) {
      coordinates[c] = intervals[c].first;
      if (intervals[c].first == intervals[c].second)
        continue;
      const std::optional<double> d = equal_double(c == 0 ? p.x() : c == 1 ? p.y() : p.z());
      if (!d)
        return std::nullopt;
      coordinates[c] = *d;
    }
    return coordinates;
  }
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_DOUBLE_COORDINATES_H
