// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_THREADS_TIME_PARTS_H
#define DELAUNAY_FROM_SURFACE_3_THREADS_TIME_PARTS_H

// Where the time of a call goes that threads share. The parts are told apart by the visitor and by
// an executor that looks at the clock: of the export each call of it is a part.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/adapters/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <cstddef>
#include <map>
#include <string>

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

template <class ExecutorOfCall>
class Timed_executor final : public CGAL::Delaunay_from_surface_3::internal::Executor
{
public:
  std::size_t number_of_workers() const override { return m_executor.number_of_workers(); }
  void run(std::size_t number,
           const CGAL::Delaunay_from_surface_3::internal::Task& task) const override
  {
    part_clock().begin_call_of_export();
    m_executor.run(number, task);
    part_clock().end_call_of_export();
  }

private:
  ExecutorOfCall m_executor;
};

} // namespace threads

namespace CGAL {
namespace Delaunay_from_surface_3 {
} // namespace Delaunay_from_surface_3
} // namespace CGAL

namespace threads {

struct Timing_visitor : CGAL::Default_surface_insertion_visitor_3
{
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    if (phase == CGAL::Surface_insertion_phase::PLAN)
      part_clock().begin("plan");
    else if (phase == CGAL::Surface_insertion_phase::SUBGRAPH)
      part_clock().begin("permute");
    else if (phase == CGAL::Surface_insertion_phase::INSERTION)
      part_clock().begin("insertion");
  }
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    part_clock().begin_export();
  }
};

// As insert_points_3() calls it, but for the executor.
template <class Executor>
std::map<std::string, double> seconds_of_parts(const surfaces::Indexed_surface& surface)
{
  using namespace CGAL::Delaunay_from_surface_3::internal;
  using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;
  using Timed = Timed_executor<Executor>;
  part_clock() = Part_clock();
  Triangulation tr;
  const auto np = CGAL::parameters::visitor(Timing_visitor());
  part_clock().begin("read");
  const Read_soup<Triangulation, decltype(surface.points), decltype(surface.faces), decltype(np)>
      read(surface.points, surface.faces, np, Timed(), false);
  insert_surface<Timed, CGAL::internal_np::point_t>(tr, read.input(),
                                                    CGAL::Surface_insertion_traits_3(), np);
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
  return number_of_threads == 1 ? seconds_of_parts<Alone>(surface)
                                : seconds_of_parts<Tbb_executor>(surface);
}

} // namespace threads

#endif // DELAUNAY_FROM_SURFACE_3_THREADS_TIME_PARTS_H
