// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tetrahedra and their neighbours as arrays of indices, and which of them are inside the surface.
// The second argument names a file for these, which ParaView opens, such as inside.vtk.

#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/inside_of_surface_3.h>
#include <CGAL/is_valid_delaunay_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

using Tetrahedra = std::vector<std::array<std::int32_t, 4>>;

void write_vtk(std::ostream& out, const std::vector<Point>& points, const Tetrahedra& tetrahedra)
{
  out.precision(17);
  out << "# vtk DataFile Version 3.0\ntetrahedra\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS "
      << points.size() << " double\n";
  for (const Point& p : points)
    out << p << '\n';
  out << "CELLS " << tetrahedra.size() << ' ' << 5 * tetrahedra.size() << '\n';
  for (const auto& v : tetrahedra)
    out << "4 " << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3] << '\n';
  out << "CELL_TYPES " << tetrahedra.size() << '\n';
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    out << "10\n"; // VTK's number of tetrahedra
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(file_name, points, faces)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }
  std::error_code error_code; // if there is no such output yet
  if (argc > 2 && std::filesystem::equivalent(file_name, argv[2], error_code)) {
    std::cerr << argv[2] << " is the input: name another file\n";
    return EXIT_FAILURE;
  }

  try {
    // [inside]
    const auto arrays = CGAL::delaunay_3_arrays(points, faces); // or of points alone
    if (!CGAL::is_valid_delaunay_3_arrays(arrays, points))      // for arrays from any source
      return EXIT_FAILURE;
    const CGAL::Inside_3 inside = CGAL::inside_of_surface_3(points, faces, arrays);

    Tetrahedra tetrahedra;
    double volume = 0;
    std::size_t skin = 0; // facets between inside and outside
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
      if (!inside[c])
        continue;
      const std::array<std::int32_t, 4> v = arrays.vertices(c);
      tetrahedra.push_back(v);
      const auto corner = [&](std::size_t k) { return points[std::size_t(v[k])]; };
      volume += CGAL::volume(corner(0), corner(1), corner(2), corner(3));
      for (const std::int32_t neighbor : arrays.neighbors(c))
        skin += std::size_t(arrays.is_infinite(neighbor) || !inside[std::size_t(neighbor)]);
    }
    // [inside]
    if (argc > 2) {
      std::ofstream file(argv[2]);
      write_vtk(file, points, tetrahedra);
      if (!file.flush()) {
        std::cerr << "Cannot write " << argv[2] << '\n';
        return EXIT_FAILURE;
      }
    }
    double enclosed = 0; // by the surface, if it is closed, in one piece and consistently oriented
    for (const auto& face : faces)
      for (std::size_t k = 2; k < face.size(); ++k)
        enclosed +=
            CGAL::volume(points.front(), points[face[0]], points[face[k - 1]], points[face[k]]);
    std::cout << arrays.number_of_simplices() << " tetrahedra; those inside have volume " << volume
              << " and " << skin << " facets to the outside; the surface encloses "
              << std::abs(enclosed) << ", if it is closed and consistently oriented\n";
    if (inside.doubtful_volume > 0.05)
      std::cerr << std::lround(100 * inside.doubtful_volume)
                << " % of this volume is in doubt, near openings: close them\n";
    if (inside.crossed_volume > 0.1)
      std::cerr << std::lround(100 * inside.crossed_volume)
                << " % of this volume may be wrong, as tetrahedra cross the surface: refine it\n";
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE; // for example, an open patch has no inside
  }
  return EXIT_SUCCESS;
}
