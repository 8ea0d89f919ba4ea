// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The core: equal to CGAL's own insertion on every input, whatever order and hints it is
// given; and what it does where it cannot serve.

#define BOOST_TEST_MODULE test_compact_kernel
#include <Delaunay_from_surface_3_meters/orders.h>

#include <boost/test/included/unit_test.hpp>

#include "core_traits.h"
#include "differential.h"
#include "parallel_case.h"
#include "points_and_graphs.h"

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Visitor_observer.h>
#include <CGAL/Delaunay_from_surface_3/adapters/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/core/build_by_threads.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_along_graph_3.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using tests::Graph;
using tests::random_points;

// In the order of the points.
struct As_given
{
  explicit As_given(unsigned int) {}
  template <class P, class Gt, class G, class Map>
  DFS::Insertion_order operator()(const std::vector<P>& points, const Gt&, const G&, Map) const
  {
    DFS::Insertion_order plan;
    plan.order = CGAL::Delaunay_from_surface_3::internal::identity_order(points.size());
    if (!points.empty())
      plan.round_ends.push_back(points.size());
    return plan;
  }
};

struct Fallback_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::string reason;
  void notice(CGAL::Surface_insertion_notice what, const std::string& r)
  {
    if (what == CGAL::Surface_insertion_notice::CORE_IS_REPLACED)
      reason = r;
  }
};

namespace {

// Inserts the points with the compact kernel, which must serve, and compares.
template <class Tr = Triangulation, class Plan = As_given>
void check_equal(const std::vector<Point>& points, const Graph& graph)
{
  Fallback_visitor visitor;
  Tr tr;
  CGAL::insert_points_along_graph_3(tr, points, graph, tests::Traits_of_plan<Plan>(),
                                    CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.reason == "");
  BOOST_TEST(tr.is_valid());
  BOOST_TEST((tr == Tr(points.begin(), points.end())));
}

void check_equal(const std::vector<Point>& points)
{
  check_equal<Triangulation>(points, Graph(points.size()));
  check_equal<Triangulation, DFS::Spatial_sort_order>(points, Graph(points.size()));
}

template <class Tr, class T>
std::string reason_for_fallback(Tr& tr, const std::vector<T>& points)
{
  Fallback_visitor visitor;
  CGAL::insert_points_along_graph_3(tr, points, Graph(points.size()),
                                    CGAL::parameters::visitor(std::ref(visitor)));
  return visitor.reason;
}

} // namespace

BOOST_AUTO_TEST_CASE(surfaces_with_all_plans)
{
  tests::check_surfaces_with_nets_and_compact_kernel<Triangulation>(tests::ordinary_surfaces(2000));
  tests::check_surfaces_with_nets_and_compact_kernel<Triangulation>(
      tests::degenerate_surfaces(1500));
  tests::check_surfaces_with_nets_and_compact_kernel<Triangulation>(
      tests::tiny_and_flat_surfaces());
}

BOOST_AUTO_TEST_CASE(coordinates_of_all_sizes)
{
  const std::vector<Point> unit = surfaces::sphere(300, 0.1).points;
  for (const double scale : {1e-300, 1e-150, 1e-40, 1e8, 1e40, 1e60}) {
    std::vector<Point> points;
    for (const Point& p : unit)
      points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    BOOST_TEST_CONTEXT("scale " << scale)
    {
      check_equal(points);
    }
  }
  std::vector<Point> far, flat, flatter, too_flat, mixed;
  CGAL::Random random(4);
  for (const Point& p : unit) {
    far.emplace_back(p.x() + 1e8, p.y() - 1e8, p.z() + 1e8);
    flat.emplace_back(p.x(), p.y(), 1e-250 * p.z());
    flatter.emplace_back(p.x(), p.y(), 1e-310 * p.z()); // denormal: half of it need be no number …
    too_flat.emplace_back(1e20 * p.x(), p.y(), 1e-310 * p.z()); // … as it would be made here
    const double s = std::ldexp(1., random.get_int(-80, 80));
    mixed.emplace_back(s * p.x(), random.get_bool() ? 0. : -0., s * p.z());
    mixed.emplace_back(p.x(), s * p.y(), p.z());
  }
  check_equal(far);
  check_equal(flat);
  check_equal(flatter);
  check_equal(mixed);
  check_equal(too_flat);
}

