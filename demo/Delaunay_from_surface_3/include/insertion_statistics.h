// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSERTION_STATISTICS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSERTION_STATISTICS_H

// What the insertion does, phase by phase and round by round, seen by two visitors.

#include "Surface.h"
#include "report.h"

#include <CGAL/Delaunay_from_surface_3/Metering_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Predicate_counting_traits_3.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <chrono>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>

using Phase = CGAL::Surface_insertion_phase;

// One line of the table: `counts`, spread over `points`.
inline void report_counts(const std::string& round, const std::string& phase, std::size_t points,
                          const CGAL::Delaunay_from_surface_3::Predicate_counts& counts,
                          bool is_walk)
{
  if (points == 0)
    return;
  const double n = double(points);
  std::cout << std::left << std::setw(7) << round << std::setw(8) << phase << std::right
            << std::setw(11) << points << std::setw(11)
            << (is_walk ? decimals(double(counts.cells_entered()) / n, 3) : "-") << std::setw(13)
            << decimals(double(counts.orientation) / n, 3) << std::setw(11)
            << decimals(double(counts.in_sphere) / n, 3) << std::setw(11)
            << decimals(double(counts.other) / n, 3) << '\n';
}

// An untimed run in which every call of a predicate is counted.
template <class Traits>
void report_predicates(const Surface& surface, const Traits& traits, unsigned int seed)
{
  using Counting_kernel = CGAL::Delaunay_from_surface_3::Predicate_counting_traits_3<Kernel>;
  const Counting_kernel kernel;
  const auto meter = [&] { return kernel.counts(); };
  CGAL::Delaunay_from_surface_3::Metering_visitor_3<decltype(meter)> visitor(meter);
  CGAL::Delaunay_triangulation_3<Counting_kernel> tr(kernel);
  insert_and_watch(tr, surface, traits, seed, visitor);

  std::cout << "\nCells entered by the walks and calls of predicates, per point\n"
               "round  phase        points      cells  orientation  in-sphere      other\n";
  std::size_t inserted = 0, traced = 0;
  for (std::size_t r = 1; r < visitor.rounds().size(); ++r) { // 0 is what comes before the rounds
    const auto& round = visitor.rounds()[r];
    const std::string name = std::to_string(r);
    report_counts(name, "locate", round.number_of_points, round[Phase::LOCATION], true);
    report_counts(name, "update", round.number_of_points, round[Phase::UPDATE], false);
    report_counts(name, "trace", round.number_of_traced_points, round[Phase::TRACE], true);
    inserted += round.number_of_points;
    traced += round.number_of_traced_points;
  }
  report_counts("all", "locate", inserted, visitor.total(Phase::LOCATION), true);
  report_counts("all", "update", inserted, visitor.total(Phase::UPDATE), false);
  report_counts("all", "trace", traced, visitor.total(Phase::TRACE), true);
}

// A run in which a clock is read whenever the phase changes, twice for every point.
template <class Traits>
void report_seconds(const Surface& surface, const Traits& traits, unsigned int seed)
{
  const auto begin = std::chrono::steady_clock::now();
  const auto clock = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  CGAL::Delaunay_from_surface_3::Metering_visitor_3<decltype(clock)> visitor(clock);
  Triangulation tr;
  insert_and_watch(tr, surface, traits, seed, visitor);

  const std::pair<Phase, const char*> phases[] = {
      {Phase::PLAN, "plan"},     {Phase::SUBGRAPH, "subgraph"}, {Phase::LOCATION, "locate"},
      {Phase::UPDATE, "update"}, {Phase::TRACE, "trace"},       {Phase::FINISH, "finish"}};
  std::cout << "\nWall seconds by phase (reading the clock included)\n";
  for (const auto& [phase, name] : phases)
    report(name, decimals(visitor.total(phase), 6));
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSERTION_STATISTICS_H
