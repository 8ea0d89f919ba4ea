// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default loop of COLMAP's mesher, as a visitor. A point that was reconstructed from images is
// left out if, in every image that shows it, it looks like all four vertices of the cell that
// contains it. For comparison, a loop over plain CGAL that locates, tests and inserts each point
// follows. In the same order it leaves out the same points.

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

// Looks along -z, from far above all points. Real ones come with the images.
struct Camera
{
  Vector offset;
  double focal_length = 200; // in pixels

  bool look_the_same(const Point& p, const Point& q) const
  {
    const double pixels = 4, depth_ratio = .05;
    const double a = 10 - p.z(), b = 10 - q.z();
    const double x = (p.x() + offset.x()) / a - (q.x() + offset.x()) / b;
    const double y = (p.y() + offset.y()) / a - (q.y() + offset.y()) / b;
    return std::abs(a - b) < depth_ratio * a && focal_length * std::hypot(x, y) <= pixels;
  }
};

struct Images
{
  std::vector<Camera> cameras = {{{0, 0, 0}}, {{4, 0, 0}}, {{-2, 3, 0}}, {{-2, -3, 0}}};

  bool look_the_same(const Point& p, const Point& q) const
  {
    return std::all_of(cameras.begin(), cameras.end(),
                       [&](const Camera& camera) { return camera.look_the_same(p, q); });
  }
};

struct Thinning_visitor : CGAL::Default_surface_insertion_visitor_3
{
  const std::vector<Point>& points;
  const Images& images;
  std::vector<std::size_t> asked; // in this order; the first point is inserted without a call

  Thinning_visitor(const std::vector<Point>& p, const Images& i)
    : points(p)
    , images(i)
  {
  }
  void order_is_replaced(const std::string&) { asked.clear(); }

  bool accept(std::size_t i, std::size_t nearest, const Point&,
              const std::array<std::size_t, 4>& corners)
  {
    if (asked.empty())
      asked.push_back(nearest);
    asked.push_back(i);
    return std::any_of(corners.begin(), corners.end(), [&](std::size_t k) {
      return k == std::size_t(-1) || !images.look_the_same(points[i], points[k]);
    });
  }
};

// The loop over plain CGAL.
Triangulation by_plain_cgal(const std::vector<Point>& points, const std::vector<std::size_t>& order,
                            const Images& images)
{
  Triangulation tr;
  for (const std::size_t i : order) {
    bool looks_new = tr.dimension() < 3;
    if (!looks_new) {
      const auto c = tr.locate(points[i]);
      for (int k = 0; k < 4; ++k)
        looks_new = looks_new || tr.is_infinite(c->vertex(k)) ||
                    !images.look_the_same(points[i], c->vertex(k)->point());
    }
    if (looks_new)
      tr.insert(points[i]);
  }
  return tr;
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

  const Images images;
  Thinning_visitor visitor(points, images);
  Triangulation tr;
  try {
    CGAL::insert_points_3(tr, points, CGAL::parameters::visitor(std::ref(visitor)));
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  const bool is_equal = tr == by_plain_cgal(points, visitor.asked, images);
  std::cout
      << tr.number_of_vertices() << " of " << points.size()
      << " points, which differ from the cells that they lie in; the loop over plain CGAL has "
      << (is_equal ? "the same\n" : "others\n");
  return is_equal ? EXIT_SUCCESS : EXIT_FAILURE;
}
