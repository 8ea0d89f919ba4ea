// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// periodic_delaunay_3_arrays() gives the cells of CGAL's periodic triangulations and, where these are not
// meant for such boxes, those of a triangulation of many copies by exact numbers.

#define BOOST_TEST_MODULE test_periodic
#include <boost/test/included/unit_test.hpp>

#include "Thread_executor.h"
#include "check_copy_signs.h"
#include "periodic_cells.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/periodic_delaunay_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/Periodic_3_regular_triangulation_3.h>
#include <CGAL/Periodic_3_regular_triangulation_traits_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using CGAL::periodic_delaunay_3_arrays;
using CGAL::periodic_regular_3_arrays;
using namespace tests::periodic;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double none = std::numeric_limits<double>::infinity();

class Random
{
public:
  explicit Random(unsigned seed)
    : m_engine(seed)
  {
  }
  double operator()() { return double(m_engine()) / 4294967296.; } // from 0 to 1
  int integer(int n) { return int(m_engine() % unsigned(n)); }     // 0, …, n - 1

private:
  std::mt19937 m_engine;
};

Points random_points(std::size_t n, const Box& box = {1, 1, 1}, unsigned seed = 1)
{
  Random random(seed);
  Points points(n);
  for (Coordinates& p : points)
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = random() * (std::isfinite(box[a]) ? box[a] : 1);
  return points;
}

// Rounded, where the side is no power of 2; `share` of it.
Points lattice(int side, double period, double share = 1, unsigned seed = 1)
{
  Random random(seed);
  Points points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k)
        if (random() < share)
          points.push_back({i * period / side, j * period / side, k * period / side});
  return points;
}

// Dense in the middle, which may be a corner of the box.
Points plummer(std::size_t n, double period, double middle, unsigned seed = 1)
{
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = .01 / std::sqrt(std::pow(random() + 1e-6, -2. / 3) - 1 + 1e-9);
    const double z = 2 * random() - 1, f = 6.283185307179586 * random(), q = std::sqrt(1 - z * z);
    Coordinates p = {middle + r * q * std::cos(f), middle + r * q * std::sin(f), middle + r * z};
    for (double& x : p) {
      x = period * (x - std::floor(x));
      x = x < period ? x : 0;
    }
    points.push_back(p);
  }
  return points;
}

Points moved(Points points, const Coordinates& by)
{
  for (Coordinates& p : points)
    for (std::size_t a = 0; a < 3; ++a)
      p[a] += by[a];
  return points;
}

Points times(Points points, double factor)
{
  for (Coordinates& p : points)
    for (double& x : p)
      x *= factor;
  return points;
}

Outcome by_cgal(const Points& points, double period, double low = 0)
{
  using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
  std::vector<Kernel::Point_3> given;
  for (const Coordinates& p : points)
    given.emplace_back(p[0], p[1], p[2]);
  const double high = low + period;
  const CGAL::Periodic_3_Delaunay_triangulation_3<Traits> tr(
      given.begin(), given.end(), Traits::Iso_cuboid_3(low, low, low, high, high, high));
  return outcome_of_periodic(tr, points);
}

// What is wrong, compared with CGAL's periodic triangulation in a cube.
std::string mistake_in_cube(const Points& points, double period, double low = 0)
{
  const Box box = {period, period, period};
  return mistake_in(periodic_delaunay_3_arrays(points, box), by_cgal(points, period, low), points,
                    {}, box);
}

// Compared with many copies.
std::string mistake(const Points& points, const Box& box, const Weights& weights = {})
{
  const Arrays arrays = weights.empty() ? periodic_delaunay_3_arrays(points, box)
                                        : periodic_regular_3_arrays(points, weights, box);
  return mistake_in(arrays, by_many_copies(points, weights, box), points, weights, box);
}

std::string message_of(const Points& points, const Box& box)
{
  try {
    periodic_delaunay_3_arrays(points, box);
  } catch (const CGAL::Surface_input_error& e) {
    return e.what();
  }
  return "";
}

bool starts_with(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

} // namespace

// --- next to CGAL's Periodic_3_Delaunay_triangulation_3 ------------------------------------------

