// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A polygon soup: three sheets that meet in one edge, and a quadrangle. No mesh data structure of
// CGAL can represent it.

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

int main()
{
  const std::vector<Point> points = {Point(0, 0, 0),  Point(0, 0, 1),   Point(1, 0, 0),
                                     Point(-1, 1, 0), Point(-1, -1, 0), Point(2, 0, 0),
                                     Point(2, 0, 1),  Point(1, 0, 1)};

  // The indices of the points of each face, in order. The edge 0-1 has three faces.
  const std::vector<std::vector<std::size_t>> faces = {
      {0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {2, 5, 6, 7}};

  Triangulation tr;
  CGAL::insert_points_3(tr, points, faces);

  std::cout << tr.number_of_vertices() << " vertices, " << tr.number_of_finite_cells()
            << " tetrahedra\n";
  return EXIT_SUCCESS;
}
