// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The compact kernel on a fan of 100 000 triangles and on more than 2^16 points of one sphere.

#define BOOST_TEST_MODULE test_compact_kernel_large
#include <boost/test/included/unit_test.hpp>

#include "check_equal.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <cmath>
#include <cstddef>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

BOOST_AUTO_TEST_CASE(fan)
{
  const std::size_t n = 100000;
  surfaces::Indexed_surface fan;
  fan.points.emplace_back(0, 0, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * double(i) / double(n);
    fan.points.emplace_back(std::cos(a), std::sin(a), 0);
    fan.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  const tests::Named_surface named = {"fan", fan};
  tests::Plain_case<Triangulation>(named).check<CGAL::Surface_insertion_traits_3>();
}

BOOST_AUTO_TEST_CASE(more_than_65536_points_on_one_sphere)
{
  const tests::Named_surface named = {"integer sphere", surfaces::integer_sphere(80000)};
  BOOST_TEST_REQUIRE(named.surface.points.size() > 65536u);
  tests::Plain_case<Triangulation>(named).check<CGAL::Surface_insertion_traits_3>();
}
