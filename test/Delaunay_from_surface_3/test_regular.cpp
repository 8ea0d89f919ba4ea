// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points with weights into a Regular_triangulation_3, next to CGAL's own insertion: cells,
// vertices, the set of hidden points, and where these are kept.

#define BOOST_TEST_MODULE test_regular
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/vertex_info.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/insert_weighted_points_3.h>
#include <CGAL/property_map.h>

#include <boost/iterator/zip_iterator.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <list>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;
namespace parameters = CGAL::parameters;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

namespace {

template <class K>
using Point_of = typename K::Weighted_point_3;
using Point = Point_of<Kernel>;
using Points = std::vector<Point>;
using Numbers = std::array<double, 4>;
using Triangulation = CGAL::Regular_triangulation_3<Kernel>;
using Vertex_handle = Triangulation::Vertex_handle;

template <class K>
using Cell_base = CGAL::Regular_triangulation_cell_base_3<K>;
using Vertex_base = CGAL::Regular_triangulation_vertex_base_3<Kernel>;
using Info_base = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, Vertex_base>;
template <class Vb, class Cb>
using Tds = CGAL::Triangulation_data_structure_3<Vb, Cb>;
using With_info = CGAL::Regular_triangulation_3<Kernel, Tds<Info_base, Cell_base<Kernel>>>;

// --- the points --------------------------------------------------------------------------------

Point weighted(double x, double y, double z, double w)
{
  return Point(Kernel::Point_3(x, y, z), w);
}

Points cube(std::size_t n, double least, double most)
{
  CGAL::Random random(5);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.get_double(), y = random.get_double(), z = random.get_double();
    points.push_back(weighted(x, y, z, least + (most - least) * random.get_double()));
  }
  return points;
}

// A chain of atoms, weighted by the squares of radii that a probe enlarges.
Points protein(std::size_t n)
{
  CGAL::Random random(6);
  Points points;
  std::array<double, 3> at = {{0, 0, 0}};
  for (std::size_t i = 0; i < n; ++i) {
    for (double& c : at)
      c = std::fmod(c + random.get_double(-1.5, 1.5), 12.);
    const double radius = 1.4 + std::array<double, 3>{{1.52, 1.7, 1.8}}[i % 3];
    points.push_back(weighted(at[0], at[1], at[2], radius * radius));
  }
  return points;
}

template <class Weight>
Points lattice(int n, const Weight& weight)
{
  Points points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        points.push_back(weighted(x, y, z, weight(x, y, z)));
  return points;
}

// Points of a small lattice, most of them several times.
Points copies()
{
  CGAL::Random random(8);
  Points points;
  for (int i = 0; i < 1500; ++i) {
    const int x = random.get_int(0, 6), y = random.get_int(0, 6), z = random.get_int(0, 6);
    points.push_back(weighted(x, y, z, random.get_int(-1, 3)));
  }
  return points;
}

Points without(Points points, bool x, bool y, bool z)
{
  for (Point& p : points)
    p = weighted(x ? 0 : p.x(), y ? 0 : p.y(), z ? 0 : p.z(), p.weight());
  return points;
}

Points heaviest_last()
{
  Points points = cube(500, 0, 0.001);
  points.push_back(weighted(.5, .5, .5, .4));
  points.push_back(weighted(.4, .5, .5, .5));
  return points;
}

Points all_hidden_but_four()
{
  Points points = cube(300, 0, 0.001);
  for (int c = 0; c < 4; ++c)
    points.push_back(weighted(c == 1 ? 9 : -1, c == 2 ? 9 : -1, c == 3 ? 9 : -1, 1000));
  return points;
}

std::map<std::string, Points> sets_of_points()
{
  CGAL::Random random(9);
  const auto lifted_to_plane = [](int x, int y, int z) {
    return double(x * x + y * y + z * z - 3 * x + 2 * y - z);
  };
  return {{"weights 0", cube(800, 0, 0)},
          {"small weights", cube(800, 0, 0.005)},
          {"large weights", cube(800, -0.1, 0.1)},
          {"protein", protein(1000)},
          {"lattice, equal weights", lattice(7, [](int, int, int) { return 2.; })},
          {"lattice", lattice(8, [&](int, int, int) { return double(random.get_int(0, 4)); })},
          {"copies", copies()},
          {"lifted to a plane", lattice(6, lifted_to_plane)},
          {"heaviest last", heaviest_last()},
          {"all hidden but four", all_hidden_but_four()}};
}

