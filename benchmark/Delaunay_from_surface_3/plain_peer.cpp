// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of compare_with_plain: CGAL's insert(first, last). It is built twice: as plain_peer, and
// as plain_peer_sse2_max with CGAL_USE_SSE2_MAX, which must not meet code without it in one
// program.

#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <vector>

int main(int argc, char** argv)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return comparison::run_peer(
      "plain_peer", false, argc, argv, [](unsigned, const std::vector<double>& coordinates) {
        std::vector<Kernel::Point_3> points;
        for (std::size_t i = 0; i < coordinates.size(); i += 3)
          points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        CGAL::Delaunay_triangulation_3<Kernel> tr;
        comparison::Stopwatch watch;
        tr.insert(points.begin(), points.end());
        watch.stop();
        comparison::print_answer(watch, tr.number_of_finite_cells());
      });
}
