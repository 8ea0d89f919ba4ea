// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Graphs of Boost.Graph and polygon soups, be they surfaces or not.

#define BOOST_TEST_MODULE test_graphs_and_soups
#include <boost/test/included/unit_test.hpp>

#include "Watching_visitor.h"

namespace DFS = CGAL::Delaunay_from_surface_3;
using namespace tests::input;

BOOST_AUTO_TEST_CASE(graphs_of_boost)
{
  const std::size_t n = torus().points.size();
  const auto edges = edges_of(torus().surface);
  check_graph(graph_of_torus());

  using Directed = boost::adjacency_list<boost::setS, boost::vecS, boost::bidirectionalS>;
  check_graph(Directed(edges.begin(), edges.end(), n));

  using Rows = boost::compressed_sparse_row_graph<boost::directedS>;
  check_graph(Rows(boost::edges_are_unsorted_multi_pass, edges.begin(), edges.end(), n));

  using Listed = boost::adjacency_list<boost::listS, boost::listS, boost::undirectedS>;
  const Listed listed(edges.begin(), edges.end(), n); // without indices of its own
  std::map<Listed::vertex_descriptor, std::size_t> index;
  for (const auto v : CGAL::make_range(vertices(listed)))
    index.emplace(v, index.size());
  check_graph(listed, parameters::vertex_index_map(boost::make_assoc_property_map(index)));

  check_graph(surfaces::to_mesh<Mesh>(torus().surface));
}

BOOST_AUTO_TEST_CASE(graph_without_edges)
{
  check_graph(Graph(torus().points.size()));
}

BOOST_AUTO_TEST_CASE(graphs_that_have_nothing_to_do_with_the_points)
{
  const std::size_t n = torus().points.size();
  Graph star(n), path(n), random(n), messy = graph_of_torus();
  boost::minstd_rand generator(1);
  for (std::size_t i = 1; i < n; ++i) {
    add_edge(0, i, star);
    add_edge((i - 1) * 37 % n, i * 37 % n, path);
  }
  for (std::size_t i = 0; i < 3 * n; ++i)
    add_edge(generator() % n, generator() % n, random);
  for (std::size_t i = 0; i < n; ++i) { // loops and multiple edges
    add_edge(i, i, messy);
    add_edge(0, i, messy);
    add_edge(0, i, messy);
  }
  check_graph(star);
  check_graph(path);
  check_graph(random);
  check_graph(messy);
}

// Why a spanning forest serves where T is to have bounded degree and the input is no surface.
const std::vector<std::string> no_faces = {
    "the subgraph needs a surface with faces, which a plain graph is not"};

BOOST_AUTO_TEST_CASE(soups_that_are_no_surface)
{
  const std::vector<Point> points = surfaces::sphere(40, 0.2).points;
  const Triangulation plain(points.begin(), points.end());
  // Only one of the traits traces; it has a subgraph of bounded degree where the soup is a surface.
  const auto reasons_for = [&](const Faces& faces, const std::string& refusal) {
    Watching_visitor visitor;
    check_with_all_traits(plain, [&](Triangulation& tr, const auto& traits) {
      return CGAL::insert_points_3(tr, points, faces, traits,
                                   parameters::visitor(std::ref(visitor)));
    });
    BOOST_TEST((visitor.reasons.empty() || visitor.reasons.size() == 3)); // once for each traits
    BOOST_TEST((visitor.reasons_of_subgraph.empty() ? "" : visitor.reasons_of_subgraph.front()) ==
               refusal);
    return visitor.reasons.empty() ? std::string() : visitor.reasons.front();
  };
  BOOST_TEST(reasons_for({}, "") == "");
  BOOST_TEST(reasons_for({{0, 1, 2}, {2, 1, 3}}, "") == "");
  BOOST_TEST(reasons_for({{0, 1, 2}, {1, 2, 3}}, "") == ""); // the orientation does not matter
  BOOST_TEST(reasons_for({{0, 1, 2}, {0, 3, 4}},
                         "vertex 0 is pinched: its edges form more than one fan") == "");
  BOOST_TEST(reasons_for({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}},
                         "vertex 0 is pinched: its edges form more than one fan") == "");
  BOOST_TEST(reasons_for({{0, 4, 5}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}},
                         "vertex 0 is pinched: its edges form more than one fan") == "");
  BOOST_TEST(reasons_for({{0, 1, 1}}, "face 0 has a vertex twice") == "");
  BOOST_TEST(reasons_for({{0, 1, 2, 3}, {4, 5, 6}, {}, {7}, {8, 9}}, "face 0 is not a triangle") ==
             "faces that are not triangles: 4, edges with more than two faces: 0");
  BOOST_TEST(
      reasons_for({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 1, 5}, {7, 8, 9}, {7, 8, 9}, {7, 8, 9}},
                  "edge (0, 1) is in more than two faces") ==
      "faces that are not triangles: 0, edges with more than two faces: 4");
}

