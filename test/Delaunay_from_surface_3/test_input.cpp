// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every kind of surface and graph a user may bring; named parameters; bad input; stops; exceptions.

#define BOOST_TEST_MODULE test_input
#include <boost/test/included/unit_test.hpp>

#include "check_equal.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/insert_points_along_graph_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/plan/Log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/trace/Traced_hints_3.h>
#include <CGAL/Plain_insertion_traits_3.h>
#include <CGAL/Surface_insertion_policies_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_surface_points_3.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/random/linear_congruential.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Vertex_handle = Triangulation::Vertex_handle;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using Index_map = std::vector<std::pair<std::size_t, Vertex_handle>>;
using tests::Indexed_surface;
namespace parameters = CGAL::parameters;

// The surface most tests use, and its points with their own triangulation.
struct Torus
{
  Indexed_surface surface = surfaces::genus_surface(1, 500, 0.05);
  const std::vector<Point>& points = surface.points;
  Triangulation stock{points.begin(), points.end()};
};

const Torus& torus()
{
  static const Torus instance;
  return instance;
}

std::vector<std::pair<std::size_t, std::size_t>> edges_of(const Indexed_surface& surface)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& face : surface.faces)
    for (std::size_t k = 0; k < 3; ++k)
      if (face[k] < face[(k + 1) % 3])
        edges.emplace_back(face[k], face[(k + 1) % 3]);
  return edges;
}

Graph graph_of_torus()
{
  const auto edges = edges_of(torus().surface);
  return Graph(edges.begin(), edges.end(), torus().points.size());
}

// Calls insert(tr, traits) with the three traits classes, and compares with the stock triangulation.
template <class Insert>
void check_with_all_traits(const Triangulation& stock, const Insert& insert)
{
  const auto check = [&](const auto& traits) {
    BOOST_TEST_CONTEXT(boost::typeindex::type_id<decltype(traits)>().pretty_name())
    {
      Triangulation tr;
      BOOST_TEST(insert(tr, traits) == std::ptrdiff_t(stock.number_of_vertices()));
      BOOST_TEST((tr == stock));
      BOOST_TEST(tr.is_valid());
    }
  };
  check(CGAL::Surface_insertion_traits_3());
  check(CGAL::Tracing_traits_3());
  check(CGAL::Plain_insertion_traits_3());
}

template <class FaceGraph>
void check_mesh(const FaceGraph& mesh)
{
  std::vector<Point> points;
  const auto point_map = get(CGAL::vertex_point, mesh);
  for (const auto v : vertices(mesh))
    points.push_back(get(point_map, v));
  const Triangulation stock(points.begin(), points.end());
  check_with_all_traits(stock, [&](Triangulation& tr, const auto& traits) {
    using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
    std::vector<std::pair<Vertex, Vertex_handle>> map;
    const auto gained = CGAL::insert_surface_vertices_3(
        tr, mesh, traits, parameters::vertex_to_vertex_output_iterator(std::back_inserter(map)));
    BOOST_TEST(map.size() == points.size());
    std::set<Vertex> seen;
    for (const auto& [v, handle] : map) {
      seen.insert(v);
      BOOST_TEST((get(point_map, v) == handle->point()));
    }
    BOOST_TEST(seen.size() == points.size());
    return gained;
  });
}

template <class AnyGraph, class NamedParameters = parameters::Default_named_parameters>
void check_graph(const AnyGraph& graph, const NamedParameters& np = parameters::default_values())
{
  check_with_all_traits(torus().stock, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_along_graph_3(tr, torus().points, graph, traits, np);
  });
}

Triangulation cube_of_points()
{
  const auto points = surfaces::lattice_surface(0, 60).points;
  return Triangulation(points.begin(), points.end());
}

