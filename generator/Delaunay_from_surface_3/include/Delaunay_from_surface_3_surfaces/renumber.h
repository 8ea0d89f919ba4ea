// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RENUMBER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RENUMBER_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace surfaces {

/// Point `order[i]` becomes point i. The faces stay in their order.
inline void renumber(Indexed_surface& surface, const std::vector<std::size_t>& order)
{
  std::vector<std::size_t> new_number(order.size());
  std::vector<Indexed_surface::Point_3> points;
  points.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    new_number[order[i]] = i;
    points.push_back(surface.points[order[i]]);
  }
  surface.points.swap(points);
  for (Indexed_surface::Face& face : surface.faces)
    for (std::size_t& v : face)
      v = new_number[v];
}

/// The points come as the rows of a table, `width` in each, and perhaps more; they are numbered
/// column by column instead, then the others.
inline void number_by_columns(Indexed_surface& surface, std::size_t width)
{
  const std::size_t rows = surface.points.size() / width;
  std::vector<std::size_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t k = 0; k < rows * width; ++k)
    order[k] = k % rows * width + k / rows;
  renumber(surface, order);
}

/// Every coordinate as the nearest number of single precision.
inline void round_to_float(Indexed_surface& surface)
{
  for (Indexed_surface::Point_3& p : surface.points)
    p = Indexed_surface::Point_3(double(float(p.x())), double(float(p.y())), double(float(p.z())));
}

/// Every coordinate as a text file with so many decimals has it.
inline void round_to_decimals(Indexed_surface& surface, unsigned decimals)
{
  const double unit = std::pow(10., decimals);
  const auto round = [unit](double x) { return std::round(x * unit) / unit; };
  for (Indexed_surface::Point_3& p : surface.points)
    p = Indexed_surface::Point_3(round(p.x()), round(p.y()), round(p.z()));
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RENUMBER_H
