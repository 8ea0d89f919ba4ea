// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures points with weights: CGAL's Regular_triangulation_3 beside one that is filled, beside
// arrays and beside other programs, by CPU time; and arrays by two threads beside one, with weights and
// without, by the clock; all in turn. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
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
using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;

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

// With weights unless these are null.
Arrays build_arrays(const Points& points, const Weights* weights, std::size_t threads)
{
  const internal::Thread_executor executor(threads);
  const auto np = CGAL::parameters::default_values();
  const std::optional<std::string> regular; // nothing to be said of a surface
  if (weights != nullptr) {
    internal::Read_weighted_points<Points, Weights> read(points, *weights);
    return internal::insert_into_arrays<std::int32_t>(read, nullptr, regular, executor, np);
  }
  internal::Read_coordinates<Points> read(points);
  return internal::insert_into_arrays<std::int32_t>(read, nullptr, regular, executor, np);
}

std::size_t number_of_hidden(const Regular& rt)
{
  std::size_t number = 0;
  for (auto c = rt.all_cells_begin(); c != rt.all_cells_end(); ++c)
    number += std::size_t(std::distance(c->hidden_points_begin(), c->hidden_points_end()));
  return number;
}

struct Times
{
  std::vector<double> cpu, wall;

  void add(const comparison::Time& time)
  {
    cpu.push_back(time.cpu);
    wall.push_back(time.wall);
  }
};

double median_ratio(const std::vector<double>& theirs, const std::vector<double>& ours)
{
  std::vector<double> ratios;
  std::transform(theirs.begin(), theirs.end(), ours.begin(), std::back_inserter(ratios),
                 std::divides<double>());
  return rounded(comparison::median(ratios), 1e3);
}

// All that is measured of one set, in turn.
class Turns
{
public:
  Turns(const Set& set, std::size_t n, const std::vector<std::string>& peers,
        comparison::Launcher& launcher)
    : m_name(set.name)
    , m_balls(set.make(n))
    , m_launcher(launcher)
  {
    for (const Ball& b : m_balls) {
      m_points.push_back({b.x(), b.y(), b.z()});
      m_weights.push_back(b.weight());
    }
    for (const std::string& text : peers)
      m_peers.emplace_back(comparison::parse_peer(text));
    if (!m_peers.empty())
      m_file.emplace(m_balls);
  }

  Json run(std::size_t repetitions)
  {
    take_turn();
    m_times = {}; // what touched the memory is not counted
    for (std::size_t r = 0; r < repetitions; ++r) {
      take_turn();
      for (auto& peer : m_peers)
        peer.run(m_launcher, m_file->name());
    }
    return as_json();
  }

private:
  enum Way { PLAIN, FILLED, ARRAYS, TWO_THREADS, WITHOUT_WEIGHTS, TWO_WITHOUT_WEIGHTS, WAYS };

  template <class Work>
  void measure(Way way, const Work& work)
  {
    m_times[way].add(comparison::time_of(work));
  }

  void take_turn()
  {
    Regular expected, rt;
    Arrays made, by_two, without_weights, without_by_two; // whose end is not measured
    measure(PLAIN, [&] { expected.insert(m_balls.begin(), m_balls.end()); });
    measure(FILLED, [&] { CGAL::insert_points_3(rt, m_balls); });
    measure(ARRAYS, [&] { made = CGAL::regular_3_arrays(m_points, m_weights); });
    measure(TWO_THREADS, [&] { by_two = build_arrays(m_points, &m_weights, 2); });
    measure(WITHOUT_WEIGHTS, [&] { without_weights = build_arrays(m_points, nullptr, 1); });
    measure(TWO_WITHOUT_WEIGHTS, [&] { without_by_two = build_arrays(m_points, nullptr, 2); });
    if (m_tetrahedra != 0) // already compared
      return;
    m_tetrahedra = made.number_of_simplices();
    m_hidden = number_of_hidden(rt);
    if (!(rt == expected) || m_hidden != number_of_hidden(expected) ||
        m_tetrahedra != rt.number_of_finite_cells())
      throw std::runtime_error(m_name + ": not equal to plain CGAL");
  }

  double median_cpu(Way way) const { return rounded(comparison::median(m_times[way].cpu)); }
  double median_wall(Way way) const { return rounded(comparison::median(m_times[way].wall)); }
  double gain_of_threads(Way one, Way two) const
  {
    return median_ratio(m_times[one].wall, m_times[two].wall);
  }

  Json as_json() const
  {
    Json line = {{"set", m_name}, {"points", m_balls.size()}, {"hidden", m_hidden}};
    line["tetrahedra"] = m_tetrahedra;
    line["median_plain_cpu"] = median_cpu(PLAIN);
    line["median_filled_cpu"] = median_cpu(FILLED);
    line["median_arrays_cpu"] = median_cpu(ARRAYS);
    line["median_two_threads_wall"] = median_wall(TWO_THREADS);
    line["median_ratio_filled"] = median_ratio(m_times[PLAIN].cpu, m_times[FILLED].cpu);
    line["median_ratio_arrays"] = median_ratio(m_times[PLAIN].cpu, m_times[ARRAYS].cpu);
    line["gain_of_two_threads"] = gain_of_threads(ARRAYS, TWO_THREADS);
    line["gain_of_two_threads_without_weights"] =
        gain_of_threads(WITHOUT_WEIGHTS, TWO_WITHOUT_WEIGHTS);
    for (const auto& peer : m_peers)
      line["peers"].push_back(beside_arrays(peer.as_json(median_cpu(PLAIN), m_tetrahedra)));
    return line;
  }

  // One thread by CPU time, more beside arrays by two, by the clock.
  Json beside_arrays(Json peer) const
  {
    const auto add = [&](const char* theirs, double ours) {
      if (peer.contains(theirs))
        peer["ratio_method_to_arrays"] = rounded(double(peer[theirs]) / ours, 1e3);
    };
    if (peer.value("threads", 1) == 1)
      add("median_cpu", median_cpu(ARRAYS));
    else
      add("median_wall", median_wall(TWO_THREADS));
    return peer;
  }

  std::string m_name;
  Balls m_balls;
  Points m_points;
  Weights m_weights;
  std::array<Times, WAYS> m_times;
  std::size_t m_hidden = 0, m_tetrahedra = 0;
  std::vector<comparison::Peer_record> m_peers;
  std::optional<comparison::Points_file> m_file; // for the peers
  comparison::Launcher& m_launcher;
};

} // namespace

int main(int argc, char** argv)
{
  comparison::Launcher launcher; // before anything large is in memory
  std::vector<std::size_t> sizes = {200000, 1000000};
  std::vector<std::string> peers;
  std::size_t repetitions = 5;
  comparison::Program program(
      "measure_weights", "Measures points with weights, beside CGAL's Regular_triangulation_3.");
  program.option("sizes", sizes, "N...", "numbers of points");
  program.option("repetitions,r", repetitions, "N", "of each, in turn");
  program.option("peer", peers, "NAME=COMMAND", "another program, as README.md says");
  return program.run(argc, argv, [&](Json& report) {
    report["repetitions"] = repetitions;
    report["results"] = Json::array();
    for (const std::size_t n : sizes)
      for (const Set& set : sets) {
        report["results"].push_back(Turns(set, n, peers, launcher).run(repetitions));
        std::cerr << report["results"].back().dump() << "\n";
      }
    report["machine"]["load_after"] = comparison::load_average();
  });
}
