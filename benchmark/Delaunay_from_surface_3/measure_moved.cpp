// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Rebuilds of points that move a little in between, as in a simulation or the training of a
// scene: by plain CGAL, by other programs, and by this package into arrays, with an order made anew each
// time and with that of the call before, in turn. Writes JSON; the times are medians of one rebuild.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
using Points = std::vector<K::Point_3>;
using Peers = std::vector<std::string>; // NAME=COMMAND

// Each step is `length` on average. The first build, of points that have not moved, is not counted.
void compare(const std::string& name, Points points, double length, comparison::Gains& gains,
             comparison::Launcher& launcher, const Peers& names)
{
  using comparison::Json;
  CGAL::Delaunay_from_surface_3::Insertion_order order;
  const std::array<std::pair<const char*, std::function<std::size_t()>>, 3> ways = {
      {{"plain",
        [&] { return Triangulation(points.begin(), points.end()).number_of_finite_cells(); }},
       {"new_order", [&] { return CGAL::delaunay_3_arrays(points).number_of_simplices(); }},
       {"kept_order",
        [&] { return CGAL::delaunay_3_arrays(points, order).number_of_simplices(); }}}};
  std::array<std::vector<double>, 3> times;
  std::vector<comparison::Peer_record> peers;
  for (const std::string& text : names)
    peers.emplace_back(comparison::parse_peer(text));
  std::mt19937_64 random(7);
  std::normal_distribution<double> step(0, length / std::sqrt(3.));
  std::size_t tetrahedra = 0;
  for (std::size_t k = 0; k <= gains.repetitions(); ++k) {
    for (std::size_t w = 0; w < ways.size(); ++w) {
      std::size_t found = 0;
      const double cpu = comparison::time_of([&] { found = ways[w].second(); }).cpu;
      if (w > 0 && found != tetrahedra)
        throw std::runtime_error("the numbers of tetrahedra differ");
      tetrahedra = found;
      if (k > 0)
        times[w].push_back(cpu);
    }
    const comparison::Points_file file(points);
    for (auto& peer : peers)
      peer.run(launcher, file.name());
    for (auto& p : points)
      p = p + K::Vector_3(step(random), step(random), step(random));
  }

  Json line = {{"consumer", name}, {"points", points.size()}};
  for (std::size_t w = 0; w < ways.size(); ++w)
    line[std::string("median_") + ways[w].first + "_cpu"] =
        comparison::rounded(comparison::median(times[w]));
  for (const auto& peer : peers)
    line["peers"].push_back(peer.as_json(comparison::median(times[0]), tetrahedra));
  gains.add(line);
}

} // namespace

int main(int argc, char** argv)
{
  comparison::Launcher launcher; // before anything large is in memory
  Peers peers;
  comparison::Program program("measure_moved", "Measures rebuilds of points that move in between.");
  program.option("peer", peers, "NAME=COMMAND", "another program, as README.md says");
  const auto measure = [&](std::size_t n, comparison::Gains& gains) {
    // Steps of a hundredth of the distance between neighbours.
    compare("points in a cube", surfaces::points_in_box(n, 1, 1, 1, 2024).points,
            .01 / std::cbrt(double(n)), gains, launcher, peers);
    compare("points of a surface", surfaces::genus_surface(3, n, 0.05, 2024).points,
            .01 / std::sqrt(double(n)), gains, launcher, peers);
  };
  return comparison::run_gains(program, argc, argv, measure);
}