std::map<std::string, Points> sets_without_volume()
{
  return {{"plane", without(cube(300, 0, 0.01), false, true, false)},
          {"flat lattice", without(copies(), true, false, false)},
          {"line", without(cube(100, 0, 0.01), true, true, false)},
          {"copies on a line", without(copies(), true, false, true)},
          {"one place", without(cube(50, 0, 1), true, true, true)},
          {"one point", cube(1, 0, 1)},
          {"none", {}}};
}

// --- checks ------------------------------------------------------------------------------------

template <class P>
Numbers numbers(const P& p)
{
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()),
           CGAL::to_double(p.weight())}};
}

template <class Tr>
std::set<Numbers> visible(const Tr& tr)
{
  std::set<Numbers> points;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    points.insert(numbers(v->point()));
  return points;
}

template <class Tr>
std::set<Numbers> hidden(const Tr& tr)
{
  std::set<Numbers> points;
  for (auto c = tr.tds().cells().begin(); c != tr.tds().cells().end(); ++c)
    for (auto p = c->hidden_points_begin(); p != c->hidden_points_end(); ++p)
      points.insert(numbers(*p));
  return points;
}

// Each hidden point is kept in a cell that contains it and has nothing against it.
template <class Tr>
void check_places_of_hidden_points(const Tr& tr)
{
  if (tr.dimension() < 3)
    return;
  for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    for (auto p = c->hidden_points_begin(); p != c->hidden_points_end(); ++p) {
      typename Tr::Locate_type type;
      int i, j;
      BOOST_TEST_REQUIRE(!tr.is_infinite(c));
      BOOST_TEST((tr.side_of_cell(*p, c, type, i, j) != CGAL::ON_UNBOUNDED_SIDE));
      BOOST_TEST((tr.side_of_power_sphere(c, *p, true) != CGAL::ON_BOUNDED_SIDE));
    }
}

template <class Tr, class Plain>
void check_equal(const Tr& tr, const Plain& plain)
{
  BOOST_TEST(tr.is_valid());
  BOOST_TEST((tr == plain));
  BOOST_TEST(tr.number_of_cells() == plain.number_of_cells());
  BOOST_TEST((visible(tr) == visible(plain)));
  BOOST_TEST((hidden(tr) == hidden(plain)));
  check_places_of_hidden_points(tr);
}

// Remembers why the core does not insert, and stops before an insertion.
struct Visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::string replaced;
  std::size_t asked = 0, stop_before = std::size_t(-1);
  bool throws = false;

  void notice(CGAL::Surface_insertion_notice what, const std::string& reason)
  {
    if (what == CGAL::Surface_insertion_notice::CORE_IS_REPLACED)
      replaced = reason;
  }
  bool go_further(std::size_t)
  {
    if (asked++ != stop_before)
      return true;
    if (throws)
      throw std::runtime_error("the visitor throws");
    return false;
  }
};

// Inserts, checks, and returns why the core does not insert.
template <class Tr = Triangulation, class Items>
std::string check(const Items& items)
{
  Tr tr, by_few;
  const Tr plain(items.begin(), items.end());
  Visitor visitor;
  BOOST_TEST(CGAL::insert_points_3(tr, items, parameters::visitor(std::ref(visitor))) ==
             std::ptrdiff_t(plain.number_of_vertices()));
  check_equal(tr, plain);
  CGAL::insert_points_3(by_few, items); // fewer than thirty go to CGAL at once
  check_equal(by_few, plain);
  return visitor.replaced;
}

// The vertices that are written are those of the points, and null for hidden ones.
template <class Tr>
void check_vertices(const Tr& tr, const Points& points,
                    const std::vector<std::pair<std::size_t, typename Tr::Vertex_handle>>& vertices)
{
  const std::set<Numbers> there = visible(tr);
  BOOST_TEST_REQUIRE(vertices.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [index, v] = vertices[i];
    BOOST_TEST_REQUIRE(index == i);
    BOOST_TEST_REQUIRE((v != typename Tr::Vertex_handle()) ==
                       (there.count(numbers(points[i])) == 1));
    if (v != typename Tr::Vertex_handle())
      BOOST_TEST((numbers(v->point()) == numbers(points[i])));
  }
}

