// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_LEAVES_OF_BOX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_LEAVES_OF_BOX_H

// Keeps account of which copies of which points in a periodic box are inserted: by leaves of a few
// points, so that the layer around home is thin where there are many.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Box_of_points.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Empty_ball.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Points in leaves of a few each, under a binary tree of bounding boxes.
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

template <class Box>
class Leaves_of_box
{
public:
  // A copy of a leaf, by a shift from home.
  struct Copy
  {
    std::size_t leaf;
    Shift shift;
    Id near; // a vertex
  };

  // `positions` are those of the points at home. Keeps a reference to the box.
  Leaves_of_box(const Box& box, const Point_array& positions, const Executor& executor)
    : m_box(box)
    , m_points(positions, executor)
    , m_next_to_home(m_points.number_of_leaves())
    , m_patches(std::size_t((std::min)(std::cbrt(double(m_points.number_of_leaves())), 64.)) + 1)
  {
    if (Box::has_weight)
      for (std::size_t i = 0; i < box.number_of_points(); ++i)
        m_largest_weight = i == 0 ? box.weight(i) : (std::max)(m_largest_weight, box.weight(i));
  }

  const std::size_t* begin(const Copy& copy) const { return m_points.begin(copy.leaf); }
  const std::size_t* end(const Copy& copy) const { return m_points.end(copy.leaf); }

  // Takes note of a copy that is to be inserted, if it is not yet.
  void request(const Copy& copy)
  {
    if (has(copy.leaf, copy.shift))
      return;
    if (is_next_to_home(copy.shift))
      m_next_to_home[copy.leaf] |= bit_of(copy.shift);
    else
      m_far.insert({copy.leaf, copy.shift});
    m_requested.push_back(copy);
  }
  std::vector<Copy> take_requested() { return std::exchange(m_requested, {}); }

  // Returns true if one of the copies of a point's leaf by one period to either side, along each axis, is
  // left to be inserted, and finds one.
  bool lacks_neighbor(std::size_t i, Copy& copy) const
  {
    copy.leaf = m_points.leaf_of(i);
    for (std::size_t a = 0; a < 3; ++a)
      for (const int by : {-1, 1}) {
        copy.shift = {0, 0, 0};
        copy.shift[a] = by;
        if (m_box.has_period(a) && !has(copy.leaf, copy.shift))
          return true;
      }
    return false;
  }

  // Requests the copies that are nearer to home than a share of their size, which was measured.
  void request_layer()
  {
    visit_around([](const Bounds& b) { return .9 * b.size(); },
                 [&](std::size_t leaf, const Shift& t, double width) {
                   double square = 0;
                   for (std::size_t a = 0; a < 3; ++a)
                     if (t[a] != 0)
                       square +=
                           std::pow((std::max)(gap(m_points.bounds_of(leaf), a, t[a]), 0.), 2);
                   if (square <= width * width)
                     request({leaf, t, 0});
                 });
  }

  // Finds how deep beyond each side of home nothing is left to be inserted, by patches of the sides:
  // that makes most balls certain.
  void find_safe_depths()
  {
    const double most = 4 * home().size() / double(m_patches);
    for (std::size_t a = 0; a < 3; ++a) // copies by two periods are left
      m_depths[a][0] = m_depths[a][1] = std::vector<double>(
          m_patches * m_patches,
          (std::min)(most, 2 * m_box.period(a) - (home().high[a] - home().low[a]) - slack));
    visit_around([most](const Bounds&) { return most; },
                 [&](std::size_t leaf, const Shift& t, double) {
                   if (!has(leaf, t))
                     limit_depths(m_points.bounds_of(leaf), t);
                 });
  }

  // Returns true if nothing that is left touches the ball, which must be known.
  bool is_safe(const Empty_ball& ball) const
  {
    const Bounds b = ball.bounds(m_largest_weight);
    bool is_safe = true;
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool up : {false, true}) {
        const double depth = up ? b.high[a] - home().high[a] : home().low[a] - b.low[a];
        if (m_box.has_period(a) && depth > -slack)
          visit_patches(a, b, [&](std::size_t patch) {
            is_safe = is_safe && depth < m_depths[a][up][patch];
          });
      }
    return is_safe;
  }

  // Finds the copy deepest in a ball, of those that are left; if the ball is not known, the one nearest
  // to the place v. Returns false if none touches it.
  bool find_deepest(const Empty_ball& ball, const double* v, Copy& copy) const
  {
    Shift first = {0, 0, 0}, last = {0, 0, 0};
    const Bounds b = ball.bounds(m_largest_weight);
    for (std::size_t a = 0; a < 3; ++a) {
      const double period = m_box.period(a), reach = m_box.reach(a);
      if (!m_box.has_period(a))
        continue;
      const double low = ball.is_known() ? (b.low[a] - home().high[a]) / period : -reach,
                   high = ball.is_known() ? (b.high[a] - home().low[a]) / period : reach;
      first[a] = int((std::max)(std::floor(low), -reach));
      last[a] = int((std::min)(std::ceil(high), reach));
    }
    double least = std::numeric_limits<double>::infinity();
    for (int x = first[0]; x <= last[0]; ++x)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int z = first[2]; z <= last[2]; ++z)
          if (x != 0 || y != 0 || z != 0)
            find_deepest(ball, v, {x, y, z}, least, copy);
    return least < std::numeric_limits<double>::infinity();
  }

