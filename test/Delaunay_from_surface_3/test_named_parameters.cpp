// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Property maps of the user.

#define BOOST_TEST_MODULE test_named_parameters
#include <boost/test/included/unit_test.hpp>

#include "input.h"

using namespace tests::input;

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
  check_with_all_traits(torus().plain, [&](Triangulation& tr, const auto& traits) {
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
  check_with_all_traits(torus().plain, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_3(tr, items, torus().surface.faces, traits, pairs);
  });
  check_with_all_traits(torus().plain, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_along_graph_3(tr, items, graph_of_torus(), traits, pairs);
  });
  check_with_all_traits(torus().plain, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_3(tr, indices, torus().surface.faces, traits, by_index);
  });
}
