// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_POINTS_BY_SPACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_POINTS_BY_SPACE_H

// Finds points by space: in leaves of a few points each, under a binary tree of bounding boxes.

#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A box with edges along the axes; empty at first.
struct Bounds
{
  double low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};

  void add(const double* p)
  {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = (std::min)(low[a], p[a]);
      high[a] = (std::max)(high[a], p[a]);
    }
  }
  bool is_empty() const { return low[0] > high[0]; }
  double size() const
  {
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      longest = (std::max)(longest, high[a] - low[a]);
    return longest;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

class Points_by_space
{
public:
  static constexpr std::size_t size_of_leaf = 8;

  // O(n log n)
  Points_by_space(const Point_array& points, const Executor& executor)
    : m_points(points.size())
    , m_leaf_of_point(points.size())
  {
    std::iota(m_points.begin(), m_points.end(), std::size_t(0));
    Sort_by_halves()(points, m_points.data(), m_points.data() + m_points.size(), executor);
    while (m_first_leaf < number_of_leaves())
      m_first_leaf *= 2;
    m_bounds.resize(m_first_leaf + (std::max)(number_of_leaves(), std::size_t(1)));
    for (std::size_t k = 0; k < m_points.size(); ++k) {
      m_leaf_of_point[m_points[k]] = std::uint32_t(k / size_of_leaf);
      m_bounds[m_first_leaf + k / size_of_leaf].add(points[m_points[k]]);
    }
    for (std::size_t node = m_bounds.size() - 1; node > 1; --node)
      if (!m_bounds[node].is_empty()) {
        m_bounds[node / 2].add(m_bounds[node].low);
        m_bounds[node / 2].add(m_bounds[node].high);
      }
  }

  std::size_t number_of_leaves() const
  {
    return (m_points.size() + size_of_leaf - 1) / size_of_leaf;
  }
  std::uint32_t leaf_of(std::size_t point) const { return m_leaf_of_point[point]; }
  const std::size_t* begin(std::size_t leaf) const { return m_points.data() + size_of_leaf * leaf; }
  const std::size_t* end(std::size_t leaf) const
  {
    return m_points.data() + (std::min)(size_of_leaf * (leaf + 1), m_points.size());
  }
  const Bounds& bounds_of(std::size_t leaf) const { return m_bounds[m_first_leaf + leaf]; }
  const Bounds& bounds() const { return m_bounds[1]; }

  // Calls visit(leaf) for the leaves under nodes for whose bounds enters() holds.
  template <class Enters, class Visit>
  void visit_leaves(const Enters& enters, const Visit& visit, std::size_t node = 1) const
  {
    if (node >= m_bounds.size() || m_bounds[node].is_empty() || !enters(m_bounds[node]))
      return;
    if (node >= m_first_leaf) {
      visit(node - m_first_leaf);
      return;
    }
    visit_leaves(enters, visit, 2 * node);
    visit_leaves(enters, visit, 2 * node + 1);
  }

private:
  std::vector<std::size_t> m_points; // by leaf
  std::vector<std::uint32_t> m_leaf_of_point;
  std::size_t m_first_leaf = 1; // the nodes 2 k and 2 k + 1 are the halves of node k; the root is 1
  std::vector<Bounds> m_bounds;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_POINTS_BY_SPACE_H
