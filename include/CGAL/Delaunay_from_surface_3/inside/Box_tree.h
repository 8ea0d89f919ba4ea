// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_TREE_H

// Whether a tetrahedron meets any of some triangles: by their boxes in a hierarchy, and then by planes:
// if none of these separates the two they are taken to meet.
//
// Invariant: as that of Winding_tree.

#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Box_3d
{
  Vector_3d low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  Vector_3d high = {-low[0], -low[0], -low[0]};

  void add(const Vector_3d& p)
  {
    for (std::size_t j = 0; j < 3; ++j) {
      low[j] = (std::min)(low[j], p[j]);
      high[j] = (std::max)(high[j], p[j]);
    }
  }
  bool meets(const Box_3d& other) const
  {
    for (std::size_t j = 0; j < 3; ++j)
      if (low[j] > other.high[j] || high[j] < other.low[j])
        return false;
    return true;
  }
};

class Box_tree
{
  static constexpr std::size_t leaf = 4; // triangles, at most

  struct Node
  {
    Box_3d box;
    std::uint32_t first = 0, last = 0, next = 0;
  };

public:
  explicit Box_tree(std::vector<Triangle_3d>&& triangles)
    : m_triangles(std::move(triangles))
  {
    if (!m_triangles.empty())
      build(0, m_triangles.size());
  }

  bool meets(const std::array<Vector_3d, 4>& tetrahedron) const
  {
    Box_3d box;
    for (const Vector_3d& p : tetrahedron)
      box.add(p);
    for (std::size_t k = 0; k < m_nodes.size();) {
      const Node& node = m_nodes[k];
      if (!node.box.meets(box)) {
        k = node.next;
        continue;
      }
      if (node.next == ++k)
        for (std::size_t t = node.first; t < node.last; ++t)
          if (!are_separated(tetrahedron, m_triangles[t]))
            return true;
    }
    return false;
  }

private:
  // The side of a plane, with normal n through a, on which p lies; 0 on the plane, or very near.
  static int side(const Vector_3d& n, double tolerance, const Vector_3d& a, const Vector_3d& p)
  {
    const double d = dot(n, minus(p, a));
    return int(d > tolerance) - int(d < -tolerance);
  }

  // Whether the plane of a facet, or that of the triangle, separates them. If a facet and the triangle lie in one
  // plane they may overlap there: then they are not.
  static bool are_separated(const std::array<Vector_3d, 4>& p, const Triangle_3d& triangle)
  {
    constexpr double near = 1e-10; // of the size of all
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector_3d &a = p[(k + 1) % 4], &b = p[(k + 2) % 4], &c = p[(k + 3) % 4];
      const Vector_3d n = cross(minus(b, a), minus(c, a));
      const double tolerance = near * std::sqrt(dot(n, n));
      const int inner = side(n, tolerance, a, p[k]);
      int most = -1, least = 1;
      for (const Vector_3d& q : triangle) {
        most = (std::max)(most, inner * side(n, tolerance, a, q));
        least = (std::min)(least, inner * side(n, tolerance, a, q));
      }
      if (inner != 0 && most <= 0 && least < 0)
        return true;
    }
    const Vector_3d n = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
    const double tolerance = near * std::sqrt(dot(n, n));
    int number[3] = {0, 0, 0}; // below, on, above
    for (const Vector_3d& q : p)
      ++number[1 + side(n, tolerance, triangle[0], q)];
    return (number[0] == 0 || number[2] == 0) && number[1] <= 2;
  }

  void build(std::size_t first, std::size_t last)
  {
    const std::size_t k = m_nodes.size();
    m_nodes.emplace_back();
    Box_3d box;
    for (std::size_t t = first; t < last; ++t)
      for (const Vector_3d& p : m_triangles[t])
        box.add(p);
    if (last - first > leaf) {
      std::size_t longest = 0;
      for (std::size_t j = 1; j < 3; ++j)
        if (box.high[j] - box.low[j] > box.high[longest] - box.low[longest])
          longest = j;
      const std::size_t middle = first + (last - first) / 2;
      const auto at = [&](std::size_t t) { return m_triangles.begin() + std::ptrdiff_t(t); };
      std::nth_element(at(first), at(middle), at(last),
                       [&](const auto& s, const auto& t) { return s[0][longest] < t[0][longest]; });
      build(first, middle);
      build(middle, last);
    }
    m_nodes[k] = {box, std::uint32_t(first), std::uint32_t(last), std::uint32_t(m_nodes.size())};
  }

  std::vector<Triangle_3d> m_triangles;
  std::vector<Node> m_nodes;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_TREE_H
