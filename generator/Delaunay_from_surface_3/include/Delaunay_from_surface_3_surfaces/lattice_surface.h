// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_LATTICE_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_LATTICE_SURFACE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace surfaces {
namespace internal {

// The boundary of a union of unit cubes, every square of it cut into cells x cells lattice squares
// of two triangles each. The points have integer coordinates.
class Lattice_shell
{
  using Index = std::array<std::int64_t, 3>;

public:
  explicit Lattice_shell(std::size_t cells)
    : cells(static_cast<std::int64_t>(cells))
  {
  }

  // Adds the square of the cube `cube` that looks along `axis`, upwards or downwards.
  void add_square(const Index& cube, int axis, bool upwards)
  {
    const std::size_t side = static_cast<std::size_t>(cells) + 1;
    std::vector<std::size_t> corner(side * side);
    for (std::int64_t i = 0; i <= cells; ++i)
      for (std::int64_t j = 0; j <= cells; ++j) {
        Index q = {cube[0] * cells, cube[1] * cells, cube[2] * cells};
        q[axis] += upwards ? cells : 0;
        q[(axis + 1) % 3] += i;
        q[(axis + 2) % 3] += j;
        const bool on_rim = i == 0 || j == 0 || i == cells || j == cells;
        corner[i * side + j] = on_rim ? shared_point(q) : new_point(q);
      }
    for (std::size_t i = 0; i + 1 < side; ++i)
      for (std::size_t j = 0; j + 1 < side; ++j) {
        const std::size_t at = i * side + j;
        add_triangle(corner[at], corner[at + side], corner[at + side + 1], upwards);
        add_triangle(corner[at], corner[at + side + 1], corner[at + 1], upwards);
      }
  }

  Indexed_surface take() { return std::move(surface); }

private:
  std::size_t new_point(const Index& q)
  {
    surface.points.emplace_back(q[0], q[1], q[2]);
    return surface.points.size() - 1;
  }

  // The point may belong to several squares: it is made by the first.
  std::size_t shared_point(const Index& q)
  {
    const std::uint64_t code = static_cast<std::uint64_t>((q[0] << 42) | (q[1] << 21) | q[2]);
    const auto found = numbers.emplace(code, surface.points.size());
    return found.second ? new_point(q) : found.first->second;
  }

  void add_triangle(std::size_t a, std::size_t b, std::size_t c, bool upwards)
  {
    surface.faces.push_back(upwards ? Indexed_surface::Face{a, b, c}
                                    : Indexed_surface::Face{a, c, b});
  }

  std::int64_t cells;
  boost::unordered_map<std::uint64_t, std::size_t> numbers;
  Indexed_surface surface;
};

// The boundary of nx x ny x nz cubes less those for which `is_hole(x, y)` holds.
template <class IsHole>
Indexed_surface lattice_shell(std::int64_t nx, std::int64_t ny, std::int64_t nz, IsHole is_hole,
                              std::size_t cells)
{
  require(static_cast<std::int64_t>(cells) * (std::max)({nx, ny, nz}) < std::int64_t(1) << 21,
          "the lattice is too large");
  const std::array<std::int64_t, 3> size = {nx, ny, nz};
  const auto is_full = [&](const std::array<std::int64_t, 3>& q) {
    for (int axis = 0; axis < 3; ++axis)
      if (q[axis] < 0 || q[axis] >= size[axis])
        return false;
    return !is_hole(q[0], q[1]);
  };
  Lattice_shell shell(cells);
  std::array<std::int64_t, 3> cube;
  for (cube[2] = 0; cube[2] < nz; ++cube[2])
    for (cube[1] = 0; cube[1] < ny; ++cube[1])
      for (cube[0] = 0; cube[0] < nx; ++cube[0])
        for (int side = 0; side < 6 && is_full(cube); ++side) {
          std::array<std::int64_t, 3> neighbour = cube;
          neighbour[side / 2] += side % 2 ? 1 : -1;
          if (!is_full(neighbour))
            shell.add_square(cube, side / 2, side % 2 == 1);
        }
  return shell.take();
}

} // namespace internal

/// A box with `genus` square holes, as a mechanical part may have them, on the integer lattice: a
/// closed surface with about `n` points of which huge numbers are coplanar and cospherical.
/// Genus 0 is a cube, genus 1 a picture frame.
inline Indexed_surface lattice_surface(std::size_t genus, std::size_t n)
{
  const std::int64_t g = static_cast<std::int64_t>(genus), across = genus == 0 ? 1 : 3;
  const auto is_hole = [](std::int64_t x, std::int64_t y) { return x % 2 == 1 && y == 1; };
  // With s squares of c x c cells there are 2 s c^2 triangles, hence 2 - 2 g + s c^2 points.
  const double squares = genus == 0 ? 6. : 2. * (5 * g + 3) + 2. * (2 * g + 1) + 6 + 4 * g;
  const double cells =
      std::round(std::sqrt((std::max)(static_cast<double>(n) + 2. * g - 2, 0.) / squares));
  return internal::lattice_shell(2 * g + 1, across, 1, is_hole,
                                 static_cast<std::size_t>((std::max)(cells, 1.)));
}

/// Two square lattices of about `n / 2` points each, at distance `thickness` where neighbours in a
/// lattice have distance 1, joined at the rim to a closed surface. \pre `thickness > 0`
inline Indexed_surface thin_plate(std::size_t n, double thickness)
{
  require(thickness > 0, "the thickness must be positive");
  const std::int64_t side =
      static_cast<std::int64_t>((std::max)(std::round(std::sqrt(n / 2.)) - 1, 1.));
  Indexed_surface surface = internal::lattice_shell(
      side, side, 1, [](std::int64_t, std::int64_t) { return false; }, 1);
  for (Indexed_surface::Point_3& p : surface.points)
    p = Indexed_surface::Point_3(p.x(), p.y(), thickness * p.z());
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_LATTICE_SURFACE_H