BOOST_AUTO_TEST_CASE(large_conflict_zones)
{
  // The centre comes last and sees every cell; so does what is far beyond on a line of outliers.
  for (const std::size_t n : {60, 62, 64, 66, 124, 126, 128, 130, 3000}) {
    std::vector<Point> points = surfaces::sphere(n, 0.01).points;
    points.emplace_back(0.001, 0.002, 0.003);
    points.emplace_back(1e4, 1e4, 1e4);
    BOOST_TEST_CONTEXT(n << " points")
    {
      check_equal(points);
    }
  }
}

// Stars of hundreds of cells, and then conflict zones as large: the arrays of zone and boundary
// must grow together. The boundary's once did not, when a star was larger than its zone.
BOOST_AUTO_TEST_CASE(knot_with_a_quadratic_triangulation)
{
  const std::size_t n = 1000;
  std::vector<Point> points;
  Graph graph(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * double(i) / double(n);
    points.emplace_back(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                        -std::sin(3 * t));
    add_edge(i, (i + 1) % n, graph);
  }
  check_equal(points);
  check_equal<Triangulation, DFS::Surface_net_rounds>(points, graph);
  check_equal<Triangulation, DFS::Geometric_rounds>(points, graph);
}

BOOST_AUTO_TEST_CASE(uniform_points_and_duplicates)
{
  std::vector<Point> points = random_points(3000);
  check_equal(points);
  points.insert(points.end(), points.begin(), points.begin() + 500);
  check_equal(points);
}

BOOST_AUTO_TEST_CASE(wrong_graph)
{
  const std::vector<Point> points = random_points(2000);
  Graph graph(points.size());
  CGAL::Random random(2);
  for (int i = 0; i < 6000; ++i)
    add_edge(std::size_t(random.get_int(0, 2000)), std::size_t(random.get_int(0, 2000)), graph);
  check_equal<Triangulation, DFS::Surface_net_rounds>(points, graph);
  check_equal<Triangulation, meters::Neighbor_started_rounds<DFS::Geometric_rounds>>(points, graph);
}

BOOST_AUTO_TEST_CASE(upper_levels_are_filled)
{
  using Fast = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;
  const std::vector<Point> points = random_points(20000);
  check_equal<Fast>(std::vector<Point>(points.begin(), points.begin() + 2000), Graph(2000));
  Fast tr;
  CGAL::insert_points_along_graph_3(tr, points, Graph(points.size()));
  // One of thirty vertices is in the level above, where CGAL makes the levels.
  std::size_t above = 0;
  for (const Fast::Vertex_handle v : tr.finite_vertex_handles())
    above += v->up() != Fast::Vertex_handle();
  BOOST_TEST(above > points.size() / 40);
  BOOST_TEST(above < points.size() / 20);
  BOOST_TEST(tr.is_valid());
}

// One thread and two end in the same way.
BOOST_AUTO_TEST_CASE(more_cells_than_there_may_be)
{
  using namespace DFS::internal;
  const std::vector<std::array<double, 3>> points = tests::points_of("cube", 4000, 1);
  const auto build_within = [&](std::size_t threads, std::size_t most_cells) {
    Given_points source(Point_array(points.front().data(), points.size()));
    Observer nobody;
    Build_options options;
    options.adds_apex = true;
    options.most_cells = most_cells;
    const Thread_executor executor(threads);
    const auto built = build(source, options, nobody, executor);
    if (built->outcome == Insertion_outcome::TOO_MANY_CELLS)
      BOOST_CHECK_THROW(arrays_of_built<std::int32_t>(*built, source, executor), std::length_error);
    return built->outcome;
  };
  for (const std::size_t threads : {1, 2}) {
    BOOST_TEST((build_within(threads, 60000) == Insertion_outcome::COMPLETE));
    for (const std::size_t most : {4, 100, 20000})
      BOOST_TEST((build_within(threads, most) == Insertion_outcome::TOO_MANY_CELLS));
  }
}

