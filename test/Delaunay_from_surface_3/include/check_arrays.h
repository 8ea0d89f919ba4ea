// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_ARRAYS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_ARRAYS_H

#include "mistake_in_arrays.h"

#include <boost/test/unit_test.hpp>

#include <vector>

namespace tests {
namespace arrays {

template <class Index>
void check_arrays(const CGAL::Delaunay_3_arrays<Index>& arrays, const std::vector<Point>& points)
{
  BOOST_TEST(mistake_in_arrays(arrays, points) == "");
}

} // namespace arrays
} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_ARRAYS_H
