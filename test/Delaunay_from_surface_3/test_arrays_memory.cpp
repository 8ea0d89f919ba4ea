// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the arrays of many points need at the peak, beyond the points. A process of its own: the
// peak is what the system has counted since it began.

#define BOOST_TEST_MODULE test_arrays_memory
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/delaunay_3_arrays.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

// In bytes; 0 where the system does not say it.
std::size_t memory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kilobytes = 0;
  while (status >> word)
    if (word == name + ":")
      status >> kilobytes;
  return 1024 * kilobytes;
}

// The peak since now is counted anew, if the system allows it.
bool forget_peak()
{
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return bool(file) && memory("VmHWM") > 0;
}

template <class Work>
double bytes_per_point(std::size_t n, const Work& work)
{
  const std::size_t before = memory("VmRSS");
  work();
  return double(memory("VmHWM") - before) / double(n);
}

} // namespace

// First: once large blocks were given back, glibc takes larger ones than before from the heap,
// where what lies between them stays.
BOOST_AUTO_TEST_CASE(points_on_a_surface)
{
  if (!forget_peak())
    return;
  const auto surface = surfaces::genus_surface(1, 400000, 0.05);
  BOOST_TEST_REQUIRE(forget_peak());
  const double peak = bytes_per_point(
      surface.points.size(), [&] { CGAL::delaunay_3_arrays(surface.points, surface.faces); });
  BOOST_TEST_MESSAGE("surface: peak " << peak << " bytes per point");
  BOOST_TEST(peak < 300);
}

BOOST_AUTO_TEST_CASE(points_in_a_cube)
{
  if (!forget_peak()) {
    BOOST_TEST_MESSAGE("skipped: the system does not tell the peak");
    return;
  }
  std::mt19937_64 random(1);
  std::vector<std::array<double, 3>> points(1500000);
  for (auto& p : points)
    for (double& x : p)
      x = std::uniform_real_distribution<double>()(random);
  const std::size_t n = points.size();
  CGAL::Delaunay_3_arrays<> arrays;
  const double peak = bytes_per_point(n, [&] { arrays = CGAL::delaunay_3_arrays(points); });
  BOOST_TEST_MESSAGE(double(arrays.number_of_cells()) / double(n)
                     << " cells per point, peak " << peak << " bytes per point");
  BOOST_TEST(peak < 280);
  const std::size_t kept = memory("VmRSS");
  BOOST_TEST_REQUIRE(forget_peak());
  arrays.separate();
  const double extra = (double(memory("VmHWM")) - double(kept)) / double(n);
  BOOST_TEST_MESSAGE("to separate them: " << extra << " bytes per point more");
  BOOST_TEST(extra < 120);
  arrays.drop_neighbors();
  BOOST_TEST(memory("VmRSS") < kept - 90 * n);
}

// All of them are on the convex hull: there are two infinite cells for each.
BOOST_AUTO_TEST_CASE(infinite_cells_of_separate_arrays)
{
  if (!forget_peak())
    return;
  std::mt19937_64 random(1);
  std::vector<std::array<double, 3>> points(400000);
  for (auto& p : points) {
    for (double& x : p)
      x = std::normal_distribution<double>()(random);
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p)
      x /= length;
  }
  CGAL::Delaunay_3_arrays<> arrays = CGAL::delaunay_3_arrays(points);
  arrays.separate();
  const std::size_t infinite = arrays.number_of_cells() - arrays.number_of_simplices();
  BOOST_TEST_REQUIRE(infinite > points.size());
  const std::size_t kept = memory("VmRSS");
  arrays.drop_infinite_cells();
  const double freed = (double(kept) - double(memory("VmRSS"))) / double(infinite);
  BOOST_TEST_MESSAGE("given back: " << freed << " bytes per infinite cell");
  BOOST_TEST(freed > 24); // of 32
}