std::vector<std::pair<Point, int>> with_infos(const Points& points)
{
  std::vector<std::pair<Point, int>> pairs;
  for (const Point& p : points)
    pairs.emplace_back(p, int(pairs.size()));
  return pairs;
}

// The info is the smallest index of the point.
void check_infos(const With_info& tr, const Points& points)
{
  std::map<Numbers, int> smallest;
  for (std::size_t i = 0; i < points.size(); ++i)
    smallest.emplace(numbers(points[i]), int(i));
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    BOOST_TEST_REQUIRE(v->info() == smallest.at(numbers(v->point())));
}

} // namespace

BOOST_AUTO_TEST_CASE(all_kinds_of_points)
{
  for (const auto& [name, points] : sets_of_points())
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(check(points) == "");
    }
}

BOOST_AUTO_TEST_CASE(points_without_volume)
{
  for (const auto& [name, points] : sets_without_volume())
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(check(points) == "the points lie in one plane");
    }
}

BOOST_AUTO_TEST_CASE(few_points)
{
  const Points many = copies();
  for (std::ptrdiff_t n = 0; n < 40; ++n)
    check(Points(many.begin() + 40 * n / 2, many.begin() + 40 * n / 2 + n));
}

BOOST_AUTO_TEST_CASE(ranges_and_parameters)
{
  const Points points = cube(500, 0, 0.05);
  const Triangulation plain(points.begin(), points.end());
  const auto check = [&](const auto& insert) {
    Triangulation tr;
    insert(tr);
    check_equal(tr, plain);
  };
  check([&](Triangulation& tr) {
    CGAL::insert_points_3(tr, points.begin(), points.end(), parameters::random_seed(3));
  });
  check([&](Triangulation& tr) {
    CGAL::insert_points_3(tr, std::list<Point>(points.begin(), points.end()));
  });
  using Item = std::pair<std::string, Point>;
  std::list<Item> items;
  std::vector<CGAL::Simple_cartesian<double>::Weighted_point_3> of_other_kernel;
  for (const Point& p : points) {
    items.emplace_back("", p);
    of_other_kernel.emplace_back(CGAL::Simple_cartesian<double>::Point_3(p.x(), p.y(), p.z()),
                                 p.weight());
  }
  check([&](Triangulation& tr) {
    CGAL::insert_points_3(tr, items,
                          parameters::point_map(CGAL::Second_of_pair_property_map<Item>()));
  });
  check([&](Triangulation& tr) { CGAL::insert_points_3(tr, of_other_kernel); });
}

BOOST_AUTO_TEST_CASE(vertices_of_points)
{
  auto sets = sets_of_points();
  sets.merge(sets_without_volume());
  for (const auto& [name, points] : sets)
    BOOST_TEST_CONTEXT(name)
    {
      std::vector<std::pair<std::size_t, Vertex_handle>> vertices, again;
      Triangulation tr;
      CGAL::insert_points_3(
          tr, points, parameters::vertex_to_vertex_output_iterator(std::back_inserter(vertices)));
      check_vertices(tr, points, vertices);
      CGAL::insert_points_3( // through CGAL's insertion
          tr, points, parameters::vertex_to_vertex_output_iterator(std::back_inserter(again)));
      BOOST_TEST((again == vertices));
      if (points.empty())
        continue;
      Triangulation begun; // some vertices are hidden later, and their memory is used again
      begun.insert(points.back());
      again.clear();
      CGAL::insert_points_3(
          begun, points, parameters::vertex_to_vertex_output_iterator(std::back_inserter(again)));
      check_vertices(begun, points, again);
    }
}