private:
  static constexpr double slack = 0x1p8; // positions are off by less

  const Bounds& home() const { return m_points.bounds(); }

  static bool is_next_to_home(const Shift& t)
  {
    return std::abs(t[0]) < 2 && std::abs(t[1]) < 2 && std::abs(t[2]) < 2;
  }
  static std::uint32_t bit_of(const Shift& t)
  {
    return std::uint32_t(1) << (9 * t[0] + 3 * t[1] + t[2] + 13);
  }
  bool has(std::size_t leaf, const Shift& t) const
  {
    return is_next_to_home(t) ? (m_next_to_home[leaf] & bit_of(t)) != 0
                              : m_far.count({leaf, t}) != 0;
  }

  // How far a box that is moved by a period, or -1, is from home.
  double gap(const Bounds& b, std::size_t axis, int by) const
  {
    return by > 0 ? b.low[axis] + m_box.period(axis) - home().high[axis]
                  : home().low[axis] - (b.high[axis] - m_box.period(axis));
  }

  // Calls visit(leaf, shift, width) for copies by one period that are, along each axis, less than
  // width(bounds) from home.
  template <class Width, class Visit>
  void visit_around(const Width& width_of, const Visit& visit)
  {
    for (std::size_t leaf = 0; leaf < m_points.number_of_leaves(); ++leaf) {
      const Bounds& b = m_points.bounds_of(leaf);
      const double width = width_of(b);
      Shift first = {0, 0, 0}, last = {0, 0, 0};
      for (std::size_t a = 0; a < 3; ++a)
        if (m_box.has_period(a)) {
          first[a] = gap(b, a, -1) <= width ? -1 : 0;
          last[a] = gap(b, a, 1) <= width ? 1 : 0;
        }
      for (int x = first[0]; x <= last[0]; ++x)
        for (int y = first[1]; y <= last[1]; ++y)
          for (int z = first[2]; z <= last[2]; ++z)
            if (x != 0 || y != 0 || z != 0)
              visit(leaf, Shift{x, y, z}, width);
    }
  }

  // The patches of a side that are in the shadow of a box; what lies beside the side has the patches
  // at its edges.
  template <class Visit>
  void visit_patches(std::size_t axis, const Bounds& b, const Visit& visit) const
  {
    const std::size_t s = (axis + 1) % 3, t = (axis + 2) % 3;
    const auto patch = [&](std::size_t a, double x) {
      const double at =
          (x - home().low[a]) * double(m_patches) / (home().high[a] - home().low[a] + 1);
      return std::size_t((std::max)(0., (std::min)(at, double(m_patches - 1))));
    };
    for (std::size_t i = patch(s, b.low[s]), i_end = patch(s, b.high[s]); i <= i_end; ++i)
      for (std::size_t j = patch(t, b.low[t]), j_end = patch(t, b.high[t]); j <= j_end; ++j)
        visit(i * m_patches + j);
  }

  // Lets the depths end before a copy, on the side from which it is farthest.
  void limit_depths(const Bounds& b, const Shift& t)
  {
    std::size_t axis = 3;
    double farthest = 0;
    Bounds moved;
    for (std::size_t a = 0; a < 3; ++a) {
      moved.low[a] = b.low[a] + t[a] * m_box.period(a) - slack;
      moved.high[a] = b.high[a] + t[a] * m_box.period(a) + slack;
      if (t[a] != 0 && (axis == 3 || gap(b, a, t[a]) > farthest)) {
        axis = a;
        farthest = gap(b, a, t[a]);
      }
    }
    visit_patches(axis, moved, [&](std::size_t patch) {
      double& depth = m_depths[axis][t[axis] > 0][patch];
      depth = (std::min)(depth, farthest - slack);
    });
  }

  void find_deepest(const Empty_ball& ball, const double* v, const Shift& t, double& least,
                    Copy& copy) const
  {
    const auto moved = m_box.moved_by(t);
    double power = 0; // of the bounds entered last
    m_points.visit_leaves(
        [&](const Bounds& b) {
          power = ball.is_known() ? ball.least_power(b, moved, m_largest_weight)
                                  : squared_distance_to(b, moved, v);
          return power < least;
        },
        [&](std::size_t leaf) {
          if (has(leaf, t))
            return;
          least = power;
          copy.leaf = leaf;
          copy.shift = t;
        });
  }

  static double squared_distance_to(const Bounds& b, const std::array<double, 3>& moved,
                                    const double* v)
  {
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a)
      square +=
          std::pow((std::max)({0., b.low[a] + moved[a] - v[a], v[a] - (b.high[a] + moved[a])}), 2);
    return square;
  }

  const Box& m_box;
  const Points_by_space m_points;
  std::vector<std::uint32_t> m_next_to_home; // for each leaf, a bit for each of 27 shifts
  std::set<std::pair<std::size_t, Shift>> m_far;
  std::vector<Copy> m_requested;
  const std::size_t m_patches;        // along an edge of home
  std::vector<double> m_depths[3][2]; // by axis, side and patch
  double m_largest_weight = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_LEAVES_OF_BOX_H
