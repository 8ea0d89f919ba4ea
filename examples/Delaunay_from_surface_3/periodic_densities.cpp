// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How dense points in a periodic box are around each of them: the density at one is 4 divided by the
// volume of its tetrahedra. No point is at a boundary, so the tetrahedra
// fill the box, and each has four corners: the volumes add up. The arguments are a file with x, y, z in each
// line and the lengths of the box; without them, it is a sample.

#include "read_rows.h"

#include <CGAL/Random.h>
#include <CGAL/periodic_delaunay_3_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

using Point = std::array<double, 3>;

// Half of the points are anywhere in the box, the others around its corner.
std::vector<Point> points_in(double period, std::size_t n)
{
  CGAL::Random random(1);
  std::vector<Point> points;
  while (points.size() < n) {
    const double size = points.size() % 2 == 0 ? period : period / 8;
    Point p;
    for (double& x : p)
      x = random.get_double(-size / 2, size / 2); // may be anywhere: the box is endless
    points.push_back(p);
  }
  return points;
}

double determinant(const Point& u, const Point& v, const Point& w)
{
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// Returns whether the volumes add up.
bool print_densities(const std::vector<Point>& points, const std::array<double, 3>& box)
{
  // [box]
  const auto arrays = CGAL::periodic_delaunay_3_arrays(points, box);

  std::vector<double> volumes(points.size()); // of the tetrahedra at each point
  double all = 0;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    const auto vertices = arrays.vertices(c);
    const auto& offsets = arrays.offsets(c);
    std::array<Point, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t a = 0; a < 3; ++a)
        corners[k][a] = points[std::size_t(vertices[k])][a] + offsets[k][a] * box[a];
    std::array<Point, 3> edges;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t a = 0; a < 3; ++a)
        edges[k][a] = corners[k + 1][a] - corners[0][a];
    const double volume = determinant(edges[0], edges[1], edges[2]) / 6;
    all += volume;
    for (const auto v : vertices)
      volumes[std::size_t(v)] += volume;
  }
  // [box]

  // Equal points are one vertex, which has the masses of all.
  std::vector<double> densities(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto v = std::size_t(arrays.vertex_of_point(i));
    densities[v] += 4 / volumes[v];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    densities[i] = densities[std::size_t(arrays.vertex_of_point(i))];
  const auto [smallest, largest] = std::minmax_element(densities.begin(), densities.end());
  std::cout << arrays.number_of_simplices() << " tetrahedra, of " << points.size() << " points and "
            << arrays.number_of_copies() << " copies; their volume is " << all << "\n"
            << "from " << *smallest << " to " << *largest << " points per unit of volume\n";
  return std::abs(all - box[0] * box[1] * box[2]) < 1e-9 * all;
}

int main(int argc, char* argv[])
{
  if (argc != 1 && argc != 5) {
    std::cerr << "usage: periodic_densities [FILE LENGTH LENGTH LENGTH]\n";
    return EXIT_FAILURE;
  }
  try {
    std::array<double, 3> box = {{10, 10, 10}};
    for (int k = 0; k < 3 && argc > 1; ++k)
      box[std::size_t(k)] = number_of(argv[k + 2]);
    const auto points = argc > 1 ? read_rows<3>(argv[1]) : points_in(10, 20000);
    return print_densities(points, box) ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
