// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_HISTORY_CASES_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_HISTORY_CASES_H

// Point sets on which histories are tested, degenerate ones among them, and what both are asked.

#include "check_equal.h"
#include "named_surfaces.h"

#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace tests {
namespace history {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Target = CGAL::Delaunay_from_surface_3::Triangulation_target_3<Triangulation>;

// Points of a set, in random order.
struct Point_set
{
  std::string name;
  std::vector<Point> points;
};

inline void shuffle(std::vector<Point>& points, std::uint32_t seed)
{
  std::mt19937 random(seed);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[random() % i]);
}

// Integer points in a box, each once.
inline std::vector<Point> grid(int size)
{
  std::vector<Point> points;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      for (int z = 0; z < size; ++z)
        points.emplace_back(x, y, z);
  return points;
}

inline std::vector<Point> random_points(std::size_t n, int size, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<Point> points;
  const auto coordinate = [&] { return double(random() % std::uint32_t(size)); };
  for (std::size_t i = 0; i < n; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

inline std::vector<Point_set> point_sets(std::size_t n)
{
  std::vector<Point_set> sets = {{"random", random_points(n, 1 << 12, 1)},
                                 {"random with duplicates", random_points(n, 6, 2)},
                                 {"surface", surfaces::genus_surface(1, n, 0.05).points},
                                 {"cospherical", surfaces::integer_sphere(n).points},
                                 {"grid", grid(int(std::cbrt(double(n))) + 1)},
                                 {"mostly coplanar", surfaces::coplanar(n / 2).points}};
  for (const Point& p : random_points(n / 20, 12, 8))
    sets.back().points.push_back(p);
  for (Point_set& set : sets)
    shuffle(set.points, 3);
  return sets;
}

// Where a point may be asked for: points of the set, points in general position inside and outside
// the convex hull, and points on edges and facets, as far as midpoints are.
inline std::vector<Point> queries(const std::vector<Point>& points, std::size_t number)
{
  std::mt19937 random(4);
  const auto any = [&] { return points[random() % points.size()]; };
  std::vector<Point> all;
  for (std::size_t k = 0; k < number; ++k) {
    const Point p = any(), q = any();
    all.push_back(p);
    all.push_back(CGAL::midpoint(p, q));
    all.push_back(p + 1.7 * (q - p));
    all.emplace_back(p.x() + 0.1, q.y() - 0.2, 0.3 * p.z() + q.z());
  }
  return all;
}

// Inserts points one by one, as the driver does, and lets `look` see what each changed.
template <class Observer, class Look>
void insert_all(Triangulation& tr, const std::vector<Point>& points, Observer& observer,
                const Look& look)
{
  Target target(tr, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    target.insert(i, target.locate(i, tr.infinite_cell()), observer);
    look(i);
  }
}

inline void ignore(std::size_t) {}

// A path through n points, broken before two of them: three components.
inline CGAL::Delaunay_from_surface_3::internal::Index_graph
broken_path(std::size_t n, std::size_t first, std::size_t second)
{
  std::vector<std::pair<std::size_t, std::size_t>> path;
  for (std::size_t i = 1; i < n; ++i)
    if (i != first && i != second) {
      path.emplace_back(i - 1, i);
      path.emplace_back(i, i - 1);
    }
  return {boost::edges_are_unsorted_multi_pass, path.begin(), path.end(), n};
}

// TracingDT with a history for Q, on everything from a single point to degenerate surfaces.
template <class Traits, template <class Target, class Subgraph> class Hints>
void check_plain_triangulations(std::size_t degenerate, unsigned int seeds)
{
  namespace DFS = CGAL::Delaunay_from_surface_3;
  std::vector<Named_surface> all = tiny_and_flat_surfaces();
  for (const auto& surfaces : {ordinary_surfaces(2000), degenerate_surfaces(degenerate)})
    all.insert(all.end(), surfaces.begin(), surfaces.end());
  for (const Named_surface& named : all) {
    const Plain_case<Triangulation> plain_case(named);
    for (unsigned int seed = 0; seed < seeds; ++seed)
      plain_case.check<Traits>(seed);
    plain_case.check<
        CGAL::Surface_insertion_policies_3<DFS::Spanning_forest, DFS::Geometric_rounds, Hints>>();
  }
}

} // namespace history
} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_HISTORY_CASES_H
