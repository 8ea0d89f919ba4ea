// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What Euclidean minimum spanning trees cost beside the triangulation that they are found in: a loop
// over CGAL's finite edges and Boost's Kruskal, euclidean_minimum_spanning_tree_3() for a
// triangulation and for arrays, and whether the surface contains the tree. In turn. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/contains_euclidean_minimum_spanning_tree.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>
#include <CGAL/euclidean_minimum_spanning_tree_3_arrays.h>
#include <CGAL/insert_points_3.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using comparison::Json;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Triangulation =
    CGAL::Delaunay_triangulation_3<K,
                                   CGAL::Triangulation_data_structure_3<
                                       CGAL::Triangulation_vertex_base_with_info_3<std::size_t, K>,
                                       CGAL::Delaunay_triangulation_cell_base_3<K>>>;
using Mesh = CGAL::Surface_mesh<Point>;

// Adds up the squared lengths of the edges of the tree, as a user of CGAL and Boost finds it.
double tree_by_finite_edges(const Triangulation& tr, std::size_t number_of_points)
{
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, double>>;
  Graph graph(number_of_points);
  for (const auto& e : tr.finite_edges()) {
    const auto v = e.first->vertex(e.second), w = e.first->vertex(e.third);
    add_edge(v->info(), w->info(), CGAL::squared_distance(v->point(), w->point()), graph);
  }
  std::vector<boost::graph_traits<Graph>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(graph, std::back_inserter(tree));
  double sum = 0;
  for (const auto& e : tree)
    sum += get(boost::edge_weight, graph, e);
  return sum;
}

double tree_of_triangulation(const Triangulation& tr)
{
  std::vector<std::pair<Triangulation::Vertex_handle, Triangulation::Vertex_handle>> tree;
  CGAL::euclidean_minimum_spanning_tree_3(tr, std::back_inserter(tree));
  double sum = 0;
  for (const auto& [v, w] : tree)
    sum += CGAL::squared_distance(v->point(), w->point());
  return sum;
}

double tree_of_arrays(const CGAL::Delaunay_3_arrays<std::int32_t>& arrays,
                      const std::vector<Point>& points)
{
  std::vector<std::array<std::int32_t, 2>> tree;
  CGAL::euclidean_minimum_spanning_tree_3(arrays, points, std::back_inserter(tree));
  double sum = 0;
  for (const auto& e : tree)
    sum += CGAL::squared_distance(points[std::size_t(e[0])], points[std::size_t(e[1])]);
  return sum;
}

Json measure_surface(const std::string& name, const surfaces::Indexed_surface& surface,
                     std::size_t repetitions)
{
  const std::vector<Point>& points = surface.points;
  const Mesh mesh = surfaces::to_mesh<Mesh>(surface);
  std::vector<std::pair<Point, std::size_t>> numbered;
  for (const Point& p : points)
    numbered.emplace_back(p, numbered.size());
  std::map<std::string, std::vector<double>> times;
  bool contains = false;
  for (std::size_t r = 0; r < repetitions; ++r) {
    Triangulation tr;
    CGAL::Delaunay_3_arrays<std::int32_t> arrays;
    const auto time = [&](const std::string& what, const auto& work) {
      times[what].push_back(comparison::time_of(work).cpu);
    };
    double expected = 0, found = 0, of_arrays = 0;
    time("triangulation", [&] { CGAL::insert_points_3(tr, numbered); });
    time("arrays", [&] { arrays = CGAL::delaunay_3_arrays(points); });
    time("finite_edges", [&] { expected = tree_by_finite_edges(tr, points.size()); });
    // The C library joins the nodes that the graph has freed when it is next asked for a large block: now.
    void* volatile large = std::malloc(1 << 20);
    std::free(large);
    time("tree", [&] { found = tree_of_triangulation(tr); });
    time("tree_of_arrays", [&] { of_arrays = tree_of_arrays(arrays, points); });
    time("contains", [&] { contains = CGAL::contains_euclidean_minimum_spanning_tree(mesh, tr); });
    if (std::abs(found - expected) > 1e-9 * expected || found != of_arrays)
      throw std::runtime_error(name + ": the trees have other lengths");
  }
  Json line = {{"surface", name}, {"points", points.size()}, {"is_in_surface", contains}};
  for (const auto& [what, seconds] : times)
    line["median_" + what + "_cpu"] = comparison::rounded(comparison::median(seconds));
  return line;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> sizes = {65536, 262144};
  std::vector<std::string> names = {"elephant", "genus-50"};
  std::size_t repetitions = 5;
  std::string data = "build/data/meshes";
  comparison::Program program("measure_spanning_trees",
                              "Measures Euclidean minimum spanning trees beside triangulations.");
  program.option("sizes", sizes, "N...", "numbers of vertices");
  program.option("surfaces", names, "NAME...", "as compare_with_plain names them");
  program.option("repetitions,r", repetitions, "N", "of each, in turn");
  program.option("data-dir", data, "FOLDER", "where bunny00.off and refined_elephant.off are");
  return program.run(argc, argv, [&](Json& report) {
    report["repetitions"] = repetitions;
    report["results"] = Json::array();
    for (const comparison::Named_surface& s : comparison::named_surfaces(data))
      if (std::find(names.begin(), names.end(), s.name) != names.end())
        for (const std::size_t n : sizes) {
          report["results"].push_back(measure_surface(s.name, s.make(n, 2024), repetitions));
          std::cerr << report["results"].back().dump() << "\n";
        }
  });
}
