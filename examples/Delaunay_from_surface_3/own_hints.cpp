// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A user-defined hint policy, Hilbert_neighbor_hints in the header beside this file, for points
// that come in random order.

#include "Hilbert_neighbor_hints.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

// All rounds in random order. CGAL inserts, since the core knows only its own policies.
struct My_traits : CGAL::Surface_insertion_policies_3<DFS::No_subgraph, DFS::Log_star_rounds,
                                                      Hilbert_neighbor_hints>
{
  Insertion_plan insertion_plan_object(unsigned int seed) const
  {
    return Insertion_plan(seed, Insertion_plan::NO_ROUND);
  }
};

int main()
{
  std::vector<K::Point_3> points;
  CGAL::Random random(1);
  std::copy_n(CGAL::Random_points_on_sphere_3<K::Point_3>(1, random), 5000,
              std::back_inserter(points));

  const std::vector<std::vector<std::size_t>> no_faces; // only a trace could use them
  Triangulation ours, plain;
  CGAL::insert_points_3(ours, points, no_faces, My_traits());
  plain.insert(points.begin(), points.end());

  std::cout << "The triangulations are " << (ours == plain ? "equal" : "different") << '\n';
  return ours == plain ? EXIT_SUCCESS : EXIT_FAILURE;
}
