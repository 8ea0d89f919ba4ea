// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_WHOLE_RUNS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_WHOLE_RUNS_H

// Ways to locate that have an order or a triangulation of their own: each is a run of
// insert_surface_vertices_3() with a visitor that counts.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>

#include <Delaunay_from_surface_3_meters/History_hints_3.h>
#include <Delaunay_from_surface_3_meters/meters.h>
#include <Delaunay_from_surface_3_meters/orders.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace theory {

using comparison::Json;
using comparison::Mesh;
using comparison::per_point;
using comparison::Phase;

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

using Counted_fast_triangulation =
    CGAL::Delaunay_triangulation_3<comparison::Counting_kernel, CGAL::Fast_location>;

// What the laboratory does not count, by name.
inline std::map<std::string, std::function<Json(const Mesh&, unsigned int seed)>> whole_runs()
{
  using namespace comparison;
  return {{"walk-trace", counts_of_run<meters::Random_tracing_traits, Counted_triangulation>},
          {"fast-location",
           counts_of_run<Random_order_traits<meters::No_hint_3>, Counted_fast_triangulation>},
          {"plain", counts_of_run<CGAL::Plain_insertion_traits_3, Counted_triangulation>}};
}

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_WHOLE_RUNS_H
