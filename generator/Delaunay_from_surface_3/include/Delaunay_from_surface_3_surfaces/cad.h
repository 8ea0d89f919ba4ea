// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CAD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CAD_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/profiles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace surfaces {

/// How CAD numbers vertices: along the profile that was extruded or turned, one copy after the
/// other; along the way that each of its points takes, one point after the other; or as something
/// else left them.
enum class Numbering { BY_PROFILE, BY_RING, SHUFFLED };

/// A closed solid of about `n` points as CAD kernels make them. The seed draws its proportions.
struct Cad_family
{
  std::string name;
  std::string description;
  std::function<Indexed_surface(std::size_t n, std::uint64_t seed, Numbering)> make;
};

namespace internal {

// A solid whose points are numbered as the rows of a table, perhaps with more behind it.
struct Numbered_solid
{
  Indexed_surface surface;
  std::size_t width;
};

inline std::size_t at_least(std::size_t low, double x)
{
  return (std::max)(low, static_cast<std::size_t>((std::max)(x, 0.) + 0.5));
}

// So many points of the profile for so many of the solid: copies are up to 8 times as far from each
// other as the points of the profile, or as near.
inline std::size_t drawn_width(std::size_t n, Random& random)
{
  return at_least(8, std::sqrt(static_cast<double>(n) * std::exp(random.uniform(-2, 2))));
}

inline Numbered_solid extruded(const Profile& profile, std::size_t layers, double scale,
                               double length)
{
  const auto position = [&](std::size_t k, std::size_t layer) {
    return Indexed_surface::Point_3(scale * profile.points[k].x(), scale * profile.points[k].y(),
                                    length * share(layer, layers - 1));
  };
  return {swept(profile, layers, position), profile.points.size()};
}

inline Numbered_solid cad_airfoil(std::size_t n, Random& random)
{
  const std::size_t half = drawn_width(n, random) / 2;
  const Profile profile = airfoil(half, random.uniform(0.01, 0.06), random.uniform(0.3, 0.5),
                                  random.uniform(0.08, 0.2));
  return extruded(profile, at_least(2, double(n) / double(2 * half)), 100, random.uniform(50, 600));
}

inline Numbered_solid cad_gear(std::size_t n, Random& random)
{
  const std::size_t flank = 3 + random.below(8), layers = 2 + random.below(20);
  const std::size_t teeth = at_least(8, double(n) / double(layers * (2 * flank + 2)));
  const double height = 2.2 / double(teeth) * internal::turn / 2;
  return extruded(gear(teeth, flank, 1 - (std::min)(height, 0.4)), layers, 40,
                  random.uniform(5, 40));
}

inline Numbered_solid cad_i_beam(std::size_t n, Random& random)
{
  const std::size_t fillet = 4 + random.below(28);
  const Profile profile = i_beam(fillet, random.uniform(0.4, 0.9), random.uniform(0.05, 0.1),
                                 random.uniform(0.03, 0.08), random.uniform(0.03, 0.1));
  return extruded(profile, at_least(2, double(n) / double(profile.points.size())), 200,
                  random.uniform(300, 3000));
}

// Rims are rounded: the holes widen towards both sides of the plate.
inline Numbered_solid cad_drilled_plate(std::size_t n, Random& random)
{
  const std::size_t segments = 12 + 4 * random.below(10), in_rim = 1 + random.below(3);
  const std::size_t layers = 2 * (in_rim + 1);
  const double holes = double(n) / double(layers * segments);
  const std::size_t rows = at_least(1, std::sqrt(holes * random.uniform(0.3, 1)));
  const std::size_t columns = at_least(1, holes / double(rows));
  const double radius = random.uniform(0.15, 0.35), thickness = random.uniform(0.2, 1);
  const double rim = 0.09;
  const Profile profile = drilled_rectangle(rows, columns, segments, radius);
  const auto position = [&](std::size_t k, std::size_t layer) {
    const bool is_low = layer <= in_rim;
    const double angle = turn / 4 * share(is_low ? in_rim - layer : layer - in_rim - 1, in_rim);
    const double z = (is_low ? -1 : 1) * (thickness / 2 - rim * (1 - std::sin(angle)));
    double x = profile.points[k].x(), y = profile.points[k].y();
    if (k >= 4) { // of a hole, around the nearest lattice point
      const double wider = 1 + rim / radius * (1 - std::cos(angle));
      x = std::round(x) + wider * (x - std::round(x));
      y = std::round(y) + wider * (y - std::round(y));
    }
    return Indexed_surface::Point_3(20 * x, 20 * y, 20 * z);
  };
  return {swept(profile, layers, position), profile.points.size()};
}

inline Numbered_solid cad_ribbed_plate(std::size_t n, Random& random)
{
  const std::size_t fillet = 3 + random.below(8), layers = 2 + random.below(6);
  const std::size_t ribs = at_least(1, double(n) / double(layers * (2 * fillet + 4)));
  const Profile profile =
      ribbed_plate(ribs, fillet, random.uniform(0.5, 2), random.uniform(0.1, 0.3));
  return extruded(profile, layers, 10, random.uniform(20, 200));
}

// Straight parts without rings between quarter bends of 8 steps, left and right in turn.
inline Numbered_solid cad_pipe(std::size_t n, Random& random)
{
  const std::size_t segments = 16 + 8 * random.below(10), steps = 8;
  const std::size_t bends = at_least(1, double(n) / double(2 * segments * (steps + 1)));
  const double bend = random.uniform(1.5, 3), straight = random.uniform(1, 10);
  const Profile profile = annulus(segments, random.uniform(0.6, 0.95));
  const auto position = [&](std::size_t k, std::size_t layer) {
    const std::size_t whole = layer / (steps + 1), step = layer % (steps + 1);
    const double angle = turn / 4 * share(step, steps), across = profile.points[k].x();
    // Every two bends end as they began, higher and farther right.
    double x = double(whole / 2) * (2 * bend + straight), z = x;
    if (whole % 2 == 0) {
      x += (bend - across) * std::sin(angle);
      z += bend - (bend - across) * std::cos(angle);
    } else {
      x += 2 * bend - (bend + across) * std::cos(angle);
      z += bend + straight + (bend + across) * std::sin(angle);
    }
    return Indexed_surface::Point_3(25 * x, -25 * profile.points[k].y(), 25 * z);
  };
  return {swept(profile, bends * (steps + 1), position), profile.points.size()};
}

// `radius(angle, height)`, both from 0 to 1; the hubs lie in the planes of the last rings.
template <class Radius>
Numbered_solid cad_turned(std::size_t segments, std::size_t rings, double length,
                          const Radius& radius)
{
  const auto position = [&](std::size_t s, std::size_t r) {
    const double angle = share(s, segments), height = share(r, rings - 1);
    const double rho = radius(angle, height);
    return Indexed_surface::Point_3(rho * std::cos(turn * angle), rho * std::sin(turn * angle),
                                    length * height);
  };
  return {turned(segments, rings, position, {0, 0, 0}, {0, 0, length}), segments};
}

inline Numbered_solid cad_cylinder(std::size_t n, Random& random)
{
  const std::size_t segments =
      at_least(3, (std::min)(double(n) / 2, std::sqrt(double(n) * std::exp(random.uniform(1, 5)))));
  return cad_turned(segments, at_least(2, double(n) / double(segments)), random.uniform(10, 300),
                    [](double, double) { return 30.; });
}

inline Numbered_solid cad_thread(std::size_t n, Random& random)
{
  const std::size_t segments = 24 + 8 * random.below(8), in_turn = 4 + 2 * random.below(5);
  const std::size_t rings = at_least(2, double(n) / double(segments));
  const double pitch = random.uniform(0.8, 2);
  const double turns = double(rings - 1) / double(in_turn);
  return cad_turned(segments, rings, pitch * turns, [=](double angle, double height) {
    const double phase = height * turns - angle;
    return 8 + 0.6 * pitch * std::abs(2 * (phase - std::floor(phase)) - 1);
  });
}

inline Numbered_solid cad_vase(std::size_t n, Random& random)
{
  const std::size_t segments = drawn_width(n, random);
  const double a = random.uniform(2, 9), b = random.uniform(0, 6);
  return cad_turned(segments, at_least(2, double(n) / double(segments)), 120,
                    [=](double, double height) {
                      return 30 + 12 * std::sin(a * height + b) - 10 * height * height;
                    });
}

} // namespace internal

