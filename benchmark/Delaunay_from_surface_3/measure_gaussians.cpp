// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that programs make which turn Gaussians into a mesh by marching tetrahedra: from float
// coordinates to the indices of all tetrahedra, by the loop over plain CGAL that these programs have,
// rebuilt from what Tetra-NeRF's src/triangulation.cpp does, and by this package. Writes JSON.

#include <Delaunay_from_surface_3_comparison/gains.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/delaunay_3_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
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

// A rotation, all equally likely.
std::array<std::array<double, 3>, 3> random_rotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  double q[4], square = 0;
  for (double& x : q)
    x = normal(random), square += x * x;
  for (double& x : q)
    x /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

// Of each of many Gaussians near a surface the centre and the corners of a box, in no order that helps.
// Sizes vary over three decades, and from axis to axis.
Points points_of_gaussians(std::size_t n)
{
  const auto centers = surfaces::genus_surface(3, n / 9, 0.05, 2024).points;
  std::mt19937 random(2024);
  std::uniform_real_distribution<double> exponent(-4, -1), flatness(.1, 1);
  std::normal_distribution<double> off(0, .01);
  Points points;
  for (const auto& c : centers) {
    const auto axes = random_rotation(random);
    const double size = std::pow(10, exponent(random));
    const double half[3] = {size * flatness(random), size * flatness(random),
                            size * flatness(random)};
    const double center[3] = {c.x() + off(random), c.y() + off(random), c.z() + off(random)};
    const auto add = [&](double s, double t, double u) {
      std::array<float, 3> p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = float(center[k] + s * half[0] * axes[k][0] + t * half[1] * axes[k][1] +
                     u * half[2] * axes[k][2]);
      points.push_back(p);
    };
    add(0, 0, 0);
    for (int corner = 0; corner < 8; ++corner)
      add(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  }
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
  return comparison::write_gains("measure_gaussians",
                                 "Measures points of Gaussians, from coordinates to tetrahedra.",
                                 argc, argv, measure);
}
