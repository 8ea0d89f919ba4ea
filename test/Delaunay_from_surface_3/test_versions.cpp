// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is built with every compiler and CGAL version: all headers, and a short differential test.

#define BOOST_TEST_MODULE test_versions
#include <boost/test/included/unit_test.hpp>

#include "all_headers.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_points_along_graph_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/version.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast_triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;
namespace parameters = CGAL::parameters;

namespace {

// A torus on a grid: every vertex has cocircular neighbours.
Mesh torus(int u, int v)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertex;
  for (int i = 0; i < u; ++i)
    for (int j = 0; j < v; ++j) {
      const double a = 6.283185307179586 * i / u, b = 6.283185307179586 * j / v;
      vertex.push_back(mesh.add_vertex(
          Point((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b))));
    }
  const auto at = [&](int i, int j) { return vertex[std::size_t(i % u * v + j % v)]; };
  for (int i = 0; i < u; ++i)
    for (int j = 0; j < v; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

template <class Tr, class Traits>
void check(const Mesh& mesh, const Traits& traits)
{
  const Tr plain(mesh.points().begin(), mesh.points().end());
  Tr tr;
  std::size_t insertions = 0;
  struct Visitor : CGAL::Default_surface_insertion_visitor_3
  {
    std::size_t* insertions;
    bool go_further(std::size_t) { return ++*insertions > 0; }
  } visitor;
  visitor.insertions = &insertions;
  std::vector<std::pair<Mesh::Vertex_index, typename Tr::Vertex_handle>> map;
  const auto gained = CGAL::insert_surface_vertices_3(
      tr, mesh, traits,
      parameters::random_seed(1).visitor(visitor).vertex_to_vertex_output_iterator(
          std::back_inserter(map)));
  BOOST_TEST((tr == plain));
  BOOST_TEST(tr.is_valid());
  BOOST_TEST(gained == std::ptrdiff_t(plain.number_of_vertices()));
  BOOST_TEST(map.size() == mesh.number_of_vertices());
  BOOST_TEST((insertions > 0) == (mesh.number_of_vertices() > 0));
}

template <class Tr>
void check_all_traits(const Mesh& mesh)
{
  check<Tr>(mesh, CGAL::Surface_insertion_traits_3());
  check<Tr>(mesh, CGAL::Tracing_traits_3());
  check<Tr>(mesh, CGAL::Plain_insertion_traits_3());
}

} // namespace

BOOST_AUTO_TEST_CASE(differential)
{
  BOOST_TEST_MESSAGE("CGAL " CGAL_VERSION_STR ", Boost " BOOST_LIB_VERSION);
  Mesh icosahedron, grid;
  CGAL::make_icosahedron(icosahedron, Point(0, 0, 0));
  CGAL::make_grid(20, 20, grid);
  for (const Mesh& mesh : {torus(60, 20), icosahedron, grid, Mesh()}) {
    check_all_traits<Triangulation>(mesh);
    check_all_traits<Fast_triangulation>(mesh);
  }
}

BOOST_AUTO_TEST_CASE(soup_graph_and_refusal)
{
  const Mesh mesh = torus(30, 10);
  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  const Triangulation plain(points.begin(), points.end());
  Triangulation from_soup, along_graph, along_mesh;
  const std::vector<std::array<int, 3>> faces = {{0, 1, 2}, {2, 1, 3}};
  CGAL::insert_points_3(from_soup, points, faces, parameters::random_seed(3));
  CGAL::insert_points_along_graph_3(
      along_graph, points,
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>(points.size()));
  CGAL::insert_points_along_graph_3(along_mesh, points, mesh, CGAL::Tracing_traits_3());
  BOOST_TEST((from_soup == plain));
  BOOST_TEST((along_graph == plain));
  BOOST_TEST((along_mesh == plain));
  BOOST_CHECK_THROW(
      CGAL::insert_points_3(from_soup, points, std::vector<std::array<int, 3>>{{0, 1, 300}}),
      CGAL::Surface_input_error);
}

// A vertex base that no copy is made of: CGAL's own insertion makes none.
BOOST_AUTO_TEST_CASE(info_that_cannot_be_copied)
{
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<std::unique_ptr<int>, Kernel>;
  using Cb = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
  CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vb, Cb>> tr, plain;
  const Mesh mesh = torus(30, 10);
  tr.infinite_vertex()->info() = std::make_unique<int>(4711);
  CGAL::insert_surface_vertices_3(tr, mesh);
  plain.insert(mesh.points().begin(), mesh.points().end());
  BOOST_TEST((tr == plain));
  BOOST_TEST(tr.is_valid());
  BOOST_TEST_REQUIRE(bool(tr.infinite_vertex()->info()));
  BOOST_TEST(*tr.infinite_vertex()->info() == 4711);
}
