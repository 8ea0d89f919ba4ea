// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A traits class of one's own: the trace of the paper, on all edges of the surface instead of a
// spanning subgraph, with rounds that grow by a constant factor.

#include <CGAL/insert_surface_vertices_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/plan/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Full_graph.h>
#include <CGAL/Delaunay_from_surface_3/trace/Traced_hints_3.h>
#include <CGAL/Surface_insertion_policies_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace DFS = CGAL::Delaunay_from_surface_3;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

struct My_traits : CGAL::Surface_insertion_policies_3<DFS::Full_graph,       // where to trace
                                                      DFS::Geometric_rounds, // order, rounds
                                                      DFS::Traced_hints_3>   // where to start
{
};

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file_name, mesh)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }

  Triangulation ours, papers;
  try {
    CGAL::insert_surface_vertices_3(ours, mesh, My_traits(), CGAL::parameters::random_seed(7));
    CGAL::insert_surface_vertices_3(papers, mesh, CGAL::Tracing_traits_3());
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }

  // Traits and seed change the way, not the result.
  std::cout << "The triangulations are " << (ours == papers ? "equal" : "different") << '\n';
  return ours == papers ? EXIT_SUCCESS : EXIT_FAILURE;
}
