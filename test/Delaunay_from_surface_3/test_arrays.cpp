// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// delaunay_3_arrays() gives the cells of CGAL's triangulation, with neighbours and orientation.

#define BOOST_TEST_MODULE test_arrays
#include <boost/test/included/unit_test.hpp>

#include "check_arrays.h"
#include "named_surfaces.h"
#include "rounding_modes.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/delaunay_3_arrays.h>

#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using CGAL::delaunay_3_arrays;
using tests::arrays::check_arrays;
using tests::arrays::Point;
using Faces = std::vector<std::array<int, 3>>;

struct Reasons_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::vector<std::string> replaced, irregular;
  std::size_t stop_before = std::size_t(-1), asked = 0, orders_replaced = 0;

  void notice(CGAL::Surface_insertion_notice what, const std::string& reason)
  {
    using Notice = CGAL::Surface_insertion_notice;
    if (what == Notice::CORE_IS_REPLACED)
      replaced.push_back(reason);
    else if (what == Notice::SURFACE_IS_IRREGULAR)
      irregular.push_back(reason);
    else if (what == Notice::ORDER_IS_REPLACED)
      ++orders_replaced;
  }
  bool go_further(std::size_t) { return asked++ != stop_before; }
};

// What was said while the arrays of the points were made, and checked.
Reasons_visitor check_points(const std::vector<Point>& points)
{
  Reasons_visitor visitor;
  check_arrays(delaunay_3_arrays(points, CGAL::parameters::visitor(std::ref(visitor))), points);
  return visitor;
}

std::vector<Point> grid(int x, int y, int z)
{
  std::vector<Point> points;
  for (int i = 0; i < x; ++i)
    for (int j = 0; j < y; ++j)
      for (int k = 0; k < z; ++k)
        points.emplace_back(i, j, k);
  return points;
}

namespace DFS = CGAL::Delaunay_from_surface_3;

// A budget that nothing keeps.
DFS::internal::Build_options starved()
{
  DFS::internal::Build_options options;
  options.cells_per_point = 1;
  return options;
}

} // namespace

// What is finished when that is found is kept.
BOOST_AUTO_TEST_CASE(an_order_over_its_budget_is_replaced)
{
  for (const std::size_t n : {250, 2000}) {
    const auto surface = surfaces::sphere(n, 0.05);
    Reasons_visitor visitor;
    const auto coordinates = DFS::internal::rounded_coordinates(surface.points);
    DFS::internal::Given_points points({coordinates.data(), surface.points.size()});
    check_arrays(DFS::internal::insert_into_arrays<std::int32_t>(
                     points, nullptr, std::nullopt, DFS::internal::Alone(),
                     CGAL::parameters::visitor(std::ref(visitor)), starved()),
                 surface.points);
    BOOST_TEST(visitor.orders_replaced == (n > 1000 ? 1u : 0u));
  }
}

BOOST_AUTO_TEST_CASE(surfaces_with_and_without_faces)
{
  for (const auto& surfaces : {tests::ordinary_surfaces(1500), tests::degenerate_surfaces(700),
                               tests::tiny_and_flat_surfaces()})
    for (const tests::Named_surface& named : surfaces)
      BOOST_TEST_CONTEXT(named.name)
      {
        const auto& [points, faces] = named.surface;
        check_arrays(delaunay_3_arrays(points), points);
        check_arrays(delaunay_3_arrays(points, faces, CGAL::parameters::random_seed(7)), points);
      }
}

