// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Alpha shapes of points: both of CGAL's classes accept a triangulation that is already built. The
// results are the same as from points that the classes insert themselves.

#include "read_rows.h"

#include <CGAL/insert_points_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Timer.h>
#include <CGAL/Triangulation_data_structure_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;

template <class Vertex_base, class Cell_base>
using Triangulation =
    CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
using Fixed_triangulation =
    Triangulation<CGAL::Fixed_alpha_shape_vertex_base_3<K>, CGAL::Fixed_alpha_shape_cell_base_3<K>>;
using General_triangulation =
    Triangulation<CGAL::Alpha_shape_vertex_base_3<K>, CGAL::Alpha_shape_cell_base_3<K>>;
using Fixed_alpha_shape = CGAL::Fixed_alpha_shape_3<Fixed_triangulation>;
using Alpha_shape = CGAL::Alpha_shape_3<General_triangulation>;

// The facets of the boundary, each as its vertices in ascending order.
template <class Shape>
std::set<std::array<Point, 3>> boundary(const Shape& shape)
{
  std::set<std::array<Point, 3>> facets;
  for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f) {
    const auto type = shape.classify(*f);
    if (type != Shape::REGULAR && type != Shape::SINGULAR)
      continue;
    std::array<Point, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[std::size_t(k)] = f->first->vertex((f->second + 1 + k) % 4)->point();
    std::sort(corners.begin(), corners.end());
    facets.insert(corners);
  }
  return facets;
}

// Writes the triangles to an OFF file.
void write_off(const std::set<std::array<Point, 3>>& facets, const std::string& file_name)
{
  std::map<Point, std::size_t> numbers;
  for (const std::array<Point, 3>& facet : facets)
    for (const Point& p : facet)
      numbers.emplace(p, 0);
  std::ofstream out(file_name);
  out.precision(17);
  out << "OFF\n" << numbers.size() << ' ' << facets.size() << " 0\n";
  std::size_t next = 0;
  for (auto& [p, number] : numbers) {
    out << p << '\n';
    number = next++;
  }
  for (const std::array<Point, 3>& facet : facets)
    out << "3 " << numbers[facet[0]] << ' ' << numbers[facet[1]] << ' ' << numbers[facet[2]]
        << '\n';
  if (!out.flush())
    throw std::runtime_error("cannot write " + file_name);
}

// Makes the shape both ways, and compares. Writes its facets, if there is a name for the file.
template <class Triangulation, class Shape>
bool is_same_shape(const std::vector<Point>& points, double alpha, const std::string& name,
                   const std::string& output = "")
{
  CGAL::Timer ours, plain;
  ours.start();
  // [shape]
  Triangulation tr;
  CGAL::insert_points_3(tr, points);
  if (tr.dimension() < 3)
    throw std::runtime_error("CGAL's alpha shapes need points that are not all in one plane");
  Shape shape(tr, alpha); // moves the contents of tr
  // [shape]
  ours.stop();
  plain.start();
  Shape plain_shape(points.begin(), points.end(), alpha);
  plain.stop();
  const auto facets = boundary(shape);
  std::cout << name << ", alpha " << alpha << ": " << facets.size() << " facets in " << ours.time()
            << " s; plain CGAL: " << plain.time() << " s\n";
  if (!output.empty())
    write_off(facets, output);
  return facets == boundary(plain_shape);
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  const std::string output = argc > 3 ? argv[3] : "";
  std::error_code none; // they differ if one is missing
  if (!output.empty() && std::filesystem::equivalent(file_name, output, none)) {
    std::cerr << output << " is the input: name another file\n";
    return EXIT_FAILURE;
  }
  std::vector<Point> points;
  if (!CGAL::IO::read_points(file_name, std::back_inserter(points))) {
    std::cerr << "Cannot read " << file_name << ": expected points as .xyz, .ply or .off\n";
    return EXIT_FAILURE;
  }
  try {
    const double alpha = argc > 2 ? number_of(argv[2]) : 0.05; // the square of a radius
    if (alpha < 0)
      throw std::runtime_error("alpha is the square of a radius, which is not negative");
    const bool is_same =
        is_same_shape<Fixed_triangulation, Fixed_alpha_shape>(points, alpha, "Fixed_alpha_shape_3",
                                                              output) &&
        is_same_shape<General_triangulation, Alpha_shape>(points, alpha, "Alpha_shape_3");
    return is_same ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
