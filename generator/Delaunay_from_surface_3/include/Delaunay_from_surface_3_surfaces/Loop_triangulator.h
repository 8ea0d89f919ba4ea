// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_LOOP_TRIANGULATOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_LOOP_TRIANGULATOR_H

#include <Delaunay_from_surface_3_surfaces/Marching_cubes_table.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace surfaces {

/// Finds a triangulation of a loop, a polygon in space, of least cost: the dynamic program for
/// triangulations of polygons (Gilbert 1979; Klincsek 1980). Costs of triangles and diagonals add
/// up.
///
/// O(m^3) calls of the cost of a triangle for m points, in time and number.
class Loop_triangulator
{
public:
  using Triangle = Marching_cubes_table::Triangle;
  using Triangulation = Marching_cubes_table::Triangulation;

  /// What must not be.
  static constexpr std::size_t forbidden = std::size_t(1) << 40;

  /// `triangle_cost(i, k, j)` and `diagonal_cost(i, j)` get places i < k < j in the loop.
  template <class TriangleCost, class DiagonalCost>
  Loop_triangulator(std::size_t size, const TriangleCost& triangle_cost,
                    const DiagonalCost& diagonal_cost)
    : m_size(size)
    , m_best(size * size)
  {
    for (std::size_t length = 2; length < size; ++length)
      for (std::size_t i = 0; i + length < size; ++i) {
        const std::size_t j = i + length;
        Best& best = m_best[i * size + j];
        best.cost = std::numeric_limits<std::size_t>::max();
        for (std::size_t k = i + 1; k < j; ++k) {
          const std::size_t cost = at(i, k).cost + at(k, j).cost + triangle_cost(i, k, j);
          if (cost < best.cost)
            best = {cost, k};
        }
        if (length + 1 < size)
          best.cost += diagonal_cost(i, j);
      }
    collect(0, size - 1);
  }

  std::size_t cost() const { return at(0, m_size - 1).cost; }
  const Triangulation& triangulation() const { return m_triangles; }

  /// The diagonals of the triangulation.
  const std::vector<std::array<std::size_t, 2>>& diagonals() const { return m_diagonals; }

private:
  // Of the polygon from place i to place j: the corner of the triangle at the edge from i to j.
  struct Best
  {
    std::size_t cost = 0, corner = 0;
  };

  const Best& at(std::size_t i, std::size_t j) const { return m_best[i * m_size + j]; }

  void collect(std::size_t i, std::size_t j)
  {
    if (j - i < 2)
      return;
    const std::size_t k = at(i, j).corner;
    m_triangles.push_back({i, k, j});
    if (j - i + 1 < m_size)
      m_diagonals.push_back({i, j});
    collect(i, k);
    collect(k, j);
  }

  std::size_t m_size;
  std::vector<Best> m_best;
  Triangulation m_triangles;
  std::vector<std::array<std::size_t, 2>> m_diagonals;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_LOOP_TRIANGULATOR_H
