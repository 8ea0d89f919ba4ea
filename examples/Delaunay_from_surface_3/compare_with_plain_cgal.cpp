// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the result and the time with those of plain CGAL. The file may contain a mesh, a polygon
// soup or points alone.

#include <CGAL/insert_points_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Timer.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<K::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(file_name, points, faces)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }
  try {
    CGAL::Timer ours, plain;
    ours.start();
    Triangulation tr;
    CGAL::insert_points_3(tr, points, faces);
    ours.stop();

    plain.start();
    const Triangulation plain_tr(points.begin(), points.end());
    plain.stop();

    std::cout << points.size() << " points: " << ours.time() << " s, plain CGAL: " << plain.time()
              << " s; the triangulations are " << (tr == plain_tr ? "equal" : "different") << '\n';
    return tr == plain_tr ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