BOOST_AUTO_TEST_CASE(indices_of_any_integer_type)
{
  const std::vector<Point> points = surfaces::sphere(40, 0.2).points;
  const Triangulation plain(points.begin(), points.end());
  const auto check = [&](auto index) {
    const std::vector<std::vector<decltype(index)>> faces = {{0, 1, 2}, {2, 3, 4}, {38, 39, 0}};
    Triangulation tr;
    CGAL::insert_points_3(tr, points, faces);
    BOOST_TEST((tr == plain));
  };
  check(std::uint8_t());
  check(std::int16_t());
  check(std::uint32_t());
  check(std::int64_t());
  check(std::uint64_t());
}

BOOST_AUTO_TEST_CASE(polygon_mesh_is_told_to_the_visitor)
{
  Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
  Watching_visitor visitor;
  Triangulation of_triangles, of_polygons;
  CGAL::insert_surface_vertices_3(of_triangles, mesh, parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.reasons.empty());
  CGAL::Euler::join_face(halfedge(*edges(mesh).first, mesh), mesh);
  CGAL::insert_surface_vertices_3(of_polygons, mesh, parameters::visitor(std::ref(visitor)));
  BOOST_TEST_REQUIRE(visitor.reasons.size() == 1u);
  BOOST_TEST(visitor.reasons[0] == "faces that are not triangles: 1");
  BOOST_TEST((of_polygons == torus().plain));
}

// Serves meshes only, and even these not all of them.
struct Refusing_subgraph
{
  template <class Surface, class VertexIndexMap, class EdgeOutputIterator,
            class = typename boost::graph_traits<Surface>::halfedge_descriptor>
  EdgeOutputIterator operator()(const Surface&, VertexIndexMap, EdgeOutputIterator) const
  {
    throw CGAL::Surface_input_error("vertex 7 is not to my liking");
  }
};

BOOST_AUTO_TEST_CASE(spanning_forest_where_the_subgraph_refuses_the_surface)
{
  struct Traits : CGAL::Surface_insertion_policies_3<Refusing_subgraph, DFS::Log_star_rounds,
                                                     DFS::Traced_hints_3>
  {
  };
  Watching_visitor on_mesh, on_graph;
  Triangulation of_mesh, of_graph;
  CGAL::insert_surface_vertices_3(of_mesh, surfaces::to_mesh<Mesh>(torus().surface), Traits(),
                                  parameters::visitor(std::ref(on_mesh)));
  CGAL::insert_points_along_graph_3(of_graph, torus().points, Graph(torus().points.size()),
                                    Traits(), parameters::visitor(std::ref(on_graph)));
  BOOST_TEST((of_mesh == torus().plain && of_graph == torus().plain));
  BOOST_TEST(on_mesh.reasons_of_subgraph ==
                 std::vector<std::string>{"vertex 7 is not to my liking"},
             boost::test_tools::per_element());
  BOOST_TEST(on_graph.reasons_of_subgraph == no_faces, boost::test_tools::per_element());
  BOOST_TEST((on_mesh.reasons.empty() && on_graph.reasons.empty()));
}
