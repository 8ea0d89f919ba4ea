// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PHASES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PHASES_H

// Where the time of an insertion goes: its three stages, which cost nothing to tell apart, and its
// phases, for which the clock is read twice per point.

#include <Delaunay_from_surface_3_comparison/measure.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <Delaunay_from_surface_3_meters/Metering_visitor_3.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace comparison {

using Phase = CGAL::Surface_insertion_phase;
using Timing_visitor = meters::Metering_visitor_3<Steady_seconds>;

inline const std::vector<std::pair<const char*, Phase>>& phases()
{
  static const std::vector<std::pair<const char*, Phase>> all = {
      {"plan", Phase::PLAN},         {"subgraph", Phase::SUBGRAPH}, {"trace", Phase::TRACE},
      {"location", Phase::LOCATION}, {"update", Phase::UPDATE},     {"finish", Phase::FINISH}};
  return all;
}

inline constexpr std::array<const char*, 3> stage_names = {"plan", "build", "export"};

// CPU seconds of the plan; of all that comes then, subgraph and traces too; and of the export.
class Stage_visitor : public CGAL::Default_surface_insertion_visitor_3
{
public:
  void phase_begins(Phase phase, std::size_t)
  {
    // Where points are inserted, a few comparisons are left of this.
    if (phase == Phase::PLAN)
      begin(0);
    else if (phase == Phase::SUBGRAPH)
      begin(1);
    else if (phase == Phase::FINISH)
      begin(2);
    else if (phase == Phase::DONE)
      begin(3);
  }

  std::array<double, 3> seconds() const
  {
    return {m_begins[1] - m_begins[0], m_begins[2] - m_begins[1], m_begins[3] - m_begins[2]};
  }

private:
  void begin(std::size_t stage) { m_begins[stage] = cpu_seconds(); }

  std::array<double, 4> m_begins = {};
};

// Of one metered run. The clock runs while other processes do; so the shares count, and
// `scale_to_cpu` turns them into CPU time.
inline Json phases_as_json(const Time& total, const Timing_visitor& visitor)
{
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

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PHASES_H
