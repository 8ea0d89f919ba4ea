// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_STATISTICS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_STATISTICS_H

#include "Report.h"
#include "Surface.h"

#include <Delaunay_from_surface_3_meters/delaunay_share.h>
#include <Delaunay_from_surface_3_meters/meters.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// Reports what --stats and --compare ask for.

// Reports how much of the surface is in the triangulation.
inline void report_surface(const Surface& surface, const Triangulation& tr,
                           const std::vector<Triangulation::Vertex_handle>& vertices,
                           Report& report)
{
  report.title("The surface in the triangulation");
  if (tr.dimension() < 2) {
    report("Delaunay edges", "not counted in dimension " + std::to_string(tr.dimension()));
    return;
  }
  const auto share = meters::delaunay_share(tr, vertices, surface.faces);
  report("Delaunay edges", fraction(share.delaunay_edges, share.edges));
  report("other edges", fraction(share.edges - share.delaunay_edges, share.edges));
  report("Delaunay triangles", fraction(share.delaunay_triangles, share.triangles));
  report("other triangles", fraction(share.triangles - share.delaunay_triangles, share.triangles));
  if (share.polygons > 0)
    report("polygons", std::to_string(share.polygons) + " (not counted as triangles)");
}

// Reports what the insertion does, phase by phase and round by round, as visitors see it.

using Phase = CGAL::Surface_insertion_phase;
using CGAL::Delaunay_from_surface_3::Insertion_counts;

// Keeps the counts of the core; CGAL's insertion counts nothing.
struct Counting_visitor : CGAL::Default_surface_insertion_visitor_3
{
  Insertion_counts counts;

  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints&)
  {
    counts = target.counts();
  }
};

inline void report_counts(const Insertion_counts& counts, std::size_t points, Report& report)
{
  static const char* const stages[] = {
      "doubles on a lattice", "integers of 30 bits",  "integers of 60 bits",  "balanced doubles",
      "double-double",        "integers of 120 bits", "integers of any width"};
  static_assert(std::size(stages) == CGAL::Delaunay_from_surface_3::NUMBER_OF_EXACT_STAGES,
                "each stage has a name");
  const double n = double(points);
  report.title("What the insertions into the compact triangulation did, per point");
  report("cells until a conflict", double(counts.cells_tested_to_start) / n, 3);
  report("cells destroyed", double(counts.cells_destroyed) / n, 3);
  report("cells created", double(counts.cells_created) / n, 3);
  report("sphere tests", double(counts.sphere_tests) / n, 3);
  report.title("Tests that floating point left open, by the stage that decided them");
  for (std::size_t s = 0; s < CGAL::Delaunay_from_surface_3::NUMBER_OF_EXACT_STAGES; ++s)
    report(stages[s], counts.sphere_tests_by_stage[s] + counts.facet_tests_by_stage[s]);
  report("sign 0, perturbed", counts.perturbed);
}

using Row = std::vector<std::string>;

// Adds one line to the table: `counts`, divided by `points`.
inline void add_row(std::vector<Row>& rows, const std::string& round, const std::string& phase,
                    std::size_t points, const meters::Predicate_counts& counts, bool is_walk)
{
  if (points == 0)
    return;
  const double n = double(points);
  rows.push_back({round, phase, std::to_string(points),
                  is_walk ? decimals(double(counts.cells_entered()) / n, 3) : "-",
                  decimals(double(counts.orientation) / n, 3),
                  decimals(double(counts.in_sphere) / n, 3),
                  decimals(double(counts.other) / n, 3)});
}

// Reports a run in which every call of a predicate is counted. It goes through CGAL's insertion.
template <class Traits>
void report_predicates(const Surface& surface, const Traits& traits, unsigned int seed,
                       Report& report)
{
  using Counting_kernel = meters::Predicate_counting_traits_3<Kernel>;
  const Counting_kernel kernel;
  const auto meter = [&] { return kernel.counts(); };
  meters::Metering_visitor_3<decltype(meter)> visitor(meter);
  CGAL::Delaunay_triangulation_3<Counting_kernel> tr(kernel);
  insert_and_watch(tr, surface, traits, seed, visitor);

  std::vector<Row> rows;
  std::size_t inserted = 0, traced = 0;
  for (std::size_t r = 1; r < visitor.rounds().size(); ++r) { // 0 is the time before the rounds
    const auto& round = visitor.rounds()[r];
    const std::string name = std::to_string(r);
    add_row(rows, name, "locate", round.number_of_points, round[Phase::LOCATION], true);
    add_row(rows, name, "update", round.number_of_points, round[Phase::UPDATE], false);
    add_row(rows, name, "trace", round.number_of_traced_points, round[Phase::TRACE], true);
    inserted += round.number_of_points;
    traced += round.number_of_traced_points;
  }
  add_row(rows, "all", "locate", inserted, visitor.total(Phase::LOCATION), true);
  add_row(rows, "all", "update", inserted, visitor.total(Phase::UPDATE), false);
  add_row(rows, "all", "trace", traced, visitor.total(Phase::TRACE), true);
  report.title("Cells entered by the walks and calls of predicates, per point");
  report.table("rounds", {"round", "phase", "points", "cells", "orientation", "in-sphere", "other"},
               2, rows);
}

