// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's regular triangulations, to which the Python module's are compared by
// python/test_learning.py. Reads sets of weighted points, one after the other: their number,
// coordinates and weights. Writes the number of tetrahedra, and of each the corners and the power
// centre, all as doubles.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Base = CGAL::Regular_triangulation_vertex_base_3<K>;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, K, Base>;
using Tds =
    CGAL::Triangulation_data_structure_3<Vertex, CGAL::Regular_triangulation_cell_base_3<K>>;
using Regular = CGAL::Regular_triangulation_3<K, Tds>;

int main()
{
  int n;
  while (std::fread(&n, sizeof(n), 1, stdin) == 1) {
    std::vector<double> numbers(4 * n);
    if (std::fread(numbers.data(), sizeof(double), 4 * n, stdin) != std::size_t(4 * n))
      return 1;
    std::vector<std::pair<Regular::Weighted_point, int>> points;
    for (int i = 0; i < n; ++i) {
      const double* p = numbers.data() + 4 * i;
      points.emplace_back(Regular::Weighted_point(K::Point_3(p[0], p[1], p[2]), p[3]), i);
    }
    const Regular regular(points.begin(), points.end());
    const int m = int(regular.number_of_finite_cells());
    std::fwrite(&m, sizeof(m), 1, stdout);
    for (auto c = regular.finite_cells_begin(); c != regular.finite_cells_end(); ++c) {
      const auto center = regular.dual(c);
      double row[7] = {0, 0, 0, 0, center.x(), center.y(), center.z()};
      for (int k = 0; k < 4; ++k)
        row[k] = c->vertex(k)->info();
      std::fwrite(row, sizeof(double), 7, stdout);
    }
  }
}
