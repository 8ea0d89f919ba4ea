// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_ARRAYS_BY_THREADS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_ARRAYS_BY_THREADS_H

// delaunay_3_arrays() by threads of the standard library.

#include "Thread_executor.h"

#include <CGAL/delaunay_3_arrays.h>
#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#include <CGAL/Delaunay_from_surface_3/core/build_by_threads.h>
#endif

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tests {

template <class Point>
CGAL::Delaunay_3_arrays<std::int32_t> arrays_by_threads(std::size_t number,
                                                        const std::vector<Point>& points)
{
  namespace internal = CGAL::Delaunay_from_surface_3::internal;
  std::vector<double> coordinates;
  for (const Point& p : points)
    for (const int k : {0, 1, 2})
      coordinates.push_back(p[k]);
  internal::Given_points source(internal::Point_array(coordinates.data(), points.size()));
  return internal::insert_into_arrays<std::int32_t>(
      source, nullptr, std::nullopt, Thread_executor(number), CGAL::parameters::default_values());
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_ARRAYS_BY_THREADS_H
