// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A Möbius band, as a graph with the cyclic order of the edges around every vertex.

#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/surface_of.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_index_t, std::size_t>>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;

int main()
{
  // A strip of triangles i, i+1, i+2. Its ends are joined with a twist, as n is odd.
  const std::size_t n = 101;
  Graph graph(n);
  std::vector<Edge> steps, leaps; // i to i+1, i to i+2
  std::vector<char> is_boundary;  // by edge index
  for (std::size_t i = 0; i < n; ++i) {
    steps.push_back(add_edge(i, (i + 1) % n, is_boundary.size(), graph).first);
    is_boundary.push_back(false);
    leaps.push_back(add_edge(i, (i + 2) % n, is_boundary.size(), graph).first);
    is_boundary.push_back(true);
  }

  // Around i: to i+2 (boundary), i+1, i-1, i-2 (boundary).
  std::vector<std::vector<Edge>> around(n);
  for (std::size_t i = 0; i < n; ++i)
    around[i] = {leaps[i], steps[i], steps[(i + n - 1) % n], leaps[(i + n - 2) % n]};

  const auto index = get(boost::vertex_index, graph);
  const auto embedding = boost::make_iterator_property_map(around.begin(), index);
  const auto boundary =
      boost::make_iterator_property_map(is_boundary.begin(), get(boost::edge_index, graph));

  const auto surface = CGAL::surface_of(graph, embedding, index, boundary);
  const auto topology = CGAL::Delaunay_from_surface_3::surface_topology(surface);
  std::cout << (topology.is_orientable() ? "orientable" : "not orientable") << ", "
            << topology.number_of_boundary_loops() << " boundary loop, Euler characteristic "
            << topology.euler_characteristic() << "\n";

  std::vector<Edge> tree;
  CGAL::bounded_degree_spanning_tree(surface, std::back_inserter(tree));
  const auto certificate = CGAL::certify_spanning_subgraph(surface, tree);
  std::cout << "a spanning tree of " << certificate.number_of_edges << " edges and degree "
            << certificate.maximum_degree << "\n";
  return certificate.is_valid_tree() ? EXIT_SUCCESS : EXIT_FAILURE;
}
