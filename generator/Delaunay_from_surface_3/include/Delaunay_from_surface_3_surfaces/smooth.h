// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SMOOTH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SMOOTH_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace surfaces {
namespace internal {

// The centroid of the triangles around each vertex.
inline std::vector<Indexed_surface::Point_3> star_centroids(const Indexed_surface& surface)
{
  using Vector_3 = Indexed_surface::Vector_3;
  std::vector<Vector_3> sum(surface.points.size(), CGAL::NULL_VECTOR);
  std::vector<double> weight(surface.points.size(), 0.);
  for (const Indexed_surface::Face& face : surface.faces) {
    const Vector_3 a = surface.points[face[0]] - CGAL::ORIGIN;
    const Vector_3 b = surface.points[face[1]] - CGAL::ORIGIN;
    const Vector_3 c = surface.points[face[2]] - CGAL::ORIGIN;
    const double area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
    for (std::size_t v : face) {
      sum[v] += area * (a + b + c);
      weight[v] += 3 * area;
    }
  }
  std::vector<Indexed_surface::Point_3> centroids(surface.points);
  for (std::size_t v = 0; v < centroids.size(); ++v)
    if (weight[v] > 0)
      centroids[v] = CGAL::ORIGIN + sum[v] / weight[v];
  return centroids;
}

// One step of Newton's method towards f = 0 along the gradient, by differences of width `width`.
template <class Shape>
Indexed_surface::Point_3 projected(const Indexed_surface::Point_3& p, const Shape& shape,
                                   double width)
{
  using Vector_3 = Indexed_surface::Vector_3;
  const double f = shape(p);
  const Vector_3 gradient((shape(p + Vector_3(width, 0, 0)) - f) / width,
                          (shape(p + Vector_3(0, width, 0)) - f) / width,
                          (shape(p + Vector_3(0, 0, width)) - f) / width);
  const double length = gradient.squared_length();
  return length > 1e-3 ? p - f / length * gradient : p;
}

} // namespace internal

/// Evens out the triangles of a surface that approximates the zero set of an implicit shape: in
/// each round every vertex moves to the centroid of its star and from there back to the surface.
template <class Shape>
void smooth(Indexed_surface& surface, const Shape& shape, int rounds)
{
  const double width = 1e-5 * shape.feature();
  for (int round = 0; round < rounds; ++round) {
    std::vector<Indexed_surface::Point_3> points = internal::star_centroids(surface);
    for (Indexed_surface::Point_3& p : points)
      p = internal::projected(p, shape, width);
    surface.points.swap(points);
  }
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SMOOTH_H
