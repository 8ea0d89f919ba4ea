// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_WHOLE_RUNS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_WHOLE_RUNS_H

// Ways to locate that have an order or a triangulation of their own, and the times of all of them:
// each is a run of insert_surface_vertices_3() with a visitor that meters the phases.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <Delaunay_from_surface_3_meters/History_hints_3.h>
#include <Delaunay_from_surface_3_meters/meters.h>
#include <Delaunay_from_surface_3_meters/orders.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace theory {

using comparison::Json;
using comparison::Mesh;
using comparison::per_point;
using comparison::Phase;
using comparison::rounded;

// From the root of the history, always: Q without traces.
template <class Target, class Subgraph>
struct Root_hints_3 : meters::History_hints_3<Target, Subgraph>
{
  static constexpr bool uses_subgraph = false;
  using meters::History_hints_3<Target, Subgraph>::History_hints_3;
  std::size_t trace() { return 0; }
};

// From any of the points inserted.
template <class Target, class Subgraph>
class Random_hint_3 : public DFS::Previous_hint_3<Target, Subgraph>
{
  using Base = CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>;
  using Base::m_target;

public:
  using Base::Base;
  typename Target::Cell start(std::size_t i)
  {
    return i == 0 ? Base::start(i) : m_target.cell(m_target.vertex(m_random.below(i)));
  }

private:
  surfaces::Random m_random{0};
};

template <template <class, class> class Hints, class Subgraph = DFS::Full_graph>
using Random_order_traits =
    CGAL::Surface_insertion_policies_3<Subgraph, meters::Random_log_star_rounds, Hints>;

// Cells entered and calls per point, and the same for the traces.
template <class Traits, class Triangulation>
Json counts_of_run(const Mesh& mesh, unsigned int seed)
{
  Triangulation tr;
  comparison::Counting_visitor visitor(comparison::Counted_calls{&tr.geom_traits().counts()});
  comparison::insert_by_package<Traits>(tr, mesh, seed, visitor);
  const std::size_t n = mesh.number_of_vertices();
  const meters::Predicate_counts location = visitor.total(Phase::LOCATION),
                                 trace = visitor.total(Phase::TRACE);
  Json result = {{"cells_entered", per_point(location.cells_entered(), n)},
                 {"calls", per_point(location.all(), n)}};
  if (trace.all() > 0) {
    result["trace_cells_entered"] = per_point(trace.cells_entered(), n);
    result["trace_calls"] = per_point(trace.all(), n);
  }
  return result;
}

// CPU seconds by phase; the clock on the wall gives the shares.
template <class Traits, class Triangulation>
Json times_of_run(const Mesh& mesh, unsigned int seed)
{
  Triangulation tr;
  comparison::Timing_visitor visitor;
  const comparison::Time total =
      comparison::time_of([&] { comparison::insert_by_package<Traits>(tr, mesh, seed, visitor); });
  Json result = {{"cpu", rounded(total.cpu, 1e3)}, {"wall", rounded(total.wall, 1e3)}};
  for (const auto& [name, phase] : comparison::phases())
    result[name] = rounded(visitor.total(phase) * total.cpu / total.wall, 1e3);
  return result;
}

using Counted_fast_triangulation =
    CGAL::Delaunay_triangulation_3<comparison::Counting_kernel, CGAL::Fast_location>;

struct Whole_run
{
  std::string name;
  std::function<Json(const Mesh&, unsigned int seed)> count; // empty if the laboratory counts it
  std::function<Json(const Mesh&, unsigned int seed)> time;
};

inline std::vector<Whole_run> whole_runs()
{
  using namespace comparison;
  using Tracing = meters::Random_tracing_traits;
  using Plain = CGAL::Plain_insertion_traits_3;
  using Fast = Random_order_traits<meters::No_hint_3>;
  return {
      {"history-root", nullptr, times_of_run<Random_order_traits<Root_hints_3>, Triangulation>},
      {"history-trace", nullptr, times_of_run<CGAL::History_tracing_traits_3, Triangulation>},
      {"walk-trace", counts_of_run<Tracing, Counted_triangulation>,
       times_of_run<Tracing, Triangulation>},
      {"walk-neighbor", nullptr,
       times_of_run<Random_order_traits<DFS::Neighbor_hints_3>, Triangulation>},
      {"walk-random", nullptr, times_of_run<Random_order_traits<Random_hint_3>, Triangulation>},
      {"fast-location", counts_of_run<Fast, Counted_fast_triangulation>,
       times_of_run<Fast, Fast_triangulation>},
      {"plain", counts_of_run<Plain, Counted_triangulation>, times_of_run<Plain, Triangulation>}};
}

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_WHOLE_RUNS_H