// Expects that insert(tr) throws Error with all of `words` in its message and changes nothing: not an
// empty triangulation and not another one.
template <class Error, class Insert>
void check_refused(const std::vector<std::string>& words, const Insert& insert)
{
  const Triangulation old = cube_of_points();
  for (const Triangulation& before : {Triangulation(), old}) {
    Triangulation tr(before);
    const auto infinite = tr.infinite_vertex();
    std::string message = "nothing was thrown";
    try {
      insert(tr);
    } catch (const Error& error) {
      message = error.what();
    }
    for (const std::string& word : words)
      BOOST_TEST(message.find(word) != std::string::npos,
                 "'" << word << "' is expected in the message '" << message << "'");
    BOOST_TEST((tr == before));
    BOOST_TEST((tr.infinite_vertex() == infinite));
    BOOST_TEST(tr.is_valid());
  }
}

template <class Insert>
void check_refused_input(const std::vector<std::string>& words, const Insert& insert)
{
  check_refused<CGAL::Surface_input_error>(words, insert);
}

using Faces = std::vector<std::vector<int>>;

// Counts everything, stops before the given insertion, or throws there.
struct Watching_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t stop_before = std::size_t(-1), throw_before = std::size_t(-1);
  std::size_t asked = 0, points_in_rounds = 0, located_by_traces = 0;
  std::vector<std::string> reasons, reasons_of_subgraph;
  std::vector<std::size_t> rounds;
  std::map<CGAL::Surface_insertion_phase, std::size_t> phases;
  CGAL::Surface_insertion_phase phase = CGAL::Surface_insertion_phase::DONE;

  void surface_is_irregular(const std::string& reason) { reasons.push_back(reason); }
  void subgraph_is_replaced(const std::string& reason) { reasons_of_subgraph.push_back(reason); }
  void phase_begins(CGAL::Surface_insertion_phase p) { ++phases[phase = p]; }
  void round_begins(std::size_t round, std::size_t number_of_points)
  {
    rounds.push_back(round);
    points_in_rounds += number_of_points;
  }
  void trace_ends(std::size_t located) { located_by_traces += located; }
  bool go_further()
  {
    if (asked == throw_before)
      throw std::runtime_error("the visitor throws");
    return asked++ != stop_before;
  }
};

template <class Traits>
Watching_visitor watch(Triangulation& tr, Watching_visitor visitor = Watching_visitor(),
                       Index_map* map = nullptr)
{
  Index_map unused;
  CGAL::insert_surface_points_3(
      tr, torus().points, torus().surface.faces, Traits(),
      parameters::visitor(std::ref(visitor))
          .vertex_to_vertex_output_iterator(std::back_inserter(map ? *map : unused)));
  return visitor;
}

template <class Traits>
void check_stop_in_empty_triangulation(std::size_t stop_before)
{
  Triangulation tr;
  const auto infinite = tr.infinite_vertex();
  Watching_visitor stop;
  stop.stop_before = stop_before;
  Index_map map;
  const Watching_visitor visitor = watch<Traits>(tr, stop, &map);
  BOOST_TEST(visitor.asked == stop_before + 1);
  BOOST_TEST(tr.number_of_vertices() == 0u);
  BOOST_TEST((tr.infinite_vertex() == infinite));
  BOOST_TEST(tr.is_valid());
  BOOST_TEST(map.empty());
  BOOST_TEST((visitor.phase == CGAL::Surface_insertion_phase::DONE));
}

template <class Traits>
void check_stop_in_other_triangulation(std::size_t stop_before)
{
  const Triangulation old = cube_of_points();
  Triangulation tr(old), expected(old);
  Watching_visitor stop;
  stop.stop_before = stop_before;
  Index_map map;
  watch<Traits>(tr, stop, &map);
  BOOST_TEST(map.size() == stop_before);
  for (const auto& [i, v] : map) {
    BOOST_TEST_REQUIRE(tr.tds().is_vertex(v));
    BOOST_TEST((v->point() == torus().points[i]));
    expected.insert(torus().points[i]);
  }
  BOOST_TEST(tr.is_valid());
  BOOST_TEST((tr == expected));
}

