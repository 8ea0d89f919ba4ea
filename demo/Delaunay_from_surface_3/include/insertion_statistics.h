// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSERTION_STATISTICS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSERTION_STATISTICS_H

// Reports what the insertion does, phase by phase and round by round, as visitors see it.

#include "Report.h"
#include "Surface.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <Delaunay_from_surface_3_meters/Metering_visitor_3.h>
#include <Delaunay_from_surface_3_meters/Predicate_counting_traits_3.h>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

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
  static const char* const stages[] = {"integers of 30 bits",  "integers of 60 bits",
                                       "balanced doubles",     "double-double",
                                       "integers of 120 bits", "integers of any width"};
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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSERTION_STATISTICS_H
