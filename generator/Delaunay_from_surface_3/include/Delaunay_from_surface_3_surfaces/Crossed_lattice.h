// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CROSSED_LATTICE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CROSSED_LATTICE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Marching_cubes_table.h>
#include <Delaunay_from_surface_3_surfaces/Volume.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace surfaces {

/// The lattice of a volume with a point on each edge that the surface crosses: those whose ends lie
/// inside and outside. A cube has the number of its lowest lattice point.
class Crossed_lattice
{
public:
  static constexpr std::size_t none = std::size_t(-1);

  /// O(n^3) for n x n x n lattice points, whose coordinates are the integers from 0.
  explicit Crossed_lattice(const Volume& volume)
    : m_size(volume.size())
    , m_step({1, m_size, m_size * m_size})
    , m_is_inside(m_size * m_size * m_size)
    , m_number(3 * m_is_inside.size(), none)
  {
    for (std::size_t p = 0; p < m_is_inside.size(); ++p)
      m_is_inside[p] = volume[p] < 0;
    for (std::size_t p = 0; p < m_is_inside.size(); ++p)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (coordinate(p, axis) + 1 == m_size || m_is_inside[p] == m_is_inside[p + m_step[axis]])
          continue;
        // Kept away from the ends, the points around a lattice point stay apart.
        const double f = volume[p], g = volume[p + m_step[axis]];
        const double t = (std::min)((std::max)(f / (f - g), 0.05), 0.95);
        m_number[3 * p + axis] = m_points.size();
        m_points.push_back(position(p) + t * (position(p + m_step[axis]) - position(p)));
      }
  }

  std::size_t size() const { return m_size; }
  const std::vector<Indexed_surface::Point_3>& points() const { return m_points; }

  /// Of lattice point or cube p.
  std::size_t coordinate(std::size_t p, std::size_t axis) const
  {
    return p / m_step[axis] % m_size;
  }

  /// From a lattice point or cube to the next along an axis.
  std::size_t step(std::size_t axis) const { return m_step[axis]; }

  std::size_t corner(std::size_t cube, int c) const
  {
    return cube + std::size_t(c & 1) * m_step[0] + std::size_t(c >> 1 & 1) * m_step[1] +
           std::size_t(c >> 2) * m_step[2];
  }

  /// Bit c says whether corner c of the cube lies inside.
  int inside(std::size_t cube) const
  {
    int result = 0;
    for (int c = 0; c < 8; ++c)
      result |= int(m_is_inside[corner(cube, c)]) << c;
    return result;
  }

  /// The number of the point on the lattice edge from p along an axis, or `none`.
  std::size_t point_along(std::size_t p, std::size_t axis) const { return m_number[3 * p + axis]; }

  /// The numbers of the points of a loop of a cube.
  std::vector<std::size_t> points_of(std::size_t cube, const Marching_cubes_table::Loop& loop) const
  {
    std::vector<std::size_t> result;
    for (const int e : loop)
      result.push_back(
          point_along(corner(cube, Marching_cubes_table::corners(e)[0]), std::size_t(e / 4)));
    return result;
  }

  template <class Visit>
  void for_each_cube(const Visit& visit) const
  {
    for (std::size_t k = 0; k + 1 < m_size; ++k)
      for (std::size_t j = 0; j + 1 < m_size; ++j)
        for (std::size_t i = 0; i + 1 < m_size; ++i)
          visit(i + m_size * (j + m_size * k));
  }

private:
  Indexed_surface::Point_3 position(std::size_t p) const
  {
    return {double(coordinate(p, 0)), double(coordinate(p, 1)), double(coordinate(p, 2))};
  }

  std::size_t m_size;
  std::array<std::size_t, 3> m_step;
  std::vector<bool> m_is_inside;
  std::vector<std::size_t> m_number; // by lattice edges
  std::vector<Indexed_surface::Point_3> m_points;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_CROSSED_LATTICE_H
