// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// regular_3_arrays() gives the cells and the hidden points of CGAL's regular triangulation.

#define BOOST_TEST_MODULE test_regular_arrays
#include <boost/test/included/unit_test.hpp>

#include "Thread_executor.h"
#include "mistake_in_arrays.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/circumspheres_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/is_valid_delaunay_3_arrays.h>
#include <CGAL/regular_3_arrays.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using CGAL::is_valid_delaunay_3_arrays;
using CGAL::regular_3_arrays;
using tests::arrays::Cell;
using tests::arrays::Cells;
using tests::arrays::Kernel;
using tests::arrays::Point;
using Weighted_point = Kernel::Weighted_point_3;
using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;
using Balls = std::vector<std::array<double, 4>>; // coordinates and weights

std::vector<Point> points_of(const Balls& balls)
{
  std::vector<Point> points;
  for (const auto& b : balls)
    points.emplace_back(b[0], b[1], b[2]);
  return points;
}

std::vector<double> weights_of(const Balls& balls)
{
  std::vector<double> weights;
  for (const auto& b : balls)
    weights.push_back(b[3]);
  return weights;
}

std::vector<Weighted_point> weighted_points_of(const Balls& balls)
{
  std::vector<Weighted_point> points;
  for (const auto& b : balls)
    points.emplace_back(Point(b[0], b[1], b[2]), b[3]);
  return points;
}

Arrays arrays_of(const Balls& balls)
{
  return regular_3_arrays(points_of(balls), weights_of(balls));
}

// What is wrong; nothing if the arrays are the triangulation that CGAL makes of the balls.
std::string mistake_in(const Arrays& arrays, const Balls& balls)
{
  std::map<std::array<double, 4>, std::int64_t> first_of_equal;
  for (std::size_t i = 0; i < balls.size(); ++i)
    first_of_equal.emplace(balls[i], i);
  const auto number = [&](const Weighted_point& p) {
    return first_of_equal.at({p.x(), p.y(), p.z(), p.weight()});
  };
  const auto given = weighted_points_of(balls);
  const CGAL::Regular_triangulation_3<Kernel> tr(given.begin(), given.end());
  Cells cells;
  for (auto c = tr.tds().raw_cells_begin(); c != tr.tds().raw_cells_end(); ++c) {
    if (tr.dimension() < 0)
      break;                      // one cell of nothing
    Cell cell = {-1, -1, -1, -1}; // "raw" in every dimension
    for (int i = 0; i <= tr.dimension(); ++i)
      if (!tr.is_infinite(c->vertex(i)))
        cell[std::size_t(i)] = number(c->vertex(i)->point());
    cells.push_back(cell);
  }
  std::set<std::int64_t> visible;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    visible.insert(number(v->point()));
  if (arrays.dimension() != tr.dimension())
    return "dimension " + std::to_string(arrays.dimension());
  if (tests::arrays::cells_of(arrays) != tests::arrays::canonical(cells))
    return "the cells of the arrays are not plain CGAL's";
  if (arrays.number_of_points() != balls.size() ||
      arrays.number_of_vertices() != tr.number_of_vertices())
    return "wrong numbers of points or vertices";
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::int64_t first = first_of_equal.at(balls[i]);
    wrong += arrays.vertex_of_point(i) != (visible.count(first) == 0 ? -1 : first);
  }
  for (std::size_t c = 0; c < arrays.number_of_cells(); ++c)
    for (std::size_t i = 0; i <= std::size_t(arrays.dimension()); ++i)
      wrong += !tests::arrays::is_neighbor(arrays, c, i);
  wrong += tests::arrays::wrong_orientations(arrays, points_of(balls));
  if (wrong != 0)
    return std::to_string(wrong) + " mistakes";
  const bool is_valid = is_valid_delaunay_3_arrays(arrays, points_of(balls), weights_of(balls));
  return is_valid ? "" : "arrays that are right are called invalid";
}

Arrays checked_arrays(const Balls& balls)
{
  Arrays arrays = arrays_of(balls);
  BOOST_TEST(mistake_in(arrays, balls) == "");
  return arrays;
}

std::size_t number_of_hidden(const Arrays& arrays)
{
  const auto& vertices = arrays.vertices_of_points();
  return std::size_t(std::count(vertices.begin(), vertices.end(), Arrays::none));
}

