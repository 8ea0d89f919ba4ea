// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_INPUT_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_INPUT_H

// What the tests of input share: a torus, checks with all traits, and checks that input is refused.

#include "check_equal.h"
#include "points_and_graphs.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_points_along_graph_3.h>
#include <CGAL/insert_surface_vertices_3.h>

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

namespace tests {
namespace input {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Vertex_handle = Triangulation::Vertex_handle;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Index_map = std::vector<std::pair<std::size_t, Vertex_handle>>;
using tests::Graph;
using tests::Indexed_surface;
namespace parameters = CGAL::parameters;

// The surface most tests use, and its points with their own triangulation.
struct Torus
{
  Indexed_surface surface = surfaces::genus_surface(1, 500, 0.05);
  const std::vector<Point>& points = surface.points;
  Triangulation plain{points.begin(), points.end()};
};

inline const Torus& torus()
{
  static const Torus instance;
  return instance;
}

inline std::vector<std::pair<std::size_t, std::size_t>> edges_of(const Indexed_surface& surface)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& face : surface.faces)
    for (std::size_t k = 0; k < 3; ++k)
      if (face[k] < face[(k + 1) % 3])
        edges.emplace_back(face[k], face[(k + 1) % 3]);
  return edges;
}

inline Graph graph_of_torus()
{
  const auto edges = edges_of(torus().surface);
  return Graph(edges.begin(), edges.end(), torus().points.size());
}

// Calls insert(tr, traits) with the three traits classes, and compares with plain CGAL
// triangulation.
template <class Insert>
void check_with_all_traits(const Triangulation& plain, const Insert& insert)
{
  const auto check = [&](const auto& traits) {
    BOOST_TEST_CONTEXT(boost::typeindex::type_id<decltype(traits)>().pretty_name())
    {
      Triangulation tr;
      BOOST_TEST(insert(tr, traits) == std::ptrdiff_t(plain.number_of_vertices()));
      BOOST_TEST((tr == plain));
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
  const Triangulation plain(points.begin(), points.end());
  check_with_all_traits(plain, [&](Triangulation& tr, const auto& traits) {
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
  check_with_all_traits(torus().plain, [&](Triangulation& tr, const auto& traits) {
    return CGAL::insert_points_along_graph_3(tr, torus().points, graph, traits, np);
  });
}

inline Triangulation cube_of_points()
{
  const auto points = surfaces::lattice_surface(0, 60).points;
  return Triangulation(points.begin(), points.end());
}

// Expects that insert(tr) throws Error with all of `words` in its message and changes nothing: not
// an empty triangulation and not another one.
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

} // namespace input
} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_INPUT_H
