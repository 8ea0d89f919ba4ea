// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A halfedge graph that is not CGAL's: OpenMesh.

#define BOOST_TEST_MODULE openmesh
#include <boost/test/included/unit_test.hpp>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include "include/check_equal.h"
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/surface_of.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using Edges = std::vector<boost::graph_traits<Mesh>::edge_descriptor>;

Mesh mesh_of_genus(std::size_t genus, std::size_t number_of_holes)
{
  const auto surface = surfaces::genus_surface(genus, 3000, 0.05, 1);
  Mesh mesh;
  std::vector<Mesh::VertexHandle> vertices;
  for (const auto& p : surface.points)
    vertices.push_back(mesh.add_vertex(Mesh::Point(float(p.x()), float(p.y()), float(p.z()))));
  // Far apart in the list, so that no two holes touch.
  const std::size_t gap = surface.faces.size() / (number_of_holes + 1);
  for (std::size_t i = 0; i < surface.faces.size(); ++i)
    if ((i + 1) % gap != 0 || (i + 1) / gap > number_of_holes) {
      const auto& f = surface.faces[i];
      BOOST_REQUIRE(mesh.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]).is_valid());
    }
  return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(subgraph_tree_and_cut)
{
  for (std::size_t genus : {0, 1, 3})
    for (std::size_t holes : {0, 1, 3}) {
      const Mesh mesh = mesh_of_genus(genus, holes);
      const auto topology = DFS::surface_topology(CGAL::surface_of(mesh));
      BOOST_TEST_REQUIRE(topology.components.size() == 1u);
      BOOST_TEST(topology.components[0].genus() == genus);
      BOOST_TEST(topology.components[0].number_of_boundary_loops == holes);
      Edges subgraph, tree, cut;
      CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(mesh), std::back_inserter(subgraph));
      BOOST_TEST(
          CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), subgraph).is_valid_subgraph());
      CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree));
      BOOST_TEST(CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), tree).is_valid_tree());
      DFS::cut_graph(CGAL::surface_of(mesh), std::back_inserter(cut));
      BOOST_TEST(cut.empty() == (genus == 0 && holes <= 1));
    }
}

BOOST_AUTO_TEST_CASE(insertion_equals_plain)
{
  const Mesh mesh = mesh_of_genus(2, 1);
  std::vector<Kernel::Point_3> points;
  for (auto v : vertices(mesh))
    points.push_back(get(CGAL::vertex_point, mesh, v));
  Triangulation tr;
  CGAL::insert_surface_vertices_3(tr, mesh,
                                  CGAL::parameters::visitor(tests::Regular_surface_visitor()));
  BOOST_TEST((tr == Triangulation(points.begin(), points.end())));
  BOOST_TEST(tr.is_valid());
}
