// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Locally uniform subsets against all pairs of points: the sizing field, who is kept, and how far the
// points kept are from each other and the others from them.

#define BOOST_TEST_MODULE test_locally_uniform_subset
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_uniform/locally_uniform_subset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

namespace {

using Point = CGAL::Epick::Point_3;
using Points = std::vector<Point>;
using Indices = std::vector<std::size_t>;
using Sizes = std::vector<double>;
using Sizing = std::function<double(std::size_t)>;

constexpr double rounding = 1e-12;

double distance(const Point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// On a bent sheet, a hundred times as dense at one end as at the other.
Points sheet(std::size_t n, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::pow(uniform(random), 3), y = uniform(random);
    points.emplace_back(x, y, 0.2 * std::sin(5 * x + y));
  }
  return points;
}

Points lattice(int side)
{
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        points.emplace_back(x, y, z);
  return points;
}

Sizes all_sizes(const Points& points, const Sizing& sizing)
{
  Sizes sizes;
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.push_back(sizing(i));
  return sizes;
}

// The minimum over all q of f(q) + |pq|.
Sizes lipschitz_by_all_pairs(const Points& points, const Sizes& f)
{
  Sizes lowered = f;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)
      lowered[i] = (std::min)(lowered[i], distance(points[i], points[j]) + f[j]);
  return lowered;
}

Indices subset_by_all_pairs(const Points& points, const Sizes& sizes)
{
  Indices order(points.size()), kept;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return sizes[i] < sizes[j]; });
  for (const std::size_t i : order)
    if (std::none_of(kept.begin(), kept.end(), [&](std::size_t j) {
          return CGAL::squared_distance(points[i], points[j]) < sizes[j] * sizes[j] ||
                 points[i] == points[j];
        }))
      kept.push_back(i);
  std::sort(kept.begin(), kept.end());
  return kept;
}

Indices subset(const Points& points, const Sizing& sizing)
{
  return uniform::locally_uniform_subset(points, all_sizes(points, sizing));
}

void check_distances(const Points& points, const Sizes& sizes, const Indices& kept)
{
  std::size_t too_near = 0, too_far = 0;
  for (const std::size_t i : kept)
    for (const std::size_t j : kept) {
      const double d = distance(points[i], points[j]) * (1 + rounding);
      too_near +=
          i != j && (d < (std::min)(sizes[i], sizes[j]) || d < (std::max)(sizes[i], sizes[j]) / 2);
    }
  for (std::size_t i = 0; i < points.size(); ++i)
    too_far += std::none_of(kept.begin(), kept.end(), [&](std::size_t j) {
      return points[i] == points[j] || distance(points[i], points[j]) < sizes[i] * (1 + rounding);
    });
  BOOST_TEST(too_near == 0);
  BOOST_TEST(too_far == 0);
}

// Returns the number of points that are kept.
std::size_t check_subset(const Points& points, const Sizing& sizing)
{
  const Sizes sizes = lipschitz_by_all_pairs(points, all_sizes(points, sizing));
  const Indices kept = subset(points, sizing);
  BOOST_REQUIRE(std::is_sorted(kept.begin(), kept.end()));
  check_distances(points, sizes, kept);
  const Indices expected = subset_by_all_pairs(points, sizes);
  BOOST_REQUIRE(kept == expected);
  return kept.size();
}

} // namespace

BOOST_AUTO_TEST_CASE(spacing_is_that_of_all_pairs)
{
  const Points points = sheet(300, 1);
  for (const std::size_t k : {std::size_t(1), std::size_t(6), std::size_t(299), std::size_t(400)}) {
    const Sizes spacing = uniform::neighbor_spacing(points, k);
    BOOST_REQUIRE_EQUAL(spacing.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      Sizes others;
      for (std::size_t j = 0; j < 300; ++j)
        others.push_back(distance(points[i], points[j]));
      std::sort(others.begin(), others.end());
      BOOST_REQUIRE_CLOSE(spacing[i], others[(std::min)(k, std::size_t(299))], 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(sizing_is_made_lipschitz)
{
  const Points points = sheet(400, 2);
  const Sizes spacing = uniform::neighbor_spacing(points);
  std::size_t lowered = 0, steep = 0;
  for (const double factor : {1., 3., 30.}) {
    Sizes sizes = all_sizes(points, [&](std::size_t i) { return factor * spacing[i]; });
    const Sizes expected = lipschitz_by_all_pairs(points, sizes), before = sizes;
    uniform::make_lipschitz(points, sizes);
    for (std::size_t i = 0; i < points.size(); ++i) {
      BOOST_REQUIRE_CLOSE(sizes[i], expected[i], 1e-10);
      lowered += sizes[i] < before[i] * (1 - rounding);
      for (std::size_t j = 0; j < points.size(); ++j)
        steep +=
            std::abs(sizes[i] - sizes[j]) > distance(points[i], points[j]) + rounding * sizes[i];
    }
    if (factor == 1) // the spacing is 1-Lipschitz by itself
      BOOST_TEST(lowered == 0);
  }
  BOOST_TEST(lowered > 400);
  BOOST_TEST(steep == 0);
}

BOOST_AUTO_TEST_CASE(packed_and_covered)
{
  const Points points = sheet(500, 3);
  const Sizes spacing = uniform::neighbor_spacing(points, 6);
  std::size_t last = points.size();
  for (const double factor : {0.5, 1., 2., 8., 100.}) {
    const std::size_t kept =
        check_subset(points, [&](std::size_t i) { return factor * spacing[i]; });
    BOOST_TEST(kept <= last);
    last = kept;
  }
  BOOST_TEST(last < 20);

  // A function of one's own: the distance to the nearest of two poles; and none that is Lipschitz.
  const Points poles = {Point(0, 0.5, 0.3), Point(1, 0.5, 0.3)};
  check_subset(points, [&](std::size_t i) {
    return 0.3 * (std::min)(distance(points[i], poles[0]), distance(points[i], poles[1]));
  });
  check_subset(points, [](std::size_t i) { return i % 7 == 0 ? 0.01 : 10.; });
  BOOST_TEST(check_subset(points, [](std::size_t) { return 100; }) == 1);
  BOOST_TEST(check_subset(points, [](std::size_t) { return 0; }) == points.size());
}

BOOST_AUTO_TEST_CASE(ties_on_lattices)
{
  const Points points = lattice(7);
  const auto all_of_size = [&](double s) {
    return check_subset(points, [s](std::size_t) { return s; });
  };
  BOOST_TEST(all_of_size(1) == points.size()); // a neighbor at that distance is not nearer
  BOOST_TEST(all_of_size(2) < points.size() / 2);
  BOOST_TEST(all_of_size(3) < all_of_size(2));
  BOOST_TEST(all_of_size(std::nextafter(1., 2.)) < points.size());
  for (const std::size_t k : {1, 6, 12, 26}) {
    const Sizes spacing = uniform::neighbor_spacing(points, k);
    check_subset(points, [&](std::size_t i) { return spacing[i]; });
  }
}