/// All kinds of solids.
inline std::vector<Cad_family> cad_families()
{
  std::vector<Cad_family> all;
  const auto add = [&](const std::string& name, const std::string& description,
                       internal::Numbered_solid (*draw)(std::size_t, Random&)) {
    const auto make = [draw](std::size_t n, std::uint64_t seed, Numbering numbering) {
      Random random(seed);
      internal::Numbered_solid solid = draw(n, random);
      if (numbering == Numbering::BY_RING)
        number_by_columns(solid.surface, solid.width);
      if (numbering == Numbering::SHUFFLED)
        shuffle(solid.surface, seed);
      return solid.surface;
    };
    all.push_back({name, description, make});
  };
  add("airfoil", "extruded NACA airfoil", internal::cad_airfoil);
  add("gear", "extruded gear with a bore", internal::cad_gear);
  add("i-beam", "extruded I-beam with fillets", internal::cad_i_beam);
  add("drilled-plate", "plate with rows of holes with rounded rims", internal::cad_drilled_plate);
  add("ribbed-plate", "plate with ribs on fillets", internal::cad_ribbed_plate);
  add("pipe", "pipe of straight parts and bends", internal::cad_pipe);
  add("cylinder", "cylinder of many segments, with fans as caps", internal::cad_cylinder);
  add("thread", "threaded rod, with fans as caps", internal::cad_thread);
  add("vase", "turned solid of a smooth outline, with fans as caps", internal::cad_vase);
  return all;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CAD_H
