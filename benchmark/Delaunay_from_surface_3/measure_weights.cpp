// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures points with weights: CGAL's Regular_triangulation_3 beside one that is filled, and beside
// arrays, by CPU time and in turn; and arrays by two threads beside one, with weights and without,
// by the clock. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>

#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_weighted_points_3.h>
#include <CGAL/regular_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <iterator>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Delaunay_from_surface_3::internal;
using comparison::Json;
using comparison::rounded;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ball = Kernel::Weighted_point_3;
using Balls = std::vector<Ball>;
using Points = std::vector<std::array<double, 3>>;
using Weights = std::vector<double>;
using Regular = CGAL::Regular_triangulation_3<Kernel>;

Ball ball(double x, double y, double z, double weight)
{
  return Ball(Kernel::Point_3(x, y, z), weight);
}

// Uniform in a cube, with weights up to `factor` times the square of the points' distance.
Balls cube(std::size_t n, double factor)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const double h = std::cbrt(1 / double(n));
  Balls balls;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    balls.push_back(ball(x, y, z, factor * h * h * unit(random)));
  }
  return balls;
}

// Atoms along a random walk in a box with 20 cubic angstroms for each, with the radii of carbon,
// nitrogen and oxygen, and three decimals as in files of molecules.
Balls chain(std::size_t n)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> step;
  const double half = std::cbrt(20. * double(n)) / 2;
  std::array<double, 3> at = {}, direction = {1, 0, 0};
  Balls balls;
  for (std::size_t i = 0; i < n; ++i) {
    double length = 0;
    for (double& d : direction) {
      d = d / 2 + step(random);
      length += d * d;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      direction[c] /= std::sqrt(length);
      if (std::abs(at[c] + 1.5 * direction[c]) > half)
        direction[c] = -direction[c];
      at[c] = std::round(1000 * (at[c] + 1.5 * direction[c])) / 1000;
    }
    const double radius = std::array<double, 3>{{1.7, 1.55, 1.52}}[i % 3];
    balls.push_back(ball(at[0], at[1], at[2], radius * radius));
  }
  return balls;
}

// A cubic lattice of spacing 2 in random order, with integer weights up to `most`.
Balls lattice(std::size_t n, std::uint64_t most)
{
  std::mt19937_64 random(3);
  const int side = int(std::lround(std::cbrt(double(n))));
  Balls balls;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        balls.push_back(ball(2 * x, 2 * y, 2 * z, double(1 + random() % (most + 1))));
  std::shuffle(balls.begin(), balls.end(), random);
  return balls;
}

struct Set
{
  std::string name;
  std::function<Balls(std::size_t)> make;
};

const std::vector<Set> sets = {
    {"cube, weights 0", [](std::size_t n) { return cube(n, 0); }},
    {"cube, small weights", [](std::size_t n) { return cube(n, .5); }},
    {"cube, large weights", [](std::size_t n) { return cube(n, 9); }},
    {"chain of atoms", chain},
    {"lattice, equal weights", [](std::size_t n) { return lattice(n, 0); }},
    {"lattice, weights 1 to 4", [](std::size_t n) { return lattice(n, 3); }},
};

// The time of arrays by the clock, with weights unless these are null.
double arrays_wall(const Points& points, const Weights* weights, std::size_t threads)
{
  const internal::Thread_executor executor(threads);
  const auto np = CGAL::parameters::default_values();
  const std::optional<std::string> regular; // nothing to be said of a surface
  return comparison::time_of([&] {
           if (weights != nullptr) {
             internal::Read_weighted_points<Points, Weights> read(points, *weights);
             internal::insert_into_arrays<std::int32_t>(read, nullptr, regular, executor, np);
           } else {
             internal::Read_coordinates<Points> read(points);
             internal::insert_into_arrays<std::int32_t>(read, nullptr, regular, executor, np);
           }
         })
      .wall;
}

// One thread over two, the median of turns.
double gain_of_threads(const Points& points, const Weights* weights, std::size_t repetitions)
{
  std::vector<double> gains;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const double one = arrays_wall(points, weights, 1);
    gains.push_back(one / arrays_wall(points, weights, 2));
  }
  return rounded(comparison::median(gains), 1e3);
}

std::size_t number_of_hidden(const Regular& rt)
{
  std::size_t number = 0;
  for (auto c = rt.all_cells_begin(); c != rt.all_cells_end(); ++c)
    number += std::size_t(std::distance(c->hidden_points_begin(), c->hidden_points_end()));
  return number;
}

Json measure_set(const Set& set, std::size_t n, std::size_t repetitions)
{
  const Balls balls = set.make(n);
  Points points;
  Weights weights;
  for (const Ball& b : balls) {
    points.push_back({b.x(), b.y(), b.z()});
    weights.push_back(b.weight());
  }
  comparison::Turns filled, arrays;
  std::size_t hidden = 0;
  for (std::size_t r = 0; r < repetitions + 1; ++r) {
    Regular expected, rt;
    CGAL::Delaunay_3_arrays<std::int32_t> made;
    const double plain =
        comparison::time_of([&] { expected.insert(balls.begin(), balls.end()); }).cpu;
    const double ours = comparison::time_of([&] { CGAL::insert_points_3(rt, balls); }).cpu;
    const double alone =
        comparison::time_of([&] { made = CGAL::regular_3_arrays(points, weights); }).cpu;
    if (r == 0) { // touches the memory, and is not counted
      hidden = number_of_hidden(rt);
      if (!(rt == expected) || hidden != number_of_hidden(expected) ||
          made.number_of_simplices() != rt.number_of_finite_cells())
        throw std::runtime_error(set.name + ": not equal to plain CGAL");
      continue;
    }
    for (comparison::Turns* turns : {&filled, &arrays}) {
      turns->plain.push_back(plain);
      turns->ours.push_back(turns == &filled ? ours : alone);
      turns->ratios.push_back(plain / turns->ours.back());
    }
  }
  Json line = {{"set", set.name}, {"points", balls.size()}, {"hidden", hidden}};
  line["median_plain_cpu"] = rounded(comparison::median(filled.plain));
  line["median_filled_cpu"] = rounded(comparison::median(filled.ours));
  line["median_arrays_cpu"] = rounded(comparison::median(arrays.ours));
  line["median_ratio_filled"] = rounded(comparison::median(filled.ratios), 1e3);
  line["median_ratio_arrays"] = rounded(comparison::median(arrays.ratios), 1e3);
  line["gain_of_two_threads"] = gain_of_threads(points, &weights, repetitions);
  line["gain_of_two_threads_without_weights"] = gain_of_threads(points, nullptr, repetitions);
  return line;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> sizes = {200000, 1000000};
  std::size_t repetitions = 5;
  comparison::Program program(
      "measure_weights", "Measures points with weights, beside CGAL's Regular_triangulation_3.");
  program.option("sizes", sizes, "N...", "numbers of points");
  program.option("repetitions,r", repetitions, "N", "of each, in turn");
  return program.run(argc, argv, [&](Json& report) {
    report["repetitions"] = repetitions;
    report["results"] = Json::array();
    for (const std::size_t n : sizes)
      for (const Set& set : sets) {
        report["results"].push_back(measure_set(set, n, repetitions));
        std::cerr << report["results"].back().dump() << "\n";
      }
  });
}