template <class Traits>
void check_stops()
{
  const std::size_t n = torus().points.size();
  for (const std::size_t stop_before :
       {std::size_t(0), std::size_t(1), std::size_t(3), n / 2, n - 1}) {
    check_stop_in_empty_triangulation<Traits>(stop_before);
    check_stop_in_other_triangulation<Traits>(stop_before);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(surface_mesh_and_polyhedron)
{
  check_mesh(surfaces::to_mesh<Mesh>(torus().surface));
  check_mesh(surfaces::to_mesh<Polyhedron>(torus().surface));
  check_mesh(surfaces::to_mesh<Mesh>(surfaces::terrain(300)));
  check_mesh(surfaces::to_mesh<Polyhedron>(surfaces::terrain(300)));
  check_mesh(Mesh());
  check_mesh(Polyhedron());
}

BOOST_AUTO_TEST_CASE(surface_mesh_with_removed_and_isolated_vertices)
{
  Mesh mesh = surfaces::to_mesh<Mesh>(surfaces::lattice_surface(1, 600));
  for (std::size_t k = 0; k < 60; ++k)
    CGAL::Euler::remove_center_vertex(mesh.halfedge(Mesh::Vertex_index(Mesh::size_type(7 * k))),
                                      mesh);
  mesh.add_vertex(Point(20, 20, 20));
  mesh.add_vertex(Point(20, 20, 20));
  BOOST_TEST_REQUIRE(mesh.has_garbage());
  check_mesh(mesh);

  // As a graph with a user's dense map, too.
  std::vector<Point> points;
  std::map<Mesh::Vertex_index, int> index;
  for (const auto v : mesh.vertices()) {
    index.emplace(v, int(points.size()));
    points.push_back(mesh.point(v));
  }
  const Triangulation stock(points.begin(), points.end());
  check_with_all_traits(stock, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_along_graph_3(
        tr, points, mesh, traits,
        parameters::vertex_index_map(boost::make_assoc_property_map(index)));
  });
}

BOOST_AUTO_TEST_CASE(user_supplied_property_maps)
{
  Polyhedron mesh = surfaces::to_mesh<Polyhedron>(torus().surface);
  using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
  std::map<Vertex, int> index; // with gaps, and not in the order of the vertices
  std::map<Vertex, CGAL::Simple_cartesian<double>::Point_3> points;
  int next = 3 * int(num_vertices(mesh));
  for (const Vertex v : vertices(mesh)) {
    index[v] = next -= 3;
    points[v] = {v->point().x(), v->point().y(), v->point().z()};
    v->point() = CGAL::ORIGIN; // the mesh's own points are not to be used
  }
  check_with_all_traits(torus().stock, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_surface_vertices_3(
        tr, mesh, traits,
        parameters::vertex_index_map(boost::make_assoc_property_map(index))
            .vertex_point_map(boost::make_assoc_property_map(points)));
  });
}

BOOST_AUTO_TEST_CASE(point_maps)
{
  using Item = std::pair<Point, std::string>;
  std::list<Item> items;
  std::vector<std::size_t> indices;
  for (const Point& p : torus().points) {
    items.emplace_back(p, "");
    indices.push_back(indices.size());
  }
  const auto pairs = parameters::point_map(CGAL::First_of_pair_property_map<Item>());
  const auto by_index = parameters::point_map(CGAL::make_property_map(torus().points));
  check_with_all_traits(torus().stock, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_surface_points_3(tr, items, torus().surface.faces, traits, pairs);
  });
  check_with_all_traits(torus().stock, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_along_graph_3(tr, items, graph_of_torus(), traits, pairs);
  });
  check_with_all_traits(torus().stock, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_surface_points_3(tr, indices, torus().surface.faces, traits, by_index);
  });
}