BOOST_AUTO_TEST_CASE(random_points_in_cubes)
{
  for (const double period : {1., 10., 6.283185307179586, 1. / 3})
    BOOST_TEST(mistake_in_cube(random_points(100, {period, period, period}), period) == "");
  BOOST_TEST(mistake_in_cube(random_points(800), 1) == "");
  for (const std::size_t n : {1, 2, 3, 5, 12, 60})
    BOOST_TEST(mistake_in_cube(random_points(n, {1, 1, 1}, unsigned(n)), 1) == "", n << " points");
  for (const double middle : {.5, 0.})
    BOOST_TEST(mistake_in_cube(plummer(150, 10, middle), 10) == "");
}

BOOST_AUTO_TEST_CASE(centered_boxes)
{
  for (const double period : {1., 10.}) {
    const Points points =
        moved(random_points(60, {period, period, period}), {-period / 2, -period / 2, -period / 2});
    BOOST_TEST(mistake_in_cube(points, period, -period / 2) == "");
  }
}

BOOST_AUTO_TEST_CASE(lattices)
{
  for (const double period : {1., .3})
    for (const double share : {1., .6})
      BOOST_TEST(mistake_in_cube(lattice(2, period, share), period) == "", period << " " << share);
  BOOST_TEST(mistake_in_cube(lattice(3, 6.283185307179586, .6), 6.283185307179586) == "");
  BOOST_TEST(mistake_in_cube(lattice(4, 8, .7), 8) == "");
  BOOST_TEST(mistake_in_cube(lattice(1, 1), 1) == "");
  BOOST_TEST(mistake_in_cube(lattice(8, 1), 1) == "");
}

// --- next to many copies -------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(points_on_the_walls)
{
  Random random(5);
  for (int round = 0; round < 4; ++round) {
    Points points;
    for (int i = 0; i < 8; ++i) {
      Coordinates p;
      for (double& x : p)
        x = random.integer(3) == 0 ? random() : random.integer(2);
      points.push_back(p);
    }
    BOOST_TEST(mistake(points, {1, 1, 1}) == "");
    BOOST_TEST(mistake(times(points, .1), {.1, .1, .1}) == "");
  }
  const Arrays arrays = periodic_delaunay_3_arrays( // all corners are one point
      Points{{1, 1, 1}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 2, 5}}, Box{1, 1, 1});
  BOOST_TEST(arrays.number_of_vertices() == 1u);
  BOOST_TEST(arrays.number_of_simplices() == 6u);
  BOOST_TEST(arrays.vertex_of_point(4) == 0);
  BOOST_TEST(!arrays.is_simplicial_complex());
}