BOOST_AUTO_TEST_CASE(smallest_index_gives_info)
{
  for (const Points& points :
       {copies(), cube(500, 0, 0.05), without(copies(), true, false, false)}) {
    const auto pairs = with_infos(points);
    std::vector<int> infos;
    for (const auto& pair : pairs)
      infos.push_back(pair.second);
    const Triangulation plain(points.begin(), points.end());
    const auto check = [&](const auto& insert) {
      With_info tr;
      insert(tr);
      check_equal(tr, plain);
      check_infos(tr, points);
    };
    check([&](With_info& tr) { CGAL::insert_points_3(tr, pairs); });
    check([&](With_info& tr) {
      CGAL::insert_points_3(
          tr, boost::make_zip_iterator(boost::make_tuple(points.begin(), infos.begin())),
          boost::make_zip_iterator(boost::make_tuple(points.end(), infos.end())));
    });
    check([&](With_info& tr) {
      CGAL::insert_points_3(tr, points, DFS::vertex_info_range(infos).random_seed(5));
    });
    check([&](With_info& tr) { // some are there already
      CGAL::insert_points_3(tr, points.begin() + 10, points.begin() + 20);
      CGAL::insert_points_3(tr, pairs);
    });
  }
}

BOOST_AUTO_TEST_CASE(vertices_in_the_order_of_the_input)
{
  for (const Points& points : {copies(), cube(500, 0, 0.05)}) {
    Triangulation tr;
    CGAL::insert_points_3(tr, points, parameters::preserve_order(true));
    check_equal(tr, Triangulation(points.begin(), points.end()));
    std::set<Numbers> to_come = visible(tr);
    auto v = tr.finite_vertices_begin();
    for (const Point& p : points)
      if (to_come.erase(numbers(p)) == 1)
        BOOST_TEST_REQUIRE((numbers((v++)->point()) == numbers(p)));
    BOOST_TEST((v == tr.finite_vertices_end()));
  }
  Triangulation flat;
  BOOST_CHECK_THROW(
      CGAL::insert_points_3(flat, sets_without_volume()["plane"], parameters::preserve_order(true)),
      CGAL::Surface_input_error);
  BOOST_TEST(flat.number_of_vertices() == 0u);
}

BOOST_AUTO_TEST_CASE(hidden_points_that_are_discarded)
{
  using Base =
      CGAL::Regular_triangulation_cell_base_3<Kernel, CGAL::Triangulation_cell_base_3<Kernel>,
                                              CGAL::Discard_hidden_points>;
  using Tr = CGAL::Regular_triangulation_3<Kernel, Tds<Vertex_base, Base>>;
  for (const Points& points : {copies(), cube(500, -0.1, 0.1)}) {
    BOOST_TEST(check<Tr>(points) == "");
    Tr tr;
    CGAL::insert_points_3(tr, points);
    BOOST_TEST(hidden(tr).empty());
  }
}

BOOST_AUTO_TEST_CASE(exact_kernel)
{
  using Tr = CGAL::Regular_triangulation_3<Exact_kernel>;
  using Exact_point = Point_of<Exact_kernel>;
  for (const Points& points : {copies(), cube(200, -0.1, 0.1)}) {
    std::vector<Exact_point> exact;
    for (const Point& p : points)
      exact.emplace_back(Exact_kernel::Point_3(p.x(), p.y(), p.z()), p.weight());
    BOOST_TEST(check<Tr>(exact) == "");
    exact[7] = Exact_point(exact[7].point(), exact[7].weight() / 3 + 1);
    BOOST_TEST(check<Tr>(exact) == "the weight of point 7 is not a double");
    exact[6] = Exact_point(Exact_kernel::Point_3(Exact_kernel::FT(1) / 3, 0, 0), 1);
    exact[7] = exact[8];
    BOOST_TEST(check<Tr>(exact) == "a coordinate of point 6 is not a double");
  }
}

// Where the core would go past predicates, or these are not exact, CGAL inserts.
struct Kernel_with_own_predicate : Kernel
{
  struct Power_side_of_oriented_power_sphere_3 : Kernel::Power_side_of_oriented_power_sphere_3
  {
  };
  Power_side_of_oriented_power_sphere_3 power_side_of_oriented_power_sphere_3_object() const
  {
    return {};
  }
};
template <class Gt>
constexpr bool is_served = DFS::internal::serves_geom_traits<CGAL::Regular_triangulation_3<Gt>>();
static_assert(is_served<Kernel> && is_served<Exact_kernel>, "");
static_assert(!is_served<CGAL::Simple_cartesian<double>>, "");
static_assert(!is_served<Kernel_with_own_predicate>, "");

