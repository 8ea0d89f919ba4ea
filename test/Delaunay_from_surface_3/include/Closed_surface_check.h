// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TEST_CLOSED_SURFACE_CHECK_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TEST_CLOSED_SURFACE_CHECK_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/determinant.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

// Whether the triangles of a surface make one closed fan around each point; and what they enclose,
// which is positive if they are oriented counterclockwise from outside.
struct Closed_surface_check
{
  bool is_closed_manifold = true;
  double volume = 0;
  std::size_t largest_degree = 0;

  explicit Closed_surface_check(const surfaces::Indexed_surface& surface)
  {
    std::vector<std::map<std::size_t, std::size_t>> next(surface.points.size()); // around each
    for (const auto& t : surface.faces) {
      for (std::size_t k = 0; k < 3; ++k)
        is_closed_manifold &= next[t[k]].emplace(t[(k + 1) % 3], t[(k + 2) % 3]).second;
      const auto origin = CGAL::ORIGIN;
      volume += CGAL::determinant(surface.points[t[0]] - origin, surface.points[t[1]] - origin,
                                  surface.points[t[2]] - origin) /
                6;
    }
    for (const auto& around : next) {
      is_closed_manifold &= is_one_cycle(around);
      largest_degree = (std::max)(largest_degree, around.size());
    }
  }

private:
  static bool is_one_cycle(const std::map<std::size_t, std::size_t>& next)
  {
    if (next.empty())
      return false;
    std::size_t steps = 0, v = next.begin()->first;
    do {
      const auto found = next.find(v);
      if (found == next.end())
        return false;
      v = found->second;
      ++steps;
    } while (v != next.begin()->first && steps <= next.size());
    return steps == next.size();
  }
};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TEST_CLOSED_SURFACE_CHECK_H
