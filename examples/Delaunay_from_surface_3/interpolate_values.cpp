// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Interpolates values at scattered points, linearly in tetrahedra. Every tenth point is left out, and
// its value is compared with the interpolated one. A file may be named that has x, y, z and a value
// of each point; with a second one, of x, y, z, the values there are printed instead.

#include "read_rows.h"

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
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

// Calls f(q, value, i) for the i-th query, where the value is NaN outside the hull.
template <class Queries, class F>
void interpolate(const Valued_points& known, const Queries& queries, const F& f)
{
  Triangulation tr;
  CGAL::insert_points_3(tr, known);
  Triangulation::Cell_handle c;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    c = tr.locate(queries[i], c); // from the last one
    f(queries[i],
      tr.dimension() < 3 || tr.is_infinite(c) ? std::nan("") : interpolated(tr, c, queries[i]), i);
  }
}

Valued_points read_values(const char* file_name)
{
  Valued_points points;
  for (const auto& [x, y, z, value] : read_rows<4>(file_name))
    points.emplace_back(Point(x, y, z), value);
  return points;
}

int print_values_at(const char* file_name, const Valued_points& known)
{
  std::vector<Point> queries;
  for (const auto& [x, y, z] : read_rows<3>(file_name))
    queries.emplace_back(x, y, z);
  std::cout.precision(17);
  interpolate(known, queries, [](const Point& q, double value, std::size_t) {
    std::cout << q << ' ' << value << '\n';
  });
  return EXIT_SUCCESS;
}

int leave_out_every_tenth(const Valued_points& all)
{
  Valued_points known;
  std::vector<Point> queries;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i % 10 == 0)
      queries.push_back(all[i].first);
    else
      known.push_back(all[i]);
  std::size_t inside = 0;
  double error = 0;
  interpolate(known, queries, [&](const Point&, double value, std::size_t i) {
    if (!std::isnan(value)) {
      ++inside;
      error += std::abs(value - all[10 * i].second);
    }
  });
  std::cout << "Every tenth of " << all.size() << " points was left out; " << inside << " of these "
            << queries.size() << " are in the hull of the others";
  if (inside > 0)
    std::cout << ", where the mean error is " << error / double(inside);
  std::cout << '\n';
  return inside > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  try {
    const Valued_points all = argc > 1 ? read_values(argv[1]) : sample(20000);
    return argc > 2 ? print_values_at(argv[2], all) : leave_out_every_tenth(all);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
