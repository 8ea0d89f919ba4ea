// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CORE_TRAITS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CORE_TRAITS_H

// Traits that go through the core with ids of another size, or round it.

#include <CGAL/Delaunay_from_surface_3/adapters/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>

namespace tests {

template <class Plan,
          template <class, class> class Hints = CGAL::Delaunay_from_surface_3::Planned_hints_3>
using Traits_of_plan =
    CGAL::Surface_insertion_policies_3<CGAL::Delaunay_from_surface_3::Full_graph, Plan, Hints>;

// As if the hint policy traced.
template <class Traits>
struct Round_the_core : Traits
{
  static constexpr bool through_core = false;
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CORE_TRAITS_H
