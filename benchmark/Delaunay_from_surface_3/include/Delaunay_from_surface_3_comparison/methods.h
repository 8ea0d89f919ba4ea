// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_METHODS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_METHODS_H

// The ways to build the triangulation, each in three forms: bare (for the time), with a clock read
// at every change of phase (for the shares of the phases), and with counted predicates.

#include <CGAL/Delaunay_from_surface_3/Metering_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Predicate_counting_traits_3.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace comparison {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Counting_kernel = CGAL::Predicate_counting_traits_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Counted_triangulation = CGAL::Delaunay_triangulation_3<Counting_kernel>;

struct Steady_seconds
{
  double operator()() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
};

struct Counted_calls
{
  const CGAL::Predicate_counts* counts;
  CGAL::Predicate_counts operator()() const { return *counts; }
};

using Timing_visitor = CGAL::Metering_visitor_3<Steady_seconds>;
using Counting_visitor = CGAL::Metering_visitor_3<Counted_calls>;

struct Method
{
  std::string name;
  std::string description;
  std::function<void(Triangulation&, const Mesh&, unsigned int seed)> build;
  // Empty for stock, whose phases cannot be seen from outside.
  std::function<void(Triangulation&, const Mesh&, unsigned int seed, Timing_visitor&)> time_phases;
  std::function<void(Counted_triangulation&, const Mesh&, unsigned int seed, Counting_visitor&)>
      count_calls;
};

template <class Traits>
Method surface_method(const std::string& name, const std::string& description)
{
  const auto with_visitor = [](auto& tr, const Mesh& mesh, unsigned int seed, auto& visitor) {
    CGAL::insert_surface_vertices_3(tr, mesh, Traits(),
                                    CGAL::parameters::random_seed(seed).visitor(std::ref(visitor)));
  };
  return {name, description,
          [](Triangulation& tr, const Mesh& mesh, unsigned int seed) {
            CGAL::insert_surface_vertices_3(tr, mesh, Traits(),
                                            CGAL::parameters::random_seed(seed));
          },
          with_visitor, with_visitor};
}

// CGAL's own insertion of a range of points, in the order of the mesh.
template <class Tr>
void insert_stock(Tr& tr, const Mesh& mesh)
{
  tr.insert(mesh.points().begin(), mesh.points().end());
}

// Stock is the first: the others are compared with it.
inline std::vector<Method> all_methods()
{
  using namespace CGAL;
  return {
      {"stock", "dt.insert(first, last) of CGAL",
       [](Triangulation& tr, const Mesh& mesh, unsigned int) { insert_stock(tr, mesh); }, nullptr,
       [](Counted_triangulation& tr, const Mesh& mesh, unsigned int, Counting_visitor&) {
         insert_stock(tr, mesh);
       }},
      surface_method<Stock_order_traits_3>("stock-order",
                                           "Stock_order_traits_3: stock's insertions, our loop"),
      surface_method<Tracing_traits_3>("tracing",
                                       "Tracing_traits_3: the paper's random order and traces"),
      surface_method<Surface_insertion_policies_3<
          Bounded_degree_subgraph, Hilbert_sorted_rounds<Log_star_rounds>, Traced_hints_3>>(
          "tracing-hilbert", "the paper's rounds and traces, rounds sorted along a Hilbert curve"),
      surface_method<
          Surface_insertion_policies_3<Bounded_degree_subgraph, Geometric_rounds, Traced_hints_3>>(
          "geometric-traced", "rounds that grow geometrically, traces"),
      surface_method<Surface_insertion_policies_3<Full_graph, Geometric_rounds, Neighbor_hints_3>>(
          "geometric-neighbor", "rounds that grow geometrically, nearest inserted neighbour"),
      surface_method<Surface_insertion_policies_3<Full_graph, Geometric_rounds, Previous_hint_3>>(
          "geometric-previous", "rounds that grow geometrically, point inserted before"),
      surface_method<Surface_insertion_policies_3<
          Full_graph, Neighbor_started_rounds<Geometric_rounds>, Planned_hints_3>>(
          "geometric-started", "rounds that grow geometrically, neighbour inserted last before"),
      surface_method<Surface_insertion_policies_3<Full_graph, Surface_net_rounds, Planned_hints_3>>(
          "nets", "nets of the surface, their starting points, CGAL's insertion"),
      surface_method<Surface_insertion_traits_3>(
          "default", "Surface_insertion_traits_3: nets, compact triangulation"),
  };
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_METHODS_H
