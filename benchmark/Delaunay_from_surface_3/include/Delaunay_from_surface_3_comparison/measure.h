// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H

// Times, phases, counts and equality of the methods on one surface.

#include <Delaunay_from_surface_3_comparison/methods.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

namespace comparison {

using Json = nlohmann::ordered_json;
using Phase = CGAL::Surface_insertion_phase;

inline const std::vector<std::pair<const char*, Phase>>& phases()
{
  static const std::vector<std::pair<const char*, Phase>> all = {
      {"plan", Phase::PLAN},         {"subgraph", Phase::SUBGRAPH}, {"trace", Phase::TRACE},
      {"location", Phase::LOCATION}, {"update", Phase::UPDATE},     {"finish", Phase::FINISH}};
  return all;
}

inline double rounded(double x, double per_unit = 1e6)
{
  return std::round(x * per_unit) / per_unit;
}

inline double median(std::vector<double> values)
{
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Time
{
  double cpu, wall; // of the process, and on the clock; seconds
};

template <class Work>
Time time_of(const Work& work)
{
  const double wall = Steady_seconds()();
  const std::clock_t cpu = std::clock();
  work();
  return {double(std::clock() - cpu) / CLOCKS_PER_SEC, Steady_seconds()() - wall};
}

// Two triangulations of one set of points with exact predicates that agree in all these are hardly
// different; it is what is checked where operator== would take longer than the measurement.
inline bool have_same_counts(const Triangulation& a, const Triangulation& b)
{
  return a.number_of_vertices() == b.number_of_vertices() &&
         a.number_of_cells() == b.number_of_cells() &&
         a.number_of_finite_cells() == b.number_of_finite_cells() &&
         a.number_of_finite_facets() == b.number_of_finite_facets() &&
         a.number_of_finite_edges() == b.number_of_finite_edges();
}

// One metered run. The clock runs while other processes do; so the shares count, and `scale` turns
// them into CPU time.
inline Json phases_of(const Method& method, const Mesh& mesh, unsigned int seed)
{
  Triangulation tr;
  Timing_visitor visitor;
  const Time total = time_of([&] { method.time_phases(tr, mesh, seed, visitor); });
  Json seconds;
  double rest = total.wall;
  for (const auto& [name, phase] : phases()) {
    seconds[name] = rounded(visitor.total(phase));
    rest -= visitor.total(phase);
  }
  seconds["input_and_output"] = rounded(rest);
  return {{"wall", rounded(total.wall)},
          {"cpu", rounded(total.cpu)},
          {"scale_to_cpu", rounded(total.cpu / total.wall)},
          {"seconds", seconds}};
}

inline Json calls_per_point(const CGAL::Predicate_counts& counts, double n)
{
  return {{"cells_entered", rounded(double(counts.cells_entered()) / n, 1e4)},
          {"orientation", rounded(double(counts.orientation) / n, 1e4)},
          {"in_sphere", rounded(double(counts.in_sphere) / n, 1e4)},
          {"other", rounded(double(counts.other) / n, 1e4)}};
}

// One run with counted predicates. In the phase UPDATE a negative orientation is no step of a walk.
inline Json counts_of(const Method& method, const Mesh& mesh, unsigned int seed)
{
  Counted_triangulation tr;
  Counting_visitor visitor(Counted_calls{&tr.geom_traits().counts()});
  method.count_calls(tr, mesh, seed, visitor);

  const double n = double(mesh.number_of_vertices());
  Json result = {
      {"all_calls_per_point", rounded(double(tr.geom_traits().counts().all()) / n, 1e4)}};
  if (!method.time_phases)
    return result;
  for (const auto& [name, phase] : {phases()[2], phases()[3], phases()[4]})
    result[name] = calls_per_point(visitor.total(phase), n);
  result["update"].erase("cells_entered");
  std::size_t traced = 0;
  for (const auto& round : visitor.rounds())
    traced += round.number_of_traced_points;
  result["rounds"] = visitor.rounds().size() - 1;
  result["traced_points"] = traced;
  if (traced > 0)
    result["cells_entered_per_traced_point"] =
        rounded(double(visitor.total(Phase::TRACE).cells_entered()) / double(traced), 1e4);
  return result;
}

inline Json times_as_json(const std::vector<Time>& times)
{
  std::vector<double> cpu, wall;
  for (const Time& time : times) {
    cpu.push_back(rounded(time.cpu));
    wall.push_back(rounded(time.wall));
  }
  return {{"median_cpu", median(cpu)}, {"median_wall", median(wall)}, {"cpu", cpu}, {"wall", wall}};
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H