// Reports what the insertions did: the target's counts, or else the predicates that were called.
template <class Traits>
void report_insertions(const Surface& surface, const Traits& traits, unsigned int seed,
                       Report& report)
{
  Counting_visitor visitor;
  Triangulation tr;
  insert_and_watch(tr, surface, traits, seed, visitor);
  if (visitor.counts.cells_created > 0)
    report_counts(visitor.counts, surface.points.size(), report);
  else
    report_predicates(surface, traits, seed, report);
}

// Reports a run in which a clock is read whenever the phase changes, twice for every point.
template <class Traits>
void report_seconds(const Surface& surface, const Traits& traits, unsigned int seed, Report& report)
{
  const auto begin = std::chrono::steady_clock::now();
  const auto clock = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  meters::Metering_visitor_3<decltype(clock)> visitor(clock);
  Triangulation tr;
  insert_and_watch(tr, surface, traits, seed, visitor);

  const std::pair<Phase, const char*> phases[] = {
      {Phase::PLAN, "plan"},     {Phase::SUBGRAPH, "subgraph"}, {Phase::LOCATION, "locate"},
      {Phase::UPDATE, "update"}, {Phase::TRACE, "trace"},       {Phase::FINISH, "finish"}};
  report.title("Wall seconds by phase (reading the clock included)");
  for (const auto& [phase, name] : phases)
    report(name, visitor.total(phase), 6);
}

// Times the package on the surface, from nothing; destruction is not timed.
template <class Tr, class Traits>
Seconds time_package(const Surface& surface, const Traits& traits, unsigned int seed)
{
  Tr tr;
  return time_of([&] { insert_surface(tr, surface, traits, CGAL::parameters::random_seed(seed)); });
}

// Times CGAL's own insertion of the points in the order of the file, from nothing into `tr`.
inline Seconds time_plain(const Surface& surface, Triangulation& tr)
{
  return time_of([&] { tr.insert(surface.points.begin(), surface.points.end()); });
}
inline Seconds time_plain(const Surface& surface, Regular& tr)
{
  return time_of([&] { tr.insert(surface.weighted.begin(), surface.weighted.end()); });
}

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Timings
{
  std::vector<double> cpu, wall;

  void add(const Seconds& seconds)
  {
    cpu.push_back(seconds.cpu);
    wall.push_back(seconds.wall);
  }
};

inline void report_timings(Report& report, const Timings& package, const Timings& plain)
{
  const double package_cpu = median(package.cpu), package_wall = median(package.wall);
  const double plain_cpu = median(plain.cpu), plain_wall = median(plain.wall);
  report("repetitions", package.cpu.size());
  report("package CPU seconds", package_cpu, 6);
  report("plain CPU seconds", plain_cpu, 6);
  report("package wall seconds", package_wall, 6);
  report("plain wall seconds", plain_wall, 6);
  report("CPU ratio", plain_cpu / package_cpu, 3);
  report("wall ratio", plain_wall / package_wall, 3);
}

// Runs the package and plain CGAL alternately, beginning now with one, now with the other. Prints
// the medians and returns whether plain CGAL's triangulation equals `result`.
template <class Tr, class Traits>
bool compare_with_plain(const Surface& surface, const Traits& traits, unsigned int seed,
                        unsigned int repetitions, const Tr& result, Report& report,
                        Messages& messages)
{
  report.title("Comparison with CGAL's own insert(first, last)"
               "\n(medians; ratio = plain CGAL / package, above 1 the package is faster)");
  Timings package, plain;
  bool is_equal = true;
  for (unsigned int r = 0; r < repetitions; ++r) {
    messages.step("comparing: repetition " + std::to_string(r + 1) + " of " +
                  std::to_string(repetitions));
    if (r % 2 == 0)
      package.add(time_package<Tr>(surface, traits, seed));
    {
      Tr tr;
      plain.add(time_plain(surface, tr));
      if (r + 1 == repetitions)
        is_equal = result == tr;
    }
    if (r % 2 == 1)
      package.add(time_package<Tr>(surface, traits, seed));
  }
  messages.clear();
  report_timings(report, package, plain);
  report("equal", is_equal ? "yes" : "no");
  return is_equal;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_STATISTICS_H