bool are_same(const Arrays& a, const Arrays& b)
{
  return a.number_of_cells() == b.number_of_cells() &&
         a.vertices_of_points() == b.vertices_of_points() &&
         std::equal(a.vertices_data(), a.vertices_data() + a.stride() * a.number_of_cells(),
                    b.vertices_data());
}

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

// Random points in a cube.
Balls cube(std::size_t n, double most_weight, unsigned seed = 1)
{
  Random random(seed);
  Balls balls(n);
  for (auto& b : balls)
    b = {random(), random(), random(), most_weight * random()};
  return balls;
}

// All places with integers less than `sides`, and integer weights.
Balls lattice(const std::array<int, 3>& sides, int most_weight, unsigned seed = 1)
{
  Random random(seed);
  Balls balls;
  for (int i = 0; i < sides[0]; ++i)
    for (int j = 0; j < sides[1]; ++j)
      for (int k = 0; k < sides[2]; ++k)
        balls.push_back({double(i), double(j), double(k), double(random.integer(most_weight + 1))});
  return balls;
}

// Atoms along a chain, with the radii of some elements.
Balls protein(std::size_t n)
{
  Random random(5);
  const double radii[] = {1.2, 1.52, 1.55, 1.7, 1.8};
  Balls balls;
  std::array<double, 3> p = {0, 0, 0};
  for (std::size_t i = 0; i < n; ++i) {
    for (double& x : p)
      x += 2 * random() - 1 - .02 * x;
    const double r = radii[random.integer(5)];
    balls.push_back({p[0], p[1], p[2], r * r});
  }
  return balls;
}

// Up to 14 points, with few different numbers, of any dimension.
Balls small_set(unsigned seed)
{
  Random random(seed);
  Balls balls(std::size_t(1 + random.integer(14)));
  const int sides[3] = {1 + random.integer(4), 1 + random.integer(3), 1 + random.integer(3)};
  const int weights = 1 + random.integer(6);
  for (auto& b : balls)
    b = {double(random.integer(sides[0])), double(random.integer(sides[1])),
         double(random.integer(sides[2])), double(random.integer(weights))};
  return balls;
}

Balls with_weights(Balls balls, double weight)
{
  for (auto& b : balls)
    b[3] = weight;
  return balls;
}

Balls shifted(Balls balls, double by)
{
  for (auto& b : balls)
    b[3] += by;
  return balls;
}

} // namespace

BOOST_AUTO_TEST_CASE(random_points)
{
  for (const double most : {0., 1e-3, 1e-2, .1, 1., 1e10})
    BOOST_TEST_CONTEXT("weights up to " << most)
    {
      const std::size_t hidden = number_of_hidden(checked_arrays(cube(2000, most)));
      BOOST_TEST((most == 0 ? hidden == 0 : most < .1 || hidden > 1000));
    }
  checked_arrays(protein(2000));
  BOOST_TEST(checked_arrays(with_weights(protein(500), -3)).number_of_vertices() == 500u);
}

BOOST_AUTO_TEST_CASE(lattices)
{
  for (const int most : {0, 1, 3})
    checked_arrays(lattice({9, 8, 7}, most));
  checked_arrays(with_weights(lattice({8, 8, 8}, 0), 7));
}

// Of points at one place only the heaviest ones are seen.
BOOST_AUTO_TEST_CASE(copies)
{
  Balls balls = lattice({6, 5, 5}, 0);
  for (const unsigned seed : {1, 2, 3}) {
    const Balls more = lattice({6, 5, 5}, 2, seed);
    balls.insert(balls.end(), more.begin(), more.end());
  }
  checked_arrays(balls);
  std::reverse(balls.begin(), balls.end());
  checked_arrays(balls);
  balls = cube(300, .01);
  for (std::size_t i = 0; i < 600; ++i)
    balls.push_back(balls[i]);
  for (std::size_t i = 300; i < 600; ++i)
    balls[i][3] += double(i % 5) / 64 - 1. / 32;
  checked_arrays(balls);
}

