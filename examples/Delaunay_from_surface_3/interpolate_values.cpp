// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Interpolates values at scattered points, linearly in tetrahedra. Every tenth point is left out, and
// its value is compared with the interpolated one. A file may be named that has x, y, z and a value
// of each point.

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<double, K>; // the info is the value
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base>;
using Triangulation = CGAL::Delaunay_triangulation_3<K, Tds>;
using Valued_points = std::vector<std::pair<Point, double>>;

Valued_points sample(std::size_t n)
{
  CGAL::Random random(1);
  Valued_points points;
  while (points.size() < n) {
    const Point p(random.get_double(), random.get_double(), random.get_double());
    points.emplace_back(p, std::sin(6 * p.x()) * std::cos(5 * p.y()) + p.z());
  }
  return points;
}

// [interpolate]
// The weight of each corner is the volume of the cell with q in its place.
double interpolated(const Triangulation& tr, Triangulation::Cell_handle c, const Point& q)
{
  double value = 0;
  for (int k = 0; k < 4; ++k) {
    Point corners[] = {tr.point(c, 0), tr.point(c, 1), tr.point(c, 2), tr.point(c, 3)};
    corners[k] = q;
    value += CGAL::volume(corners[0], corners[1], corners[2], corners[3]) * c->vertex(k)->info();
  }
  return value / tr.tetrahedron(c).volume();
}
// [interpolate]

int main(int argc, char* argv[])
{
  Valued_points all = argc > 1 ? Valued_points() : sample(20000), known, queries;
  std::ifstream file(argc > 1 ? argv[1] : "");
  for (double x, y, z, value; file >> x >> y >> z >> value;)
    all.emplace_back(Point(x, y, z), value);
  for (std::size_t i = 0; i < all.size(); ++i)
    (i % 10 == 0 ? queries : known).push_back(all[i]);

  Triangulation tr;
  CGAL::insert_points_3(tr, known);
  std::size_t inside = 0;
  double error = 0;
  Triangulation::Cell_handle c;
  for (const auto& [q, value] : queries) {
    c = tr.locate(q, c); // from the last one
    if (tr.dimension() < 3 || tr.is_infinite(c))
      continue;
    ++inside;
    error += std::abs(interpolated(tr, c, q) - value);
  }
  if (inside == 0) {
    std::cerr
        << "The file cannot be read, or no point that was left out is in the hull of the others\n";
    return EXIT_FAILURE;
  }
  std::cout << inside << " of " << queries.size()
            << " points are in the hull; mean error there: " << error / double(inside) << '\n';
  return EXIT_SUCCESS;
}
