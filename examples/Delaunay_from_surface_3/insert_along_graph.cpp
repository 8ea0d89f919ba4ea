// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points on a closed curve, joined by a graph of the Boost Graph Library. Traits of one's own
// may trace the graph; by default the points alone are used.

#include <CGAL/insert_points_along_graph_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/graph/adjacency_list.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

int main()
{
  // A trefoil knot of 1000 points.
  const std::size_t n = 1000;
  std::vector<Point> points;
  Graph graph(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * double(i) / double(n);
    points.emplace_back(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                        -std::sin(3 * t));
    add_edge(i, (i + 1) % n, graph); // vertex i of the graph represents points[i]
  }

  Triangulation tr;
  CGAL::insert_points_along_graph_3(tr, points, graph);

  std::cout << tr.number_of_vertices() << " vertices, " << tr.number_of_finite_cells()
            << " tetrahedra\n";
  return EXIT_SUCCESS;
}