// Weights |p|² and a linear function, so that only the perturbation decides; then a little less or
// more.
BOOST_AUTO_TEST_CASE(lifted_points_in_a_hyperplane)
{
  Balls balls = lattice({6, 6, 6}, 0);
  for (auto& b : balls)
    b[3] = b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + 3 * b[0] - 2 * b[1] + b[2];
  BOOST_TEST(number_of_hidden(checked_arrays(balls)) == 0u);
  Random random(4);
  for (auto& b : balls)
    b[3] += random.integer(3) - 1;
  checked_arrays(balls);
  for (auto& b : balls)
    b[3] += std::ldexp(random() - .5, -44);
  checked_arrays(balls);
}

BOOST_AUTO_TEST_CASE(points_in_a_plane)
{
  for (const int most : {0, 1, 4}) {
    Balls balls = lattice({12, 11, 1}, most);
    balls.insert(balls.end(), balls.begin(), balls.begin() + 30);
    BOOST_TEST(checked_arrays(balls).dimension() == 2);
    for (auto& b : balls)
      b = {b[0] + b[1], b[0] - 2 * b[1], 3 * b[1] - b[0], b[3] * 2.5};
    BOOST_TEST(checked_arrays(balls).dimension() == 2);
    for (auto& b : balls)
      b = {b[0] / 3, b[0] / 3, std::sqrt(100 + b[1]), b[3]};
    BOOST_TEST(checked_arrays(balls).dimension() == 2);
  }
}

BOOST_AUTO_TEST_CASE(points_on_a_line)
{
  Random random(6);
  for (const double most : {0., 1., 30., 1e4, 1e300})
    BOOST_TEST_CONTEXT("weights up to " << most)
    {
      Balls balls;
      for (int i = 0; i < 60; ++i) {
        const double t = random.integer(50);
        balls.push_back({2 * t, -t, 5, most * random.integer(4) / 3});
      }
      BOOST_TEST(checked_arrays(balls).dimension() == 1);
      for (auto& b : balls)
        b = {0, 0, b[0] / 3, b[3] / 3};
      BOOST_TEST(checked_arrays(balls).dimension() == 1);
    }
  Balls parabola; // a point on the segment of others is seen
  for (int i = -20; i <= 20; ++i)
    parabola.push_back({0, double(i), 0, double(i * i + 4 * i)});
  BOOST_TEST(checked_arrays(parabola).number_of_vertices() == 41u);
  parabola[20][3] -= 0x1p-48;
  BOOST_TEST(checked_arrays(parabola).number_of_vertices() == 40u);
}

BOOST_AUTO_TEST_CASE(points_at_one_place)
{
  BOOST_TEST(checked_arrays({}).dimension() == -1);
  const Arrays arrays = checked_arrays({{1, 2, 3, -4}, {1, 2, 3, 0}, {1, 2, 3, 0}, {1, 2, 3, -1}});
  BOOST_TEST(arrays.dimension() == 0);
  BOOST_TEST(arrays.vertices_of_points() == (std::vector<std::int32_t>{-1, 1, 1, -1}),
             boost::test_tools::per_element());
  BOOST_TEST(number_of_hidden(checked_arrays({{0, 0, 0, 1}, {0, 0, 0, 1}})) == 0u);
}

BOOST_AUTO_TEST_CASE(small_sets_in_any_order)
{
  for (unsigned seed = 0; seed < 8; ++seed) {
    Random random(seed);
    Balls balls(6);
    for (auto& b : balls)
      b = {double(random.integer(3)), double(random.integer(seed % 4 == 0 ? 1 : 2)),
           double(random.integer(seed % 4 == 1 ? 1 : 2)), double(random.integer(3))};
    std::sort(balls.begin(), balls.end());
    std::size_t wrong = 0;
    do
      wrong += !mistake_in(arrays_of(balls), balls).empty();
    while (std::next_permutation(balls.begin(), balls.end()));
    BOOST_TEST(wrong == 0u, "seed " << seed);
  }
}

BOOST_AUTO_TEST_CASE(many_small_sets)
{
  std::size_t wrong = 0;
  for (unsigned seed = 0; seed < 6000; ++seed) {
    const Balls balls = small_set(seed);
    const std::string mistake = mistake_in(arrays_of(balls), balls);
    BOOST_TEST_INFO("seed " << seed);
    if (!mistake.empty() && ++wrong < 5)
      BOOST_TEST(mistake == "");
  }
  BOOST_TEST(wrong == 0u);
}