BOOST_AUTO_TEST_CASE(every_dimension)
{
  BOOST_TEST(delaunay_3_arrays(std::vector<Point>()).dimension() == -1);
  const std::array<int, 3> sides[] = {{1, 1, 1}, {2, 1, 1}, {9, 1, 1}, {1, 7, 5}, {4, 5, 3}};
  const int dimensions[] = {0, 1, 1, 2, 3};
  const std::size_t simplices[] = {1, 1, 8, 48};
  for (std::size_t k = 0; k < 5; ++k)
    BOOST_TEST_CONTEXT("grid " << k)
    {
      std::vector<Point> points = grid(sides[k][0], sides[k][1], sides[k][2]);
      const std::size_t n = points.size();
      points.insert(points.end(), points.begin(), points.begin() + std::ptrdiff_t(n / 2 + 1));
      std::reverse(points.begin(), points.end());
      const Reasons_visitor visitor = check_points(points);
      const auto arrays = delaunay_3_arrays(points);
      BOOST_TEST(arrays.dimension() == dimensions[k]);
      if (k < 4)
        BOOST_TEST(arrays.number_of_simplices() == simplices[k]);
      BOOST_TEST(visitor.replaced.empty());
    }
}

// The segments of a line, and one beyond each end: 127 with numbers of seven bits.
BOOST_AUTO_TEST_CASE(too_many_points_on_a_line)
{
  const std::vector<double> zeros(3 * 127);
  const auto number_of_cells = [](const std::vector<double>& coordinates, std::size_t n) {
    return DFS::internal::arrays_on_line<std::int8_t>(
               DFS::internal::Point_array(coordinates.data(), n))
        .number_of_cells();
  };
  std::vector<double> line = zeros;
  for (std::size_t i = 0; i < 127; ++i)
    line[3 * i] = double(i);
  BOOST_TEST(number_of_cells(zeros, 126) == 2u);
  BOOST_TEST(number_of_cells(line, 126) == 127u);
  BOOST_CHECK_THROW(number_of_cells(line, 127), std::length_error);
}

BOOST_AUTO_TEST_CASE(coordinates_of_too_different_size)
{
  std::vector<Point> points = grid(3, 3, 3);
  points.emplace_back(1e-200, 1e-250, 1e300);
  points.emplace_back(1e300, 1e-300, 5e-324);
  BOOST_TEST(check_points(points).replaced.empty());
  for (const double size :
       {1e-320, 1e-200, 1e160, 1e308}) { // in planes: products overflow, or vanish
    std::vector<Point> flat, turned;
    for (const Point& p : grid(4, 5, 1)) {
      flat.emplace_back(size * (p.x() / 5), 0, p.y());
      turned.emplace_back(size * (p.x() / 5), size * (p.y() / 5), size * (p.x() / 5));
    }
    BOOST_TEST(check_points(flat).replaced.empty());
    BOOST_TEST(check_points(turned).replaced.empty());
  }
}

