// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that programs make which turn Gaussians into a mesh by marching tetrahedra: from float
// coordinates to the indices of all tetrahedra, by the loop over plain CGAL that these programs have,
// rebuilt from what Tetra-NeRF's src/triangulation.cpp does, and by this package. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_surfaces/clusters.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/delaunay_3_arrays.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<unsigned int, K>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<Vertex_base>>;
using Points = std::vector<std::array<float, 3>>;
using Rows = std::vector<std::array<int, 4>>;

Points points_of_gaussians(std::size_t n)
{
  Points points;
  for (const auto& p : surfaces::boxes_of_gaussians(n, 2024).points)
    points.push_back({float(p.x()), float(p.y()), float(p.z())});
  return points;
}

Rows by_plain_cgal(const Points& points, bool is_checked)
{
  std::vector<std::pair<K::Point_3, unsigned int>> numbered;
  numbered.reserve(points.size());
  for (const auto& [x, y, z] : points)
    numbered.emplace_back(K::Point_3(x, y, z), unsigned(numbered.size()));
  const Triangulation tr(numbered.begin(), numbered.end());
  if (is_checked && !tr.is_valid())
    throw std::runtime_error("the triangulation is not valid");
  Rows rows;
  rows.reserve(tr.number_of_finite_cells());
  for (const auto c : tr.finite_cell_handles())
    rows.push_back({int(c->vertex(0)->info()), int(c->vertex(1)->info()), int(c->vertex(2)->info()),
                    int(c->vertex(3)->info())});
  return rows;
}

Rows by_package(const Points& points)
{
  const auto arrays = CGAL::delaunay_3_arrays(points);
  Rows rows(arrays.number_of_simplices());
  for (std::size_t c = 0; c < rows.size(); ++c)
    rows[c] = arrays.vertices(c);
  return rows;
}

void measure(std::size_t n, comparison::Gains& gains)
{
  const Points points = points_of_gaussians(n);
  for (const bool is_checked : {false, true}) {
    if (is_checked && n > 5000000) // the check takes longer than all else
      return;
    gains.line(
        is_checked ? "boxes of Gaussians, loop of Tetra-NeRF with is_valid()"
                   : "boxes of Gaussians",
        points.size(), [&] { return by_plain_cgal(points, is_checked); },
        [&] { return by_package(points); },
        [](comparison::Json& line, const Rows& by_cgal, const Rows& ours) {
          if (by_cgal.size() != ours.size())
            throw std::runtime_error("the numbers of tetrahedra differ");
          line["tetrahedra"] = ours.size();
        });
  }
}

} // namespace

int main(int argc, char** argv)
{
  comparison::Program program("measure_gaussians",
                              "Measures points of Gaussians, from coordinates to tetrahedra.");
  return comparison::run_gains(program, argc, argv, measure);
}