// Where a weight or a coordinate changes, the arrays are valid only if they would be made again.
BOOST_AUTO_TEST_CASE(arrays_of_other_points_are_invalid)
{
  std::size_t wrong = 0, valid = 0;
  for (unsigned seed = 0; seed < 12000; ++seed) {
    Balls balls = small_set(seed);
    const Arrays arrays = arrays_of(balls);
    Random random(seed);
    for (int changes = 0; changes < 2; ++changes)
      balls[std::size_t(random.integer(int(balls.size())))][seed % 8 == 0 ? 0 : 3] +=
          random.integer(5) - 2;
    const Arrays others = arrays_of(balls);
    const bool are_equal = arrays.dimension() == others.dimension() &&
                           arrays.vertices_of_points() == others.vertices_of_points() &&
                           tests::arrays::cells_of(arrays) == tests::arrays::cells_of(others) &&
                           tests::arrays::wrong_orientations(arrays, points_of(balls)) == 0;
    wrong += is_valid_delaunay_3_arrays(arrays, points_of(balls), weights_of(balls)) != are_equal;
    valid += are_equal;
  }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(valid > 1000u);
  BOOST_TEST(valid < 11000u);
}

// The one that comes last hides all but the corners of the hull.
BOOST_AUTO_TEST_CASE(heaviest_last)
{
  for (Balls balls : {cube(1000, .001), lattice({7, 7, 7}, 2)}) {
    const double middle = balls.size() == 1000 ? .5 : 3;
    balls.push_back({middle, middle, middle, 1e6});
    const Arrays arrays = checked_arrays(balls);
    BOOST_TEST(number_of_hidden(arrays) > 160u);
    BOOST_TEST(arrays.vertex_of_point(balls.size() - 1) == std::int32_t(balls.size() - 1));
    balls.push_back({0, 0, 0, 2e6});
    checked_arrays(balls);
    balls.push_back({middle, middle, middle, 3e6});
    BOOST_TEST(checked_arrays(balls).vertex_of_point(balls.size() - 3) == Arrays::none);
  }
}

// Weights and coordinates of every size.
BOOST_AUTO_TEST_CASE(hostile_numbers)
{
  Random random(9);
  const double sizes[] = {5e-324, 1e-310, 1e-160, 1e-150, 1e-20, 1, 1e20, 1e150, 1e300};
  for (const double size : {1e-300, 1e-160, 1., 1e100, 1e150, 1e300})
    for (int round = 0; round < 4; ++round) {
      Balls balls;
      for (int i = 0; i < 60; ++i) {
        const double of = round == 0 ? 1 : size;
        const double weight = sizes[random.integer(9)] * (random.integer(7) - 3);
        const double x = random.integer(4), y = random.integer(4), z = random.integer(4);
        balls.push_back({of * x, size * y, round < 3 ? size * z : 0., weight});
      }
      BOOST_TEST_CONTEXT("size " << size << ", round " << round)
      {
        checked_arrays(balls);
      }
    }
}

BOOST_AUTO_TEST_CASE(only_differences_of_weights_count)
{
  for (const Balls& balls : {lattice({7, 6, 6}, 3), lattice({7, 8, 1}, 3), lattice({40, 1, 1}, 9)})
    for (const double by : {-5., 1024., 1099511627776.})
      BOOST_TEST(are_same(arrays_of(balls), arrays_of(shifted(balls, by))));
}

BOOST_AUTO_TEST_CASE(equal_weights_give_delaunay)
{
  for (const Balls& balls : {cube(1000, 0), lattice({7, 6, 6}, 0), lattice({7, 8, 1}, 0),
                             lattice({40, 1, 1}, 0), lattice({1, 1, 1}, 0)}) {
    const Arrays arrays = CGAL::delaunay_3_arrays(points_of(balls));
    BOOST_TEST(are_same(arrays_of(balls), arrays));
    BOOST_TEST(are_same(arrays_of(with_weights(balls, .1)), arrays));
  }
}