namespace {

struct Input_of_points
{
  const std::vector<Point>& points;
  Graph graph;
  boost::typed_identity_property_map<std::size_t> index_map;
};

struct Stopping_visitor : Fallback_visitor
{
  std::size_t calls_left = std::size_t(-1);
  bool go_further(std::size_t) { return calls_left-- > 0; }
};

} // namespace

// CGAL goes on in the same order, and can be stopped.
BOOST_AUTO_TEST_CASE(insertion_in_place_of_the_core_that_gave_up)
{
  using namespace DFS::internal;
  const std::vector<Point> points = random_points(4000);
  const Input_of_points input = {points, Graph(points.size()), {}};
  for (const bool stops : {false, true}) {
    Stopping_visitor visitor;
    const DFS::internal::Rounding_to_nearest rounding;
    Visitor_observer<Stopping_visitor> observer(visitor, rounding);
    if (stops)
      visitor.calls_left = 3000;
    Triangulation tr;
    const auto inserted = insert_through_core<CGAL::Surface_insertion_traits_3>(
        tr, input, DFS::Spaced_rounds(), {0, false, 20000}, observer, Alone());
    BOOST_TEST(visitor.reason ==
               "there are more than 2^30 cells, or 2^31 points: tiles serve these");
    BOOST_TEST(inserted.is_complete == !stops);
    if (!stops)
      BOOST_TEST((tr == Triangulation(points.begin(), points.end())));
  }
}

