// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates of very different size, along an axis or in some of the points, and points on a line:
// equal to plain CGAL's, by the cheap stages of the predicates, and not by an order that is of no
// use.

#define BOOST_TEST_MODULE test_flat_and_far
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_points_along_graph_3.h>

#include "build_in_order.h"
#include "points_and_graphs.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

namespace {

struct Counting_visitor : CGAL::Default_surface_insertion_visitor_3
{
  DFS::Insertion_counts counts;
  std::string reason;

  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints&)
  {
    counts = target.counts();
  }
  void notice(CGAL::Surface_insertion_notice what, const std::string& r)
  {
    if (what == CGAL::Surface_insertion_notice::CORE_IS_REPLACED)
      reason = r;
  }
};

// What was left open by the first filters, by doubles on lattices, too, and by all stages but the last,
// of one point on average.
struct Left_open
{
  double by_filters, by_lattice, by_stages;
};

Left_open left_open(const DFS::Insertion_counts& counts, std::size_t n)
{
  const auto sum = [](const std::size_t* stages) {
    return std::accumulate(stages, stages + DFS::NUMBER_OF_EXACT_STAGES, std::size_t(0));
  };
  const std::size_t open = sum(counts.sphere_tests_by_stage) + sum(counts.facet_tests_by_stage);
  return {double(open) / double(n),
          double(open - counts.sphere_tests_by_stage[DFS::LATTICE] -
                 counts.facet_tests_by_stage[DFS::LATTICE]) /
              double(n),
          double(counts.sphere_tests_by_stage[DFS::ANY_WIDTH] +
                 counts.facet_tests_by_stage[DFS::ANY_WIDTH]) /
              double(n)};
}

// For lattices and rings, where signs are 0.
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
constexpr bool has_integers = true;
#else
constexpr bool has_integers = false;
#endif

// With the faces, and the points alone.
std::vector<Left_open> insert_and_compare(const surfaces::Indexed_surface& surface)
{
  const Triangulation expected(surface.points.begin(), surface.points.end());
  std::vector<Left_open> open;
  for (const bool has_faces : {true, false}) {
    Counting_visitor visitor;
    const auto np = CGAL::parameters::visitor(std::ref(visitor));
    Triangulation tr;
    if (has_faces)
      CGAL::insert_points_3(tr, surface.points, surface.faces, np);
    else
      CGAL::insert_points_3(tr, surface.points, np);
    BOOST_TEST(visitor.reason == "");
    BOOST_TEST((tr == expected));
    open.push_back(left_open(visitor.counts, surface.points.size()));
  }
  return open;
}

} // namespace

BOOST_AUTO_TEST_CASE(flat_sheets)
{
  for (const int k : {38, 40, 45, 52, 66, 80, 92, 120, 160})
    for (const Left_open& open : insert_and_compare(surfaces::noisy_sheet(1000, k, 1)))
      BOOST_TEST_CONTEXT("noise of 2^-" << k)
      {
        BOOST_TEST(open.by_filters < 1);
        BOOST_TEST(open.by_stages < .7);
      }
  for (const Left_open& open : insert_and_compare(surfaces::dented_sheet(1000, 1e-17)))
    BOOST_TEST((open.by_stages < .1 || !has_integers));
}

// A unit that is no power of 2, and points so far apart that doubles round, are left to integers.
BOOST_AUTO_TEST_CASE(lattices)
{
  for (const double step : {1., 0x1p-40, 3., 0x1p10 + 1, .1}) {
    surfaces::Indexed_surface surface;
    for (int i = 0; i < 512; ++i)
      surface.points.emplace_back(step * (i % 8), step * (i / 8 % 8), step * (i / 64));
    for (const Left_open& open : insert_and_compare(surface)) {
      BOOST_TEST(open.by_filters > 5);
      BOOST_TEST((open.by_lattice == 0) == (step < .05 || (step > .5 && step < 100)));
    }
  }
}

// (t, t^2, t^3), where every two points are joined: integers of few bits would decide nearly all tests,
// and columns do so in less time.
BOOST_AUTO_TEST_CASE(moment_curve_of_integers)
{
  surfaces::Indexed_surface surface;
  for (double t = -250; t < 250; ++t)
    surface.points.emplace_back(t, t * t, t * t * t);
  for (std::size_t i = 0; i + 2 < surface.points.size(); ++i)
    surface.faces.push_back({i, i + 1, i + 2});
  for (const Left_open& open : insert_and_compare(surface))
    BOOST_TEST((open.by_filters < 100 || !has_integers)); // of 750 sphere tests
}

// Flat boxes next to others, along each axis: what is asked first in the one is of no use in the
// other.
BOOST_AUTO_TEST_CASE(sheets_beside_a_sphere)
{
  surfaces::Indexed_surface surface = surfaces::sphere(500, 0.01, 1);
  for (int axis = 0; axis < 3; ++axis) {
    const surfaces::Indexed_surface sheet = surfaces::noisy_sheet(500, 60, 1);
    const std::size_t first = surface.points.size();
    for (const Point& p : sheet.points) {
      const double x[3] = {p.x() / 16, p.y() / 16, p.z()};
      surface.points.emplace_back(x[axis], x[(axis + 1) % 3], x[(axis + 2) % 3]);
    }
    for (auto face : sheet.faces) {
      for (auto& v : face)
        v += first;
      surface.faces.push_back(face);
    }
  }
  for (const Left_open& open : insert_and_compare(surface))
    BOOST_TEST(open.by_stages < .1);
}

