// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tetrahedra and their neighbours as arrays of indices, and which of them are inside the surface.

#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/inside_of_surface_3.h>
#include <CGAL/is_valid_delaunay_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(file_name, points, faces)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }

  try {
    const auto arrays = CGAL::delaunay_3_arrays(points, faces); // or of points alone
    if (!CGAL::is_valid_delaunay_3_arrays(arrays, points))      // for arrays from any source
      return EXIT_FAILURE;
    const CGAL::Inside_3 inside = CGAL::inside_of_surface_3(points, faces, arrays);

    double volume = 0;
    std::size_t skin = 0; // facets between inside and outside
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
      if (!inside[c])
        continue;
      const std::array<std::int32_t, 4> v = arrays.vertices(c);
      const auto corner = [&](std::size_t k) { return points[std::size_t(v[k])]; };
      volume += CGAL::volume(corner(0), corner(1), corner(2), corner(3));
      for (const std::int32_t neighbor : arrays.neighbors(c))
        skin += std::size_t(arrays.is_infinite(neighbor) || !inside[std::size_t(neighbor)]);
    }
    std::cout << arrays.number_of_simplices() << " tetrahedra; those inside have volume " << volume
              << " and " << skin << " facets to the outside\n";
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE; // for example, an open patch has no inside
  }
  return EXIT_SUCCESS;
}