// What the check after an insertion sees.
BOOST_AUTO_TEST_CASE(validity_of_the_compact_complex)
{
  using Level = CGAL::Delaunay_validity_level;
  using Complex = DFS::internal::Compact_complex<DFS::internal::Compact_vertex>;
  const std::vector<std::array<double, 3>> points = {
      {{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{.3, .3, .3}}};
  // The first level at which a spoilt complex is found out; 4 if it never is.
  const auto level_of = [&](const std::function<void(Complex&)>& spoil) {
    Complex complex(points.size(), [&](std::size_t i) { return points[i]; });
    complex.start({1, 2, 3, 4});
    using namespace DFS::internal;
    Inserter<Alone_with_complex<Compact_vertex>> inserter(complex);
    inserter.dig(5, inserter.walk(5, 0, Read_alone()).cell);
    inserter.fill(5);
    spoil(complex);
    BOOST_TEST((complex.is_valid() && DFS::internal::is_delaunay(complex)) ==
               DFS::internal::is_valid(complex, Level(3)));
    int level = 0;
    while (level < 4 && DFS::internal::is_valid(complex, Level(level)))
      ++level;
    return level;
  };
  const auto built = [&](const std::function<void(Complex&)>& spoil) {
    return level_of(spoil) == 4;
  };
  BOOST_TEST(level_of([](Complex& complex) { complex.cell(0).neighbors[1] ^= 1; }) == 0);
  BOOST_TEST(level_of([](Complex& complex) { complex.vertex(5).coordinates[2] = -.5; }) == 2);
  std::uint32_t c = 0; // a finite cell
  BOOST_TEST(built([&](Complex& complex) { c = complex.vertex(5).cell; }));
  BOOST_TEST(!built([&](Complex& complex) { complex.cell(c).neighbors[1] ^= 1; }));
  BOOST_TEST(!built([&](Complex& complex) { complex.cell(c).neighbors[2] = 4 * 1000; }));
  BOOST_TEST(
      !built([&](Complex& complex) { std::swap(complex.cell(c).v[1], complex.cell(c).v[2]); }));
  BOOST_TEST(!built([&](Complex& complex) { complex.cell(c).v[0] |= Complex::dead; }));
  BOOST_TEST(!built([&](Complex& complex) {
    complex.vertex(5).cell = complex.cell(c).neighbors[0] >> 2; // which has not that vertex …
    complex.vertex(5).cell += complex.vertex(5).cell == 0;      // … nor has cell 1
  }));
  BOOST_TEST(!built([&](Complex& complex) {
    complex.vertex(1).coordinates[0] = .4; // now in the sphere of a cell
    complex.vertex(1).coordinates[1] = .4;
    complex.vertex(1).coordinates[2] = .4;
  }));
}

namespace {

// Its labels run out many times over a few thousand insertions.
struct Vertex_of_short_labels
{
  using Place = const double*;
  using Exact_place = Place;
  static constexpr bool has_weight = false;
  static constexpr std::size_t size = 3;
  double coordinates[3];
  std::uint32_t cell;
  std::uint16_t label;
};

// The cells of points that are inserted one after the other, in scalar code.
template <class Vertex>
std::vector<std::array<tests::Id, 4>>
cells_in_scalars(const std::vector<std::array<double, 3>>& points)
{
  using namespace DFS::internal;
  tests::Subject<Vertex> subject(points);
  Conflict_zone zone;
  Compact_predicates<Vertex> predicates(subject.complex, zone.counts);
  Fill_star<Vertex> fill;
  Id last = subject.any_vertex;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (subject.vertex_of[i] == 0) {
      const Id p = Compact_numbers::vertex_of_point(i);
      const Compact_location place = Walk_to_conflict<Sphere_filter, Read_alone>()(
          subject.complex, predicates, p, subject.complex.vertex(last).cell);
      subject.vertex_of[i] = last = place.vertex != 0 ? place.vertex : p;
      if (place.vertex != 0)
        continue;
      Dig_conflict_zone<Explore_neighbors>()(subject.complex, predicates, zone, p, place.cell);
      fill(subject.complex, zone, p);
    }
  BOOST_TEST(is_valid(subject.complex, CGAL::Delaunay_validity_level::DELAUNAY));
  return subject.cells();
}

} // namespace

BOOST_AUTO_TEST_CASE(scalar_code_and_labels_that_start_again)
{
  for (const char* const kind :
       {"cube", "duplicates", "sphere", "lattice", "moment curve", "hub"}) {
    const auto points = tests::points_of(kind, kind[0] == 'm' ? 300 : 4000, 1);
    const auto expected = tests::cells_by_one(points);
    BOOST_TEST((cells_in_scalars<DFS::internal::Compact_vertex>(points) == expected), kind);
    BOOST_TEST((cells_in_scalars<Vertex_of_short_labels>(points) == expected), kind);
  }
}

// The filters go past the predicates of the traits: any that is not the kernel's own must stop
// them.
template <class Predicate>
struct Replaced : Predicate
{
};

struct Own_circle_test : Kernel
{
  Replaced<Kernel::Coplanar_side_of_bounded_circle_3>
  coplanar_side_of_bounded_circle_3_object() const
  {
    return {};
  }
};

struct Own_comparison : Kernel
{
  Replaced<Kernel::Compare_xyz_3> compare_xyz_3_object() const { return {}; }
};

struct Own_planar_orientation : Kernel
{
  Replaced<Kernel::Coplanar_orientation_3> coplanar_orientation_3_object() const { return {}; }
};

struct Own_orientation : Kernel
{
  Replaced<Kernel::Orientation_3> orientation_3_object() const { return {}; }
};

struct Own_sphere_test : Kernel
{
  Replaced<Kernel::Side_of_oriented_sphere_3> side_of_oriented_sphere_3_object() const
  {
    return {};
  }
};

struct Nothing_replaced : Kernel
{
};

// A point that belongs to no kernel, and what a triangulation needs to know of it.
struct Own_point
{
  Own_point(double a = 0, double b = 0, double c = 0)
    : coordinates{a, b, c}
  {
  }
  explicit Own_point(CGAL::Origin) {}
  double x() const { return coordinates[0]; }
  double y() const { return coordinates[1]; }
  double z() const { return coordinates[2]; }
  operator Point() const { return Point(x(), y(), z()); }
  friend bool operator==(const Own_point& p, const Own_point& q)
  {
    return p.coordinates == q.coordinates;
  }
  friend bool operator!=(const Own_point& p, const Own_point& q) { return !(p == q); }

  std::array<double, 3> coordinates = {};
};

template <class Functor>
struct Of_own_points
{
  using result_type = typename Functor::result_type;
  template <class... P>
  result_type operator()(const P&... p) const
  {
    return Functor()(Point(p)...);
  }
};

struct Traits_of_own_points : Kernel
{
  using Point_3 = Own_point;
  using Point = Own_point;
  template <class Functor>
  using Of = Of_own_points<Functor>;
  using Orientation_3 = Of<Kernel::Orientation_3>;
  using Compare_xyz_3 = Of<Kernel::Compare_xyz_3>;
  using Compute_x_3 = Of<Kernel::Compute_x_3>;
  using Compute_y_3 = Of<Kernel::Compute_y_3>;
  using Compute_z_3 = Of<Kernel::Compute_z_3>;
  using Less_x_3 = Of<Kernel::Less_x_3>;
  using Less_y_3 = Of<Kernel::Less_y_3>;
  using Less_z_3 = Of<Kernel::Less_z_3>;
  Orientation_3 orientation_3_object() const { return {}; }
  Compare_xyz_3 compare_xyz_3_object() const { return {}; }
  Compute_x_3 compute_x_3_object() const { return {}; }
  Compute_y_3 compute_y_3_object() const { return {}; }
  Compute_z_3 compute_z_3_object() const { return {}; }
  Less_x_3 less_x_3_object() const { return {}; }
  Less_y_3 less_y_3_object() const { return {}; }
  Less_z_3 less_z_3_object() const { return {}; }
  Of<Kernel::Side_of_oriented_sphere_3> side_of_oriented_sphere_3_object() const { return {}; }
  Of<Kernel::Coplanar_side_of_bounded_circle_3> coplanar_side_of_bounded_circle_3_object() const
  {
    return {};
  }
  Of<Kernel::Coplanar_orientation_3> coplanar_orientation_3_object() const { return {}; }
  Of<Kernel::Compare_distance_3> compare_distance_3_object() const { return {}; }
  struct Construct_point_3
  {
    const Own_point& operator()(const Own_point& p) const { return p; }
  };
  Construct_point_3 construct_point_3_object() const { return {}; }
};

template <class Gt>
constexpr bool is_served = DFS::internal::serves_geom_traits<CGAL::Delaunay_triangulation_3<Gt>>();

BOOST_AUTO_TEST_CASE(traits_with_predicates_of_their_own_are_not_served)
{
  BOOST_TEST(is_served<Kernel>);
  BOOST_TEST(is_served<Nothing_replaced>);
  BOOST_TEST(!is_served<Own_circle_test>);
  BOOST_TEST(!is_served<Own_comparison>);
  BOOST_TEST(!is_served<Own_planar_orientation>);
  BOOST_TEST(!is_served<Own_orientation>);
  BOOST_TEST(!is_served<Own_sphere_test>);
}

BOOST_AUTO_TEST_CASE(falls_back_and_says_so)
{
  std::vector<Point> points = random_points(100);
  Triangulation tr;
  BOOST_TEST(reason_for_fallback(tr, points) == "");
  BOOST_TEST(reason_for_fallback(tr, points) == "the triangulation is not empty");
  BOOST_TEST((tr == Triangulation(points.begin(), points.end())));

  const std::vector<Point> flat = surfaces::coplanar(50).points;
  Triangulation plane;
  BOOST_TEST(reason_for_fallback(plane, flat) == "the points lie in one plane");
  BOOST_TEST((plane == Triangulation(flat.begin(), flat.end())));

  CGAL::Delaunay_triangulation_3<CGAL::Simple_cartesian<double>> unfiltered;
  BOOST_TEST(reason_for_fallback(unfiltered, points) ==
             "the predicates of the geometric traits are not the exact ones of a kernel");

  std::vector<Own_point> own;
  for (const Point& p : points)
    own.emplace_back(p.x(), p.y(), p.z());
  CGAL::Delaunay_triangulation_3<Traits_of_own_points> of_own;
  CGAL::insert_points_3(of_own, own);
  BOOST_TEST(of_own.number_of_cells() ==
             Triangulation(points.begin(), points.end()).number_of_cells());
}
