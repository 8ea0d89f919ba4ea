// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DEGENERATE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DEGENERATE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace surfaces {

/// The first `n` of three points, and their triangle when all are there. \pre `n <= 3`
inline Indexed_surface few_points(std::size_t n)
{
  if (n > 3)
    throw std::invalid_argument("there are at most 3 points");
  Indexed_surface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.points.resize(n);
  if (n == 3)
    surface.faces.push_back({0, 1, 2});
  return surface;
}

/// A band of triangles without area on `n` points of one line, exactly collinear. \pre `n >= 3`
inline Indexed_surface collinear(std::size_t n)
{
  if (n < 3)
    throw std::invalid_argument("a collinear band needs at least 3 vertices");
  Indexed_surface surface;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    surface.points.emplace_back(t, 2 * t, 3 * t);
  }
  for (std::size_t i = 0; i + 2 < n; ++i) // neighbours in a band of triangles turn opposite ways
    surface.faces.push_back(i % 2 == 0 ? Indexed_surface::Face{i, i + 1, i + 2}
                                       : Indexed_surface::Face{i + 1, i, i + 2});
  return surface;
}

/// A square piece of the integer lattice with about `n` points in the plane x + y + z = 0, exactly
/// coplanar, with cocircular squares. \pre `n >= 4`
inline Indexed_surface coplanar(std::size_t n)
{
  if (n < 4)
    throw std::invalid_argument("a coplanar patch needs at least 4 vertices");
  return internal::grid_patch(
      n, [](double x, double y, double) { return Indexed_surface::Point_3(x + y, x - y, -2 * x); });
}

/// Adds `count` duplicates of points, each of which takes over one random face of its original: a
/// soup that is torn open there.
/// \pre there is a face
inline void duplicate_points(Indexed_surface& surface, std::size_t count, std::uint64_t seed)
{
  if (surface.faces.empty())
    throw std::invalid_argument("there are no faces to take points from");
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    Indexed_surface::Face& face = surface.faces[random.below(surface.faces.size())];
    std::size_t& corner = face[random.below(3)];
    surface.points.push_back(Indexed_surface::Point_3(surface.points[corner]));
    corner = surface.points.size() - 1;
  }
}

/// Gives every face three points of its own, as in an STL file.
inline void separate_faces(Indexed_surface& surface)
{
  Indexed_surface result;
  for (const Indexed_surface::Face& face : surface.faces) {
    const std::size_t first = result.points.size();
    for (std::size_t v : face)
      result.points.push_back(surface.points[v]);
    result.faces.push_back({first, first + 1, first + 2});
  }
  surface = std::move(result);
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_DEGENERATE_H
