// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is refused, and leaves the triangulation as it was.

#define BOOST_TEST_MODULE test_refused_input
#include <boost/test/included/unit_test.hpp>

#include "input.h"

#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/surface_of.h>

#include <iterator>
#include <map>
#include <vector>

using namespace tests::input;

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite_are_refused)
{
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  for (const double x : bad)
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<Point> points = torus().points;
      points[7] = Point(c == 0 ? x : 0., c == 1 ? x : 0., c == 2 ? x : 0.);
      const std::vector<std::string> words = {"vertex 7", std::string(1, "xyz"[c])};
      check_refused_input(words, [&](Triangulation& tr) {
        CGAL::insert_points_3(tr, points, torus().surface.faces);
      });
      check_refused_input(words, [&](Triangulation& tr) {
        CGAL::insert_points_along_graph_3(tr, points, graph_of_torus());
      });
      Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
      mesh.point(Mesh::Vertex_index(7)) = points[7];
      check_refused_input(words,
                          [&](Triangulation& tr) { CGAL::insert_surface_vertices_3(tr, mesh); });
    }
  // The largest numbers are finite.
  const double most = (std::numeric_limits<double>::max)();
  Triangulation tr;
  CGAL::insert_points_3(tr, std::vector<Point>{{most, 0, 0}, {-most, 0, 0}}, Faces{});
  BOOST_TEST(tr.number_of_vertices() == 2u);
}

BOOST_AUTO_TEST_CASE(numbers_too_large_for_the_triangulation_are_refused)
{
  using Wide = CGAL::Simple_cartesian<long double>;
  std::vector<Wide::Point_3> points(9, Wide::Point_3(1, 2, 3));
  points[4] = Wide::Point_3(0, std::numeric_limits<long double>::max(), 0);
  check_refused_input({"vertex 4", "y coordinate"},
                      [&](Triangulation& tr) { CGAL::insert_points_3(tr, points, Faces{}); });
}

BOOST_AUTO_TEST_CASE(indices_out_of_range_are_refused)
{
  const auto check = [](const auto& faces, const std::string& face, const std::string& index) {
    check_refused_input(
        {face, index, std::to_string(torus().points.size())},
        [&](Triangulation& tr) { CGAL::insert_points_3(tr, torus().points, faces); });
  };
  const int n = int(torus().points.size());
  check(Faces{{0, 1, 2}, {1, n, 3}}, "face 1", std::to_string(n));
  check(Faces{{0, 1, 2}, {1, 2, -1}}, "face 1", "-1");
  check(Faces{{-2147483647}}, "face 0", "-2147483647");
  check(std::vector<std::vector<std::size_t>>{{0, std::size_t(-1), 2}}, "face 0",
        std::to_string(std::size_t(-1)));
}

BOOST_AUTO_TEST_CASE(graphs_of_another_size_are_refused)
{
  const std::size_t n = torus().points.size();
  for (const std::size_t m : {std::size_t(0), n - 1, n + 1})
    check_refused_input({std::to_string(m) + " vertices", std::to_string(n) + " points"},
                        [&](Triangulation& tr) {
                          CGAL::insert_points_along_graph_3(tr, torus().points, Graph(m));
                        });
}

BOOST_AUTO_TEST_CASE(index_maps_that_are_no_bijection_are_refused)
{
  const Graph graph = graph_of_torus();
  const std::size_t n = torus().points.size();
  const auto check = [&](auto wrong, const std::vector<std::string>& words) {
    std::vector<decltype(wrong)> index(n);
    for (std::size_t i = 0; i < n; ++i)
      index[i] = static_cast<decltype(wrong)>(i);
    index[9] = wrong;
    const auto map =
        boost::make_iterator_property_map(index.begin(), get(boost::vertex_index, graph));
    check_refused_input(words, [&](Triangulation& tr) {
      CGAL::insert_points_along_graph_3(tr, torus().points, graph,
                                        parameters::vertex_index_map(map));
    });
  };
  check(std::size_t(3), {"3 and 9", "same index 3"});
  check(int(n), {"index"});
  check(-1, {"vertex 9", "index"});
  check(std::size_t(-1), {"vertex 9", "index"});
  check(std::size_t(1) << 60, {"vertex 9", "index"});
  check(std::uint32_t(-1), {"vertex 9", "index"});
}

// So are those for subgraphs, by the function that reads them, whatever CGAL asserts.
BOOST_AUTO_TEST_CASE(index_maps_of_surfaces_that_are_no_bijection_are_refused)
{
  const Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
  for (const int wrong : {3, -1, int(num_vertices(mesh))}) {
    std::map<Mesh::Vertex_index, int> index;
    for (const auto v : mesh.vertices())
      index[v] = int(v.idx());
    index[Mesh::Vertex_index(9)] = wrong;
    const auto surface =
        CGAL::surface_of(mesh, parameters::vertex_index_map(boost::make_assoc_property_map(index)));
    std::vector<Mesh::Edge_index> edges;
    BOOST_CHECK_THROW(CGAL::bounded_degree_spanning_subgraph(surface, std::back_inserter(edges)),
                      CGAL::Surface_input_error);
    BOOST_TEST(edges.empty());
  }
}

// A mesh numbers its vertices with gaps where some were removed.
BOOST_AUTO_TEST_CASE(mesh_with_removed_vertices_as_graph_is_refused_without_an_index_map)
{
  Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
  CGAL::Euler::remove_center_vertex(mesh.halfedge(Mesh::Vertex_index(3)), mesh);
  std::vector<Point> points;
  for (const auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  check_refused_input(
      {"index"}, [&](Triangulation& tr) { CGAL::insert_points_along_graph_3(tr, points, mesh); });
}

BOOST_AUTO_TEST_CASE(index_maps_of_meshes_that_are_not_one_to_one_are_refused)
{
  const Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
  const auto check = [&](auto wrong, const std::vector<std::string>& words) {
    std::map<Mesh::Vertex_index, decltype(wrong)> index;
    for (const auto v : mesh.vertices())
      index[v] = static_cast<decltype(wrong)>(v.idx());
    index[Mesh::Vertex_index(9)] = wrong;
    check_refused_input(words, [&](Triangulation& tr) {
      CGAL::insert_surface_vertices_3(
          tr, mesh, parameters::vertex_index_map(boost::make_assoc_property_map(index)));
    });
  };
  check(3, {"3 and 9", "same index 3"});
  check(-1, {"vertex 9", "negative"});
  check(std::size_t(-1), {"vertex 9", "index"}); // the usual mark of what was never set
}
