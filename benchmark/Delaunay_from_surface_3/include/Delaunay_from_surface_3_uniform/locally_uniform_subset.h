// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_LOCALLY_UNIFORM_SUBSET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_LOCALLY_UNIFORM_SUBSET_H

// Choi 2002, §3.1: "locally uniform samples" (Funke, Ramos 2002), on which "the surface Delaunay
// triangulation has a bounded degree". Here they are found by greedy packing, unlike there.
//
// When the degree is bounded. Let the sizing field f be L-Lipschitz for some L < 1: for t up to 1,
// t times the spacing is t-Lipschitz. Let p and q be kept and neighbours on the surface: some point
// c of the surface is as far from p as from q, and no point that is kept is nearer to c. Let c be
// at most r away from a point s of the whole sample. A point within f(s) of s is kept, so
// |cp| <= r + f(s) <= r + f(p) + L (r + |cp|). If r is at most k f(p) with a constant k, this gives
// |cp| <= C f(p) with C = (1 + k + k L) / (1 - L). All neighbours of p are then in a ball of radius
// 2 C f(p) around it. Their sizes are at least (1 - 2 C L) f(p), and so are their distances from each
// other. If 2 C L < 1, which requires an L of less than 1/3, their number is bounded.

#include <CGAL/Dimension.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/K_neighbor_search.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace uniform {

using Plain_point = CGAL::Simple_cartesian<double>::Point_3;
using Numbered_point = std::pair<Plain_point, std::size_t>;
using Numbered_point_traits =
    CGAL::Search_traits_adapter<Numbered_point, CGAL::First_of_pair_property_map<Numbered_point>,
                                CGAL::Search_traits_3<CGAL::Simple_cartesian<double>>>;
using Numbered_point_tree = CGAL::Kd_tree<Numbered_point_traits>;

// A point and its size, as a fourth coordinate. Then a box of CGAL's tree knows the smallest size
// inside, and the q with the smallest f(q) + |pq| is a nearest neighbor of p for another distance.
using Raised_point = std::array<double, 4>;
struct Coordinates_of_raised_point
{
  using result_type = const double*;
  const double* operator()(const Raised_point& p) const { return p.data(); }
  const double* operator()(const Raised_point& p, int) const { return p.data() + p.size(); }
};
using Raised_point_traits =
    CGAL::Search_traits<double, Raised_point, const double*, Coordinates_of_raised_point,
                        CGAL::Dimension_tag<4>>;

// A model of CGAL's GeneralDistance. Rounding is monotonic, so a box is never taken to be farther
// than a point inside.
struct Distance_plus_size
{
  using D = CGAL::Dimension_tag<4>;
  using FT = double;
  using Point_d = Raised_point;
  using Query_item = Plain_point;
  using Box = CGAL::Kd_tree_rectangle<FT, D>;

  FT transformed_distance(const Plain_point& p, const Raised_point& q) const
  {
    return std::sqrt(CGAL::squared_distance(p, Plain_point(q[0], q[1], q[2]))) + q[3];
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
  FT transformed_distance(FT d) const { return d; }
  FT inverse_of_transformed_distance(FT d) const { return d; }
};

template <class Points>
std::vector<Numbered_point> numbered(const Points& points)
{
  std::vector<Numbered_point> items;
  for (const auto& p : points)
    items.emplace_back(Plain_point(p.x(), p.y(), p.z()), items.size());
  return items;
}

/// Returns the distance from each of distinct points to its k-th nearest neighbor, or to the farthest if
/// there are fewer others: a measure of the spacing, and 1-Lipschitz.
template <class Points>
std::vector<double> neighbor_spacing(const Points& points, std::size_t k = 12)
{
  const std::vector<Numbered_point> items = numbered(points);
  const Numbered_point_tree tree(items.begin(), items.end());
  const auto with_itself = static_cast<unsigned int>((std::min)(k + 1, items.size()));
  std::vector<double> spacing;
  for (const Numbered_point& item : items) {
    double squared = 0;
    for (const auto& neighbor :
         CGAL::Orthogonal_k_neighbor_search<Numbered_point_traits>(tree, item.first, with_itself))
      squared = (std::max)(squared, neighbor.second);
    spacing.push_back(std::sqrt(squared));
  }
  return spacing;
}

/// Lowers sizes at points to the largest 1-Lipschitz function that is nowhere above them: at p it is the
/// minimum over all points q of the size at q plus |pq|.
template <class Points>
void make_lipschitz(const Points& points, std::vector<double>& sizes)
{
  std::vector<Raised_point> raised;
  for (const auto& p : points)
    raised.push_back({p.x(), p.y(), p.z(), sizes[raised.size()]});
  using Search = CGAL::K_neighbor_search<Raised_point_traits, Distance_plus_size>;
  const typename Search::Tree tree(raised.begin(), raised.end());
  for (std::size_t k = 0; k < raised.size(); ++k)
    sizes[k] = Search(tree, Plain_point(raised[k][0], raised[k][1], raised[k][2])).begin()->second;
}

/// Returns the indices, ascending, of a subset of distinct points such that no two are near each other, and
/// every other point is near one of them, by a sizing field that is made 1-Lipschitz. By increasing size,
/// then index, a point is kept unless it is in the open ball around one kept before, whose radius is the
/// size of that one. So two that are kept have a distance of at least half of the larger size, and a point
/// that is left out is nearer than its size to one that is kept.
template <class Points>
std::vector<std::size_t> locally_uniform_subset(const Points& points, std::vector<double> sizes)
{
  make_lipschitz(points, sizes);
  const std::vector<Numbered_point> items = numbered(points);
  const Numbered_point_tree tree(items.begin(), items.end());
  std::vector<std::size_t> order(items.size()), kept;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return sizes[k] < sizes[l]; });
  std::vector<bool> is_left_out(items.size());
  std::vector<Numbered_point> ball;
  for (const std::size_t k : order) {
    if (is_left_out[k])
      continue;
    kept.push_back(k);
    const Plain_point& p = items[k].first;
    ball.clear();
    tree.search(std::back_inserter(ball), CGAL::Fuzzy_sphere<Numbered_point_traits>(p, sizes[k]));
    for (const auto& [q, l] : ball)
      if (l != k && CGAL::squared_distance(p, q) < sizes[k] * sizes[k])
        is_left_out[l] = true;
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

} // namespace uniform

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_LOCALLY_UNIFORM_SUBSET_H
