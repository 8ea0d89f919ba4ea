// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_DIFFERENTIAL_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_DIFFERENTIAL_H

// The cases of the differential test on generated surfaces, for any triangulation. One unit per
// kernel, since the sanitizers have no time for an exact one.

#include "core_traits.h"
#include "check_equal.h"

#include <Delaunay_from_surface_3_meters/orders.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <vector>

namespace tests {

// Every combination of subgraph, plan and hints.
template <class Subgraph, class Plan, class Case>
void check_all_hints(const Case& plain_case)
{
  using namespace CGAL;
  using namespace CGAL::Delaunay_from_surface_3;
  plain_case.template check<Surface_insertion_policies_3<Subgraph, Plan, Traced_hints_3>>(1);
  plain_case.template check<Surface_insertion_policies_3<Subgraph, Plan, Neighbor_hints_3>>(2);
  plain_case.template check<
      Round_the_core<Surface_insertion_policies_3<Subgraph, Plan, Previous_hint_3>>>(3);
}

template <class Subgraph, class Case>
void check_all_plans_and_hints(const Case& plain_case)
{
  check_all_hints<Subgraph, CGAL::Delaunay_from_surface_3::Log_star_rounds>(plain_case);
  check_all_hints<Subgraph, CGAL::Delaunay_from_surface_3::Geometric_rounds>(plain_case);
  check_all_hints<Subgraph, CGAL::Delaunay_from_surface_3::Spatial_sort_order>(plain_case);
  check_all_hints<Subgraph, meters::Random_log_star_rounds>(plain_case);
  check_all_hints<Subgraph, CGAL::Delaunay_from_surface_3::Surface_net_rounds>(plain_case);
}

// Nets through CGAL's insertion and through the core, and the core with other plans.
template <class Case>
void check_nets_and_compact_kernel_apart(const Case& plain_case, unsigned int seed = 0)
{
  using namespace CGAL;
  using namespace CGAL::Delaunay_from_surface_3;
  plain_case.template check<Round_the_core<
      Surface_insertion_policies_3<Full_graph, Surface_net_rounds, Planned_hints_3>>>(seed);
  plain_case.template check<
      Surface_insertion_policies_3<Full_graph, Surface_net_rounds, Planned_hints_3>>(seed);
  plain_case
      .template check<Surface_insertion_policies_3<Full_graph, Geometric_rounds, Planned_hints_3>>(
          seed);
  plain_case
      .template check<Surface_insertion_policies_3<Full_graph, Spaced_rounds, Planned_hints_3>>(
          seed);
  plain_case
      .template check<Surface_insertion_policies_3<Full_graph, Log_star_rounds, Previous_hint_3>>(
          seed);
  plain_case.template check<
      Surface_insertion_policies_3<Full_graph, Spatial_sort_order, Planned_hints_3>>(seed);
}

template <class Case>
void check_named_traits(const Case& plain_case, unsigned int seed = 0)
{
  plain_case.template check<CGAL::Surface_insertion_traits_3>(seed);
  plain_case.template check<CGAL::Tracing_traits_3>(seed);
  plain_case.template check_as_mesh<CGAL::Tracing_traits_3>(seed);
  plain_case.template check<CGAL::Plain_insertion_traits_3>(seed);
}

template <class Triangulation>
void check_surfaces_with_nets_and_compact_kernel(const std::vector<Named_surface>& surfaces)
{
  for (const Named_surface& named : surfaces)
    check_nets_and_compact_kernel_apart(Plain_case<Triangulation>(named));
}

template <class Triangulation>
void check_surfaces_with_named_traits(const std::vector<Named_surface>& surfaces)
{
  for (const Named_surface& named : surfaces) {
    const Plain_case<Triangulation> plain_case(named);
    BOOST_TEST_MESSAGE(named.name << ": " << plain_case.points().size() << " points");
    check_named_traits(plain_case);
  }
}

template <class Triangulation>
void check_surfaces_with_all_combinations(const std::vector<Named_surface>& surfaces)
{
  for (const Named_surface& named : surfaces) {
    const Plain_case<Triangulation> plain_case(named);
    check_all_plans_and_hints<CGAL::Delaunay_from_surface_3::Spanning_forest>(plain_case);
    check_all_plans_and_hints<CGAL::Delaunay_from_surface_3::Full_graph>(plain_case);
  }
}

template <class Triangulation>
void check_seeds(const Named_surface& named, unsigned int number_of_seeds)
{
  const Plain_case<Triangulation> plain_case(named);
  for (unsigned int seed = 0; seed < number_of_seeds; ++seed)
    check_named_traits(plain_case, seed);
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_DIFFERENTIAL_H