// Weights so much larger than coordinates that determinants of these, scaled, would underflow.
BOOST_AUTO_TEST_CASE(huge_equal_weights)
{
  const Balls balls = lattice({5, 5, 5}, 0);
  const Cells expected = tests::arrays::cells_of(CGAL::delaunay_3_arrays(points_of(balls)));
  for (const int exponent : {0, 300, 600, 900, 1020})
    for (const int unit : {0, -100, -200, -300}) {
      Balls scaled = with_weights(balls, std::ldexp(1., exponent));
      for (auto& b : scaled)
        for (int k = 0; k < 3; ++k)
          b[k] = std::ldexp(b[k], unit);
      BOOST_TEST((tests::arrays::cells_of(arrays_of(scaled)) == expected),
                 exponent << ", " << unit);
    }
}

BOOST_AUTO_TEST_CASE(kept_order)
{
  DFS::Insertion_order order, of_weighted_points;
  Balls balls = cube(1500, .01);
  Random random(3);
  for (int step = 0; step < 4; ++step) {
    const Arrays arrays = regular_3_arrays(points_of(balls), weights_of(balls), order);
    BOOST_TEST(mistake_in(arrays, balls) == "");
    BOOST_TEST(order.order.size() == 1500u);
    BOOST_TEST(are_same(regular_3_arrays(weighted_points_of(balls), of_weighted_points), arrays));
    BOOST_TEST((of_weighted_points.order == order.order));
    for (auto& b : balls)
      b = {b[0] + .001 * random(), b[1], b[2], b[3] + .001 * random()};
  }
  order.order[0] = order.order[1];
  BOOST_CHECK_THROW(regular_3_arrays(points_of(balls), weights_of(balls), order),
                    CGAL::Surface_input_error);
  BOOST_CHECK_THROW(
      regular_3_arrays(weighted_points_of(balls), order, CGAL::parameters::random_seed(1)),
      CGAL::Surface_input_error);
}

BOOST_AUTO_TEST_CASE(many_threads)
{
  for (const Balls& balls : {cube(20000, .001), cube(20000, .01), lattice({20, 20, 20}, 2)}) {
    const auto points = points_of(balls);
    const auto weights = weights_of(balls);
    DFS::internal::Read_weighted_points<std::vector<Point>, std::vector<double>> read(points,
                                                                                      weights);
    const Arrays arrays = DFS::internal::insert_into_arrays<std::int32_t>(
        read, nullptr, std::nullopt, tests::Thread_executor(4), CGAL::parameters::default_values());
    BOOST_TEST(mistake_in(arrays, balls) == "");
  }
}

// A few heavy ones swallow nearly all others, so that walks are to start in cells that are dead.
BOOST_AUTO_TEST_CASE(many_threads_and_heavy_points)
{
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Balls balls;
    const std::size_t n = 400 + random() % 4000, heavy = 1 + random() % 12;
    const double weight = 8 * unit(random), spread = 1 + 2 * unit(random);
    for (std::size_t i = 0; i < n; ++i)
      balls.push_back({unit(random), unit(random), unit(random), 0});
    for (std::size_t i = 0; i < heavy; ++i) {
      Balls::value_type ball = {0, 0, 0, weight};
      for (std::size_t c = 0; c < 3; ++c)
        ball[c] = .5 + spread * (unit(random) - .5);
      balls.push_back(ball);
    }
    const auto points = points_of(balls);
    const auto weights = weights_of(balls);
    DFS::internal::Read_weighted_points<std::vector<Point>, std::vector<double>> read(points,
                                                                                      weights);
    const Arrays arrays = DFS::internal::insert_into_arrays<std::int32_t>(
        read, nullptr, std::nullopt, tests::Thread_executor(2), CGAL::parameters::default_values());
    BOOST_TEST(mistake_in(arrays, balls) == "", "seed " << seed);
  }
}

