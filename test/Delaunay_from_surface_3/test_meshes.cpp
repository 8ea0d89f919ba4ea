// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every kind of mesh a user may bring, more than once or with points that are there already.

#define BOOST_TEST_MODULE test_meshes
#include <boost/test/included/unit_test.hpp>

#include "input.h"

using namespace tests::input;

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
  const Triangulation plain(points.begin(), points.end());
  check_with_all_traits(plain, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_along_graph_3(
        tr, points, mesh, traits,
        parameters::vertex_index_map(boost::make_assoc_property_map(index)));
  });
}

BOOST_AUTO_TEST_CASE(forms_without_traits)
{
  Triangulation by_vertices, by_points, along_graph;
  CGAL::insert_surface_vertices_3(by_vertices, surfaces::to_mesh<Mesh>(torus().surface));
  CGAL::insert_points_3(by_points, torus().points, torus().surface.faces);
  CGAL::insert_points_along_graph_3(along_graph, torus().points, graph_of_torus());
  BOOST_TEST((by_vertices == torus().plain));
  BOOST_TEST((by_points == torus().plain));
  BOOST_TEST((along_graph == torus().plain));
}

BOOST_AUTO_TEST_CASE(triangulation_that_was_cleared)
{
  Triangulation tr = cube_of_points();
  tr.clear();
  CGAL::insert_points_3(tr, torus().points, torus().surface.faces);
  BOOST_TEST((tr == torus().plain));
  tr.clear();
  BOOST_TEST(CGAL::insert_points_3(tr, std::vector<Point>(), Faces()) == 0);
  BOOST_TEST((tr == Triangulation()));
  BOOST_TEST(tr.is_valid());
}

// The second insertion finds every point there, and gains nothing.
BOOST_AUTO_TEST_CASE(surface_inserted_twice)
{
  Triangulation tr;
  Index_map first, second;
  for (Index_map* map : {&first, &second})
    CGAL::insert_points_3(tr, torus().points, torus().surface.faces,
                          parameters::vertex_to_vertex_output_iterator(std::back_inserter(*map)));
  BOOST_TEST((tr == torus().plain));
  BOOST_TEST((first == second));
}

BOOST_AUTO_TEST_CASE(duplicates_share_a_vertex)
{
  std::vector<Point> points = torus().points;
  points.insert(points.end(), torus().points.begin(), torus().points.end());
  Index_map map;
  Triangulation tr;
  const auto gained =
      CGAL::insert_points_3(tr, points, torus().surface.faces,
                            parameters::vertex_to_vertex_output_iterator(std::back_inserter(map)));
  const std::size_t n = torus().points.size();
  BOOST_TEST(gained == std::ptrdiff_t(n));
  BOOST_TEST_REQUIRE(map.size() == 2 * n);
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST((map[i].second == map[n + i].second));
}
