// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_TREE_H

// Triangles in a hierarchy of boxes.
//
// Invariant: as that of Winding_tree.

#include <CGAL/Delaunay_from_surface_3/inside/Box_3d.h>
#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A triangle that counts `number` times. The normal is as long as twice its area.
struct Cutting_triangle
{
  Triangle_3d corners;
  Vector_3d normal;
  int number;

  Cutting_triangle(const Triangle_3d& t, int times)
    : corners(t)
    , normal(cross(minus(t[1], t[0]), minus(t[2], t[0])))
    , number(times)
  {
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
  explicit Box_tree(std::vector<Cutting_triangle>&& triangles)
    : m_triangles(std::move(triangles))
  {
    if (!m_triangles.empty())
      build(0, m_triangles.size());
  }

  // Calls visit(t) for each triangle that stands in a leaf whose box meets this one.
  template <class Visit>
  void visit(const Box_3d& box, const Visit& visit) const
  {
    for (std::size_t k = 0; k < m_nodes.size();) {
      const Node& node = m_nodes[k];
      if (!node.box.meets(box))
        k = node.next;
      else if (node.next == ++k)
        for (std::size_t t = node.first; t < node.last; ++t)
          visit(m_triangles[t]);
    }
  }

private:
  void build(std::size_t first, std::size_t last)
  {
    const std::size_t k = m_nodes.size();
    m_nodes.emplace_back();
    Box_3d box;
    for (std::size_t t = first; t < last; ++t)
      for (const Vector_3d& p : m_triangles[t].corners)
        box.add(p);
    if (last - first > leaf) {
      const std::size_t longest = box.longest_side();
      const std::size_t middle = first + (last - first) / 2;
      const auto at = [&](std::size_t t) { return m_triangles.begin() + std::ptrdiff_t(t); };
      std::nth_element(at(first), at(middle), at(last), [&](const auto& s, const auto& t) {
        return s.corners[0][longest] < t.corners[0][longest];
      });
      build(first, middle);
      build(middle, last);
    }
    m_nodes[k] = {box, std::uint32_t(first), std::uint32_t(last), std::uint32_t(m_nodes.size())};
  }

  std::vector<Cutting_triangle> m_triangles;
  std::vector<Node> m_nodes;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_TREE_H