BOOST_AUTO_TEST_CASE(points_and_weights_of_any_kind)
{
  const Balls balls = lattice({4, 3, 3}, 2);
  const Arrays arrays = arrays_of(balls);
  const auto points = points_of(balls);
  const auto given = weighted_points_of(balls);
  BOOST_TEST(are_same(regular_3_arrays(given), arrays));
  BOOST_TEST(are_same(regular_3_arrays(given, CGAL::parameters::random_seed(3)), arrays));
  std::list<float> floats;
  std::vector<int> integers;
  std::vector<CGAL::Epeck::FT> numbers;
  std::vector<CGAL::Epeck::Weighted_point_3> exact;
  std::vector<std::pair<int, Weighted_point>> pairs;
  for (const auto& b : balls) {
    floats.push_back(float(b[3]));
    integers.push_back(int(b[3]));
    numbers.emplace_back(b[3]);
    exact.emplace_back(CGAL::Epeck::Point_3(b[0], b[1], b[2]), CGAL::Epeck::FT(b[3]));
    pairs.emplace_back(7, Weighted_point(Point(b[0], b[1], b[2]), b[3]));
  }
  BOOST_TEST(are_same(regular_3_arrays(points, floats), arrays));
  BOOST_TEST(are_same(regular_3_arrays(points, integers), arrays));
  BOOST_TEST(are_same(regular_3_arrays(points, numbers), arrays));
  BOOST_TEST(are_same(regular_3_arrays(exact), arrays));
  const CGAL::Second_of_pair_property_map<std::pair<int, Weighted_point>> second;
  BOOST_TEST(are_same(regular_3_arrays(pairs, CGAL::parameters::point_map(second)), arrays));
}

// Centres and squared radii are compared with CGAL's exact ones, a radius with what it is the
// difference of.
BOOST_AUTO_TEST_CASE(power_spheres)
{
  using Exact = CGAL::Epeck;
  Random random(8);
  std::size_t wrong = 0, imaginary = 0, flat = 0;
  for (int round = 0; round < 2000; ++round) {
    const double thickness = std::ldexp(1, -round % 60), size = std::ldexp(1, round % 300 - 150);
    std::array<double, 4> corners[4];
    std::vector<Exact::Weighted_point_3> exact;
    for (auto& p : corners) {
      p = {size * random(), size * random(), size * (1 + thickness * random.integer(9)),
           round % 2 * size * size * (round % 4 + random.integer(5) / 8. - 1)};
      exact.emplace_back(Exact::Point_3(p[0], p[1], p[2]), Exact::FT(p[3]));
    }
    const auto sphere = DFS::internal::power_sphere_of(corners);
    if (CGAL::coplanar(exact[0].point(), exact[1].point(), exact[2].point(), exact[3].point())) {
      ++flat;
      continue;
    }
    const auto center =
        Exact().construct_weighted_circumcenter_3_object()(exact[0], exact[1], exact[2], exact[3]);
    const auto nearest = [](const auto& x) { return CGAL::to_double(CGAL::exact(x)); };
    const auto squared = CGAL::squared_distance(center, exact[0].point());
    const double power = nearest(squared - exact[0].weight()), length = nearest(squared);
    imaginary += sphere.squared_radius < 0;
    wrong +=
        !(std::abs(sphere.squared_radius - power) <= 1e-12 * (length + std::abs(corners[0][3])));
    for (int i = 0; i < 3; ++i) {
      const double x = nearest(center[i] - exact[0].point()[i]);
      wrong += !(std::abs(sphere.center[std::size_t(i)] - x) <= 1e-12 * std::sqrt(length));
    }
    if (round % 2 == 0) {
      std::array<double, 3> places[4];
      for (std::size_t k = 0; k < 4; ++k)
        places[k] = {corners[k][0], corners[k][1], corners[k][2]};
      wrong += sphere.center != DFS::internal::circumsphere_of(places).center;
    }
  }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(imaginary > 20u);
  BOOST_TEST(flat < 500u);
  const double huge = 1e308;
  const std::array<double, 4> huge_corners[4] = {
      {0, 0, 0, -huge}, {huge, 0, 0, huge}, {0, huge, 0, huge}, {0, 0, huge, huge}};
  const auto far = DFS::internal::power_sphere_of(huge_corners);
  for (const double x : far.center)
    BOOST_TEST(x == huge / 2);
}

