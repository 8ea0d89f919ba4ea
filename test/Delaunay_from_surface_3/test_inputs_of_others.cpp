// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points with which other programs loop, crash, take very long or give something else, rebuilt from
// the reports; and the table of fixed inputs, by one to eight threads. All equal to plain CGAL's, by
// not many more tests per point than random points take.

#define BOOST_TEST_MODULE test_inputs_of_others
#include <boost/test/included/unit_test.hpp>

#include "arrays_by_threads.h"
#include "fixed_inputs.h"
#include "mistake_in_arrays.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/delaunay_3_arrays.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace {

using tests::arrays::Point;
using Points = std::vector<Point>;

struct Counting_visitor : CGAL::Default_surface_insertion_visitor_3
{
  CGAL::Delaunay_from_surface_3::Insertion_counts counts;

  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints&)
  {
    counts = target.counts();
  }
};

// Cells tested for each point, those on the way to it included.
double tests_per_point(const Points& points)
{
  Counting_visitor visitor;
  const auto arrays = CGAL::delaunay_3_arrays(points, CGAL::parameters::visitor(std::ref(visitor)));
  return double(visitor.counts.sphere_tests + visitor.counts.cells_tested_to_start) /
         double(arrays.number_of_vertices());
}

void check(const Points& points)
{
  BOOST_TEST(tests::arrays::mistake_in_arrays(CGAL::delaunay_3_arrays(points), points) == "");
  BOOST_TEST(tests::arrays::mistake_in_arrays(tests::arrays_by_threads(8, points), points) == "");
}

Points in_cube(std::size_t n)
{
  CGAL::Random random(1);
  Points points;
  while (points.size() < n)
    points.emplace_back(random.get_double(), random.get_double(), random.get_double());
  return points;
}

// Next to as many random points.
void check_tests(const Points& points, double most)
{
  const double tests = tests_per_point(points), random = tests_per_point(in_cube(points.size()));
  BOOST_TEST_MESSAGE(points.size()
                     << " points, tests per point " << tests << ", of random points " << random);
  BOOST_TEST(tests < most * random);
}

// A wall and a bottom, as a scanner sees them.
Points mug(std::size_t n)
{
  CGAL::Random random(2);
  Points points;
  while (points.size() < n) {
    const double a = random.get_double(0, 6.283185307179586), h = random.get_double(0, 1.5);
    const double r = h < 1.2 ? .5 : .5 * std::sqrt(random.get_double());
    const double noise = random.get_double(-.002, .002);
    points.emplace_back((r + noise) * std::cos(a), (r + noise) * std::sin(a), h < 1.2 ? h : noise);
  }
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(fixed_inputs_by_any_number_of_threads)
{
  for (const tests::Fixed_input& input : tests::fixed_inputs) {
    const auto points = tests::points_of(input);
    BOOST_TEST(tests::line_of(input.name, CGAL::delaunay_3_arrays(points)) ==
               tests::line_of(input));
    for (std::size_t threads = 2; threads <= 8; ++threads)
      BOOST_TEST(tests::line_of(input.name, tests::arrays_by_threads(threads, points)) ==
                 tests::line_of(input));
  }
}

// Geogram 358: a walk went round and round where products were fused.
BOOST_AUTO_TEST_CASE(vertices_of_a_cone)
{
  for (const int n : {3, 4, 6, 7, 12, 16, 24, 32, 60, 64, 100, 360})
    for (const double tilt : {0., .3}) {
      Points points = {{0, -std::sin(tilt), std::cos(tilt)}, {0, 0, 0}};
      for (int i = 0; i < n; ++i) {
        const double a = 6.283185307179586 * i / n, y = std::sin(a);
        points.emplace_back(std::cos(a), y * std::cos(tilt), y * std::sin(tilt));
      }
      BOOST_TEST_CONTEXT(n << " vertices, tilted by " << tilt)
      check(points);
    }
}

// Geogram 108: threads crashed or looped over nine points, an octahedron among them.
BOOST_AUTO_TEST_CASE(nine_points)
{
  const Points octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Points others[] = {{{0, 0, 0}, {2, 0, 0}, {-2, 0, 0}},
                           {{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}},
                           {{0, 0, 2}, {0, 0, 3}, {0, 0, 4}},
                           {{1, 1, 1}, {1, 1, -1}, {-1, -1, 0}}};
  for (const Points& three : others) {
    Points points = octahedron;
    points.insert(points.end(), three.begin(), three.end());
    for (int turn = 0; turn < 9; ++turn) {
      std::rotate(points.begin(), points.begin() + 1, points.end());
      check(points);
    }
  }
}

// SciPy 16094: cells that overlap, in a grid of 18 points.
BOOST_AUTO_TEST_CASE(a_small_grid)
{
  for (const double step : {8., .1, 1e-7}) {
    Points points;
    for (int i = 0; i < 18; ++i)
      points.emplace_back(step * (i / 6), step * (i / 2 % 3), step * (i % 2));
    check(points);
  }
}

// SciPy 11133: a mesh that was sampled took a night, with noise too.
BOOST_AUTO_TEST_CASE(a_sampled_mesh)
{
  CGAL::Random random(3);
  for (const double noise : {0., .1}) {
    Points points; // of a box of squares, each sampled in single precision
    while (points.size() < 6000) {
      double p[3];
      for (double& c : p)
        c = random.get_double(-1, 1);
      p[points.size() % 3] = points.size() % 2 == 0 ? 1 : -1;
      for (double& c : p)
        c = double(float(c + noise * random.get_double(-1, 1)));
      points.emplace_back(p[0], p[1], p[2]);
    }
    check(points);
    check_tests(points, 1.5);
  }
}

// Open3D 6482, Qhull 146: a mug took fifty times as long with a lid, all in one plane.
BOOST_AUTO_TEST_CASE(a_mug_with_a_lid)
{
  const std::size_t n = 8000;
  Points points = mug(n);
  const double without_lid = tests_per_point(points);
  CGAL::Random random(4);
  while (points.size() < n + n / 20) {
    const double x = random.get_double(-.5, .5), y = random.get_double(-.5, .5);
    if (x * x + y * y < .25)
      points.emplace_back(x, y, 1.2);
  }
  check(points);
  check_tests(points, 1.5);
  BOOST_TEST(tests_per_point(points) < 1.5 * without_lid);
}

// Near duplicates: neighbours in single precision, as scanners and exporters write them.
BOOST_AUTO_TEST_CASE(near_duplicates_in_single_precision)
{
  CGAL::Random random(5);
  Points points;
  while (points.size() < 6000) {
    float p[3];
    for (float& c : p)
      c = float(random.get_double(-100, 100));
    for (int k = 0; k < 3; ++k) {
      points.emplace_back(p[0], p[1], p[2]);
      p[k] = std::nextafter(p[k], 1000.f);
    }
  }
  check(points);
  check_tests(points, 1.5);
}