BOOST_AUTO_TEST_CASE(points_far_outside)
{
  Points points = random_points(12, {8, 8, 8});
  for (Coordinates& p : points)
    for (double& x : p)
      x = std::floor(1024 * x) / 1024; // so that no sum is rounded
  Random random(3);
  for (const int most : {1, 5, 16000}) {
    Points far = points;
    for (Coordinates& p : far)
      for (double& x : p)
        x += 8. * (random.integer(2 * most + 1) - most);
    BOOST_TEST(mistake(far, {8, 8, 8}) == "");
  }
  BOOST_TEST(mistake(moved(points, {0x1p31, -0x1p31, 0x1p30}), {8, 8, 8}) == "");
  points[3][1] += 8. * 100000;
  BOOST_TEST(message_of(points, {8, 8, 8}).find("too many periods apart") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(slabs_wires_and_other_boxes)
{
  const Box boxes[] = {{1, 1, none},    {1, none, 1},   {none, 2, 1}, {none, none, 1},
                       {1, none, none}, {1, 1.7, 1.25}, {2, 1, 1},    {1, 3, .7},
                       {none, .1, .3},  {1, 1, 5},      {3, 4, none}, {.1, .2, .3},
                       {none, 4, none}};
  for (const Box& box : boxes)
    BOOST_TEST_CONTEXT("box " << box[0] << " " << box[1] << " " << box[2])
    {
      BOOST_TEST(mistake(random_points(9, box), box) == "");
      Points few = random_points(4, box, 2);
      for (Coordinates& p : few)
        for (std::size_t a = 0; a < 3; ++a)
          p[a] = std::round(2 * p[a] / (std::isfinite(box[a]) ? box[a] : 1)) *
                 (std::isfinite(box[a]) ? box[a] : 1) / 2;
      few.push_back({.123, .1, .05}); // so that they are not flat
      few.push_back({.223, .15, .07});
      few.push_back({.1, .18, .09});
      BOOST_TEST(mistake(few, box) == "");
    }
}

// The tops of slabs are flat, or nearly so.
BOOST_AUTO_TEST_CASE(flat_tops)
{
  for (const double noise : {0., 1e-16, 1e-9, 1e-30}) {
    Random random(7);
    Points points;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 2; ++k)
          points.push_back({i / 3., j / 3., k - 1 - noise * random()});
    BOOST_TEST(mistake(points, {1, 1, none}) == "", "noise " << noise);
  }
}

BOOST_AUTO_TEST_CASE(without_periods)
{
  for (const Points& points : {random_points(200), lattice(5, 1)}) {
    const Arrays arrays = periodic_delaunay_3_arrays(points, Box{none, none, none});
    const auto plain = CGAL::delaunay_3_arrays(points);
    BOOST_TEST(arrays.number_of_copies() == 0u);
    std::set<Simplex> cells, expected;
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
      cells.insert(canonical(simplex_of(arrays, c)));
    for (std::size_t c = 0; c < plain.number_of_simplices(); ++c) {
      Simplex s;
      for (int k = 0; k < 4; ++k)
        s.push_back({plain.vertices(c)[k], 0, 0, 0});
      expected.insert(canonical(s));
    }
    BOOST_TEST((cells == expected));
    BOOST_TEST(are_neighbors_right(arrays));
  }
}

// --- numbers -------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(positions_are_not_rounded)
{
  Points tenths;
  for (int i = 0; i < 27; i += 2)
    tenths.push_back({.1 * (i % 3), .1 * (i / 3 % 3), .1 * (i / 9)});
  BOOST_TEST(mistake(tenths, {.3, .3, .3}) == "");
  BOOST_TEST(mistake(tenths, {.1 + .2, .3, .3}) == ""); // another number
  Points beside = {{.1, .2, .3}, {.7, .7, .7}};         // where a copy is, but for an ulp
  for (const double x : {1.1, std::nextafter(1.1, 2), std::nextafter(1.1, 0)})
    beside.push_back({x, .2, .3});
  BOOST_TEST(mistake(beside, {1, 1, 1}) == "");
  for (const double tiny : {1e-17, 1e-300, 5e-324}) {
    const Points points = {{0, tiny, .5},    {tiny, 0, .25}, {-tiny, .75, tiny}, {1, 1, 1},
                           {.5, -tiny, .75}, {.5, .5, .5},   {.25, -.5, tiny},   {1 - 1e-16, 0, 0}};
    if (tiny != 1e-300)
      BOOST_TEST(mistake(points, {1, 1, 1}) == "", "tiny " << tiny);
    BOOST_TEST(mistake(points, {1, 1, none}) == "", "tiny " << tiny);
  }
}

BOOST_AUTO_TEST_CASE(boxes_of_any_size)
{
  for (const double size : {1e-300, 1e-320, 1e300}) {
    const Points points = times(random_points(3), size);
    BOOST_TEST(mistake(points, {size, size, size}) == "", "size " << size);
    BOOST_TEST(mistake(points, {size, size, none}) == "", "size " << size);
  }
  // heights that vanish when coordinates are scaled
  const Points steps = {{0, 0, 0}, {3e299, 5e299, 5e-324}, {8e299, 1e299, 1e-323}};
  BOOST_TEST(mistake(steps, {1e300, 1e300, none}) == "");
}

// Flat cells have balls that only exact numbers know; if they were not known, all copies would be
// inserted.
BOOST_AUTO_TEST_CASE(noisy_lattices)
{
  for (const double noise : {1e-16, 1e-17, 1e-25, 1e-33, 1e-60, 1e-200}) {
    Random random(2);
    Points points = lattice(noise == 1e-33 ? 3 : 6, 1);
    for (Coordinates& p : points)
      for (double& x : p)
        x += noise * random();
    const Arrays arrays = periodic_delaunay_3_arrays(points, Box{1, 1, 1});
    if (noise == 1e-33)
      BOOST_TEST(mistake_in(arrays, by_cgal(points, 1), points, {}, {1, 1, 1}) == "");
    else
      BOOST_TEST(arrays.number_of_copies() < 7 * points.size(), "noise " << noise);
  }
}

// Coordinates so large that copies would be rounded.
BOOST_AUTO_TEST_CASE(far_from_the_origin)
{
  const Points at_home = {{0, 0, 0}, {.25, .5, .125}, {.5, .5, .75}};
  for (const double by : {0x1p20, 0x1p28}) {
    const Points points = moved(at_home, {by, -by, 0});
    BOOST_TEST(mistake(points, {1, 1, 1}) == "");
  }
  BOOST_TEST(
      starts_with(message_of({{1e17, 0, 0}}, {1, 1, 1}), "box: the period along x is so small"));
  BOOST_TEST(starts_with(message_of({{0, 0, 1e17}, {0, 0, 0}, {0, 0, 1}}, {2, 1e-3, none}),
                         "box: the z coordinate of point 0, along"));
  BOOST_TEST(periodic_delaunay_3_arrays(moved(random_points(500), {1e8, 0, 0}), Box{1, 1, 1})
                 .number_of_copies() < 5000u);
}

// --- weights -------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(weights_next_to_many_copies)
{
  Random random(4);
  const Box boxes[] = {{1, 1, 1}, {1, 1, none}, {none, 1, none}, {2, 1.5, 1}};
  for (const Box& box : boxes)
    for (const double most : {.01, .1, 1., 8.}) {
      const Points points = random_points(8, box, unsigned(random.integer(1000)));
      Weights weights, integers;
      for (std::size_t i = 0; i < points.size(); ++i) {
        weights.push_back(most * random());
        integers.push_back(random.integer(3) / 4.);
      }
      BOOST_TEST(mistake(points, box, weights) == "");
      BOOST_TEST(mistake(points, box, integers) == "");
      weights.assign(points.size(), 0);
      weights[3] = most;
      BOOST_TEST(mistake(points, box, weights) == "");
    }
  const Points corners = lattice(2, 2);
  Weights weights;
  for (std::size_t i = 0; i < 8; ++i)
    weights.push_back(random.integer(2));
  BOOST_TEST(mistake(corners, {2, 2, 2}, weights) == "");
  BOOST_TEST(mistake(corners, {2, 2, 2}, Weights(8, 3)) == "");
}

// Long edges end at heavy points, which are far from the centres of balls.
BOOST_AUTO_TEST_CASE(heavy_points_have_double_edges)
{
  for (unsigned seed = 0; seed < 12; ++seed) {
    Random random(seed);
    Points points = random_points(60, {1, 1, 1}, seed);
    Weights weights(points.size(), 0);
    weights[std::size_t(random.integer(60))] = .15 + .1 * random();
    std::swap(weights[0], weights[std::size_t(random.integer(60))]);
    const Arrays arrays = periodic_regular_3_arrays(points, weights, Box{1, 1, 1});
    std::set<Simplex> cells;
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
      cells.insert(canonical(simplex_of(arrays, c)));
    BOOST_TEST(Numbers_of_simplices(cells).is_simplicial == arrays.is_simplicial_complex());
  }
}

BOOST_AUTO_TEST_CASE(small_weights_next_to_cgal)
{
  using Traits = CGAL::Periodic_3_regular_triangulation_traits_3<Kernel>;
  using Regular = CGAL::Periodic_3_regular_triangulation_3<Traits>;
  const Points points = random_points(500);
  Random random(6);
  Weights weights;
  std::vector<Traits::Weighted_point_3> given;
  for (const Coordinates& p : points) {
    weights.push_back(random() / 70);
    given.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), weights.back());
  }
  const Regular tr(given.begin(), given.end(), Traits::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
  std::map<Coordinates, int> number;
  for (std::size_t i = 0; i < points.size(); ++i)
    number[points[i]] = int(i);
  Outcome outcome;
  for (auto c = tr.cells_begin(); c != tr.cells_end(); ++c) {
    Simplex corners;
    for (int k = 0; k < 4; ++k) {
      const auto p = tr.periodic_point(c, k);
      const int i = number.at({p.first.x(), p.first.y(), p.first.z()});
      corners.push_back({i, p.second.x(), p.second.y(), p.second.z()});
      outcome.visible.insert(i);
    }
    outcome.cells.insert(canonical(corners));
  }
  BOOST_TEST(outcome.visible.size() < points.size());
  const Arrays arrays = periodic_regular_3_arrays(points, weights, Box{1, 1, 1});
  BOOST_TEST(mistake_in(arrays, outcome, points, weights, {1, 1, 1}) == "");
}