// Those of arrays, with weights and without, are compared with what CGAL constructs exactly.
BOOST_AUTO_TEST_CASE(spheres_of_arrays)
{
  using Exact = CGAL::Epeck;
  const Exact kernel;
  const auto difference = [](double x, const Exact::FT& of) {
    return std::abs(CGAL::to_double(CGAL::exact(Exact::FT(x) - of)));
  };
  const auto wrong_spheres = [&](const auto& spheres, const Arrays& arrays, const Balls& balls,
                                 const auto& center_of, const auto& squared_radius_of) {
    std::size_t wrong = spheres.size() != arrays.number_of_simplices();
    for (std::size_t c = 0; c < spheres.size(); ++c) {
      std::vector<Exact::Weighted_point_3> p;
      double size = 0;
      for (const std::int32_t v : arrays.vertices(c)) {
        const auto& b = balls[std::size_t(v)];
        p.emplace_back(Exact::Point_3(b[0], b[1], b[2]), Exact::FT(b[3]));
        size = std::abs(b[0]) + std::abs(b[1]) + std::abs(b[2]);
      }
      const Exact::Point_3 center = center_of(p[0], p[1], p[2], p[3]);
      const double squared = CGAL::to_double(CGAL::squared_distance(center, p[0].point()));
      for (int i = 0; i < 3; ++i)
        wrong +=
            difference(spheres[c][std::size_t(i)], center[i]) > 1e-12 * (std::sqrt(squared) + size);
      wrong += difference(spheres[c][3], squared_radius_of(p[0], p[1], p[2], p[3])) >
               1e-12 * (squared + std::abs(CGAL::to_double(p[0].weight())));
    }
    return wrong;
  };
  for (const Balls& balls :
       {cube(300, .05), protein(300), lattice({5, 5, 4}, 3), shifted(cube(100, .01), -7)}) {
    const auto points = points_of(balls);
    const auto weights = weights_of(balls);
    const Arrays weighted = regular_3_arrays(points, weights);
    const Arrays plain = CGAL::delaunay_3_arrays(points);
    BOOST_TEST(wrong_spheres(CGAL::circumspheres_3(weighted, points, weights), weighted, balls,
                             kernel.construct_weighted_circumcenter_3_object(),
                             kernel.compute_squared_radius_smallest_orthogonal_sphere_3_object()) ==
               0u);
    const auto bare = [](const auto& construct) {
      return [construct](const auto&... p) { return construct(p.point()...); };
    };
    BOOST_TEST(wrong_spheres(CGAL::circumspheres_3(plain, points), plain, balls,
                             bare(kernel.construct_circumcenter_3_object()),
                             bare(kernel.compute_squared_radius_3_object())) == 0u);
    BOOST_CHECK_EXCEPTION(CGAL::circumspheres_3(plain, points_of({{0, 0, 0, 0}})),
                          CGAL::Surface_input_error, [&](const auto& error) {
                            return error.what() == "the arrays are of " +
                                                       std::to_string(balls.size()) +
                                                       " points, and 1 are given";
                          });
  }
  const Balls flat = lattice({4, 4, 1}, 2);
  BOOST_TEST(CGAL::circumspheres_3(arrays_of(flat), points_of(flat), weights_of(flat)).empty());
}

BOOST_AUTO_TEST_CASE(refused_weights)
{
  const auto points = points_of(lattice({3, 3, 1}, 0));
  const auto says = [&](const auto& weights, const std::string& message) {
    BOOST_CHECK_EXCEPTION(regular_3_arrays(points, weights), CGAL::Surface_input_error,
                          [&](const auto& error) { return error.what() == message; });
  };
  std::vector<double> weights(9);
  weights[5] = std::numeric_limits<double>::infinity();
  says(weights, "vertex 5: its weight is inf, not a finite number");
  weights[5] = std::numeric_limits<double>::quiet_NaN();
  weights[2] = -std::numeric_limits<double>::infinity();
  says(weights, "vertex 2: its weight is -inf, not a finite number");
  says(std::vector<float>(8), "there are 8 weights, but 9 points");
  std::vector<std::int64_t> integers(9, 1);
  integers[3] = 9007199254740993;
  says(integers,
       "a weight is not a double: 9007199254740993; remedy: subtract the same number from "
       "all");
}

BOOST_AUTO_TEST_CASE(stopped)
{
  struct Stop : CGAL::Default_surface_insertion_visitor_3
  {
    bool go_further(std::size_t) { return false; }
  };
  for (const Balls& balls : {cube(1000, .01), lattice({9, 1, 1}, 2)}) {
    const Arrays arrays =
        regular_3_arrays(points_of(balls), weights_of(balls), CGAL::parameters::visitor(Stop()));
    BOOST_TEST(arrays.number_of_points() == 0u);
    BOOST_TEST(arrays.number_of_cells() == 0u);
  }
}
