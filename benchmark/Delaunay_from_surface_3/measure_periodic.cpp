// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures points in a periodic box: arrays of them beside CGAL's Periodic_3_Delaunay_triangulation_3 and
// other programs, by CPU time and in turn; how many copies of points they take; their memory beside that
// of arrays without periods; and two threads beside one, by the clock. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>

#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/periodic_delaunay_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
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
using Point = Kernel::Point_3;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Periodic = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
using Points = std::vector<std::array<double, 3>>;

// Moves a coordinate into a box of this period.
double wrapped(double x, double period)
{
  x -= period * std::floor(x / period);
  return x < period ? x : 0;
}

Points cube(std::size_t n, double period)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> side(0, period);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = side(random), y = side(random), z = side(random);
    points.push_back({x, y, z});
  }
  return points;
}

// A cubic lattice in random order, of which so many points are left out; its coordinates are rounded
// unless the period is a power of 2.
Points lattice(std::size_t n, double period, double share_left_out)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  const int side = int(std::lround(std::cbrt(double(n))));
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        if (unit(random) >= share_left_out)
          points.push_back({x * period / side, y * period / side, z * period / side});
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

// A Plummer sphere, the density of star clusters, with its centre in a corner of the box.
Points plummer(std::size_t n)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = .01 / std::sqrt(std::pow(unit(random), -2. / 3) - 1);
    const double z = 2 * unit(random) - 1, angle = 6.283185307179586 * unit(random),
                 across = radius * std::sqrt(1 - z * z);
    points.push_back({wrapped(across * std::cos(angle), 1), wrapped(across * std::sin(angle), 1),
                      wrapped(radius * z, 1)});
  }
  return points;
}

// Along five waves through the box.
Points filaments(std::size_t n)
{
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal(0, .003);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t which = random() % 5;
    const double along = unit(random), angle = 6.283185307179586 * along;
    const double s = .37 * double(which) + .1 * std::sin(angle) + normal(random),
                 t = .61 * double(which) + .1 * std::cos(angle) + normal(random);
    std::array<double, 3> p = {along, wrapped(s, 1), wrapped(t, 1)};
    std::rotate(p.begin(), p.begin() + which % 3, p.end());
    points.push_back(p);
  }
  return points;
}

struct Set
{
  std::string name;
  double period;
  std::size_t most_plain; // points that CGAL takes in less than a minute
  std::function<Points(std::size_t)> make;
};

const std::vector<Set> sets = {
    {"random, period 1", 1, 10000000, [](std::size_t n) { return cube(n, 1); }},
    {"random, period 10", 10, 10000000, [](std::size_t n) { return cube(n, 10); }},
    {"lattice", 1, 200000, [](std::size_t n) { return lattice(n, 1, 0); }},
    {"lattice, three in ten left out, period 10", 10, 200000,
     [](std::size_t n) { return lattice(n, 10, .3); }},
    {"Plummer sphere in a corner", 1, 2000, plummer},
    {"filaments", 1, 2000, filaments},
};

CGAL::Periodic_3_arrays<> arrays_of(const Points& points, double period)
{
  return CGAL::periodic_delaunay_3_arrays(points, {{period, period, period}});
}

// The time of arrays by the clock.
double arrays_wall(const Points& points, double period, std::size_t threads)
{
  const internal::Thread_executor executor(threads);
  internal::Read_coordinates<Points> read(points);
  const auto np = CGAL::parameters::default_values();
  return comparison::time_of([&] {
           internal::insert_into_box<std::int32_t>(read, {{period, period, period}}, executor, np);
         })
      .wall;
}

// The peak above the input, in bytes.
template <class Make>
double peak_of(const std::string& name, const Make& make)
{
  const comparison::Memory memory = comparison::memory_of_build(name, [&](const auto& look) {
    const auto made = make();
    look();
  });
  return double(memory.peak) - double(memory.input);
}

double plain_cpu(const Set& set, const std::vector<Point>& points, std::size_t tetrahedra)
{
  Periodic expected(Traits::Iso_cuboid_3(0, 0, 0, set.period, set.period, set.period));
  const double time =
      comparison::time_of([&] { expected.insert(points.begin(), points.end(), true); }).cpu;
  if (expected.number_of_cells() != tetrahedra)
    throw std::runtime_error(set.name + ": not equal to CGAL");
  return time;
}

