// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Thins points while they are inserted: a point that is nearer to a vertex than a given distance is
// left out. So no two vertices are nearer to each other, and every point is that near to a vertex.

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

// Decides about each point, given the vertex that is nearest to it at that time.
struct Thinning_visitor : CGAL::Default_surface_insertion_visitor_3
{
  const std::vector<Point>& points;
  const double least_squared_distance;

  Thinning_visitor(const std::vector<Point>& p, double d)
    : points(p)
    , least_squared_distance(d * d)
  {
  }

  bool accept(std::size_t i, std::size_t /* number of the point there */,
              const Point& nearest) const
  {
    return CGAL::squared_distance(points[i], nearest) >= least_squared_distance;
  }
};

// Whether the points were thinned as intended.
bool is_thinned(const Triangulation& tr, const std::vector<Point>& points, double squared_distance)
{
  for (const auto& e : tr.finite_edges()) // the nearest vertices are joined by an edge
    if (tr.segment(e).squared_length() < squared_distance)
      return false;
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    const auto v = tr.nearest_vertex(p);
    return p == v->point() || CGAL::squared_distance(p, v->point()) < squared_distance;
  });
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> unused_faces;
  if (!CGAL::IO::read_polygon_soup(file_name, points, unused_faces) || points.empty()) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  const double distance = argc > 2
                              ? std::atof(argv[2])
                              : std::sqrt(CGAL::squared_distance((box.min)(), (box.max)())) / 30;

  const Thinning_visitor visitor(points, distance);
  Triangulation tr;
  try {
    CGAL::insert_points_3(tr, points, CGAL::parameters::visitor(visitor));
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cout << tr.number_of_vertices() << " of " << points.size()
            << " points, none nearer to another than " << distance << '\n';
  return is_thinned(tr, points, visitor.least_squared_distance) ? EXIT_SUCCESS : EXIT_FAILURE;
}
