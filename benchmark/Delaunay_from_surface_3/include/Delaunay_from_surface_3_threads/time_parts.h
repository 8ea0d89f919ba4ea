// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_THREADS_TIME_PARTS_H
#define DELAUNAY_FROM_SURFACE_3_THREADS_TIME_PARTS_H

// Where the time of a call goes that threads share. The parts are told apart by the visitor, by a
// plan that looks at the clock, and by an executor that does: of the export each call of it is a
// part.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Delaunay_from_surface_3/insertion/Compact_delaunay_3.h>
#include <CGAL/Delaunay_from_surface_3/plan/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Full_graph.h>
#include <CGAL/Delaunay_from_surface_3/trace/Planned_hints_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_policies_3.h>
#include <CGAL/insert_surface_points_3.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace threads {

// Seconds by part. One call at a time is looked at.
class Part_clock
{
public:
  void begin(const std::string& part)
  {
    end();
    m_part = part;
  }
  void end()
  {
    const double now = comparison::Steady_seconds()();
    if (!m_part.empty())
      m_seconds[m_part] += now - m_since;
    m_part.clear();
    m_since = now;
  }
  const std::map<std::string, double>& seconds() const { return m_seconds; }

  // The calls of the executor in the export, in their order.
  void begin_call_of_export()
  {
    static const char* const names[] = {"vertices", "vertices", "cells", "links", "vertices"};
    if (m_is_export)
      begin(names[m_calls < 5 ? m_calls++ : 4]);
  }
  void end_call_of_export()
  {
    if (m_is_export)
      begin("rest");
  }
  void begin_export()
  {
    m_is_export = true;
    begin("rest");
  }

private:
  std::map<std::string, double> m_seconds;
  std::string m_part;
  double m_since = 0;
  bool m_is_export = false;
  std::size_t m_calls = 0;
};

inline Part_clock& part_clock()
{
  static Part_clock clock;
  return clock;
}

template <class Executor>
class Timed_executor : public Executor
{
public:
  void run(std::size_t number,
           const CGAL::Delaunay_from_surface_3::internal::Task& task) const override
  {
    part_clock().begin_call_of_export();
    Executor::run(number, task);
    part_clock().end_call_of_export();
  }
};

struct Timed_plan : CGAL::Delaunay_from_surface_3::Surface_net_rounds
{
  using Base = CGAL::Delaunay_from_surface_3::Surface_net_rounds;
  using Base::Base;

  template <class... Arguments>
  auto operator()(const Arguments&... arguments) const
  {
    part_clock().begin("plan");
    auto plan = Base::operator()(arguments...);
    part_clock().begin("permute");
    return plan;
  }
};

template <class Executor>
struct Timed
{
  template <class Triangulation>
  struct Target
    : CGAL::Delaunay_from_surface_3::Compact_delaunay_with_ids_3<Triangulation, std::uint32_t,
                                                                 Timed_executor<Executor>>
  {
    using CGAL::Delaunay_from_surface_3::Compact_delaunay_with_ids_3<
        Triangulation, std::uint32_t, Timed_executor<Executor>>::Compact_delaunay_with_ids_3;
    using Parallel_target = Target;
  };

  using Traits =
      CGAL::Surface_insertion_policies_3<CGAL::Delaunay_from_surface_3::Full_graph, Timed_plan,
                                         CGAL::Delaunay_from_surface_3::Planned_hints_3, Target>;
};

struct Timing_visitor : CGAL::Default_surface_insertion_visitor_3
{
  void insertion_begins(std::size_t) { part_clock().begin("insertion"); }
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    part_clock().begin_export();
  }
};

template <class ConcurrencyTag, class Executor>
std::map<std::string, double> seconds_of_parts(const surfaces::Indexed_surface& surface)
{
  part_clock() = Part_clock();
  CGAL::Delaunay_triangulation_3<CGAL::Epick> tr;
  part_clock().begin("read");
  CGAL::insert_surface_points_3<ConcurrencyTag>(tr, surface.points, surface.faces,
                                                typename Timed<Executor>::Traits(),
                                                CGAL::parameters::visitor(Timing_visitor()));
  part_clock().end();
  return part_clock().seconds();
}

// Of a call on so many threads, which TBB has; on one of the sequential code. "read": points and
// faces; "permute": points in order, and scaled; "links": those between the cells of different
// threads; "rest": what is left once all is inserted.
inline std::map<std::string, double> seconds_of_parts(const surfaces::Indexed_surface& surface,
                                                      std::size_t number_of_threads)
{
  using namespace CGAL::Delaunay_from_surface_3::internal;
  return number_of_threads == 1 ? seconds_of_parts<CGAL::Sequential_tag, Alone>(surface)
                                : seconds_of_parts<CGAL::Parallel_tag, Tbb_executor>(surface);
}

} // namespace threads

#endif // DELAUNAY_FROM_SURFACE_3_THREADS_TIME_PARTS_H
