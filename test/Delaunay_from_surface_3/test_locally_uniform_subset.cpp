// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Locally uniform subsets against all pairs of points: the sizing field, who is kept, how far the
// points kept are from each other and the others from them; and input that is degenerate or refused.

#define BOOST_TEST_MODULE test_locally_uniform_subset
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/locally_uniform_subset_3.h>
#include <CGAL/neighbor_spacing_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
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
  Indices kept;
  CGAL::locally_uniform_subset_3(points, sizing, std::back_inserter(kept));
  return kept;
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

template <class Range>
void check_refused(const Range& points, const Sizing& sizing)
{
  Indices kept;
  BOOST_CHECK_THROW(CGAL::locally_uniform_subset_3(points, sizing, std::back_inserter(kept)),
                    CGAL::Surface_input_error);
  BOOST_TEST(kept.empty());
}

} // namespace

BOOST_AUTO_TEST_CASE(spacing_is_that_of_all_pairs)
{
  Points points = sheet(300, 1);
  points.insert(points.end(), points.begin(), points.begin() + 50); // equal ones count as one
  for (const std::size_t k : {std::size_t(1), std::size_t(6), std::size_t(299), std::size_t(-1)}) {
    const Sizes spacing = CGAL::neighbor_spacing_3(points, k);
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
  std::vector<DFS::internal::Plain_point> plain;
  for (const Point& p : points)
    plain.emplace_back(p.x(), p.y(), p.z());
  const Sizes spacing = CGAL::neighbor_spacing_3(points);
  std::size_t lowered = 0, steep = 0;
  for (const double factor : {1., 3., 30.}) {
    Sizes sizes = all_sizes(points, [&](std::size_t i) { return factor * spacing[i]; });
    const Sizes expected = lipschitz_by_all_pairs(points, sizes), before = sizes;
    DFS::internal::make_lipschitz(plain, sizes);
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
  const Sizes spacing = CGAL::neighbor_spacing_3(points, 6);
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
    const Sizes spacing = CGAL::neighbor_spacing_3(points, k);
    check_subset(points, [&](std::size_t i) { return spacing[i]; });
  }
}

BOOST_AUTO_TEST_CASE(degenerate_input)
{
  const auto one = [](std::size_t) { return 1.; };
  BOOST_TEST(subset({}, one).empty());
  BOOST_TEST(CGAL::neighbor_spacing_3(Points()).empty());
  BOOST_TEST(subset({Point(1, 2, 3)}, one) == Indices{0});
  BOOST_TEST(CGAL::neighbor_spacing_3(Points{Point(1, 2, 3)}) == Sizes{0});

  // Of equal points the first, whatever its size; the smallest size counts.
  const Points equal(5, Point(1, 2, 3));
  BOOST_TEST(subset(equal, one) == Indices{0});
  BOOST_TEST(subset(equal, [](std::size_t) { return 0.; }) == Indices{0});
  BOOST_TEST(CGAL::neighbor_spacing_3(equal) == Sizes(5, 0));
  Points twice = sheet(200, 4);
  twice.insert(twice.end(), twice.rbegin(), twice.rend());
  check_subset(twice, [](std::size_t i) { return i < 200 ? 0.2 : 0.1; });

  Points line;
  for (int i = 0; i < 100; ++i)
    line.emplace_back(i, 0, 0);
  BOOST_TEST(check_subset(line, [](std::size_t) { return 10; }) == 10);
}

BOOST_AUTO_TEST_CASE(refused_before_anything_is_written)
{
  const Points points = sheet(50, 5);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1., -1e-300, infinity, -infinity, std::nan("")})
    check_refused(points, [&](std::size_t i) { return i == 49 ? bad : 0.1; });
  for (const double bad : {infinity, std::nan(""), 1e200}) {
    Points with_bad = points;
    with_bad.emplace_back(0, bad, 0);
    check_refused(with_bad, [](std::size_t) { return 1.; });
    BOOST_CHECK_THROW(CGAL::neighbor_spacing_3(with_bad), CGAL::Surface_input_error);
  }
}

BOOST_AUTO_TEST_CASE(other_points)
{
  const Points points = sheet(200, 6);
  const Sizing sizing = [](std::size_t) { return 0.2; };
  const Indices expected = subset(points, sizing);
  std::vector<CGAL::Epeck::Point_3> exact;
  std::vector<std::pair<int, Point>> pairs;
  for (const Point& p : points) {
    exact.emplace_back(p.x(), p.y(), p.z());
    pairs.emplace_back(int(pairs.size()), p);
  }
  Indices kept;
  CGAL::locally_uniform_subset_3(exact, sizing, std::back_inserter(kept));
  BOOST_TEST(kept == expected);
  kept.clear();
  const auto np =
      CGAL::parameters::point_map(CGAL::Second_of_pair_property_map<std::pair<int, Point>>());
  CGAL::locally_uniform_subset_3(pairs, sizing, std::back_inserter(kept), np);
  BOOST_TEST(kept == expected);
  BOOST_TEST(CGAL::neighbor_spacing_3(pairs, 5, np) == CGAL::neighbor_spacing_3(points, 5));
}
