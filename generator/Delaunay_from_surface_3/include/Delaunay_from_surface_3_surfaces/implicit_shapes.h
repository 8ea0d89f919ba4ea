// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IMPLICIT_SHAPES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IMPLICIT_SHAPES_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace surfaces {

// An implicit shape is a function object f on points, negative inside, together with `radius()`,
// the radius of a ball about the origin that holds the shape, and `feature()`, a length that a
// lattice has to resolve. f is 1-Lipschitz: |f(p)| bounds the distance from p to the surface from
// below. The polygoniser relies on this to pass over empty space.

/// A chain of `genus` tori in a row, smoothly joined where neighbours touch; an ellipsoid for
/// genus 0. Nothing on it is flat or spherical, so its points are in general position.
class Torus_chain
{
public:
  using Point_3 = Indexed_surface::Point_3;

  explicit Torus_chain(std::size_t genus)
    : genus(static_cast<double>(genus))
  {
  }

  double operator()(const Point_3& p) const { return genus == 0 ? ellipsoid(p) : chain(p); }

  double radius() const { return genus == 0 ? 1.5 : genus + tube; }

  double feature() const { return tube; }

private:
  static constexpr double tube = 0.4;   // the ring itself has radius 1
  static constexpr double blend = 0.25; // rings nearer to each other than this flow together

  // |p / r| - 1 has slope at most 1 / min(r).
  static double ellipsoid(const Point_3& p)
  {
    return 0.75 *
           (std::sqrt(p.x() * p.x() / (1.4 * 1.4) + p.y() * p.y() + p.z() * p.z() / (0.75 * 0.75)) -
            1);
  }

  static double ring(double x, double y, double z)
  {
    const double radial = std::sqrt(x * x + y * y) - 1;
    return std::sqrt(radial * radial + z * z) - tube;
  }

  // The two rings nearest to p are the one whose slab holds p and its neighbour on p's side.
  double chain(const Point_3& p) const
  {
    const double along = p.x() + genus - 1; // ring i has its centre at 2 i
    const double i = (std::min)((std::max)(std::round(along / 2), 0.), genus - 1);
    const double j = along > 2 * i ? i + 1 : i - 1;
    const double d = ring(along - 2 * i, p.y(), p.z());
    if (j < 0 || j >= genus)
      return d;
    return smooth_minimum(d, ring(along - 2 * j, p.y(), p.z()));
  }

  // Its gradient is a convex combination of the two gradients: still 1-Lipschitz.
  static double smooth_minimum(double a, double b)
  {
    const double h = (std::max)(blend - std::abs(a - b), 0.) / blend;
    return (std::min)(a, b) - h * h * blend / 4;
  }

  double genus;
};

/// A plate with rounded rims and `genus` round holes in a row. Its two flat sides are a hard case
/// on purpose: they carry most of the points.
class Holed_plate
{
public:
  using Point_3 = Indexed_surface::Point_3;

  explicit Holed_plate(std::size_t genus)
    : genus(static_cast<double>(genus))
  {
  }

  double operator()(const Point_3& p) const
  {
    const double across = outline(p.x(), p.y()) + rim;
    const double up = std::abs(p.z()) - half_thickness + rim;
    const double a = (std::max)(across, 0.), b = (std::max)(up, 0.);
    return std::sqrt(a * a + b * b) + (std::min)((std::max)(across, up), 0.) - rim;
  }

  double radius() const { return (std::max)(genus, 1.) + 0.5; }

  double feature() const { return 2 * half_thickness; }

private:
  static constexpr double half_thickness = 0.15;
  static constexpr double rim = 0.14;
  static constexpr double hole = 0.5;

  // Signed distance in the plane: a stadium of half width 1, less the nearest of the holes.
  double outline(double x, double y) const
  {
    const double half_length = (std::max)(genus - 1, 0.);
    const double past_end = (std::max)(std::abs(x) - half_length, 0.);
    const double stadium = std::sqrt(past_end * past_end + y * y) - 1;
    if (genus == 0)
      return stadium;
    const double along = x + genus - 1;
    const double i = (std::min)((std::max)(std::round(along / 2), 0.), genus - 1);
    const double from_centre = along - 2 * i;
    return (std::max)(stadium, hole - std::sqrt(from_centre * from_centre + y * y));
  }

  double genus;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IMPLICIT_SHAPES_H
