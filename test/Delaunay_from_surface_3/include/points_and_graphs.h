// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_POINTS_AND_GRAPHS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_POINTS_AND_GRAPHS_H

// Points without a surface, and surfaces as graphs of Boost.Graph.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Random.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <vector>

namespace tests {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

// In a cube about the origin.
inline std::vector<surfaces::Indexed_surface::Point_3> random_points(std::size_t n,
                                                                     unsigned int seed = 1)
{
  CGAL::Random random(seed);
  std::vector<surfaces::Indexed_surface::Point_3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(random.get_double(-1, 1), random.get_double(-1, 1),
                        random.get_double(-1, 1));
  return points;
}

// An edge between two triangles is there twice.
inline Graph graph_of(const surfaces::Indexed_surface& surface)
{
  Graph graph(surface.points.size());
  for (const auto& face : surface.faces)
    for (std::size_t k = 0; k < 3; ++k)
      add_edge(face[k], face[(k + 1) % 3], graph);
  return graph;
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_POINTS_AND_GRAPHS_H