// --- all else ------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(few_copies)
{
  const Points points = random_points(20000);
  const Arrays arrays = periodic_delaunay_3_arrays(points, Box{1, 1, 1});
  BOOST_TEST(arrays.number_of_copies() < 18500u);
  BOOST_TEST(arrays.is_simplicial_complex());
  BOOST_TEST(std::abs(share_of_volume(arrays, points, {1, 1, 1}) - 1) < 1e-9);
  BOOST_TEST(are_neighbors_right(arrays));
}

// A layer that is too thin, here none, is refused: of the tetrahedra of the points alone exactly those
// are certain that are periodic, too.
BOOST_AUTO_TEST_CASE(certificate_of_a_layer)
{
  namespace core = DFS::core;
  const Points points = random_points(500);
  const double periods[3] = {1, 1, 1};
  const core::Box_of_points<false> box(core::Point_array(points[0].data(), points.size()), nullptr,
                                       periods);
  Points positions;
  auto copies = box.copies();
  for (std::size_t i = 0; i < points.size(); ++i) {
    positions.push_back(box.position(i, {0, 0, 0}));
    copies.copies.push_back(box.copy(i, {0, 0, 0}));
  }
  core::Leaves_of_box<core::Box_of_points<false>> leaves(
      box, core::Point_array(positions[0].data(), positions.size()), core::Alone());
  leaves.find_safe_depths();

  const auto sorted = [](std::array<std::int32_t, 4> v) {
    std::sort(v.begin(), v.end());
    return v;
  };
  std::set<std::array<std::int32_t, 4>> at_home;
  const Arrays periodic = periodic_delaunay_3_arrays(points, Box{1, 1, 1});
  for (std::size_t c = 0; c < periodic.number_of_simplices(); ++c)
    if (periodic.offsets(c) == std::array<Arrays::Offset, 4>{})
      at_home.insert(sorted(periodic.vertices(c)));

  const auto alone = CGAL::delaunay_3_arrays(points);
  std::size_t certain = 0;
  for (std::size_t c = 0; c < alone.number_of_simplices(); ++c) {
    const auto v = alone.vertices(c);
    const auto place = [&](std::size_t k) {
      return core::Rounded_place<false>(positions[std::size_t(v[k])].data());
    };
    const auto exact = [&](std::size_t k) { return copies.place(std::size_t(v[k])); };
    const core::Rounded_place<false> places[4] = {place(0), place(1), place(2), place(3)};
    const core::Copy_place<false> exact_places[4] = {exact(0), exact(1), exact(2), exact(3)};
    const core::Empty_ball ball(places, exact_places, box.rounding());
    BOOST_REQUIRE(ball.is_known());
    core::Leaves_of_box<core::Box_of_points<false>>::Copy copy = {};
    const bool is_certain = !leaves.find_deepest(ball, places[0].coordinates, copy);
    BOOST_TEST(is_certain == (at_home.count(sorted(v)) != 0));
    BOOST_TEST((is_certain || !leaves.is_safe(ball)));
    certain += is_certain;
  }
  BOOST_TEST(certain > 0u);
  BOOST_TEST(certain < alone.number_of_simplices());
}

