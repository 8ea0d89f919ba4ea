// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What CGAL's classes make of points, in words: test_patches.py compiles it with CGAL's headers as
// they are, and with those that the patches of the manual's folder patches/ have changed.

#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Regular_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <set>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
template <class Vb, class Cb>
using Delaunay = CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<Vb, Cb>>;

using Alpha_shape = CGAL::Alpha_shape_3<
    Delaunay<CGAL::Alpha_shape_vertex_base_3<K>, CGAL::Alpha_shape_cell_base_3<K>>>;
using Fixed_shape = CGAL::Fixed_alpha_shape_3<
    Delaunay<CGAL::Fixed_alpha_shape_vertex_base_3<K>, CGAL::Fixed_alpha_shape_cell_base_3<K>>>;

using Regular_vertex =
    CGAL::Fixed_alpha_shape_vertex_base_3<K, CGAL::Regular_triangulation_vertex_base_3<K>>;
using Regular_cell =
    CGAL::Fixed_alpha_shape_cell_base_3<K, CGAL::Regular_triangulation_cell_base_3<K>>;
using Weighted_shape = CGAL::Fixed_alpha_shape_3<CGAL::Regular_triangulation_3<
    K, CGAL::Triangulation_data_structure_3<Regular_vertex, Regular_cell>>>;

template <class Shape>
void print(const char* name, const Shape& shape)
{
  std::size_t of_kind[4] = {0, 0, 0, 0};
  for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f)
    ++of_kind[shape.classify(*f)];
  std::cout << name << ' ' << shape.number_of_vertices();
  for (const std::size_t number : of_kind)
    std::cout << ' ' << number;
  std::cout << '\n';
}

int main()
{
  const std::vector<Point> points = surfaces::sphere(800, .05, 1).points;
  print("alpha shape", Alpha_shape(points.begin(), points.end(), .02));
  Alpha_shape made;
  made.make_alpha_shape(points.begin(), points.end());
  made.set_alpha(.02);
  print("made later", made);
  print("alphas", Alpha_shape(points.begin(), points.end(), *made.find_optimal_alpha(1)));
  print("fixed", Fixed_shape(points.begin(), points.end(), .02));
  std::vector<K::Weighted_point_3> weighted;
  for (const Point& p : points)
    weighted.emplace_back(p, .001 * double(weighted.size() % 5));
  print("weighted", Weighted_shape(weighted.begin(), weighted.end(), .02));

  std::vector<std::array<std::size_t, 3>> faces;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(faces));
  for (auto& face : faces) // from which side the front begins depends on the order of the cells
    std::sort(face.begin(), face.end());
  for (const auto& face : std::set<std::array<std::size_t, 3>>(faces.begin(), faces.end()))
    std::cout << "face " << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
#ifdef CGAL_INSERT_POINTS_3_H
  std::cerr << "patched\n";
#endif
}
