// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polygon soup that is a surface gets the same subgraph as the halfedge graph of its faces,
// however its faces are oriented a certified one, and non-orientable surfaces too.

#define BOOST_TEST_MODULE bounded_degree_soups
#include <boost/test/included/unit_test.hpp>

#include "named_surfaces.h"

#include <Delaunay_from_surface_3_triangle_lists/Surface_recipe.h>
#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <CGAL/Delaunay_from_surface_3/adapters/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/surface_of.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

namespace {

using Mesh = CGAL::Surface_mesh<surfaces::Indexed_surface::Point_3>;
using Pair = std::pair<std::size_t, std::size_t>;

using Kind = DFS::Bounded_degree_subgraph::Kind;
constexpr Kind SUBGRAPH = DFS::Bounded_degree_subgraph::SUBGRAPH;
constexpr Kind TREE = DFS::Bounded_degree_subgraph::TREE;
constexpr Kind NEAR_MINIMUM_TREE = DFS::Bounded_degree_subgraph::NEAR_MINIMUM_TREE;

template <class FaceRange>
std::set<Pair> edges_of_soup(Kind kind, const FaceRange& faces, std::size_t n)
{
  namespace internal = DFS::internal;
  const internal::Graph_of_faces<FaceRange> graph(internal::soup_edges(faces, n).lower, faces);
  std::set<Pair> result;
  const DFS::Bounded_degree_subgraph subgraph(kind);
  subgraph(graph, internal::Identity_index_map(),
           boost::make_function_output_iterator(
               [&](const Pair& e) { result.insert(std::minmax(e.first, e.second)); }));
  return result;
}

// The mesh of the faces, in which the stored halfedge of a vertex is that of its first face: there
// a soup's list begins.
Mesh mesh_of(const surfaces::Indexed_surface& surface)
{
  Mesh mesh = surfaces::to_mesh<Mesh>(surface); // points and faces in their order
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for (std::size_t f = faces.size(); f-- > 0;)
    for (const auto h : halfedges_around_face(halfedge(faces[f], mesh), mesh))
      mesh.set_halfedge(mesh.target(h), h);
  return mesh;
}

std::set<Pair> edges_of_mesh(Kind kind, const Mesh& mesh)
{
  std::set<Pair> result;
  const DFS::Bounded_degree_subgraph subgraph(kind);
  subgraph(mesh, get(boost::vertex_index, mesh),
           boost::make_function_output_iterator([&](Mesh::Edge_index e) {
             result.insert(
                 std::minmax(std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1))));
           }));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_edges_as_with_halfedges)
{
  for (tests::Named_surface& named : tests::ordinary_surfaces(2000))
    BOOST_TEST_CONTEXT(named.name)
    {
      const Mesh mesh = mesh_of(named.surface);
      const std::size_t n = named.surface.points.size();
      BOOST_TEST(
          (edges_of_soup(SUBGRAPH, named.surface.faces, n) == edges_of_mesh(SUBGRAPH, mesh)));
      BOOST_TEST((edges_of_soup(TREE, named.surface.faces, n) == edges_of_mesh(TREE, mesh)));

      // Faces oriented at random.
      std::mt19937 random(1);
      for (auto& face : named.surface.faces)
        if (random() % 2)
          std::swap(face[0], face[1]);
      const auto soup = edges_of_soup(SUBGRAPH, named.surface.faces, n);
      std::vector<Pair> directly;
      CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(n, named.surface.faces),
                                             std::back_inserter(directly));
      BOOST_TEST(directly.size() == soup.size());
      for (const Pair& e : directly)
        BOOST_TEST(soup.count(std::minmax(e.first, e.second)) == 1u);
      BOOST_TEST(CGAL::certify_spanning_subgraph(
                     CGAL::surface_of(num_vertices(mesh), named.surface.faces), directly)
                     .is_valid_subgraph());
      std::vector<Mesh::Edge_index> edges;
      for (const Pair& e : soup)
        edges.push_back(mesh.edge(mesh.halfedge(Mesh::Vertex_index(Mesh::size_type(e.first)),
                                                Mesh::Vertex_index(Mesh::size_type(e.second)))));
      BOOST_TEST(
          CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), edges).is_valid_subgraph());
    }
}

// Random surfaces of every kind, against the certificate of the embedded graph.
BOOST_AUTO_TEST_CASE(soups_of_any_surface)
{
  using namespace triangle_lists;
  std::mt19937 random(2);
  for (int seed = 0; seed < 400; ++seed) {
    const Triangle_list s = cook(random_recipe(seed, seed % 2 == 0));
    const Embedded_graph g = embed(s, random);
    const auto certify = [&](const std::set<Pair>& pairs) {
      std::vector<Embedded_graph::Edge> edges;
      for (const Pair& e : pairs)
        edges.push_back(edge(e.first, e.second, g.graph).first);
      return CGAL::certify_spanning_subgraph(g.surface(), edges);
    };
    const std::size_t n = std::size_t(s.n);
    BOOST_TEST(certify(edges_of_soup(SUBGRAPH, s.triangles, n)).is_valid_subgraph());
    BOOST_TEST(
        certify(edges_of_soup(NEAR_MINIMUM_TREE, s.triangles, n)).is_valid_near_minimum_tree());
  }
}

// Indices come from anywhere.
BOOST_AUTO_TEST_CASE(indices_and_edges_that_are_none)
{
  using Faces = std::vector<std::array<std::int64_t, 3>>;
  for (const std::int64_t wrong : {std::int64_t(4), std::int64_t(-1), std::int64_t(1) << 32}) {
    const Faces faces = {{{0, 1, 2}}, {{0, 2, wrong}}};
    std::vector<Pair> edges;
    const auto surface = CGAL::surface_of(4, faces);
    BOOST_CHECK_THROW(CGAL::bounded_degree_spanning_subgraph(surface, std::back_inserter(edges)),
                      CGAL::Surface_input_error);
    BOOST_TEST(edges.empty());
  }
  const Faces band = {{{0, 1, 2}}, {{0, 2, 3}}};
  const auto surface = CGAL::surface_of(4, band);
  BOOST_TEST(CGAL::certify_spanning_subgraph(surface, std::vector<Pair>{{0, 1}, {2, 0}, {3, 0}})
                 .is_spanning());
  for (const Pair& wrong : {Pair(1, 3), Pair(0, 4), Pair(std::size_t(-1), 0), Pair(1, 1)})
    BOOST_CHECK_THROW(
        CGAL::certify_spanning_subgraph(surface, std::vector<Pair>{{0, 1}, {2, 0}, wrong}),
        CGAL::Surface_input_error);
}