BOOST_AUTO_TEST_CASE(predicates_that_are_not_the_ones_of_a_kernel)
{
  using Tr = CGAL::Regular_triangulation_3<Kernel_with_own_predicate>;
  BOOST_TEST(check<Tr>(copies()) ==
             "the predicates of the geometric traits are not the exact ones of a kernel");
}

BOOST_AUTO_TEST_CASE(triangulation_that_is_not_empty)
{
  for (const auto& [name, points] : sets_of_points())
    BOOST_TEST_CONTEXT(name)
    {
      const auto middle = points.begin() + std::ptrdiff_t(points.size() / 2);
      Triangulation tr(points.begin(), middle), plain(points.begin(), middle);
      const auto gained = std::ptrdiff_t(plain.insert(middle, points.end()));
      Visitor visitor;
      BOOST_TEST(CGAL::insert_points_3(tr, middle, points.end(),
                                       parameters::visitor(std::ref(visitor))) == gained);
      BOOST_TEST(visitor.replaced == "the triangulation is not empty");
      check_equal(tr, plain);
    }
}

// New points hide more vertices than they become.
BOOST_AUTO_TEST_CASE(vertices_that_are_lost)
{
  Points points = cube(300, 0, 0.001);
  Triangulation tr, plain;
  CGAL::insert_points_3(tr, points);
  const auto before = std::ptrdiff_t(tr.number_of_vertices());
  const Points all = all_hidden_but_four(), heavy(all.end() - 4, all.end());
  BOOST_TEST(CGAL::insert_points_3(tr, heavy) == 4 - before);
  points.insert(points.end(), heavy.begin(), heavy.end());
  plain.insert(points.begin(), points.end());
  check_equal(tr, plain);
}

// Sets of points that are equal, cospherical and in few planes, of all sizes.
BOOST_AUTO_TEST_CASE(small_lattices)
{
  for (int seed = 0; seed < 300; ++seed) {
    CGAL::Random random(seed);
    const int n = random.get_int(1, 80), size = random.get_int(1, 5),
              heaviest = random.get_int(1, 7);
    Points points;
    for (int i = 0; i < n; ++i) {
      const int x = random.get_int(0, size), y = random.get_int(0, size);
      points.push_back(
          weighted(x, y, random.get_int(0, size), random.get_int(-heaviest, heaviest) / 2.));
    }
    BOOST_TEST_CONTEXT(seed)
    {
      check(points);
    }
  }
}

BOOST_AUTO_TEST_CASE(stops)
{
  const Points points = cube(3000, 0, 0.01);
  const auto stop_before = [&](Triangulation& tr, std::size_t number) {
    Visitor visitor;
    visitor.stop_before = number;
    std::vector<std::pair<std::size_t, Vertex_handle>> vertices;
    const auto gained =
        CGAL::insert_points_3(tr, points,
                              parameters::visitor(visitor).vertex_to_vertex_output_iterator(
                                  std::back_inserter(vertices)));
    return std::make_pair(gained, vertices);
  };
  for (const std::size_t number : {0, 1, 4}) {
    Triangulation empty;
    const auto [gained, vertices] = stop_before(empty, number);
    BOOST_TEST(gained == 0);
    BOOST_TEST(vertices.empty());
    BOOST_TEST(empty.number_of_vertices() == 0u);
    Visitor visitor;
    visitor.stop_before = number;
    visitor.throws = true;
    BOOST_CHECK_THROW(CGAL::insert_points_3(empty, points, parameters::visitor(visitor)),
                      std::runtime_error);
    BOOST_TEST(empty.number_of_vertices() == 0u);
    CGAL::insert_points_3(empty, points);
    check_equal(empty, Triangulation(points.begin(), points.end()));
  }
  Triangulation tr(points.begin(), points.begin() + 100);
  const auto [gained, vertices] = stop_before(tr, 900);
  BOOST_TEST(tr.is_valid());
  BOOST_TEST(gained > 0);
  BOOST_TEST(gained < 900);
  BOOST_TEST(vertices.size() == points.size());
  for (const auto& [i, v] : vertices)
    if (v != Vertex_handle())
      BOOST_TEST((numbers(v->point()) == numbers(points[i])));
  // Points that are there already, but were not inserted, are not reported.
  Triangulation full(points.begin(), points.end());
  for (const auto& [i, v] : stop_before(full, 0).second)
    BOOST_TEST((v == Vertex_handle()), i);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto check = [](const Point& bad, const std::string& message) {
    Points points = cube(100, 0, 0.05);
    Triangulation tr, filled(points.begin(), points.end());
    const Triangulation before(filled);
    points[42] = bad;
    const auto says_so = [&](const CGAL::Surface_input_error& error) {
      BOOST_TEST_MESSAGE(error.what());
      return error.what() == "vertex 42: its " + message;
    };
    BOOST_CHECK_EXCEPTION(CGAL::insert_points_3(tr, points), CGAL::Surface_input_error, says_so);
    BOOST_TEST(tr.number_of_vertices() == 0u);
    BOOST_CHECK_EXCEPTION(CGAL::insert_points_3(filled, points), CGAL::Surface_input_error,
                          says_so);
    check_equal(filled, before);
  };
  check(weighted(0, 0, 0, infinity), "weight is inf, not a finite number");
  check(weighted(0, 0, 0, -infinity), "weight is -inf, not a finite number");
  check(weighted(0, 0, 0, std::nan("")), "weight is nan, not a finite number");
  check(weighted(0, infinity, 0, 1), "y coordinate is not a finite number");
}

