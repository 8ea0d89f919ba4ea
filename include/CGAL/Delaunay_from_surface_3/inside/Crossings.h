// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_CROSSINGS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_CROSSINGS_H

// By how much a winding number changes on the way from the centre of a tetrahedron to those of
// its facets, where these ways cross triangles. A way that comes so near to the border of a
// triangle, or ends so near to its plane, that rounding might decide is not known: another will do.

#include <CGAL/Delaunay_from_surface_3/inside/Box_tree.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// For each facet of a tetrahedron, by the corner opposite to it.
using Jumps = std::array<std::int8_t, 4>;
constexpr int unknown_jump = -128;

inline std::int8_t as_jump(int j)
{
  return std::int8_t(std::abs(j) < -unknown_jump ? j : unknown_jump);
}

// A distance that is no rounding, in a frame of size 1.
constexpr double no_rounding = 1e-10;

// Whether a triangle passes through the inside of a tetrahedron, and not only along its surface: no
// direction separates them, neither a normal of one of them nor what an edge of each spans.
inline bool passes_inside(const Cutting_triangle& t, const std::array<Vector_3d, 4>& p,
                          const Box_3d& box_of_p)
{
  for (std::size_t j = 0; j < 3; ++j) // most are not even near
    if ((std::max)({t.corners[0][j], t.corners[1][j], t.corners[2][j]}) <= box_of_p.low[j] ||
        (std::min)({t.corners[0][j], t.corners[1][j], t.corners[2][j]}) >= box_of_p.high[j])
      return false;
  const Vector_3d& origin = t.corners[0]; // it is not far from 0, as corners of tetrahedra may be
  const auto ends_of = [&](const auto& corners, const Vector_3d& direction) {
    std::array<double, 2> ends = {dot(direction, minus(corners[0], origin)), 0};
    ends[1] = ends[0];
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const double x = dot(direction, minus(corners[k], origin));
      ends = {(std::min)(ends[0], x), (std::max)(ends[1], x)};
    }
    return ends;
  };
  const auto separates = [&](const Vector_3d& direction) {
    const std::array<double, 2> a = ends_of(t.corners, direction), b = ends_of(p, direction);
    const double length = std::sqrt(dot(direction, direction));
    return length > 0 && (std::min)(a[1] - b[0], b[1] - a[0]) <= no_rounding * length;
  };
  if (separates(t.normal))
    return false;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector_3d& corner = p[(k + 1) % 4];
    if (separates(cross(minus(p[(k + 2) % 4], corner), minus(p[(k + 3) % 4], corner))))
      return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (separates(cross(minus(t.corners[(k + 1) % 3], t.corners[k]), minus(p[j], p[i]))))
          return false;
  return true;
}

class Crossings
{
  static constexpr double near = no_rounding;

public:
  // From the centre of tetrahedron c of the cells.
  template <class Cells>
  static Jumps of(const Box_tree& tree, const Cells& cells, std::size_t c)
  {
    Jumps jumps = {0, 0, 0, 0};
    Crossings crossings;
    bool is_ready = false;
    tree.visit(box_of_ways(cells(c)), [&](const Cutting_triangle& t) {
      if (!std::exchange(is_ready, true))
        crossings.set(cells, c);
      crossings.add(t, jumps);
    });
    return jumps;
  }

private:
  // The box of the centres, and a little more.
  static Box_3d box_of_ways(const std::array<Vector_3d, 4>& p)
  {
    Box_3d box;
    for (std::size_t j = 0; j < 3; ++j) {
      const double sum = p[0][j] + p[1][j] + p[2][j] + p[3][j];
      const auto ends = std::minmax({p[0][j], p[1][j], p[2][j], p[3][j]});
      box.low[j] = (sum - ends.second) / 3 - near;
      box.high[j] = (sum - ends.first) / 3 + near;
    }
    return box;
  }

  // The centre of a facet has the same bits in both tetrahedra: vertices are added in ascending
  // order.
  template <class Cells>
  void set(const Cells& cells, std::size_t c)
  {
    m_center = cells.center(c);
    const auto v = cells.vertices_of(c);
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return v[i] < v[j]; });
    for (std::size_t k = 0; k < 4; ++k) {
      Vector_3d sum = {0, 0, 0};
      for (const std::size_t i : order)
        for (std::size_t j = 0; i != k && j < 3; ++j)
          sum[j] += cells.points[std::size_t(v[i])][j];
      m_ends[k] = {sum[0] / 3, sum[1] / 3, sum[2] / 3};
    }
  }

  static int sign(double x, double tolerance) { return int(x > tolerance) - int(x < -tolerance); }

  void add(const Cutting_triangle& t, Jumps& jumps) const
  {
    const double tolerance = near * std::sqrt(dot(t.normal, t.normal));
    const auto side = [&](const Vector_3d& p) {
      return sign(dot(t.normal, minus(p, t.corners[0])), tolerance);
    };
    const int side_of_center = side(m_center);
    for (std::size_t k = 0; k < 4; ++k) {
      const int side_of_end = side(m_ends[k]);
      if ((side_of_center == side_of_end && side_of_end != 0) || jumps[k] == unknown_jump)
        continue;
      const int passes = passes_through(t.corners, m_ends[k]);
      if (passes < 0 || (passes > 0 && side_of_center * side_of_end == 0))
        jumps[k] = unknown_jump;
      else if (passes > 0)
        jumps[k] = as_jump(jumps[k] + side_of_center * t.number);
    }
  }

  // Whether the line to q passes through a triangle: 1 if so, 0 if not, -1 if this is not known.
  int passes_through(const Triangle_3d& corners, const Vector_3d& q) const
  {
    const Vector_3d way = minus(q, m_center);
    int signs[3] = {0, 0, 0}; // negative, small, positive
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3d &a = corners[i], &b = corners[(i + 1) % 3];
      const Vector_3d n = cross(way, minus(b, a));
      const double lengths = std::sqrt(dot(way, way) * dot(minus(b, a), minus(b, a)));
      ++signs[1 + sign(dot(n, minus(a, m_center)), near * lengths)];
    }
    return signs[0] > 0 && signs[2] > 0 ? 0 : signs[1] > 0 ? -1 : 1;
  }

  Vector_3d m_center;
  std::array<Vector_3d, 4> m_ends;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_CROSSINGS_H
