// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_MAKE_LIPSCHITZ_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_MAKE_LIPSCHITZ_H

// The largest 1-Lipschitz function on points that is nowhere above given values f: at p it is
// the minimum over all points q of f(q) + |pq|.

#include <CGAL/Delaunay_from_surface_3/samples/Distinct_points.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Dimension.h>
#include <CGAL/K_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SAMPLES_MAKE_LIPSCHITZ_H
