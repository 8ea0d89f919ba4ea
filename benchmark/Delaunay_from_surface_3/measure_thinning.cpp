// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Thinning while points are inserted: loops over plain CGAL beside a visitor with accept(). Writes
// JSON.
//
// The loops do what those of OpenMVS (libs/MVS/SceneReconstruct.cpp) and COLMAP
// (src/colmap/mvs/delaunay_meshing.cc) do to triangulate points that images show, rebuilt from what
// can be read there: order, start of the walk, rule and thresholds. Cameras and points are made.

#include <Delaunay_from_surface_3_comparison/gains.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
using With_levels = CGAL::Delaunay_triangulation_3<K, CGAL::Fast_location>;

struct Camera
{
  Point center;
  Vector right, up, forward; // of length 1
  double focal_length;       // in pixels
};

// When do two points look the same in an image?
struct Thresholds
{
  double pixels, depth_ratio;
};

// Points, and the cameras that see each of them.
struct Scene
{
  std::vector<Point> points;
  std::vector<Camera> cameras;
  std::vector<std::vector<unsigned short>> views;

  bool look_the_same(const Camera& camera, const Point& p, const Point& q,
                     const Thresholds& thresholds) const
  {
    const Vector v = p - camera.center, w = q - camera.center;
    const double depth = v * camera.forward, other_depth = w * camera.forward;
    if (depth <= 0 || other_depth <= 0 ||
        std::abs(depth - other_depth) > thresholds.depth_ratio * depth)
      return false;
    const double dx = v * camera.right / depth - w * camera.right / other_depth,
                 dy = v * camera.up / depth - w * camera.up / other_depth,
                 distance = thresholds.pixels / camera.focal_length;
    return dx * dx + dy * dy <= distance * distance;
  }

  bool look_the_same(std::size_t i, const Point& q, const Thresholds& thresholds) const
  {
    return std::all_of(views[i].begin(), views[i].end(), [&](const unsigned short c) {
      return look_the_same(cameras[c], points[i], q, thresholds);
    });
  }
};

// 32 cameras, evenly spread on a sphere three times as large as the surface. A point is seen by
// those on its side of the surface's middle. Images are as fine as the points: seen from in front,
// neighbours are two pixels apart.
Scene scene_of(const std::vector<Point>& points, double distance_of_neighbors)
{
  Scene scene;
  scene.points = points;
  const Point origin(0, 0, 0);
  double radius = 0;
  for (const Point& p : points)
    radius = (std::max)(radius, std::sqrt(CGAL::squared_distance(origin, p)));
  const int number = 32;
  for (int k = 0; k < number; ++k) {
    const double z = (2 * k + 1.) / number - 1, angle = 2.399963 * k, r = std::sqrt(1 - z * z);
    const Vector out(r * std::cos(angle), r * std::sin(angle), z),
        right(-std::sin(angle), std::cos(angle), 0);
    scene.cameras.push_back({origin + 3 * radius * out, right, CGAL::cross_product(out, right),
                             -out, 2 * 2 * radius / distance_of_neighbors});
  }
  scene.views.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < scene.cameras.size(); ++c)
      if ((points[i] - origin) * scene.cameras[c].forward < 0)
        scene.views[i].push_back(static_cast<unsigned short>(c));
  return scene;
}

std::vector<std::size_t> all_indices(std::size_t n)
{
  std::vector<std::size_t> indices(n);
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  return indices;
}

// In spatial order, from the last vertex seen; is_left_out(i, q) of the nearest vertex.
template <class IsLeftOut>
std::size_t insert_in_spatial_order(const std::vector<Point>& points, const IsLeftOut& is_left_out)
{
  std::vector<std::size_t> order = all_indices(points.size());
  const auto point_map = CGAL::make_property_map(points);
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<K, decltype(point_map)>(point_map));
  Triangulation tr;
  Triangulation::Vertex_handle hint;
  std::vector<Triangulation::Vertex_handle> adjacent;
  for (const std::size_t i : order) {
    const Point& p = points[i];
    if (tr.dimension() < 3) { // every point, until there are cells
      hint = tr.insert(p);
      continue;
    }
    Triangulation::Locate_type type;
    int li, lj;
    const auto c = tr.locate(p, type, li, lj, hint->cell());
    if (type == Triangulation::VERTEX) {
      hint = c->vertex(li);
      continue;
    }
    hint = tr.nearest_vertex_in_cell(p, c);
    for (auto last = Triangulation::Vertex_handle(); last != hint;) {
      last = hint;
      adjacent.clear();
      tr.finite_adjacent_vertices(last, std::back_inserter(adjacent));
      for (const auto v : adjacent)
        if (CGAL::compare_distance_to_point(p, v->point(), hint->point()) == CGAL::SMALLER)
          hint = v;
    }
    if (!is_left_out(i, hint->point()))
      hint = tr.insert(p, type, c, li, lj);
  }
  return tr.number_of_vertices();
}