BOOST_AUTO_TEST_CASE(forms_without_traits)
{
  Triangulation by_vertices, by_points, along_graph;
  CGAL::insert_surface_vertices_3(by_vertices, surfaces::to_mesh<Mesh>(torus().surface));
  CGAL::insert_surface_points_3(by_points, torus().points, torus().surface.faces);
  CGAL::insert_points_along_graph_3(along_graph, torus().points, graph_of_torus());
  BOOST_TEST((by_vertices == torus().stock));
  BOOST_TEST((by_points == torus().stock));
  BOOST_TEST((along_graph == torus().stock));
}

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

// Why a spanning forest serves where T is to have bounded degree and the input is no mesh.
const std::vector<std::string> no_halfedges = {
    "the subgraph needs halfedges, which a soup or a plain graph does not have"};

BOOST_AUTO_TEST_CASE(soups_that_are_no_surface)
{
  const std::vector<Point> points = surfaces::sphere(40, 0.2).points;
  const Triangulation stock(points.begin(), points.end());
  const auto reasons_for = [&](const Faces& faces) {
    Watching_visitor visitor;
    check_with_all_traits(stock, [&](Triangulation& tr, const auto& traits) {
      return CGAL::insert_surface_points_3(tr, points, faces, traits,
                                           parameters::visitor(std::ref(visitor)));
    });
    // Once for each traits. Only one of them traces, which a soup gives no halfedges for.
    BOOST_TEST((visitor.reasons.empty() || visitor.reasons.size() == 3));
    BOOST_TEST(visitor.reasons_of_subgraph == no_halfedges, boost::test_tools::per_element());
    return visitor.reasons.empty() ? std::string() : visitor.reasons.front();
  };
  BOOST_TEST(reasons_for({}) == "");
  BOOST_TEST(reasons_for({{0, 1, 2}, {2, 1, 3}}) == "");
  BOOST_TEST(reasons_for({{0, 1, 2}, {1, 2, 3}}) == ""); // the orientation does not matter
  BOOST_TEST(reasons_for({{0, 1, 2, 3}, {4, 5, 6}, {}, {7}, {8, 9}}) ==
             "faces that are not triangles: 4, edges with more than two faces: 0");
  BOOST_TEST(
      reasons_for({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 1, 5}, {7, 8, 9}, {7, 8, 9}, {7, 8, 9}}) ==
      "faces that are not triangles: 0, edges with more than two faces: 4");
}

BOOST_AUTO_TEST_CASE(indices_of_any_integer_type)
{
  const std::vector<Point> points = surfaces::sphere(40, 0.2).points;
  const Triangulation stock(points.begin(), points.end());
  const auto check = [&](auto index) {
    const std::vector<std::vector<decltype(index)>> faces = {{0, 1, 2}, {2, 3, 4}, {38, 39, 0}};
    Triangulation tr;
    CGAL::insert_surface_points_3(tr, points, faces);
    BOOST_TEST((tr == stock));
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
  BOOST_TEST((of_polygons == torus().stock));
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
  BOOST_TEST((of_mesh == torus().stock && of_graph == torus().stock));
  BOOST_TEST(on_mesh.reasons_of_subgraph ==
                 std::vector<std::string>{"vertex 7 is not to my liking"},
             boost::test_tools::per_element());
  BOOST_TEST(on_graph.reasons_of_subgraph == no_halfedges, boost::test_tools::per_element());
  BOOST_TEST((on_mesh.reasons.empty() && on_graph.reasons.empty()));
}

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
        CGAL::insert_surface_points_3(tr, points, torus().surface.faces);
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
  CGAL::insert_surface_points_3(tr, std::vector<Point>{{most, 0, 0}, {-most, 0, 0}}, Faces{});
  BOOST_TEST(tr.number_of_vertices() == 2u);
}

BOOST_AUTO_TEST_CASE(numbers_too_large_for_the_triangulation_are_refused)
{
  using Wide = CGAL::Simple_cartesian<long double>;
  std::vector<Wide::Point_3> points(9, Wide::Point_3(1, 2, 3));
  points[4] = Wide::Point_3(0, std::numeric_limits<long double>::max(), 0);
  check_refused_input({"vertex 4", "y coordinate"}, [&](Triangulation& tr) {
    CGAL::insert_surface_points_3(tr, points, Faces{});
  });
}

