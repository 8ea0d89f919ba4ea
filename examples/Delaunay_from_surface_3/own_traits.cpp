// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A user-defined traits class: the trace of the paper, on all edges of the surface instead of a
// spanning subgraph, and a user-defined insertion plan instead of the paper's rounds.

#include <CGAL/insert_surface_vertices_3.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

// An InsertionPlan: a random order, and rounds that are each as long as all earlier ones together.
class Doubling_rounds
{
public:
  explicit Doubling_rounds(unsigned int seed)
    : m_seed(seed)
  {
  }

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  DFS::Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                                  VertexIndexMap) const
  {
    DFS::Insertion_order plan;
    plan.order.resize(points.size());
    std::iota(plan.order.begin(), plan.order.end(), std::size_t(0));
    std::shuffle(plan.order.begin(), plan.order.end(), std::mt19937(m_seed));
    for (std::size_t end = 16; end < points.size(); end *= 2)
      plan.round_ends.push_back(end);
    if (!points.empty())
      plan.round_ends.push_back(points.size());
    return plan;
  }

private:
  unsigned int m_seed;
};

struct My_traits : CGAL::Surface_insertion_policies_3<DFS::Full_graph,     // where to trace
                                                      Doubling_rounds,     // order, rounds
                                                      DFS::Traced_hints_3> // where to start
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

  // Traits and seed do not change the result.
  std::cout << "The triangulations are " << (ours == papers ? "equal" : "different") << '\n';
  return ours == papers ? EXIT_SUCCESS : EXIT_FAILURE;
}
