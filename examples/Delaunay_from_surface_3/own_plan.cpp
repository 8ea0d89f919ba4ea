// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A user-defined order on the fast path, through the compact triangulation. Points that were
// scanned in rows need no faces: their indices say which are adjacent.

#include <CGAL/insert_points_3.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

constexpr std::size_t side = 65; // rows, and points in each

// An InsertionPlan: grids, each with half the step of the previous one. A new point starts at a
// point of the previous grid.
struct Grid_rounds
{
  explicit Grid_rounds(unsigned int /* seed */) {}

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  DFS::Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                                  VertexIndexMap) const
  {
    std::vector<std::size_t> place(points.size());
    DFS::Insertion_order plan;
    plan.order = plan.starting_places = {0};
    for (std::size_t step = side - 1; step > 0; step /= 2) {
      const auto before = [&](std::size_t x) { return x / (2 * step) * (2 * step); };
      for (std::size_t y = 0; y < side; y += step)
        for (std::size_t x = 0; x < side; x += step) {
          const std::size_t i = y * side + x, start = before(y) * side + before(x);
          if (i == start)
            continue;
          place[i] = plan.order.size();
          plan.order.push_back(i);
          plan.starting_places.push_back(place[start]);
        }
      plan.round_ends.push_back(plan.order.size());
    }
    return plan;
  }
};

// Planned_hints_3 starts each point where the plan says. Nothing is traced.
using My_traits =
    CGAL::Surface_insertion_policies_3<DFS::Full_graph, Grid_rounds, DFS::Planned_hints_3>;

int main()
{
  std::vector<K::Point_3> points;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      points.emplace_back(double(x), double(y), double(x * x + 2 * y * y) / 64);

  const std::vector<std::vector<std::size_t>> no_faces; // only the plan could use them
  Triangulation ours, plain;
  CGAL::insert_points_3(ours, points, no_faces, My_traits());
  plain.insert(points.begin(), points.end());

  std::cout << "The triangulations are " << (ours == plain ? "equal" : "different") << '\n';
  return ours == plain ? EXIT_SUCCESS : EXIT_FAILURE;
}
