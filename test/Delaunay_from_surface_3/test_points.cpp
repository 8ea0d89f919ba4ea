// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points alone, what their vertices get, and in what order these are created.

#define BOOST_TEST_MODULE test_points
#include <boost/test/included/unit_test.hpp>

#include "Watching_visitor.h"

#include <CGAL/Delaunay_from_surface_3/vertex_info.h>
#include <CGAL/Random.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/property_map.h>

#include <boost/iterator/zip_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <list>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;
using namespace tests::input;

namespace {

using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using Cell_base = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;
using With_info = CGAL::Delaunay_triangulation_3<Kernel, Tds>;
using With_info_and_levels = CGAL::Delaunay_triangulation_3<Kernel, Tds, CGAL::Fast_location>;
using Pair = std::pair<Point, int>;

// Every point three times, first those that come before all, and 0 with both signs.
std::vector<Point> with_duplicates(const std::vector<Point>& points)
{
  std::vector<Point> all;
  for (int k = 0; k < 3; ++k)
    for (const Point& p : points)
      all.push_back(p);
  all.insert(all.begin() + 1, Point(-0., 0., 5.));
  all.emplace_back(0., 0., 5.);
  all.emplace_back(0., -0., 5.);
  return all;
}

std::vector<Pair> with_infos(const std::vector<Point>& points)
{
  std::vector<Pair> pairs;
  for (const Point& p : points)
    pairs.emplace_back(p, int(pairs.size()));
  return pairs;
}

// The infos are the indices of the points. Those of the smallest must be there.
template <class Tr>
void check_infos(const Tr& tr, const std::vector<Point>& points)
{
  std::map<Point, int> smallest;
  for (std::size_t i = 0; i < points.size(); ++i)
    smallest.emplace(points[i], int(i));
  BOOST_TEST(tr.number_of_vertices() == smallest.size());
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v) {
    const int i = v->info();
    BOOST_TEST_REQUIRE(smallest.at(v->point()) == i);
    for (int c = 0; c < 3; ++c) // 0 and -0 are equal, too
      BOOST_TEST(std::signbit(v->point()[c]) == std::signbit(points[std::size_t(i)][c]));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(ranges_of_points)
{
  const std::vector<Point>& points = torus().points;
  const auto check = [&](const auto& insert) {
    Triangulation tr;
    BOOST_TEST(insert(tr) == std::ptrdiff_t(torus().plain.number_of_vertices()));
    BOOST_TEST((tr == torus().plain));
    BOOST_TEST(tr.is_valid());
  };
  check([&](Triangulation& tr) { return CGAL::insert_points_3(tr, points); });
  check([&](Triangulation& tr) {
    return CGAL::insert_points_3(tr, points.begin(), points.end(), parameters::random_seed(3));
  });
  check([&](Triangulation& tr) {
    return CGAL::insert_points_3(tr, std::list<Point>(points.begin(), points.end()));
  });

  std::stringstream stream; // each item can be read but once
  for (std::size_t i = 0; i < points.size(); ++i)
    stream << i << ' ';
  check([&](Triangulation& tr) {
    return CGAL::insert_points_3(tr, std::istream_iterator<std::size_t>(stream),
                                 std::istream_iterator<std::size_t>(),
                                 parameters::point_map(CGAL::make_property_map(points)));
  });

  using Item = std::pair<std::string, Point>;
  std::list<Item> items;
  for (const Point& p : points)
    items.emplace_back("", p);
  check([&](Triangulation& tr) {
    return CGAL::insert_points_3(tr, items,
                                 parameters::point_map(CGAL::Second_of_pair_property_map<Item>()));
  });

  Triangulation tr;
  BOOST_TEST(CGAL::insert_points_3(tr, std::vector<Point>()) == 0);
  BOOST_TEST(tr.number_of_vertices() == 0u);
}

// CGAL inserts fewer than thirty where nobody can tell. All forms, with faces, points that are equal
// or all in a plane, infos and vertices handed over; a wrong face is refused.
BOOST_AUTO_TEST_CASE(few_points)
{
  CGAL::Random random(7);
  for (std::size_t n = 0; n < 40; ++n)
    for (const bool is_flat : {false, true}) {
      std::vector<Point> points;
      for (std::size_t i = 0; i < n; ++i)
        if (i % 5 == 4)
          points.push_back(points[i / 2]);
        else
          points.emplace_back(random.get_int(-4, 5) * .5,
                              i % 4 == 0 ? random.get_int(-1, 2) * 0. : double(i % 4),
                              is_flat ? 1 : random.get_int(-4, 5));
      std::vector<std::array<std::size_t, 3>> faces;
      for (std::size_t i = 0; i + 2 < n; ++i)
        faces.push_back({{i, i + 1, i + 2}});
      const Triangulation plain(points.begin(), points.end());
      const auto check = [&](const auto& insert) {
        With_info tr;
        std::vector<With_info::Vertex_handle> vertices(n);
        std::vector<int> infos(n);
        std::iota(infos.begin(), infos.end(), 0);
        const auto np = DFS::vertex_info_range(infos).vertex_to_vertex_output_iterator(
            [&](std::size_t i, With_info::Vertex_handle v) { vertices[i] = v; });
        BOOST_TEST(insert(tr, np) == std::ptrdiff_t(plain.number_of_vertices()));
        BOOST_TEST(tr.is_valid());
        check_infos(tr, points);
        for (std::size_t i = 0; i < n; ++i)
          BOOST_TEST((vertices[i]->point() == points[i]));
        BOOST_TEST((Triangulation(tr.points_begin(), tr.points_end()) == plain));
        BOOST_TEST(tr.number_of_cells() == plain.number_of_cells());
      };
      check([&](With_info& tr, const auto& np) { return CGAL::insert_points_3(tr, points, np); });
      check([&](With_info& tr, const auto& np) {
        return CGAL::insert_points_3(tr, points, faces, np);
      });
      faces.push_back({{0, 1, n}});
      Triangulation tr;
      BOOST_CHECK_THROW(CGAL::insert_points_3(tr, points, faces), CGAL::Surface_input_error);
      BOOST_TEST(tr.number_of_vertices() == 0u);

      // What throws while the vertices are handed over leaves the triangulation empty, and of use.
      if (n < 2)
        continue;
      const auto refuse = [](std::size_t i, Triangulation::Vertex_handle) {
        if (i == 1)
          throw std::runtime_error("no more");
      };
      const auto np = CGAL::parameters::vertex_to_vertex_output_iterator(refuse);
      BOOST_CHECK_THROW(CGAL::insert_points_3(tr, points, np), std::runtime_error);
      BOOST_TEST(tr.number_of_vertices() == 0u);
      CGAL::insert_points_3(tr, points);
      BOOST_TEST((tr == plain));
    }
}

BOOST_AUTO_TEST_CASE(smallest_index_gives_point_and_info)
{
  const auto check = [&](auto tr, const std::vector<Point>& points) {
    using Tr = decltype(tr);
    const auto pairs = with_infos(points);
    CGAL::insert_points_3(tr, pairs);
    check_infos(tr, points);
    Tr by_iterators, by_zip, later(points.begin() + 3, points.begin() + 30);
    CGAL::insert_points_3(by_iterators, pairs.begin(), pairs.end());
    check_infos(by_iterators, points);
    std::vector<int> infos;
    for (const Pair& pair : pairs)
      infos.push_back(pair.second);
    CGAL::insert_points_3(
        by_zip, boost::make_zip_iterator(boost::make_tuple(points.begin(), infos.begin())),
        boost::make_zip_iterator(boost::make_tuple(points.end(), infos.end())));
    check_infos(by_zip, points);
    CGAL::insert_points_3(later, pairs); // through CGAL's insertion, and some are there already
    check_infos(later, points);
    Tr along_graph, as_soup;
    CGAL::insert_points_along_graph_3(along_graph, pairs, Graph(pairs.size()));
    check_infos(along_graph, points);
    CGAL::insert_points_3(as_soup, pairs, Faces{{0, 1, 2}}, CGAL::Tracing_traits_3());
    check_infos(as_soup, points);
  };
  const std::vector<Point> in_space = with_duplicates(torus().points);
  std::vector<Point> in_plane;
  for (const Point& p : in_space)
    in_plane.emplace_back(p.x(), p.y(), 5.);
  check(With_info(), in_space);
  check(With_info_and_levels(), in_space);
  check(With_info(), in_plane);
}

BOOST_AUTO_TEST_CASE(infos_by_named_parameters)
{
  const std::vector<Point> points = with_duplicates(torus().points);
  std::vector<int> infos(points.size());
  for (std::size_t i = 0; i < infos.size(); ++i)
    infos[i] = int(i);
  const auto check = [&](const auto& insert) {
    With_info tr;
    insert(tr);
    check_infos(tr, points);
  };
  const auto by_index =
      boost::make_function_property_map<std::size_t>([](std::size_t i) { return int(i); });
  check([&](With_info& tr) {
    CGAL::insert_points_3(tr, points, DFS::vertex_info_range(infos).random_seed(5));
  });
  check([&](With_info& tr) { CGAL::insert_points_3(tr, points, DFS::vertex_info_map(by_index)); });
  check([&](With_info& tr) { // returns a reference to its key
    CGAL::insert_points_3(tr, points,
                          DFS::vertex_info_map(CGAL::Identity_property_map<std::size_t>()));
  });
  check([&](With_info& tr) {
    CGAL::insert_points_3(tr, points, torus().surface.faces, DFS::vertex_info_map(by_index));
  });
  check([&](With_info& tr) {
    CGAL::insert_points_along_graph_3(tr, points, Graph(points.size()),
                                      DFS::vertex_info_map(&infos[0]));
  });
  Mesh mesh;
  for (const Point& p : points)
    mesh.add_vertex(p);
  check([&](With_info& tr) {
    CGAL::insert_surface_vertices_3(tr, mesh, DFS::vertex_info_map(get(boost::vertex_index, mesh)));
  });
  check([&](With_info& tr) {
    CGAL::insert_surface_vertices_3(tr, mesh, DFS::vertex_info_range(infos));
  });
}

BOOST_AUTO_TEST_CASE(infos_that_are_too_few)
{
  const std::vector<int> infos(torus().points.size() - 1);
  const std::string n = std::to_string(torus().points.size());
  With_info tr(torus().points.begin(), torus().points.begin() + 30), empty;
  const With_info before(tr);
  for (With_info* t : {&tr, &empty}) {
    const auto says_what = [&](const CGAL::Surface_input_error& error) {
      return error.what() ==
             "there are " + std::to_string(infos.size()) + " infos for " + n + " points";
    };
    BOOST_CHECK_EXCEPTION(CGAL::insert_points_3(*t, torus().points, DFS::vertex_info_range(infos)),
                          CGAL::Surface_input_error, says_what);
  }
  BOOST_TEST((tr == before));
  BOOST_TEST(empty.number_of_vertices() == 0u);
}

BOOST_AUTO_TEST_CASE(callables)
{
  // Progress, and the last call says that all is inserted.
  std::vector<double> shares;
  Index_map map;
  Triangulation tr;
  CGAL::insert_points_3(tr, torus().points,
                        parameters::visitor([&](double share) {
                          shares.push_back(share);
                        }).vertex_to_vertex_output_iterator([&](std::size_t i, Vertex_handle v) {
                          map.emplace_back(i, v);
                        }));
  BOOST_TEST(shares.size() >= 2u);
  BOOST_TEST(shares.front() == 0);
  BOOST_TEST(shares.back() == 1);
  BOOST_TEST(std::is_sorted(shares.begin(), shares.end()));
  BOOST_TEST(map.size() == torus().points.size());
  for (const auto& [i, v] : map)
    BOOST_TEST((v->point() == torus().points[i]));

  // A callable that stops, by reference, and one that takes pairs.
  std::size_t calls = 0;
  auto stops = [&](double share) { return ++calls, share < 0.5; };
  Triangulation stopped;
  CGAL::insert_points_3(
      stopped, torus().points, torus().surface.faces,
      parameters::visitor(std::ref(stops))
          .vertex_to_vertex_output_iterator([](const std::pair<std::size_t, Vertex_handle>&) {
            BOOST_ERROR("none is inserted");
          }));
  BOOST_TEST(stopped.number_of_vertices() == 0u);
  BOOST_TEST(calls > 1u);

  Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
  Triangulation of_mesh;
  std::size_t seen = 0;
  CGAL::insert_surface_vertices_3(
      of_mesh, mesh,
      parameters::vertex_to_vertex_output_iterator(
          [&](Mesh::Vertex_index u, auto v) { seen += mesh.point(u) == v->point(); }));
  BOOST_TEST(seen == mesh.number_of_vertices());
}

BOOST_AUTO_TEST_CASE(vertices_in_the_order_of_the_input)
{
  const std::vector<Point> points = with_duplicates(torus().points);
  std::vector<Point> distinct;
  std::set<Point> seen;
  for (const Point& p : points)
    if (seen.insert(p).second)
      distinct.push_back(p);
  const auto check = [&](auto tr, const auto& insert) {
    const auto np = parameters::preserve_order(true);
    BOOST_TEST(insert(tr, np) == std::ptrdiff_t(distinct.size()));
    BOOST_TEST(tr.is_valid());
    auto v = tr.finite_vertices_begin();
    for (const Point& p : distinct) {
      BOOST_TEST_REQUIRE((v != tr.finite_vertices_end()));
      BOOST_TEST_REQUIRE(v->point() == p);
      BOOST_TEST(std::signbit(v->point().x()) == std::signbit(p.x()));
      ++v;
    }
    BOOST_TEST((v == tr.finite_vertices_end()));
  };
  const auto as_points = [&](auto& tr, const auto& np) {
    return CGAL::insert_points_3(tr, points, np);
  };
  const auto as_soup = [&](auto& tr, const auto& np) {
    return CGAL::insert_points_3(tr, points, torus().surface.faces, np);
  };
  check(Triangulation(), as_points);
  check(Triangulation(), as_soup);
  check(CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>(), as_points);
  Triangulation cleared = torus().plain; // its memory has another order
  cleared.clear();
  check(cleared, as_points);
}

BOOST_AUTO_TEST_CASE(order_of_the_input_that_cannot_be_had)
{
  const auto np = parameters::preserve_order(true);
  const std::vector<Point> flat = surfaces::coplanar(50).points;
  const auto check = [](Triangulation tr, const std::string& reason, const auto& insert) {
    const Triangulation before(tr);
    const auto says_why = [&](const CGAL::Surface_input_error& error) {
      BOOST_TEST_MESSAGE(error.what());
      return error.what() == "the vertices cannot be created in the order of the input: " + reason;
    };
    BOOST_CHECK_EXCEPTION(insert(tr), CGAL::Surface_input_error, says_why);
    BOOST_TEST((tr == before));
  };
  check(Triangulation(), "the points lie in one plane",
        [&](Triangulation& tr) { CGAL::insert_points_3(tr, flat, np); });
  check(cube_of_points(), "the triangulation is not empty",
        [&](Triangulation& tr) { CGAL::insert_points_3(tr, torus().points, np); });
  check(Triangulation(), "that needs traits that go through the core", [&](Triangulation& tr) {
    CGAL::insert_points_3(tr, torus().points, torus().surface.faces,
                          CGAL::Plain_insertion_traits_3(), np);
  });
}

BOOST_AUTO_TEST_CASE(order_of_less_than_two_points)
{
  for (const std::size_t n : {0, 1}) {
    Triangulation tr;
    CGAL::insert_points_3(tr, std::vector<Point>(n), parameters::preserve_order(true));
    BOOST_TEST(tr.number_of_vertices() == n);
  }
}

BOOST_AUTO_TEST_CASE(coordinates_without_a_point)
{
  const std::vector<Point>& points = torus().points;
  std::vector<std::array<double, 3>> arrays;
  std::vector<std::array<float, 3>> floats;
  std::vector<const double*> pointers;
  for (const Point& p : points) {
    arrays.push_back({p.x(), p.y(), p.z()});
    floats.push_back({float(p.x()), float(p.y()), float(p.z())});
  }
  for (const auto& p : arrays)
    pointers.push_back(p.data());
  Triangulation from_arrays, from_pointers, with_faces, from_floats, from_c_array;
  CGAL::insert_points_3(from_arrays, arrays);
  CGAL::insert_points_3(from_pointers, pointers.begin(), pointers.end());
  CGAL::insert_points_3(with_faces, arrays, torus().surface.faces);
  BOOST_TEST((from_arrays == torus().plain));
  BOOST_TEST((from_pointers == torus().plain));
  BOOST_TEST((with_faces == torus().plain));
  CGAL::insert_points_3(from_floats, floats);
  BOOST_TEST(from_floats.number_of_vertices() > 0u);
  const std::vector<std::array<int, 3>> integers = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 1, 3}}; // of the same type
  Triangulation from_integers;
  BOOST_TEST(CGAL::insert_points_3(from_integers, integers, triangles) == 4);
  const double corners[5][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  BOOST_TEST(CGAL::insert_points_3(from_c_array, corners) == 5);
}
