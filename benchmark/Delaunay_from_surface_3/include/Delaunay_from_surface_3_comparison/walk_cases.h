// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_WALK_CASES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_WALK_CASES_H

// Where walks or a budget can go wrong: smooth surfaces, whose triangulations have huge thin cells
// beside small ones; points of which the first have a triangulation of quadratic size; and points
// alone in boxes that are long or flat.

#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/random.h>
#include <Delaunay_from_surface_3_surfaces/sphere.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace comparison {

// n random points in a box with these sides, without faces.
inline surfaces::Indexed_surface points_in_box(std::size_t n, double a, double b, double c,
                                               std::uint64_t seed)
{
  surfaces::Random random(seed);
  surfaces::Indexed_surface points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform(0, a), y = random.uniform(0, b), z = random.uniform(0, c);
    points.points.emplace_back(x, y, z);
  }
  return points;
}

// measure(family, kind, surface), one after the other, of about n points; the tori of more, what is
// of quadratic size or takes long to find, of fewer.
template <class Measure>
void for_walk_cases(std::size_t n, std::uint64_t seed, const Measure& measure)
{
  for (const std::size_t m : {3 * n / 2, 7 * n / 2}) {
    measure("smooth torus", "from a grid", surfaces::genus_surface(1, m));
    measure("smooth torus", "winding", surfaces::winding_torus(m));
  }
  measure("round tube", "in rings", surfaces::round_tube(n));
  measure("sphere, exactly", "up to rounding, in rings", surfaces::sphere(n));
  measure("sphere, exactly", "integers",
          surfaces::integer_sphere((std::min)(n, std::size_t(20000))));
  measure("two lines", "quadratic", surfaces::two_lines((std::min)(n, std::size_t(3000))));
  measure("stars", "hubs on two lines", surfaces::skew_stars(n, seed));
  for (const auto& [name, a] : {std::pair("1/100", 1e-2), {"1/1000", 1e-3}, {"1/10000", 1e-4}}) {
    const std::string thin = name;
    measure("points alone", "box 1 : " + thin + " : " + thin, points_in_box(n, 1, a, a, seed));
    measure("points alone", "slab 1 : 1 : " + thin, points_in_box(n, 1, 1, a, seed));
  }
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_WALK_CASES_H
