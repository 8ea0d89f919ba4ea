// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_DISTINCT_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_DISTINCT_POINTS_H

// Points as doubles, each of them once, and a tree of them to search in: distances need no more
// than that, whatever the kernel.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Plain_point = Simple_cartesian<double>::Point_3;
using Numbered_point = std::pair<Plain_point, std::size_t>;
using Numbered_point_traits =
    Search_traits_adapter<Numbered_point, First_of_pair_property_map<Numbered_point>,
                          Search_traits_3<Simple_cartesian<double>>>;
using Numbered_point_tree = Kd_tree<Numbered_point_traits>;

// The square is the sum of squares in this order in CGAL's search too, so the two agree.
inline double squared_length_between(const Plain_point& p, const Plain_point& q)
{
  const double x = p.x() - q.x(), y = p.y() - q.y(), z = p.z() - q.z();
  return x * x + y * y + z * z;
}

class Distinct_points
{
public:
  explicit Distinct_points(const std::vector<Plain_point>& all)
    : m_number(all.size())
  {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return all[i] < all[j] || (all[i] == all[j] && i < j);
    });
    for (const std::size_t i : order) {
      if (m_points.empty() || all[i] != m_points.back()) {
        m_points.push_back(all[i]);
        m_first.push_back(i);
      }
      m_number[i] = m_points.size() - 1;
    }
  }

  std::size_t size() const { return m_points.size(); }
  const std::vector<Plain_point>& points() const { return m_points; }

  // The smallest index of the k-th distinct point, and which of these the i-th point is.
  std::size_t first_index(std::size_t k) const { return m_first[k]; }
  std::size_t number(std::size_t i) const { return m_number[i]; }

  std::size_t number_of_all() const { return m_number.size(); }

  // For all points, what is known of the distinct ones.
  std::vector<double> spread(const std::vector<double>& of_distinct) const
  {
    std::vector<double> of_all(m_number.size());
    for (std::size_t i = 0; i < m_number.size(); ++i)
      of_all[i] = of_distinct[m_number[i]];
    return of_all;
  }

  // All of them, each with its number.
  Numbered_point_tree tree() const
  {
    std::vector<Numbered_point> items;
    items.reserve(size());
    for (std::size_t k = 0; k < size(); ++k)
      items.emplace_back(m_points[k], k);
    return Numbered_point_tree(items.begin(), items.end());
  }

private:
  std::vector<Plain_point> m_points;
  std::vector<std::size_t> m_first, m_number;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_DISTINCT_POINTS_H
