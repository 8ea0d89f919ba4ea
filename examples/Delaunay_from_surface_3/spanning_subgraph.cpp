// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A spanning subgraph of bounded degree, as a property map on the edges of a mesh, and as a
// separate graph by boost::filtered_graph.

#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/near_minimum_degree_spanning_tree.h>
#include <CGAL/surface_of.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

// The predicate that boost::filtered_graph applies to every edge.
struct Is_in_subgraph
{
  Edge_map map;
  template <class Edge>
  bool operator()(const Edge& e) const
  {
    return get(map, e);
  }
};

// Prints the results, and returns whether the subgraph is correct.
bool certified_subgraph(Mesh& mesh)
{
  const auto surface = CGAL::surface_of(mesh);
  const DFS::Surface_topology topology = DFS::surface_topology(surface);
  for (const auto& component : topology.components)
    std::cout << "genus " << component.genus() << ", " << component.number_of_boundary_loops
              << " boundary loops: degree at most " << component.subgraph_degree_bound() << "\n";

  // Each edge that is written sets its entry in the property map.
  Edge_map is_in_subgraph =
      mesh.add_property_map<Mesh::Edge_index, bool>("e:subgraph", false).first;
  std::vector<Mesh::Edge_index> edges;
  CGAL::bounded_degree_spanning_subgraph(
      surface, boost::make_function_output_iterator([&](Mesh::Edge_index e) {
        put(is_in_subgraph, e, true);
        edges.push_back(e);
      }));

  const auto certificate = CGAL::certify_spanning_subgraph(surface, edges);
  std::cout << certificate.number_of_edges << " of " << num_edges(mesh) << " edges, degree "
            << certificate.maximum_degree << ", "
            << (certificate.is_valid_subgraph() ? "certified" : "not certified") << "\n";

  // A tree whose largest degree is nearly the least possible.
  std::vector<Mesh::Edge_index> tree;
  CGAL::near_minimum_degree_spanning_tree(surface, std::back_inserter(tree));
  std::cout << "a spanning tree of degree "
            << CGAL::certify_spanning_subgraph(surface, tree).maximum_degree << "\n";

  // Any algorithm of Boost.Graph works on the subgraph.
  const boost::filtered_graph<Mesh, Is_in_subgraph> subgraph(mesh, {is_in_subgraph});
  std::vector<std::size_t> distances(num_vertices(mesh), 0);
  const auto index = get(boost::vertex_index, mesh);
  boost::breadth_first_search(
      subgraph, *vertices(mesh).first,
      boost::vertex_index_map(index).visitor(boost::make_bfs_visitor(boost::record_distances(
          boost::make_iterator_property_map(distances.begin(), index), boost::on_tree_edge()))));
  std::cout << "the farthest vertex is " << *std::max_element(distances.begin(), distances.end())
            << " edges away from the first\n";
  return certificate.is_valid_subgraph();
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file_name, mesh)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }
  try {
    return certified_subgraph(mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE; // for example, the surface has other faces than triangles
  }
}