BOOST_AUTO_TEST_CASE(indices_out_of_range_are_refused)
{
  const auto check = [](const auto& faces, const std::string& face, const std::string& index) {
    check_refused_input(
        {face, index, std::to_string(torus().points.size())},
        [&](Triangulation& tr) { CGAL::insert_surface_points_3(tr, torus().points, faces); });
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

BOOST_AUTO_TEST_CASE(visitor_is_told_everything)
{
  using Phase = CGAL::Surface_insertion_phase;
  const std::size_t n = torus().points.size();
  Triangulation tr;
  Watching_visitor visitor = watch<CGAL::Tracing_traits_3>(tr);
  const auto ends = DFS::Log_star_rounds::round_ends(n);
  std::size_t not_inserted = 0;
  for (const std::size_t end : ends)
    not_inserted += n - end;
  BOOST_TEST(visitor.asked == n);
  BOOST_TEST(visitor.points_in_rounds == n);
  BOOST_TEST(visitor.rounds.size() == ends.size());
  BOOST_TEST(visitor.located_by_traces == not_inserted);
  BOOST_TEST(visitor.phases[Phase::PLAN] == 1u);
  BOOST_TEST(visitor.phases[Phase::SUBGRAPH] == 1u);
  BOOST_TEST(visitor.phases[Phase::LOCATION] == n);
  BOOST_TEST(visitor.phases[Phase::UPDATE] == n);
  BOOST_TEST(visitor.phases[Phase::TRACE] == ends.size() - 1);
  BOOST_TEST(visitor.phases[Phase::FINISH] == 1u);
  BOOST_TEST(visitor.phases[Phase::DONE] == 1u);
  BOOST_TEST(visitor.reasons.empty());
  BOOST_TEST(visitor.reasons_of_subgraph.size() == 1u); // a soup: T is a spanning forest
}

BOOST_AUTO_TEST_CASE(visitor_is_told_in_the_order_documented)
{
  struct Logging
  {
    std::string log;
    void surface_is_irregular(const std::string&) { log += "irregular "; }
    void subgraph_is_replaced(const std::string&) { log += "replaced "; }
    void phase_begins(CGAL::Surface_insertion_phase phase) { log += "PSLUTFD"[int(phase)]; }
    void round_begins(std::size_t h, std::size_t n)
    {
      log += " round " + std::to_string(h) + " of " + std::to_string(n) + ": ";
    }
    void trace_ends(std::size_t located) { log += " located " + std::to_string(located); }
    bool go_further() { return log += " go ", true; }
  } visitor;
  Triangulation tr;
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CGAL::insert_surface_points_3(tr, points, Faces{{0, 1}}, CGAL::Tracing_traits_3(),
                                parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.log ==
             "irregular PSreplaced  round 0 of 2:  go LU go LUT located 1 round 1 of 1:  go LUFD");
}

BOOST_AUTO_TEST_CASE(visitor_by_value)
{
  struct Stopping : CGAL::Default_surface_insertion_visitor_3
  {
    std::size_t* insertions;
    explicit Stopping(std::size_t* n)
      : insertions(n)
    {
    }
    bool go_further() const { return ++*insertions <= 10; }
  };
  std::size_t insertions = 0;
  Triangulation tr = cube_of_points();
  const std::size_t before = tr.number_of_vertices();
  const auto gained = CGAL::insert_surface_points_3(tr, torus().points, torus().surface.faces,
                                                    parameters::visitor(Stopping(&insertions)));
  BOOST_TEST(gained == 10);
  BOOST_TEST(insertions == 11u);
  BOOST_TEST(tr.number_of_vertices() == before + 10);

  Triangulation whole;
  CGAL::insert_surface_points_3(whole, torus().points, torus().surface.faces,
                                parameters::visitor(CGAL::Default_surface_insertion_visitor_3()));
  BOOST_TEST((whole == torus().stock));
}

BOOST_AUTO_TEST_CASE(visitor_that_is_not_copied_may_have_a_state_of_its_own)
{
  Triangulation tr;
  BOOST_TEST(watch<CGAL::Plain_insertion_traits_3>(tr).asked == torus().points.size());
}

BOOST_AUTO_TEST_CASE(stops)
{
  check_stops<CGAL::Surface_insertion_traits_3>();
  check_stops<CGAL::Tracing_traits_3>();
  check_stops<CGAL::Plain_insertion_traits_3>();
}

BOOST_AUTO_TEST_CASE(exception_of_the_visitor)
{
  for (const std::size_t when : {std::size_t(0), std::size_t(1), torus().points.size() - 1}) {
    Watching_visitor visitor;
    visitor.throw_before = when;
    Triangulation empty, tr = cube_of_points();
    const std::size_t before = tr.number_of_vertices();
    BOOST_CHECK_THROW(watch<CGAL::Tracing_traits_3>(empty, visitor), std::runtime_error);
    BOOST_TEST(empty.number_of_vertices() == 0u);
    BOOST_TEST(empty.is_valid());
    BOOST_CHECK_THROW(watch<CGAL::Tracing_traits_3>(tr, visitor), std::runtime_error);
    BOOST_TEST(tr.number_of_vertices() == before + when);
    BOOST_TEST(tr.is_valid());
    watch<CGAL::Tracing_traits_3>(empty); // and may be used again
    BOOST_TEST((empty == torus().stock));
  }
}

BOOST_AUTO_TEST_CASE(exception_of_the_output_iterator)
{
  std::size_t written = 0;
  const auto throwing = boost::make_function_output_iterator([&](const auto&) {
    if (++written == 100)
      throw std::runtime_error("the output throws");
  });
  Triangulation tr;
  BOOST_CHECK_THROW(
      CGAL::insert_surface_points_3(tr, torus().points, torus().surface.faces,
                                    parameters::vertex_to_vertex_output_iterator(throwing)),
      std::runtime_error);
  BOOST_TEST(written == 100u);
  BOOST_TEST(tr.number_of_vertices() == 0u);
  BOOST_TEST(tr.is_valid());
}

BOOST_AUTO_TEST_CASE(triangulation_that_was_cleared)
{
  Triangulation tr = cube_of_points();
  tr.clear();
  CGAL::insert_surface_points_3(tr, torus().points, torus().surface.faces);
  BOOST_TEST((tr == torus().stock));
  tr.clear();
  BOOST_TEST(CGAL::insert_surface_points_3(tr, std::vector<Point>(), Faces()) == 0);
  BOOST_TEST((tr == Triangulation()));
  BOOST_TEST(tr.is_valid());
}

// The second insertion finds every point there, and gains nothing.
BOOST_AUTO_TEST_CASE(surface_inserted_twice)
{
  Triangulation tr;
  Index_map first, second;
  for (Index_map* map : {&first, &second})
    CGAL::insert_surface_points_3(
        tr, torus().points, torus().surface.faces,
        parameters::vertex_to_vertex_output_iterator(std::back_inserter(*map)));
  BOOST_TEST((tr == torus().stock));
  BOOST_TEST((first == second));
}

BOOST_AUTO_TEST_CASE(duplicates_share_a_vertex)
{
  std::vector<Point> points = torus().points;
  points.insert(points.end(), torus().points.begin(), torus().points.end());
  Index_map map;
  Triangulation tr;
  const auto gained = CGAL::insert_surface_points_3(
      tr, points, torus().surface.faces,
      parameters::vertex_to_vertex_output_iterator(std::back_inserter(map)));
  const std::size_t n = torus().points.size();
  BOOST_TEST(gained == std::ptrdiff_t(n));
  BOOST_TEST_REQUIRE(map.size() == 2 * n);
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST((map[i].second == map[n + i].second));
}