// --- the class ---------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(the_class)
{
  using Ours = CGAL::Regular_from_points_3<Kernel>;
  const Points points = cube(500, 0, 0.05);
  const Triangulation plain(points.begin(), points.end());
  const Ours ours(points.begin(), points.end()),
      with_traits(points.begin(), points.end(), Kernel());
  check_equal(ours, plain);
  check_equal(with_traits, plain);
  Ours copy(ours), moved(std::move(copy)), one_by_one, assigned;
  check_equal(moved, plain);
  assigned = ours;
  check_equal(assigned, plain);
  Ours::Vertex_handle v;
  for (const Point& p : points)
    v = one_by_one.insert(p, v);
  check_equal(one_by_one, plain);
  assigned.clear();
  BOOST_TEST(assigned.insert(points.begin(), points.end()) ==
             std::ptrdiff_t(plain.number_of_vertices()));
  check_equal(assigned, plain);

  using Ours_with_info = CGAL::Regular_from_points_3<Kernel, Tds<Info_base, Cell_base<Kernel>>>;
  const auto pairs = with_infos(points);
  const Ours_with_info with_info(pairs.begin(), pairs.end());
  check_equal(with_info, plain);
  check_infos(with_info, points);
}

// --- many threads ------------------------------------------------------------------------------

#ifdef CGAL_LINKED_WITH_TBB

BOOST_AUTO_TEST_CASE(parallel_tag)
{
  using Parallel_tds =
      CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base<Kernel>, CGAL::Parallel_tag>;
  using Parallel = CGAL::Regular_triangulation_3<Kernel, Parallel_tds>;
  auto sets = sets_of_points();
  sets.merge(sets_without_volume());
  sets["many"] = cube(20000, -0.005, 0.005);
  for (const auto& [name, points] : sets)
    BOOST_TEST_CONTEXT(name)
    {
      const Triangulation plain(points.begin(), points.end());
      Triangulation tr;
      CGAL::insert_points_3<CGAL::Parallel_tag>(tr, points);
      check_equal(tr, plain);
      Parallel parallel;
      CGAL::insert_points_3(parallel, points);
      check_equal(parallel, plain);
    }

  // The parallel insertion of CGAL can go on from there.
  Parallel::Lock_data_structure locks(CGAL::Bbox_3(-1, -1, -1, 2, 2, 2), 20);
  const Points points = cube(5000, 0, 0.001), more = cube(3000, 0, 0.002);
  Parallel tr(Kernel(), &locks);
  CGAL::insert_points_3(tr, points);
  BOOST_TEST(tr.get_lock_data_structure() == &locks);
  tr.insert(more.begin(), more.end());
  Triangulation plain(points.begin(), points.end());
  plain.insert(more.begin(), more.end());
  check_equal(tr, plain);
}

#else

BOOST_AUTO_TEST_CASE(parallel_tag)
{
  BOOST_TEST_MESSAGE("skipped: Parallel_tag, as TBB was not found");
}

#endif