// Balls that are much larger than the box is thick touch thousands of copies of its bounds.
BOOST_AUTO_TEST_CASE(few_copies_in_thin_boxes)
{
  for (const double height : {300., 3000.})
    for (const std::size_t n : {1, 2, 10, 300}) {
      Points points = random_points(n);
      for (auto& p : points)
        p[2] *= height;
      const Box box = {1, 1, height};
      const Arrays arrays = periodic_delaunay_3_arrays(points, box);
      BOOST_TEST(arrays.number_of_copies() < 30 * n + 100);
      BOOST_TEST(std::abs(share_of_volume(arrays, points, box) - 1) < 1e-9);
      BOOST_TEST(are_neighbors_right(arrays));
    }
}

// The others are not taken for as heavy, nor are they rounded more, nor do they need more copies.
BOOST_AUTO_TEST_CASE(few_copies_beside_a_heavy_point)
{
  const Points points = random_points(10000);
  for (const double weight : {.1, -1e30, -1e32}) {
    Weights weights(points.size(), 0);
    weights[5] = weight;
    const Arrays arrays = periodic_regular_3_arrays(points, weights, Box{1, 1, 1});
    BOOST_TEST(arrays.number_of_copies() < 15000u);
    BOOST_TEST(std::abs(share_of_volume(arrays, points, {1, 1, 1}) - 1) < 1e-9);
  }
}