BOOST_AUTO_TEST_CASE(thin_tubes)
{
  for (const Left_open& open : insert_and_compare(surfaces::thin_tube(1000, 60)))
    BOOST_TEST((open.by_stages < 6 || !has_integers));
}

BOOST_AUTO_TEST_CASE(far_points)
{
  for (const int k : {60, 100, 123, 200, 500, 996})
    for (const Left_open& open : insert_and_compare(surfaces::far_points(1000, k, 1)))
      BOOST_TEST_CONTEXT("every tenth point 2^" << k << " times as far away")
      {
        BOOST_TEST(open.by_stages < .1);
      }
  for (const Left_open& open : insert_and_compare(surfaces::sentinels(1000, 123, 1)))
    BOOST_TEST(open.by_stages < .1);
}

// The same in other numberings and sizes.
BOOST_AUTO_TEST_CASE(all_families)
{
  for (const surfaces::Flat_or_far_family& family : surfaces::flat_and_far_families())
    for (const std::size_t n : {60, 300})
      BOOST_TEST_CONTEXT(family.name << ", " << family.kind << ", " << n << " points")
      {
        surfaces::Indexed_surface surface = family.make(n, n);
        surfaces::shuffle(surface, n);
        insert_and_compare(surface);
      }
}

// --- points on a line ----------------------------------------------------------------------------

// How often an order was made.
struct Counted_rounds : DFS::Geometric_rounds
{
  static inline std::size_t calls = 0;
  using DFS::Geometric_rounds::Geometric_rounds;

  template <class... Arguments>
  DFS::Insertion_order operator()(const Arguments&... arguments) const
  {
    ++calls;
    return DFS::Geometric_rounds::operator()(arguments...);
  }
};

using Counted_traits =
    CGAL::Surface_insertion_policies_3<DFS::Full_graph, Counted_rounds, DFS::Planned_hints_3>;

static std::size_t orders_made(const std::vector<Point>& points)
{
  Counting_visitor visitor;
  std::vector<std::pair<std::size_t, Triangulation::Vertex_handle>> vertices;
  Triangulation tr;
  Counted_rounds::calls = 0;
  CGAL::insert_points_along_graph_3(
      tr, points, tests::Graph(points.size()), Counted_traits(),
      CGAL::parameters::visitor(std::ref(visitor))
          .vertex_to_vertex_output_iterator(std::back_inserter(vertices)));
  BOOST_TEST((tr == Triangulation(points.begin(), points.end())));
  BOOST_TEST(tr.is_valid());
  BOOST_TEST((visitor.reason == "" || visitor.reason == "the points lie in one plane"));
  BOOST_TEST(vertices.size() == points.size());
  for (const auto& [i, v] : vertices)
    BOOST_TEST((v->point() == points[i]));
  return Counted_rounds::calls;
}

// A plan is asked once, whatever the points are like.
BOOST_AUTO_TEST_CASE(plan_of_points_on_a_line)
{
  std::vector<Point> points(500, Point(.1, .2, .3));
  BOOST_TEST(orders_made(points) == 1u);
  points[400] = Point(1, 2, 3);
  BOOST_TEST(orders_made(points) == 1u);
  points[450] = Point(1, 2, 4);
  BOOST_TEST(orders_made(points) == 1u); // in a plane
  surfaces::Indexed_surface line = surfaces::collinear(500);
  surfaces::shuffle(line, 1);
  line.points.insert(line.points.end(), line.points.begin(), line.points.begin() + 100);
  BOOST_TEST(orders_made(line.points) == 1u);
  for (Point& p : line.points)
    p = Point(p.x(), 7, -0.);
  BOOST_TEST(orders_made(line.points) == 1u);
  BOOST_TEST(orders_made({}) == 1u);
  BOOST_TEST(orders_made({Point(1, 1, 1)}) == 1u);
}

// Points on a line are inserted along it, whatever order is given: at random they would take
// quadratic time.
BOOST_AUTO_TEST_CASE(order_of_points_on_a_line)
{
  surfaces::Indexed_surface line = surfaces::collinear(500);
  surfaces::shuffle(line, 1);
  DFS::Insertion_order plan;
  for (std::size_t i = 0; i < line.points.size(); ++i)
    plan.order.push_back(i);
  plan.round_ends = {line.points.size()};
  const auto built = tests::build_in_order(line.points, plan);
  BOOST_TEST(built->dimension == 1);
  BOOST_TEST_REQUIRE(built->order.size == line.points.size());
  const auto lies_before = [&](std::size_t i, std::size_t j) {
    return line.points[i] < line.points[j];
  };
  const std::size_t* const order = built->order.order;
  BOOST_TEST((std::is_sorted(order, order + built->order.size, lies_before) ||
              std::is_sorted(std::reverse_iterator(order + built->order.size),
                             std::reverse_iterator(order), lies_before)));
}

// The faces of points at one place are still looked at.
BOOST_AUTO_TEST_CASE(faces_of_equal_points)
{
  surfaces::Indexed_surface surface = surfaces::all_equal(100);
  Triangulation tr;
  BOOST_TEST(CGAL::insert_points_3(tr, surface.points, surface.faces) == 1);
  surface.faces.push_back({0, 1, surface.points.size()});
  Triangulation untouched;
  BOOST_CHECK_THROW(CGAL::insert_points_3(untouched, surface.points, surface.faces),
                    CGAL::Surface_input_error);
  BOOST_TEST(untouched.number_of_vertices() == 0u);
}