BOOST_AUTO_TEST_CASE(points_of_any_kind)
{
  const std::vector<Point> points = grid(3, 4, 2);
  std::vector<std::array<double, 3>> numbers;
  std::vector<std::array<float, 3>> floats;
  std::vector<CGAL::Epeck::Point_3> exact;
  std::vector<CGAL::Simple_cartesian<double>::Point_3> simple;
  for (const Point& p : points) {
    numbers.push_back({p.x(), p.y(), p.z()});
    floats.push_back({float(p.x()), float(p.y()), float(p.z())});
    exact.emplace_back(p.x(), p.y(), p.z());
    simple.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<const double*> pointers;
  for (const auto& p : numbers)
    pointers.push_back(p.data());
  check_arrays(delaunay_3_arrays(numbers), points);
  check_arrays(delaunay_3_arrays(floats), points);
  check_arrays(delaunay_3_arrays(exact), points);
  check_arrays(delaunay_3_arrays(simple), points);
  check_arrays(delaunay_3_arrays(pointers), points);
  std::vector<std::size_t> numbers_of_points(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    numbers_of_points[i] = i;
  const auto map = boost::make_function_property_map<std::size_t>(
      [&](std::size_t i) -> const Point& { return points[i]; });
  check_arrays(delaunay_3_arrays(numbers_of_points, CGAL::parameters::point_map(map)), points);
}

// What would be rounded is refused: equal points could come of it.
BOOST_AUTO_TEST_CASE(coordinates_that_are_no_doubles)
{
  constexpr std::int64_t large = std::int64_t(1) << 53;
  using Integers = std::vector<std::array<std::int64_t, 3>>;
  Integers points = {{0, 0, 0}, {large, 0, 0}, {0, large + 2, 0}, {0, 0, -large}};
  BOOST_TEST(delaunay_3_arrays(points).number_of_simplices() == 1u);
  for (const std::int64_t wrong :
       {large + 1, -large - 1, (std::numeric_limits<std::int64_t>::max)()}) {
    points[3][2] = wrong;
    BOOST_CHECK_EXCEPTION(
        delaunay_3_arrays(points), CGAL::Surface_input_error, [](const auto& error) {
          return std::string(error.what()).find("is not a double") != std::string::npos;
        });
  }
  std::vector<std::array<long double, 3>> wide = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  BOOST_TEST(delaunay_3_arrays(wide).number_of_simplices() == 1u);
  if (std::numeric_limits<long double>::digits > 53) {
    wide[3][2] = 1 + std::numeric_limits<long double>::epsilon();
    BOOST_CHECK_THROW(delaunay_3_arrays(wide), CGAL::Surface_input_error);
  }
}

BOOST_AUTO_TEST_CASE(what_is_given_up)
{
  const std::vector<Point> points = grid(4, 4, 4);
  const auto all = delaunay_3_arrays(points);
  auto arrays = delaunay_3_arrays(points);
  arrays.separate();
  BOOST_TEST(arrays.stride() == 4u);
  check_arrays(arrays, points);
  for (const bool are_separate : {false, true}) {
    auto finite = delaunay_3_arrays(points);
    if (are_separate)
      finite.separate();
    finite.drop_infinite_cells();
    BOOST_TEST_REQUIRE(finite.number_of_cells() == all.number_of_simplices());
    std::size_t wrong = 0;
    for (std::size_t c = 0; c < finite.number_of_cells(); ++c) {
      wrong += finite.vertices(c) != all.vertices(c);
      for (std::size_t i = 0; i < 4; ++i) {
        const auto n = all.neighbors(c)[i];
        wrong += finite.neighbors(c)[i] != (all.is_infinite(n) ? -1 : n);
      }
    }
    finite.drop_neighbors();
    BOOST_TEST(finite.neighbors_data() == nullptr);
    for (std::size_t c = 0; c < finite.number_of_cells(); ++c)
      wrong += finite.vertices(c) != all.vertices(c);
    BOOST_TEST(wrong == 0u);
  }
}

BOOST_AUTO_TEST_CASE(copies_and_what_was_moved_from)
{
  using Arrays = CGAL::Delaunay_3_arrays<>;
  static_assert(std::is_nothrow_move_constructible<Arrays>::value, "");
  static_assert(std::is_nothrow_move_assignable<Arrays>::value, "");
  const std::vector<Point> points = grid(4, 4, 4);
  const auto check_empty = [](const Arrays& arrays) {
    BOOST_TEST(arrays.dimension() == -1);
    BOOST_TEST(arrays.number_of_points() == 0u);
    BOOST_TEST(arrays.number_of_vertices() == 0u);
    BOOST_TEST(arrays.number_of_simplices() == 0u);
    BOOST_TEST(arrays.number_of_cells() == 0u);
    BOOST_TEST(arrays.stride() == Arrays().stride());
    BOOST_TEST(arrays.is_infinite(0));
  };
  for (const int kind : {0, 1, 2}) { // neighbours beside the vertices, apart, none
    Arrays arrays = delaunay_3_arrays(points);
    if (kind == 1)
      arrays.separate();
    if (kind == 2)
      arrays.drop_neighbors();
    const std::size_t stride = arrays.stride(), cells = arrays.number_of_cells();
    Arrays copy(arrays), assigned;
    assigned = arrays;
    Arrays moved(std::move(arrays));
    check_empty(arrays); // NOLINT: that is what is tested
    arrays = std::move(moved);
    check_empty(moved);
    BOOST_TEST((copy.vertices_data() != arrays.vertices_data()));
    for (Arrays* const a : {&arrays, &copy, &assigned}) {
      BOOST_TEST(a->stride() == stride);
      BOOST_TEST(a->number_of_cells() == cells);
      BOOST_TEST((a->neighbors_data() == nullptr) == (kind == 2));
      if (kind < 2)
        check_arrays(*a, points);
      else
        BOOST_TEST((a->vertices(cells - 1) == delaunay_3_arrays(points).vertices(cells - 1)));
      a->drop_infinite_cells(); // and the others keep them
    }
  }
  Arrays nothing, other(nothing);
  other = std::move(nothing);
  check_empty(other);
}

namespace {

using Level = CGAL::Delaunay_validity_level;
using Arrays_of_points = CGAL::Delaunay_3_arrays<std::int32_t>;

// The first level at which spoilt arrays are found out; 4 if they never are.
int found_out_at(const std::vector<Point>& points,
                 const std::function<void(Arrays_of_points&, std::int32_t* entries)>& spoil)
{
  Arrays_of_points arrays = delaunay_3_arrays(points);
  spoil(arrays, const_cast<std::int32_t*>(arrays.vertices_data())); // cell c at entries + 8 c
  int level = 0;
  while (level < 4 && CGAL::is_valid_delaunay_3_arrays(arrays, points, Level(level)))
    ++level;
  for (int l = level; l < 4; ++l)
    BOOST_TEST(!CGAL::is_valid_delaunay_3_arrays(arrays, points, Level(l)));
  return level;
}

} // namespace

BOOST_AUTO_TEST_CASE(levels_of_validity)
{
  const std::vector<Point> space = surfaces::sphere(200, .1).points;
  const std::vector<Point> plane = grid(6, 7, 1), line = grid(1, 9, 1);
  const auto nothing = [](auto&, auto*) {};
  for (const auto& points : {space, plane, line, grid(1, 1, 1), grid(3, 4, 5)})
    BOOST_TEST(found_out_at(points, nothing) == 4);
  for (const auto& points : {space, plane, line}) {
    const int corners = points.size() == 200 ? 4 : points.size() == 42 ? 3 : 2;
    BOOST_TEST(found_out_at(points, [](auto&, auto* entries) { entries[4] = -1; }) == 0);
    BOOST_TEST(found_out_at(points, [](auto&, auto* entries) { entries[4] = entries[5]; }) == 0);
    BOOST_TEST(found_out_at(points, [](auto&, auto* entries) { entries[1] = entries[0]; }) == 0);
    BOOST_TEST(found_out_at(points, [](auto&, auto* entries) { entries[1] = 1000; }) == 0);
    // One cell turned inside out; segments need not be oriented alike.
    const int one_turned = found_out_at(points, [](auto&, auto* entries) {
      std::swap(entries[0], entries[1]);
      std::swap(entries[4], entries[5]);
    });
    BOOST_TEST(one_turned == (corners == 2 ? 4 : 0));
    // All of them.
    const int turned = found_out_at(points, [](auto& arrays, auto* entries) {
      for (std::size_t c = 0; c < arrays.number_of_cells(); ++c) {
        std::swap(entries[8 * c], entries[8 * c + 1]);
        std::swap(entries[8 * c + 4], entries[8 * c + 5]);
      }
    });
    BOOST_TEST(turned == (corners == 4 ? 2 : 4)); // planes and lines are seen from either side
  }
  // One point more, which is in no cell; and two that are said to be one.
  std::vector<Point> more = space;
  more.push_back(Point(0, 0, .01));
  BOOST_TEST(!CGAL::is_valid_delaunay_3_arrays(delaunay_3_arrays(space), more, Level::LINKS));
  std::vector<Point> twice = space;
  twice.push_back(space[7]);
  Arrays_of_points of_twice = delaunay_3_arrays(twice);
  BOOST_TEST(CGAL::is_valid_delaunay_3_arrays(of_twice, twice));
  twice.back() = Point(0, 0, .01);
  BOOST_TEST(CGAL::is_valid_delaunay_3_arrays(of_twice, twice, Level::EULER));
  BOOST_TEST(!CGAL::is_valid_delaunay_3_arrays(of_twice, twice, Level::ORIENTATION));
  const_cast<std::int32_t&>(of_twice.vertices_of_points()[200]) = 200;
  BOOST_TEST(!CGAL::is_valid_delaunay_3_arrays(of_twice, twice, Level::LINKS));

  // A vertex that is moved, and one that is moved little.
  for (const double far : {10., .02}) {
    std::vector<Point> moved = space;
    moved[17] = Point(moved[17].x() + far, moved[17].y(), moved[17].z());
    const Arrays_of_points arrays = delaunay_3_arrays(space);
    BOOST_TEST(CGAL::is_valid_delaunay_3_arrays(arrays, moved, Level::EULER));
    BOOST_TEST(CGAL::is_valid_delaunay_3_arrays(arrays, moved, Level::ORIENTATION) == (far < 1));
    BOOST_TEST(!CGAL::is_valid_delaunay_3_arrays(arrays, moved));
  }
  Arrays_of_points arrays = delaunay_3_arrays(space);
  arrays.drop_infinite_cells();
  BOOST_CHECK_THROW(CGAL::is_valid_delaunay_3_arrays(arrays, space), std::invalid_argument);
  arrays = delaunay_3_arrays(space);
  arrays.drop_neighbors();
  BOOST_CHECK_THROW(CGAL::is_valid_delaunay_3_arrays(arrays, space), std::invalid_argument);
}

// Four points on a square, whose other diagonal is as good but for CGAL's perturbation.
BOOST_AUTO_TEST_CASE(what_only_the_last_level_sees)
{
  const std::vector<Point> square = grid(2, 2, 1);
  Arrays_of_points arrays = delaunay_3_arrays(square);
  auto* const entries = const_cast<std::int32_t*>(arrays.vertices_data());
  // Every index turned by a quarter: (i, j) becomes (j, 1 - i). The diagonal is the other one.
  const std::int32_t turned[] = {1, 3, 0, 2};
  for (std::size_t c = 0; c < arrays.number_of_cells(); ++c)
    for (std::size_t k = 0; k < 3; ++k)
      if (std::int32_t& v = entries[8 * c + k]; v >= 0)
        v = turned[v];
  BOOST_TEST(CGAL::is_valid_delaunay_3_arrays(arrays, square, Level::ORIENTATION));
  BOOST_TEST(!CGAL::is_valid_delaunay_3_arrays(arrays, square));
}

// Around a vertex or an edge with many simplices, all questions take one turn together; what they find
// is the least simplex, as that of a few questions is.
BOOST_AUTO_TEST_CASE(many_questions_at_a_hub)
{
  const std::size_t n = 2000;
  std::vector<std::array<double, 3>> points = {{0, 0, 0}, {0, 0, 8}};
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 6.283185 * double(i) / double(n);
    points.push_back({std::cos(t), std::sin(t), 0.3 * std::sin(5 * t)});
  }
  std::vector<double> questions;
  for (std::size_t i = 0; i < n; ++i) {
    questions.insert(questions.end(), {0, 0, 0});
    questions.insert(questions.end(), {0, 0, 8 * double(i + 1) / double(n + 1)});
    questions.insert(questions.end(),
                     {points[i + 2][0] / 2, points[i + 2][1] / 2, points[i + 2][2] / 2});
    questions.insert(questions.end(), {points[i + 2][0], points[i + 2][1], points[i + 2][2]});
  }
  const auto arrays = CGAL::delaunay_3_arrays(points);
  const DFS::internal::Simplices_view<std::int32_t> view = {arrays.vertices_data(),
                                                            arrays.stride(),
                                                            arrays.neighbors_data(),
                                                            arrays.stride(),
                                                            arrays.number_of_simplices(),
                                                            arrays.number_of_cells(),
                                                            points.size()};
  std::size_t asked = 0;
  const auto point_of = [&](std::size_t i) {
    ++asked;
    return points[i];
  };
  std::vector<std::int32_t> found(questions.size() / 3);
  DFS::internal::find_simplices(view, point_of,
                                DFS::internal::Point_array(questions.data(), found.size()),
                                found.data(), DFS::internal::Alone());
  BOOST_TEST(asked < 200 * found.size());
  for (std::size_t k = 0; k < found.size(); k += 97) {
    DFS::internal::Find_simplex<std::int32_t, decltype(point_of)> alone(view, point_of);
    BOOST_TEST(alone({questions[3 * k], questions[3 * k + 1], questions[3 * k + 2]}) == found[k]);
  }
}

// The points of the last ones differ by denormal numbers.
BOOST_AUTO_TEST_CASE(validity_in_every_rounding_mode)
{
  for (const double size : {1., 0.1, 0x1p-1060}) {
    std::vector<Point> points;
    for (const Point& p : grid(5, 5, 5))
      points.push_back(Point(size * p.x(), size * p.y(), size * p.z()));
    const Arrays_of_points arrays = delaunay_3_arrays(points);
    for (const fuzz::Rounding_mode& mode : fuzz::rounding_modes) {
      const fuzz::Rounding rounding(mode);
      const bool is_valid = CGAL::is_valid_delaunay_3_arrays(arrays, points);
      const bool is_kept = rounding.is_kept();
      BOOST_TEST(is_valid, mode.name);
      BOOST_TEST(is_kept, mode.name);
    }
  }
}

// Whoever has set the mode: what no macro tells is found, and what lives in Rounding_to_nearest keeps
// denormal numbers, on all threads.
BOOST_AUTO_TEST_CASE(denormal_numbers_in_a_mode_without_them)
{
  for (const fuzz::Rounding_mode& mode : fuzz::rounding_modes) {
    std::vector<std::array<double, 3>> points;
    for (const Point& p : grid(5, 5, 5))
      points.push_back({p.x() * 1e-310, p.y() * 1e-320, p.z() * 5e-324});
    const fuzz::Rounding rounding(mode);
    const bool has_obstacle = DFS::internal::obstacle_of_core() != nullptr;
    const bool is_without = mode.takes_denormals_for_zero && fuzz::bits_of_arithmetic() != 0;
    const auto arrays = CGAL::delaunay_3_arrays(points);
    const bool is_valid = CGAL::is_valid_delaunay_3_arrays(arrays, points);
    BOOST_TEST((has_obstacle || !is_without), mode.name);
    BOOST_TEST(is_valid, mode.name);
    BOOST_TEST(arrays.dimension() == 3, mode.name);
    BOOST_TEST(arrays.number_of_simplices() >= 5u * 64u, mode.name);
  }
}

BOOST_AUTO_TEST_CASE(visitors_are_called_in_the_rounding_mode_of_the_caller)
{
  struct Mode_visitor : CGAL::Default_surface_insertion_visitor_3
  {
    std::set<int> modes;
    bool go_further(std::size_t) { return modes.insert(std::fegetround()), true; }
  };
  for (const auto& points : {grid(4, 4, 4), grid(5, 5, 1), grid(9, 1, 1)})
    for (const bool has_faces : {false, true}) {
      Mode_visitor visitor;
      const auto np = CGAL::parameters::visitor(std::ref(visitor));
      std::fesetround(FE_UPWARD);
      const auto arrays = has_faces ? delaunay_3_arrays(points, Faces{{0, 1, 2}}, np)
                                    : delaunay_3_arrays(points, np);
      const int after = std::fegetround();
      std::fesetround(FE_TONEAREST);
      BOOST_TEST(after == FE_UPWARD);
      BOOST_TEST((visitor.modes == std::set<int>{FE_UPWARD}));
      check_arrays(arrays, points);
    }
}

BOOST_AUTO_TEST_CASE(refusals_and_stops)
{
  std::vector<Point> points = grid(4, 4, 4);
  BOOST_CHECK_THROW(delaunay_3_arrays(points, Faces{{0, 1, 64}}), CGAL::Surface_input_error);
  BOOST_CHECK_THROW(delaunay_3_arrays(points, Faces{{0, 1, -1}}), CGAL::Surface_input_error);
  for (const std::size_t stop_before : {0, 1}) { // there are two rounds
    Reasons_visitor visitor;
    visitor.stop_before = stop_before;
    const auto arrays =
        delaunay_3_arrays(grid(5, 5, 5), CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(visitor.asked == stop_before + 1);
    BOOST_TEST(arrays.dimension() == -1);
    BOOST_TEST(arrays.number_of_cells() == 0u);
  }
  Reasons_visitor on_line;
  on_line.stop_before = 0;
  BOOST_TEST(
      delaunay_3_arrays(grid(9, 1, 1), CGAL::parameters::visitor(std::ref(on_line))).dimension() ==
      -1);
  Reasons_visitor irregular;
  check_arrays(delaunay_3_arrays(points, std::vector<std::vector<int>>{{0, 1, 2, 3}},
                                 CGAL::parameters::visitor(std::ref(irregular))),
               points);
  BOOST_TEST(irregular.irregular.size() == 1u);
  points[5] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  BOOST_CHECK_THROW(delaunay_3_arrays(points), CGAL::Surface_input_error);
}

// Points that move keep their order; the cells are theirs all the same.
BOOST_AUTO_TEST_CASE(order_of_the_last_call)
{
  std::vector<Point> points = surfaces::genus_surface(2, 2000, 0.05, 1).points;
  DFS::Insertion_order order;
  check_arrays(delaunay_3_arrays(points, order), points);
  const DFS::Insertion_order first = order;
  BOOST_CHECK_EQUAL(first.order.size(), points.size());
  for (int step = 1; step < 4; ++step) {
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = Point(points[i].x() + 1e-3 * double(i * 7 % 11), points[i].y(),
                        points[i].z() - 1e-3 * double(i * 5 % 13));
    check_arrays(delaunay_3_arrays(points, order), points);
    BOOST_CHECK(order.order == first.order); // it is kept
  }
  // Of fewer points it is made anew; what is none is refused, and so are points.
  points.resize(900);
  check_arrays(delaunay_3_arrays(points, order), points);
  BOOST_CHECK_EQUAL(order.order.size(), points.size());
  DFS::Insertion_order none = order;
  none.order[5] = none.order[6];
  BOOST_CHECK_THROW(delaunay_3_arrays(points, none), CGAL::Surface_input_error);
  check_arrays(delaunay_3_arrays(std::vector<Point>(), order), std::vector<Point>());
  order = DFS::Insertion_order();
  // One that costs too much by now, and so does the next.
  points = surfaces::sphere(2000, 0.05).points;
  for (std::size_t i = 0; i < points.size(); ++i)
    order.order.push_back(i);
  order.round_ends = {points.size()};
  order.starting_places.clear();
  const auto coordinates = DFS::internal::rounded_coordinates(points);
  DFS::internal::Given_points source({coordinates.data(), points.size()});
  Reasons_visitor visitor;
  check_arrays(DFS::internal::insert_into_arrays<std::int32_t>(
                   source, &order, std::nullopt, DFS::internal::Alone(),
                   CGAL::parameters::visitor(std::ref(visitor)), starved()),
               points);
  BOOST_CHECK_EQUAL(visitor.orders_replaced, 2u);
  BOOST_CHECK_EQUAL(order.order.size(), points.size());
}