// In random order, with levels to locate by; is_left_out(i, q) of all vertices of the cell that
// contains the point, where what lies outside the convex hull is inserted; or of the nearest
// vertex.
template <class IsLeftOut>
std::size_t insert_in_random_order(const std::vector<Point>& points, const IsLeftOut& is_left_out,
                                   bool asks_of_nearest)
{
  std::vector<std::size_t> order = all_indices(points.size());
  std::shuffle(order.begin(), order.end(), std::mt19937(2024));
  With_levels tr;
  for (const std::size_t i : order) {
    const Point& p = points[i];
    if (tr.number_of_vertices() >= 4) {
      const auto c = tr.locate(p);
      bool stays_out =
          asks_of_nearest ? is_left_out(i, tr.nearest_vertex(p, c)->point()) : !tr.is_infinite(c);
      for (int k = 0; !asks_of_nearest && stays_out && k < 4; ++k)
        stays_out = is_left_out(i, c->vertex(k)->point());
      if (stays_out)
        continue;
    }
    tr.insert(p);
  }
  return tr.number_of_vertices();
}

// This package: in its order, by the nearest vertex.
template <class Tr, class IsLeftOut>
std::size_t insert_by_visitor(const std::vector<Point>& points, const IsLeftOut& is_left_out)
{
  struct Visitor : CGAL::Default_surface_insertion_visitor_3
  {
    const IsLeftOut& is_left_out;
    explicit Visitor(const IsLeftOut& f)
      : is_left_out(f)
    {
    }
    bool accept(std::size_t i, std::size_t, const Point& nearest) const
    {
      return !is_left_out(i, nearest);
    }
  };
  Tr tr;
  CGAL::insert_points_3(tr, points, CGAL::parameters::visitor(Visitor(is_left_out)));
  return tr.number_of_vertices();
}

// The same by the corners of the cell that contains the point, as COLMAP's default loop.
template <class Tr, class IsLeftOut>
std::size_t insert_by_corners(const std::vector<Point>& points, const IsLeftOut& is_left_out)
{
  struct Visitor : CGAL::Default_surface_insertion_visitor_3
  {
    const std::vector<Point>& points;
    const IsLeftOut& is_left_out;
    Visitor(const std::vector<Point>& p, const IsLeftOut& f)
      : points(p)
      , is_left_out(f)
    {
    }
    bool accept(std::size_t i, std::size_t, const Point&,
                const std::array<std::size_t, 4>& corners) const
    {
      return std::any_of(corners.begin(), corners.end(), [&](std::size_t k) {
        return k == std::size_t(-1) || !is_left_out(i, points[k]);
      });
    }
  };
  Tr tr;
  CGAL::insert_points_3(tr, points, CGAL::parameters::visitor(Visitor(points, is_left_out)));
  return tr.number_of_vertices();
}

// How far a point is from its nearest neighbour, in the median.
double spacing_of(const std::vector<Point>& points)
{
  const Triangulation tr(points.begin(), points.end());
  std::vector<double> distances;
  std::vector<Triangulation::Vertex_handle> adjacent;
  for (const auto v : tr.finite_vertex_handles()) {
    adjacent.clear();
    tr.finite_adjacent_vertices(v, std::back_inserter(adjacent));
    double least = CGAL::squared_distance(v->point(), adjacent.front()->point());
    for (const auto w : adjacent)
      least = (std::min)(least, CGAL::squared_distance(v->point(), w->point()));
    distances.push_back(std::sqrt(least));
  }
  return comparison::median(distances);
}

void measure(std::size_t n, comparison::Gains& gains)
{
  const std::vector<Point> points = surfaces::genus_surface(3, n, 0.05, 2024).points;
  const double spacing = spacing_of(points);
  const Scene scene = scene_of(points, spacing);

  const auto compare = [&](const std::string& what, const auto& plain, const auto& ours) {
    gains.line(what, points.size(), plain, ours,
               [](comparison::Json& line, std::size_t by_cgal, std::size_t by_package) {
                 line["plain_vertices"] = by_cgal;
                 line["ours_vertices"] = by_package;
               });
  };
  const auto is_near = [&](std::size_t i, const Point& q) {
    return CGAL::squared_distance(points[i], q) < 4 * spacing * spacing;
  };
  compare(
      "by distance", [&] { return insert_in_spatial_order(points, is_near); },
      [&] { return insert_by_visitor<Triangulation>(points, is_near); });
  const auto as_openmvs = [&](std::size_t i, const Point& q) {
    return scene.look_the_same(i, q, {2.5, .01});
  };
  compare(
      "by 2.5 pixels, loop of OpenMVS", [&] { return insert_in_spatial_order(points, as_openmvs); },
      [&] { return insert_by_visitor<Triangulation>(points, as_openmvs); });
  const auto as_colmap = [&](std::size_t i, const Point& q) {
    return scene.look_the_same(i, q, {20, .05});
  };
  for (const bool asks_of_nearest : {false, true})
    compare(
        std::string("by 20 pixels, loop of COLMAP") + (asks_of_nearest ? ", nearest vertex" : ""),
        [&] { return insert_in_random_order(points, as_colmap, asks_of_nearest); },
        [&] {
          return asks_of_nearest ? insert_by_visitor<With_levels>(points, as_colmap)
                                 : insert_by_corners<With_levels>(points, as_colmap);
        });
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::write_gains("measure_thinning", "Measures thinning while points are inserted.",
                                 argc, argv, measure);
}
