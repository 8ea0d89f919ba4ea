// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Thins points that were reconstructed from images, where the images cannot tell them apart. A
// point is left out if, in all images that show it, the nearest vertex has a similar depth and lies
// within a few pixels. OpenMVS does this before it cuts a surface out of the cells; COLMAP's test
// is in thin_points_by_cells.cpp. The images that show a point left out are then counted for the
// vertex that represents it.

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/bounding_box.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

struct Camera
{
  Point center;
  Vector right, up, forward; // unit vectors
  double focal_length;       // in pixels

  struct Projection
  {
    double x, y, depth;
  };
  Projection operator()(const Point& p) const
  {
    const Vector v = p - center;
    const double depth = v * forward;
    return {focal_length * (v * right) / depth, focal_length * (v * up) / depth, depth};
  }

  // Whether the two look different here.
  bool tells_apart(const Point& p, const Point& q) const
  {
    const double pixels = 4, depth_ratio = .05;
    const Projection a = (*this)(p), b = (*this)(q);
    return std::abs(a.depth - b.depth) >= depth_ratio * a.depth ||
           std::hypot(a.x - b.x, a.y - b.y) > pixels;
  }
};

// Eight cameras around the points. Real ones come with the images, as does which of them see a
// point.
std::vector<Camera> cameras_around(const Point& center, double radius)
{
  std::vector<Camera> cameras;
  for (int k = 0; k < 8; ++k) {
    const double angle = k * CGAL_PI / 4, height = k % 2 == 0 ? .6 : -.6;
    const Vector out(.8 * std::cos(angle), .8 * std::sin(angle), height);
    const Vector right(-std::sin(angle), std::cos(angle), 0);
    cameras.push_back(
        {center + 3 * radius * out, right, CGAL::cross_product(out, right), -out, 100});
  }
  return cameras;
}

struct Thinning_visitor : CGAL::Default_surface_insertion_visitor_3
{
  const std::vector<Point>& points;
  const std::vector<Camera>& cameras;
  const std::vector<std::vector<std::size_t>>& views; // by point: the cameras that see it
  std::vector<std::size_t> stands_in;                 // by point: the one that represents it

  Thinning_visitor(const std::vector<Point>& p, const std::vector<Camera>& c,
                   const std::vector<std::vector<std::size_t>>& v)
    : points(p)
    , cameras(c)
    , views(v)
    , stands_in(p.size())
  {
    std::iota(stands_in.begin(), stands_in.end(), std::size_t(0));
  }

  // If the work begins anew, this is called again for each point: the last answer counts.
  bool accept(std::size_t i, std::size_t nearest, const Point& point)
  {
    stands_in[i] = i;
    for (const std::size_t c : views[i])
      if (cameras[c].tells_apart(points[i], point))
        return true;
    stands_in[i] = nearest;
    return false;
  }
};

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
  const Point center = CGAL::midpoint((box.min)(), (box.max)());
  const double radius = std::sqrt(CGAL::squared_distance(center, (box.max)()));
  const std::vector<Camera> cameras = cameras_around(center, radius);
  std::vector<std::vector<std::size_t>> views(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < cameras.size(); ++c)
      if ((points[i] - center) * cameras[c].forward < 0)
        views[i].push_back(c);

  Thinning_visitor visitor(points, cameras, views);
  Triangulation tr;
  std::vector<std::pair<std::size_t, Triangulation::Vertex_handle>> vertices;
  try {
    CGAL::insert_points_3(tr, points,
                          CGAL::parameters::visitor(std::ref(visitor))
                              .vertex_to_vertex_output_iterator(std::back_inserter(vertices)));
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }

  // The views of each vertex, including those of the points that it represents.
  std::vector<std::set<std::size_t>> views_of_vertices(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    views_of_vertices[visitor.stands_in[i]].insert(views[i].begin(), views[i].end());
  std::size_t before = 0, after = 0;
  for (const auto& [i, v] : vertices) {
    before += views[i].size();
    after += views_of_vertices[i].size();
  }
  std::cout << tr.number_of_vertices() << " of " << points.size()
            << " points, which the images tell apart; they have " << after << " views instead of "
            << before << '\n';
  return after >= before && tr.number_of_vertices() <= points.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
