// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_DISTINCT_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_DISTINCT_POINTS_H

// Points as doubles, each of them once, and a tree of them to search in: distances need no more
// than that, whatever the kernel.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>
#include <CGAL/K_neighbor_search.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
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

// The largest 1-Lipschitz function on points that is nowhere above given values f: at p it is
// the minimum over all points q of f(q) + |pq|.

// A point and the value there, as a fourth coordinate. Then a box of CGAL's tree knows the smallest
// value inside, and q with the smallest f(q) + |pq| is a nearest neighbor of p for another distance.
using Raised_point = std::array<double, 4>;

struct Coordinates_of_raised_point
{
  using result_type = const double*;
  const double* operator()(const Raised_point& p) const { return p.data(); }
  const double* operator()(const Raised_point& p, int) const { return p.data() + p.size(); }
};

using Raised_point_traits = Search_traits<double, Raised_point, const double*,
                                          Coordinates_of_raised_point, Dimension_tag<4>>;

// A model of CGAL's GeneralDistance. Rounding is monotonic, so a box is never taken to be farther
// than a point inside.
struct Distance_plus_value
{
  using D = Dimension_tag<4>;
  using FT = double;
  using Point_d = Raised_point;
  using Query_item = Plain_point;
  using Box = Kd_tree_rectangle<FT, D>;

  FT transformed_distance(const Plain_point& p, const Raised_point& q) const
  {
    return std::sqrt(squared_length_between(p, Plain_point(q[0], q[1], q[2]))) + q[3];
  }

  FT min_distance_to_rectangle(const Plain_point& p, const Box& box) const
  {
    const auto nearest = [&](int c) {
      return (std::min)((std::max)(p[c], box.min_coord(c)), box.max_coord(c));
    };
    return transformed_distance(p, {nearest(0), nearest(1), nearest(2), box.min_coord(3)});
  }

  FT max_distance_to_rectangle(const Plain_point& p, const Box& box) const
  {
    const auto farthest = [&](int c) {
      return p[c] - box.min_coord(c) < box.max_coord(c) - p[c] ? box.max_coord(c)
                                                               : box.min_coord(c);
    };
    return transformed_distance(p, {farthest(0), farthest(1), farthest(2), box.max_coord(3)});
  }

  // It is not transformed.
  FT transformed_distance(FT d) const { return d; }
  FT inverse_of_transformed_distance(FT d) const { return d; }
};

// Lowers the values at the points to that function.
inline void make_lipschitz(const std::vector<Plain_point>& points, std::vector<double>& values)
{
  std::vector<Raised_point> raised;
  raised.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    raised.push_back({points[k].x(), points[k].y(), points[k].z(), values[k]});
  using Search = K_neighbor_search<Raised_point_traits, Distance_plus_value>;
  const typename Search::Tree tree(raised.begin(), raised.end());
  for (std::size_t k = 0; k < points.size(); ++k)
    values[k] = Search(tree, points[k]).begin()->second;
}

// The points of a user's range, checked, where only distances between them are asked for.

template <class PointRange, class NamedParameters>
Distinct_points read_distinct_points(const PointRange& items, const NamedParameters& np)
{
  using Item = typename std::iterator_traits<decltype(std::begin(items))>::value_type;
  const auto point_map = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::point_map), Identity_property_map<const Item>());
  std::vector<Plain_point> points;
  Bbox_3 box;
  for (const auto& item : items) {
    const auto& p = get(point_map, item);
    check_point(p, points.size());
    points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    box += points.back().bbox();
  }
  if (!points.empty() &&
      !std::isfinite(squared_length_between({box.xmin(), box.ymin(), box.zmin()},
                                            {box.xmax(), box.ymax(), box.zmax()})))
    throw Surface_input_error("the points are too far from each other: the square of their "
                              "distance is too large for a double");
  return Distinct_points(points);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_DISTINCT_POINTS_H
