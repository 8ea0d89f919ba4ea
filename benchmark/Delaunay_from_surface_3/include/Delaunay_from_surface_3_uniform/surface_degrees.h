// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_SURFACE_DEGREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_SURFACE_DEGREES_H

// Degrees in D(S) and in the surface Delaunay triangulation: the triangles of D(S) whose Voronoi
// edges end on either side of the surface.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_points_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace uniform {

struct Degrees
{
  std::size_t vertices = 0; // with an edge
  std::size_t largest = 0;
  double mean = 0;
};

struct Surface_degrees
{
  std::size_t points = 0;
  std::ptrdiff_t euler_characteristic = 0;
  Degrees surface, delaunay;
  double largest_ratio_of_edges = 0; // of the surface, at one vertex
};

using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

inline Degrees degrees_of(const Edges& edges, std::size_t n)
{
  std::vector<std::size_t> degree(n, 0);
  for (const auto& [i, j] : edges)
    ++degree[i], ++degree[j];
  const std::size_t vertices =
      n - std::size_t(std::count(degree.begin(), degree.end(), std::size_t(0)));
  return {vertices, *std::max_element(degree.begin(), degree.end()),
          2 * double(edges.size()) / double(vertices)};
}

// At each vertex the longest edge is divided by the shortest.
template <class Point>
double largest_ratio(const Edges& edges, const std::vector<Point>& points)
{
  std::vector<double> longest(points.size(), 0), shortest(points.size(), 1e300);
  for (const auto& [i, j] : edges)
    for (const std::size_t k : {i, j}) {
      const double d = CGAL::squared_distance(points[i], points[j]);
      longest[k] = (std::max)(longest[k], d);
      shortest[k] = (std::min)(shortest[k], d);
    }
  double ratio = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    ratio = (std::max)(ratio, longest[k] / shortest[k]);
  return std::sqrt(ratio);
}

inline void sort_and_unite(Edges& edges)
{
  for (auto& [i, j] : edges)
    if (j < i)
      std::swap(i, j);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

// `shape` is negative inside.
template <class Point, class Shape>
Surface_degrees surface_degrees(const std::vector<Point>& points, const Shape& shape)
{
  using Kernel = CGAL::Epick;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cell_base =
      CGAL::Triangulation_cell_base_with_info_3<bool, Kernel,
                                                CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using Tr =
      CGAL::Delaunay_triangulation_3<Kernel,
                                     CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
  std::vector<std::pair<Point, std::size_t>> numbered;
  for (const Point& p : points)
    numbered.emplace_back(p, numbered.size());
  Tr tr;
  CGAL::insert_points_3(tr, numbered);
  for (const auto c : tr.all_cell_handles())
    c->info() = !tr.is_infinite(c) && shape(tr.dual(c)) < 0;

  Edges surface, delaunay;
  std::size_t triangles = 0;
  for (const auto& [c, i] : tr.finite_facets())
    if (c->info() != c->neighbor(i)->info()) {
      ++triangles;
      for (int k = 0; k < 3; ++k)
        surface.emplace_back(c->vertex(Tr::vertex_triple_index(i, k))->info(),
                             c->vertex(Tr::vertex_triple_index(i, (k + 1) % 3))->info());
    }
  sort_and_unite(surface);
  for (const auto& e : tr.finite_edges())
    delaunay.emplace_back(e.first->vertex(e.second)->info(), e.first->vertex(e.third)->info());

  Surface_degrees result;
  result.points = points.size();
  result.surface = degrees_of(surface, points.size());
  result.delaunay = degrees_of(delaunay, points.size());
  result.euler_characteristic = std::ptrdiff_t(result.surface.vertices) -
                                std::ptrdiff_t(surface.size()) + std::ptrdiff_t(triangles);
  result.largest_ratio_of_edges = largest_ratio(surface, points);
  return result;
}

} // namespace uniform

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_SURFACE_DEGREES_H