std::vector<Point> scaled(const Points& points, double by)
{
  std::vector<Point> result;
  for (const auto& p : points)
    result.emplace_back(p[0] * by, p[1] * by, p[2] * by);
  return result;
}

// Other programs of one thread, by CPU time.
Json beside_arrays(const comparison::Peer_record& peer, double ours, std::size_t tetrahedra)
{
  Json line = peer.as_json(0, tetrahedra);
  line.erase("ratio_plain_to_method");
  if (line.contains("median_cpu"))
    line["ratio_method_to_arrays"] = rounded(double(line["median_cpu"]) / ours, 1e3);
  return line;
}

Json measure_set(const Set& set, std::size_t n, std::size_t repetitions,
                 const std::vector<std::string>& commands, comparison::Launcher& launcher)
{
  const bool has_plain = n <= set.most_plain;
  const Points points = set.make(n);
  const std::vector<Point> of_cgal = scaled(points, 1);
  const comparison::Points_file file(
      scaled(points, 1 / set.period)); // for the others, in a box of 1
  std::vector<comparison::Peer_record> peers;
  for (const std::string& text : commands)
    peers.emplace_back(comparison::parse_peer(text));
  Json line = {{"set", set.name}, {"points", points.size()}};
  const double peak = peak_of(set.name, [&] { return arrays_of(points, set.period); });
  const double peak_in_space = peak_of(set.name, [&] { return CGAL::delaunay_3_arrays(points); });
  comparison::Turns turns;
  for (std::size_t r = 0; r < repetitions + 1; ++r) {
    CGAL::Periodic_3_arrays<> arrays;
    const double ours = comparison::time_of([&] { arrays = arrays_of(points, set.period); }).cpu;
    const double plain = has_plain ? plain_cpu(set, of_cgal, arrays.number_of_simplices()) : 0;
    if (r == 0) { // touches the memory, and is not counted
      line["tetrahedra"] = arrays.number_of_simplices();
      line["copies_per_point"] = comparison::per_point(arrays.number_of_copies(), points.size());
      continue;
    }
    turns.plain.push_back(plain);
    turns.ours.push_back(ours);
    turns.ratios.push_back(plain / ours);
    for (auto& peer : peers)
      peer.run(launcher, file.name());
  }
  const double ours = rounded(comparison::median(turns.ours));
  if (has_plain) {
    line["median_plain_cpu"] = rounded(comparison::median(turns.plain));
    line["median_ratio"] = rounded(comparison::median(turns.ratios), 1e3);
  }
  line["median_arrays_cpu"] = ours;
  line["peak_bytes_per_point"] = rounded(peak / double(points.size()), 10);
  line["peak_to_that_in_space"] = rounded(peak / peak_in_space, 1e3);
  std::vector<double> gains;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const double one = arrays_wall(points, set.period, 1);
    gains.push_back(one / arrays_wall(points, set.period, 2));
  }
  line["gain_of_two_threads"] = rounded(comparison::median(gains), 1e3);
  for (const auto& peer : peers)
    line["peers"].push_back(beside_arrays(peer, ours, line["tetrahedra"]));
  return line;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> sizes = {100000, 1000000};
  std::size_t repetitions = 3;
  std::vector<std::string> peers;
  comparison::Launcher launcher;
  comparison::Program program(
      "measure_periodic",
      "Measures points in a periodic box, beside CGAL's Periodic_3_Delaunay_triangulation_3.");
  program.option("sizes", sizes, "N...", "numbers of points");
  program.option("repetitions,r", repetitions, "N", "of each, in turn");
  program.option("peer", peers, "NAME=COMMAND", "another program, as README.md says");
  return program.run(argc, argv, [&](Json& report) {
    report["repetitions"] = repetitions;
    report["results"] = Json::array();
    for (const std::size_t n : sizes)
      for (const Set& set : sets) {
        report["results"].push_back(measure_set(set, n, repetitions, peers, launcher));
        std::cerr << report["results"].back().dump() << "\n";
      }
  });
}