// Points that are equal to others, or hidden, have no copies.
BOOST_AUTO_TEST_CASE(no_copies_of_equal_points)
{
  Points points = random_points(5000);
  for (std::size_t i = 0; i < points.size(); i += 2)
    points[i] = {0, 0, 0};
  const Arrays arrays = periodic_delaunay_3_arrays(points, Box{1, 1, 1});
  BOOST_TEST(arrays.number_of_copies() < 6000u);
  BOOST_TEST(std::abs(share_of_volume(arrays, points, {1, 1, 1}) - 1) < 1e-9);
  const Points all_equal(5000, {.5, .5, .5});
  BOOST_TEST(periodic_delaunay_3_arrays(all_equal, Box{1, 1, 1}).number_of_copies() < 100u);
}

namespace {

struct Logging_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t inserted = 0, ends = 0;
  bool is_ended = false, is_right = true;

  bool go_further(std::size_t n)
  {
    is_right = is_right && !is_ended && n >= inserted;
    inserted = n;
    return true;
  }
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    ++ends;
    is_ended = true;
  }
};

} // namespace

// The insertions end once, after all copies, whose number grows.
BOOST_AUTO_TEST_CASE(visitors)
{
  for (const std::size_t n : {0, 10, 3000}) {
    Points points = random_points(n);
    for (auto& p : points)
      p[2] *= 300;
    Logging_visitor visitor;
    periodic_delaunay_3_arrays(points, Box{1, 1, 300},
                               CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(visitor.ends == 1u);
    BOOST_TEST(visitor.is_right);
    if (n == 3000) // it is asked every 256 points or so
      BOOST_TEST(visitor.inserted >= n);
  }
}

BOOST_AUTO_TEST_CASE(many_threads)
{
  const auto cells_of = [](const Arrays& arrays) {
    std::set<Simplex> cells;
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
      cells.insert(canonical(simplex_of(arrays, c)));
    return cells;
  };
  const Points sets[] = {random_points(5000), lattice(14, 1)};
  for (const Points& points : sets) {
    const Box box = {1, 1, 1};
    Weights weights;
    Random random(8);
    for (std::size_t i = 0; i < points.size(); ++i)
      weights.push_back(random() / 1000);
    DFS::internal::Read_coordinates<Points, CGAL::parameters::Default_named_parameters> read(
        points, CGAL::parameters::default_values());
    DFS::internal::Read_weighted_points<Points, Weights> read_weighted(points, weights);
    const tests::Thread_executor executor(4);
    const Arrays plain = DFS::internal::insert_into_box<std::int32_t>(
        read, box, executor, CGAL::parameters::default_values());
    const Arrays weighted = DFS::internal::insert_into_box<std::int32_t>(
        read_weighted, box, executor, CGAL::parameters::default_values());
    BOOST_TEST(are_neighbors_right(plain));
    BOOST_TEST(are_neighbors_right(weighted));
    BOOST_TEST((cells_of(plain) == cells_of(periodic_delaunay_3_arrays(points, box))));
    BOOST_TEST((cells_of(weighted) == cells_of(periodic_regular_3_arrays(points, weights, box))));
  }
}

// The memory of so many cells is mapped apart from the heap.
BOOST_AUTO_TEST_CASE(many_points)
{
  Arrays arrays = periodic_delaunay_3_arrays(random_points(60000), Box{1, 1, 1});
  BOOST_TEST(are_neighbors_right(arrays));
  const Arrays copy = arrays;
  arrays = Arrays();
  BOOST_TEST(copy.number_of_simplices() > 6u * 60000);
}

// The order of the axes, and how far the points spread, does not matter.
BOOST_AUTO_TEST_CASE(far_along_a_long_axis)
{
  Points points = random_points(20);
  const auto cells = periodic_delaunay_3_arrays(points, Box{9000, 1, 1}).number_of_simplices();
  for (const double spread : {1., 9000.}) {
    Points far = points;
    for (auto& p : far)
      p[0] = p[0] * spread + 9e8;
    const Arrays arrays = periodic_delaunay_3_arrays(far, Box{9000, 1, 1});
    BOOST_TEST(are_neighbors_right(arrays));
    BOOST_TEST((spread != 1 || arrays.number_of_simplices() == cells));
  }
  points[7][2] = 1e9;
  BOOST_TEST(message_of(points, {1, 2, none}) ==
             "box: the z coordinate of point 7, along an axis without a period, is 2^29 times the "
             "shortest period; remedy: move the points towards 0");
}

BOOST_AUTO_TEST_CASE(stopped)
{
  struct Stop : CGAL::Default_surface_insertion_visitor_3
  {
    int left = 0;
    bool go_further(std::size_t) { return left-- > 0; }
  };
  for (const Points& points : {random_points(2000), random_points(2)})
    for (int left = 0; left < 9; ++left) {
      Stop stop;
      stop.left = left;
      const Arrays arrays = periodic_delaunay_3_arrays(points, Box{1, 1, 1},
                                                       CGAL::parameters::visitor(std::ref(stop)));
      const bool is_stopped = stop.left < 0;
      BOOST_TEST((arrays.number_of_points() == 0) == is_stopped);
      BOOST_TEST((arrays.number_of_simplices() == 0) == is_stopped);
    }
  BOOST_TEST(periodic_delaunay_3_arrays(Points{}, Box{1, 1, 1}).number_of_points() == 0u);
}

BOOST_AUTO_TEST_CASE(refused)
{
  const Points points = random_points(5);
  const std::string along[] = {"box: the period along x is ", "box: the period along y is ",
                               "box: the period along z is "};
  for (std::size_t a = 0; a < 3; ++a) {
    for (const double bad : {0., -1., -none, std::nan(""), -5e-324}) {
      Box box = {1, 1, 1};
      box[a] = bad;
      BOOST_TEST(message_of(points, box) == along[a] + "not positive");
    }
    Box box = {1, 1, 1};
    box[a] = 1e-5;
    BOOST_TEST(message_of(points, box) ==
               along[a] + "less than 1/10000 of the diagonal of the box");
    Points far = points;
    far[3][a] = 1e10;
    BOOST_TEST(message_of(far, {1, 1, 1}) ==
               along[a] + "so small that point 3 is 2^29 of them away");
  }
  BOOST_TEST(message_of(points, {1e308, 1e308, 1e308}) ==
             "box: copies of the points would have infinite coordinates");
  const Points plane = {{0, 0, 1}, {.5, .2, 1}, {.3, .7, 1}, {.1, .2, 1}};
  const Points line = {{0, 2, 1}, {.5, 2, 1}};
  BOOST_TEST(starts_with(message_of(plane, {1, 1, none}), "box: the points lie in a plane"));
  BOOST_TEST(starts_with(message_of(plane, {none, 1, none}), "box: the points lie in a plane"));
  BOOST_TEST(starts_with(message_of(plane, {none, none, none}), "box: the points lie in a plane"));
  BOOST_TEST(starts_with(message_of(line, {1, none, none}), "box: the points lie in a plane"));
  BOOST_TEST(starts_with(message_of({{1, 1, 1}}, {1, 1, none}), "box: the points lie in a plane"));
  BOOST_TEST(message_of(plane, {1, 1, 1}) == "");
  BOOST_TEST(message_of({{0, 0, std::nan("")}}, {1, 1, 1}) != "");
}

// --- the exact pieces ----------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(signs_and_balls_of_copies)
{
  fuzz::Tally tally;
  for (std::uint64_t seed = 0; seed < 1500; ++seed)
    BOOST_TEST(fuzz::mistake_in_copies(seed, tally) == "", "seed " << seed);
}
