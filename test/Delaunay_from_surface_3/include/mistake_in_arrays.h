// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_MISTAKE_IN_ARRAYS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_MISTAKE_IN_ARRAYS_H

// Are arrays the triangulation that CGAL makes of the points?

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/is_valid_delaunay_3_arrays.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tests {
namespace arrays {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Cell = std::array<std::int64_t, 4>;
using Cells = std::vector<Cell>; // vertices in ascending order, -1 for none, sorted

inline Cells canonical(Cells cells)
{
  for (Cell& c : cells)
    std::sort(c.begin(), c.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

inline Cells cells_of_cgal(const std::vector<Point>& points,
                           const std::map<Point, std::int64_t>& first_of_equal)
{
  const Triangulation tr(points.begin(), points.end());
  Cells cells;
  for (auto c = tr.tds().raw_cells_begin(); c != tr.tds().raw_cells_end(); ++c) {
    if (points.empty())
      break;                      // one cell of nothing
    Cell cell = {-1, -1, -1, -1}; // "raw" in every dimension
    for (int i = 0; i <= tr.dimension(); ++i)
      if (!tr.is_infinite(c->vertex(i)))
        cell[std::size_t(i)] = first_of_equal.at(c->vertex(i)->point());
    cells.push_back(cell);
  }
  return canonical(cells);
}

template <class Index>
Cells cells_of(const CGAL::Delaunay_3_arrays<Index>& arrays)
{
  Cells cells;
  for (std::size_t c = 0; c < arrays.number_of_cells(); ++c) {
    const auto v = arrays.vertices(c);
    cells.push_back({v[0], v[1], v[2], v[3]});
  }
  return canonical(cells);
}

// Does neighbour i share the facet opposite to vertex i, and lead back?
template <class Index>
bool is_neighbor(const CGAL::Delaunay_3_arrays<Index>& arrays, std::size_t c, std::size_t i)
{
  const Index n = arrays.neighbors(c)[i];
  if (n < 0 || std::size_t(n) >= arrays.number_of_cells())
    return false;
  std::size_t corners = std::size_t(arrays.dimension()) + 1, in_common = 0, back = 4;
  const auto v = arrays.vertices(c), w = arrays.vertices(std::size_t(n));
  for (std::size_t k = 0; k < corners; ++k)
    in_common += k != i && std::count(w.begin(), w.begin() + std::ptrdiff_t(corners), v[k]) == 1;
  for (std::size_t k = 0; k < corners; ++k)
    if (std::count(v.begin(), v.begin() + std::ptrdiff_t(corners), w[k]) == 0)
      back = k;
  if (back == 4) // both have the same vertices but for none: in low dimensions
    return in_common == corners - 1;
  return in_common == corners - 1 && arrays.neighbors(std::size_t(n))[back] == Index(c);
}

// Positive, and with the infinite vertex last: a point that takes its place would make it positive.
template <class Index>
std::size_t wrong_orientations(const CGAL::Delaunay_3_arrays<Index>& arrays,
                               const std::vector<Point>& points)
{
  std::size_t wrong = 0;
  for (std::size_t c = 0; arrays.dimension() == 3 && c < arrays.number_of_cells(); ++c) {
    auto v = arrays.vertices(c);
    const bool is_infinite = arrays.is_infinite(Index(c));
    wrong += is_infinite != (v[3] == arrays.none);
    if (is_infinite) { // the finite cell across the facet lies on the other side
      const auto across = arrays.vertices(std::size_t(arrays.neighbors(c)[3]));
      for (const Index w : across)
        if (std::find(v.begin(), v.end(), w) == v.end())
          v[3] = w;
    }
    const auto p = [&](std::size_t k) { return points[std::size_t(v[k])]; };
    wrong += CGAL::orientation(p(0), p(1), p(2), p(3)) !=
             (is_infinite ? CGAL::NEGATIVE : CGAL::POSITIVE);
  }
  return wrong;
}

// What is wrong; nothing if all is well.
template <class Index>
std::string mistake_in_arrays(const CGAL::Delaunay_3_arrays<Index>& arrays,
                              const std::vector<Point>& points)
{
  std::map<Point, std::int64_t> first_of_equal;
  for (std::size_t i = 0; i < points.size(); ++i)
    first_of_equal.emplace(points[i], i);
  if (cells_of(arrays) != cells_of_cgal(points, first_of_equal))
    return "the cells of the arrays are not plain CGAL's";
  if (arrays.number_of_points() != points.size())
    return std::to_string(arrays.number_of_points()) + " points in the arrays";
  if (arrays.number_of_vertices() != first_of_equal.size())
    return std::to_string(arrays.number_of_vertices()) + " vertices in the arrays";
  std::size_t wrong_vertices = 0, wrong_neighbors = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    wrong_vertices += arrays.vertex_of_point(i) != first_of_equal.at(points[i]);
  for (std::size_t c = 0; c < arrays.number_of_cells(); ++c)
    for (std::size_t i = 0; i <= std::size_t(arrays.dimension()); ++i)
      wrong_neighbors += !is_neighbor(arrays, c, i);
  if (wrong_vertices != 0)
    return std::to_string(wrong_vertices) + " points have a wrong vertex in the arrays";
  if (wrong_neighbors != 0)
    return std::to_string(wrong_neighbors) + " wrong neighbours in the arrays";
  const std::size_t turned = wrong_orientations(arrays, points);
  if (turned != 0)
    return std::to_string(turned) + " wrong orientations in the arrays";
  const bool is_valid = CGAL::is_valid_delaunay_3_arrays(arrays, points);
  return is_valid ? "" : "arrays that are right are called invalid";
}

} // namespace arrays
} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_MISTAKE_IN_ARRAYS_H
