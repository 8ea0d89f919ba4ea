// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Euclidean minimum spanning tree of points. Its edges are edges of their Delaunay
// triangulation.

#include <CGAL/euclidean_minimum_spanning_tree_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
using Vertex_handle = Triangulation::Vertex_handle;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<K::Point_3> points;
  std::vector<std::vector<std::size_t>> unused_faces;
  if (!CGAL::IO::read_polygon_soup(file_name, points, unused_faces)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }

  Triangulation tr;
  try {
    CGAL::insert_points_3(tr, points);
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::vector<std::pair<Vertex_handle, Vertex_handle>>
      tree; // from the shortest edge to the longest
  CGAL::euclidean_minimum_spanning_tree_3(tr, std::back_inserter(tree));

  double length = 0;
  std::map<Vertex_handle, int> degrees;
  int degree = 0;
  for (const auto& [v, w] : tree) {
    length += std::sqrt(CGAL::squared_distance(v->point(), w->point()));
    degree = (std::max)({degree, ++degrees[v], ++degrees[w]});
  }
  std::cout << tree.size() << " edges join " << tr.number_of_vertices() << " points; length "
            << length << ", largest degree " << degree << '\n';
  return tree.size() + 1 == tr.number_of_vertices() ? EXIT_SUCCESS : EXIT_FAILURE;
}
