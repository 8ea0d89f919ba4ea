// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Twenty rebuilds of points that move a little in between, as in a simulation or the training of a
// scene: by plain CGAL, and by this package into arrays, with an order made anew each time and with
// that of the call before. Writes JSON; the times are of all rebuilds together.

#include <Delaunay_from_surface_3_comparison/gains.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
using Points = std::vector<std::array<double, 3>>;
constexpr int rebuilds = 20;

Points points_in_cube(std::size_t n)
{
  std::mt19937_64 random(2024);
  std::uniform_real_distribution<double> uniform;
  Points points(n);
  for (auto& p : points)
    p = {uniform(random), uniform(random), uniform(random)};
  return points;
}

Points points_of_surface(std::size_t n)
{
  Points points;
  for (const auto& p : surfaces::genus_surface(3, n, 0.05, 2024).points)
    points.push_back({p.x(), p.y(), p.z()});
  return points;
}

// Calls build(points) for each place of the points; each step is `length` on average. Returns the
// sum of what the builds return.
template <class Build>
std::size_t rebuild(Points points, double length, const Build& build)
{
  std::mt19937_64 random(7);
  std::normal_distribution<double> step(0, length / std::sqrt(3.));
  std::size_t cells = 0;
  for (int k = 0; k < rebuilds; ++k) {
    cells += build(points);
    for (auto& p : points)
      for (double& x : p)
        x += step(random);
  }
  return cells;
}

std::size_t by_plain_cgal(const Points& points)
{
  std::vector<K::Point_3> converted;
  converted.reserve(points.size());
  for (const auto& [x, y, z] : points)
    converted.emplace_back(x, y, z);
  return Triangulation(converted.begin(), converted.end()).number_of_finite_cells();
}

void compare(const std::string& name, const Points& points, double length, comparison::Gains& gains)
{
  const auto see = [](comparison::Json& line, std::size_t by_cgal, std::size_t ours) {
    if (by_cgal != ours)
      throw std::runtime_error("the numbers of tetrahedra differ");
    line["rebuilds"] = rebuilds;
    line["tetrahedra"] = ours / rebuilds;
  };
  const auto plain = [&] { return rebuild(points, length, by_plain_cgal); };
  gains.line(
      name + ", a new order each time", points.size(), plain,
      [&] {
        return rebuild(points, length, [](const Points& moved) {
          return CGAL::delaunay_3_arrays(moved).number_of_simplices();
        });
      },
      see);
  gains.line(
      name + ", the order of the call before", points.size(), plain,
      [&] {
        CGAL::Delaunay_from_surface_3::Insertion_order order;
        return rebuild(points, length, [&](const Points& moved) {
          return CGAL::delaunay_3_arrays(moved, order).number_of_simplices();
        });
      },
      see);
}

void measure(std::size_t n, comparison::Gains& gains)
{
  // Steps of a hundredth of the distance between neighbours.
  compare("points in a cube", points_in_cube(n), .01 / std::cbrt(double(n)), gains);
  compare("points of a surface", points_of_surface(n), .01 / std::sqrt(double(n)), gains);
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::write_gains("measure_moved",
                                 "Measures twenty rebuilds of points that move in between.", argc,
                                 argv, measure);
}
