// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The weighted alpha shape of a chain of balls like a molecule: with alpha 0 it is dual to the
// union of the balls. The type of the triangulation is all that differs from plain CGAL. A file may
// be named that has x, y, z and a radius of each ball.

#include "read_rows.h"

#include <CGAL/insert_weighted_points_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Random.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Timer.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ball = K::Weighted_point_3; // the weight is the square of the radius
using Vertex_base =
    CGAL::Fixed_alpha_shape_vertex_base_3<K, CGAL::Regular_triangulation_vertex_base_3<K>>;
using Cell_base =
    CGAL::Fixed_alpha_shape_cell_base_3<K, CGAL::Regular_triangulation_cell_base_3<K>>;
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;

// [types]
using Alpha_shape = CGAL::Fixed_alpha_shape_3<CGAL::Regular_from_points_3<K, Tds>>;
// [types]
using Plain_alpha_shape = CGAL::Fixed_alpha_shape_3<CGAL::Regular_triangulation_3<K, Tds>>;

// A random walk in a box, of steps as long as bonds, with the radii of carbon, nitrogen and oxygen,
// each enlarged by that of a molecule of water (Å).
std::vector<Ball> chain_of_balls(std::size_t n)
{
  constexpr double bond = 1.5, water = 1.4;
  constexpr std::array<double, 3> radii = {{1.7, 1.55, 1.52}};
  const double half = 1.2 * std::cbrt(double(n));
  CGAL::Random random(1);
  std::vector<Ball> balls;
  K::Point_3 center = CGAL::ORIGIN;
  while (balls.size() < n) {
    const K::Vector_3 v(random.get_double(-1, 1), random.get_double(-1, 1),
                        random.get_double(-1, 1));
    const K::Point_3 next = center + v * (bond / CGAL::approximate_sqrt(v.squared_length()));
    if (v.squared_length() > 1 || std::abs(next.x()) > half || std::abs(next.y()) > half ||
        std::abs(next.z()) > half)
      continue;
    center = next;
    const double radius = radii[balls.size() % 3] + water;
    balls.emplace_back(center, radius * radius);
  }
  return balls;
}

std::vector<Ball> read_balls(const char* file_name)
{
  std::vector<Ball> balls;
  for (const auto& [x, y, z, radius] : read_rows<4>(file_name)) {
    if (radius < 0)
      throw std::runtime_error(std::string(file_name) + ": a radius is negative");
    balls.emplace_back(K::Point_3(x, y, z), radius * radius);
  }
  return balls;
}

// Counts the balls, edges and facets at the surface, and those inside.
struct Counts
{
  std::array<std::size_t, 3> outer, inner;
  bool operator==(const Counts& other) const
  {
    return outer == other.outer && inner == other.inner;
  }
};

template <class Shape>
Counts counts_of(const Shape& shape)
{
  Counts counts = {};
  const auto count = [&](std::size_t dimension, auto type) {
    counts.outer[dimension] += type == Shape::REGULAR || type == Shape::SINGULAR;
    counts.inner[dimension] += type == Shape::INTERIOR;
  };
  for (auto v = shape.finite_vertices_begin(); v != shape.finite_vertices_end(); ++v)
    count(0, shape.classify(v));
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e)
    count(1, shape.classify(*e));
  for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f)
    count(2, shape.classify(*f));
  return counts;
}

template <class Shape>
Counts counts_of_shape(const std::vector<Ball>& balls, const std::string& name)
{
  CGAL::Timer timer;
  timer.start();
  const Shape shape(balls.begin(), balls.end(), 0);
  timer.stop();
  if (shape.dimension() < 3)
    throw std::runtime_error(
        "CGAL's alpha shapes need balls whose centres are not all in one plane");
  const Counts counts = counts_of(shape);
  std::cout << balls.size() << " balls, " << name << ": " << timer.time() << " s, "
            << counts.outer[0] << " balls at the surface, " << counts.inner[0] << " inside, "
            << balls.size() - counts.outer[0] - counts.inner[0] << " covered by others\n";
  return counts;
}

int main(int argc, char* argv[])
{
  try {
    const std::vector<Ball> balls = argc > 1 ? read_balls(argv[1]) : chain_of_balls(20000);
    const Counts counts = counts_of_shape<Alpha_shape>(balls, "Regular_from_points_3");
    return counts == counts_of_shape<Plain_alpha_shape>(balls, "Regular_triangulation_3")
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
