// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILES_H

#include <Delaunay_from_surface_3_surfaces/Profile.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace surfaces {

namespace internal {

constexpr double turn = 2 * 3.14159265358979323846;

inline double share(std::size_t k, std::size_t n)
{
  return static_cast<double>(k) / static_cast<double>(n);
}

// n + 1 points of a circular arc from the angle a to the angle b, in turns.
inline void add_arc(Profile& profile, double x, double y, double radius, double a, double b,
                    std::size_t n)
{
  for (std::size_t k = 0; k <= n; ++k) {
    const double angle = turn * (a + (b - a) * share(k, n));
    profile.points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
}

} // namespace internal

/// Ends the profile with a round hole of `n` points. \pre it lies inside, away from other loops
inline void add_hole(Profile& profile, double x, double y, double radius, std::size_t n)
{
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = -internal::turn * internal::share(k, n);
    profile.points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  profile.end_loop();
}

/// A NACA airfoil of four digits with chord 1 and a closed trailing edge: `camber` and `thickness`
/// in shares of the chord, the largest camber at `position` (Jacobs, Ward, Pinkerton: The
/// characteristics of 78 related airfoil sections, NACA Report 460, 1933). 2 `half` points, dense
/// at both edges.
inline Profile airfoil(std::size_t half, double camber, double position, double thickness)
{
  const auto surface_point = [=](double x, double side) {
    const double y = 5 * thickness *
                     (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
                      0.1036 * x * x * x * x);
    const double rest = x < position ? position : 1 - position;
    const double slope = 2 * camber / (rest * rest) * (position - x);
    const double line =
        camber - camber / (rest * rest) * (position - x) * (position - x); // zero at both edges
    const double angle = std::atan(slope);
    return Profile::Point_2(x - side * y * std::sin(angle), line + side * y * std::cos(angle));
  };
  Profile profile;
  for (std::size_t k = 0; k < half; ++k) // from the trailing edge over the upper side
    profile.points.push_back(
        surface_point((1 + std::cos(internal::turn / 2 * internal::share(k, half))) / 2, 1));
  for (std::size_t k = 0; k < half; ++k)
    profile.points.push_back(
        surface_point((1 - std::cos(internal::turn / 2 * internal::share(k, half))) / 2, -1));
  profile.end_loop();
  return profile;
}

/// A gear with a bore: every tooth has flanks of `n` points and a tip and a root of two points.
inline Profile gear(std::size_t teeth, std::size_t n, double root_radius)
{
  Profile profile;
  for (std::size_t t = 0; t < teeth; ++t)
    for (std::size_t k = 0; k < 2 * n; ++k) {
      const bool rises = k < n;
      const double s =
          internal::share(rises ? k : 2 * n - 1 - k, n - 1); // 0 at the root, 1 at the tip
      const double half_width = 0.17 - 0.09 * s * s;         // of a tooth, in steps
      const double angle = internal::turn *
                           (static_cast<double>(t) + (rises ? -half_width : half_width)) /
                           static_cast<double>(teeth);
      const double radius = root_radius + (1 - root_radius) * s;
      profile.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  profile.end_loop();
  add_hole(profile, 0, 0, 0.4 * root_radius, (std::max)(std::size_t(8), 2 * teeth));
  return profile;
}

/// An I-beam of height 1 whose web meets the flanges in fillets of `n` + 1 points each.
inline Profile i_beam(std::size_t n, double width, double flange, double web, double fillet)
{
  Profile profile;
  const double x = width / 2, w = web / 2, inner = 0.5 - flange;
  const auto add = [&](double px, double py) { profile.points.emplace_back(px, py); };
  add(-x, -0.5);
  add(x, -0.5);
  add(x, -inner);
  internal::add_arc(profile, w + fillet, -inner + fillet, fillet, 0.75, 0.5, n);
  internal::add_arc(profile, w + fillet, inner - fillet, fillet, 0.5, 0.25, n);
  add(x, inner);
  add(x, 0.5);
  add(-x, 0.5);
  add(-x, inner);
  internal::add_arc(profile, -w - fillet, inner - fillet, fillet, 0.25, 0, n);
  internal::add_arc(profile, -w - fillet, -inner + fillet, fillet, 0, -0.25, n);
  add(-x, -inner);
  profile.end_loop();
  return profile;
}

/// A plate with `ribs` ribs on top that stand on fillets of `n` + 1 points, a step of 1 from rib to
/// rib.
inline Profile ribbed_plate(std::size_t ribs, std::size_t n, double height, double thickness)
{
  const double width = 0.2, fillet = 0.15;
  Profile profile;
  profile.points.emplace_back(-1, -thickness);
  profile.points.emplace_back(static_cast<double>(ribs), -thickness);
  profile.points.emplace_back(static_cast<double>(ribs), 0);
  for (std::size_t r = ribs; r-- > 0;) { // from right to left
    const double x = static_cast<double>(r);
    internal::add_arc(profile, x + width / 2 + fillet, fillet, fillet, 0.75, 0.5, n);
    profile.points.emplace_back(x + width / 2, height);
    profile.points.emplace_back(x - width / 2, height);
    internal::add_arc(profile, x - width / 2 - fillet, fillet, fillet, 0, -0.25, n);
  }
  profile.points.emplace_back(-1, 0);
  profile.end_loop();
  return profile;
}

/// A rectangle with `rows` times `columns` holes of `n` points, a step of 1 from hole to hole.
inline Profile drilled_rectangle(std::size_t rows, std::size_t columns, std::size_t n,
                                 double hole_radius)
{
  const double x = static_cast<double>(columns) - 0.5, y = static_cast<double>(rows) - 0.5;
  Profile profile;
  profile.points = {{-0.5, -0.5}, {x, -0.5}, {x, y}, {-0.5, y}};
  profile.end_loop();
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c)
      add_hole(profile, static_cast<double>(c), static_cast<double>(r), hole_radius, n);
  return profile;
}

/// A ring of `n` points on each of its two circles, of radius 1 and `bore`.
inline Profile annulus(std::size_t n, double bore)
{
  Profile profile;
  for (std::size_t k = 0; k < n; ++k)
    profile.points.emplace_back(std::cos(internal::turn * internal::share(k, n)),
                                std::sin(internal::turn * internal::share(k, n)));
  profile.end_loop();
  add_hole(profile, 0, 0, bore, n);
  return profile;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILES_H
