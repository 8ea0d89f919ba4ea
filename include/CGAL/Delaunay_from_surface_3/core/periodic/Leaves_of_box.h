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

// What bounds some points, and their weights.
struct Bounds_of_points : Bounds
{
  double weight = -std::numeric_limits<double>::infinity();

  void add(const double* p, double w)
  {
    Bounds::add(p);
    weight = (std::max)(weight, w);
  }
  void add(const Bounds_of_points& b)
  {
    Bounds::add(b.low);
    add(b.high, b.weight);
  }
};

// Points in leaves of a few each, under a binary tree of their bounds.
class Points_by_space
{
public:
  static constexpr std::size_t size_of_leaf = 8;

  // `weight(i)` is the weight of point i, or 0. O(n log n)
  template <class Weight>
  Points_by_space(const Point_array& points, const Weight& weight, const Executor& executor)
    : m_points(points.size())
    , m_leaf_of_point(points.size())
  {
    std::iota(m_points.begin(), m_points.end(), std::size_t(0));
    Sort_by_halves()(points, m_points.data(), m_points.data() + m_points.size(), executor);
    while (m_first_leaf < number_of_leaves())
      m_first_leaf *= 2;
    m_bounds.resize(2 * m_first_leaf);
    for (std::size_t k = 0; k < m_points.size(); ++k) {
      m_leaf_of_point[m_points[k]] = std::uint32_t(k / size_of_leaf);
      m_bounds[m_first_leaf + k / size_of_leaf].add(points[m_points[k]], weight(m_points[k]));
    }
    for (std::size_t node = m_bounds.size() - 1; node > 1; --node)
      if (!m_bounds[node].is_empty())
        m_bounds[node / 2].add(m_bounds[node]);
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

  // The nodes 2 k and 2 k + 1 are the halves of node k; the root is 1, and the leaves come last. Some are
  // empty.
  std::size_t number_of_nodes() const { return m_bounds.size(); }
  bool is_leaf(std::size_t node) const { return node >= m_first_leaf; }
  std::size_t leaf(std::size_t node) const { return node - m_first_leaf; }
  std::size_t node_of_leaf(std::size_t leaf) const { return m_first_leaf + leaf; }
  const Bounds_of_points& bounds(std::size_t node = 1) const { return m_bounds[node]; }

private:
  std::vector<std::size_t> m_points; // by leaf
  std::vector<std::uint32_t> m_leaf_of_point;
  std::size_t m_first_leaf = 1; // a node
  std::vector<Bounds_of_points> m_bounds;
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
    , m_points(
          positions, [this](std::size_t i) { return weight(i); }, executor)
    , m_next_to_home(m_points.number_of_nodes())
    , m_patches(std::size_t((std::min)(std::cbrt(double(m_points.number_of_leaves())), 64.)) + 1)
  {
    for (std::size_t node = m_next_to_home.size() - 1; node > 0; --node)
      if (m_points.bounds(node).is_empty())
        set_bits(node, all_bits);
  }

  // Calls visit(i) for the points of a leaf whose copies matter.
  template <class Visit>
  void visit_points(std::size_t leaf, const Visit& visit) const
  {
    for (const std::size_t* i = m_points.begin(leaf); i != m_points.end(leaf); ++i)
      if (m_is_left_out.empty() || !m_is_left_out[*i])
        visit(*i);
  }

  // Leaves out a point that has no vertex, because it is equal to another at home, or hidden. So are its
  // copies, which need not be inserted.
  void leave_out(std::size_t i)
  {
    m_is_left_out.resize(m_box.number_of_points());
    m_is_left_out[i] = true;
    const std::size_t leaf = m_points.leaf_of(i);
    bool is_any_left = false;
    visit_points(leaf, [&](std::size_t) { is_any_left = true; });
    if (!is_any_left)
      set_bits(m_points.node_of_leaf(leaf), all_bits);
  }

  // Takes note of a copy that is to be inserted, if it is not yet.
  void request(const Copy& copy)
  {
    if (has(copy.leaf, copy.shift))
      return;
    if (is_next_to_home(copy.shift))
      set_bits(m_points.node_of_leaf(copy.leaf), bit_of(copy.shift));
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
          (std::min)(most, 2 * m_box.period(a) - (home().high[a] - home().low[a]) - slack()));
    visit_around([most](const Bounds&) { return most; },
                 [&](std::size_t leaf, const Shift& t, double) {
                   if (!has(leaf, t))
                     limit_depths(m_points.bounds_of(leaf), t);
                 });
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool up : {false, true})
        m_least_depth[a][up] = *std::min_element(m_depths[a][up].begin(), m_depths[a][up].end());
  }

  // Returns true if nothing that is left touches the ball, which must be known.
  bool is_safe(const Empty_ball& ball) const
  {
    const Bounds b = ball.bounds(m_points.bounds().weight);
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool up : {false, true}) {
        const double depth = up ? b.high[a] - home().high[a] : home().low[a] - b.low[a];
        const auto is_safe = [&](std::size_t patch) { return depth < m_depths[a][up][patch]; };
        if (m_box.has_period(a) && depth > -slack() && !(depth < m_least_depth[a][up]) &&
            !visit_patches(a, b, is_safe))
          return false;
      }
    return true;
  }

  // Finds the copy of a leaf with the point that is deepest in a ball, of those that are left; if the ball
  // is not known, with the one nearest to the place v. Returns false if none touches it.
  bool find_deepest(const Empty_ball& ball, const double* v, Copy& copy) const
  {
    Shift first = {0, 0, 0}, last = {0, 0, 0};
    const Bounds b = ball.bounds(m_points.bounds().weight);
    for (std::size_t a = 0; a < 3; ++a) {
      const double period = m_box.period(a), reach = m_box.reach(a);
      if (!m_box.has_period(a))
        continue;
      const double low = ball.is_known() ? (b.low[a] - home().high[a]) / period : -reach,
                   high = ball.is_known() ? (b.high[a] - home().low[a]) / period : reach;
      first[a] = int((std::max)(std::floor(low), -reach));
      last[a] = int((std::min)(std::ceil(high), reach));
      if (last[a] < first[a])
        return false;
    }
    Search search{*this, ball, v};
    search({first, last, 1, m_points.bounds()});
    copy.leaf = search.copy.leaf;
    copy.shift = search.copy.shift;
    return search.least < std::numeric_limits<double>::infinity();
  }

private:
  static constexpr std::uint32_t all_bits = ~std::uint32_t(0);

  double slack() const { return 4 * m_box.rounding(); } // positions are off by less

  const Bounds& home() const { return m_points.bounds(); }

  static bool is_next_to_home(const Shift& t)
  {
    return std::abs(t[0]) < 2 && std::abs(t[1]) < 2 && std::abs(t[2]) < 2;
  }
  static std::uint32_t bit_of(const Shift& t)
  {
    return std::uint32_t(1) << (9 * t[0] + 3 * t[1] + t[2] + 13);
  }
  // Also those of the nodes above whose leaves all have them.
  void set_bits(std::size_t node, std::uint32_t bits)
  {
    m_next_to_home[node] |= bits;
    for (node /= 2; node > 0; node /= 2)
      m_next_to_home[node] |= m_next_to_home[2 * node] & m_next_to_home[2 * node + 1];
  }

  bool has(std::size_t leaf, const Shift& t) const
  {
    return has_all(m_points.node_of_leaf(leaf), t);
  }
  bool has_all(std::size_t node, const Shift& t) const
  {
    return is_next_to_home(t)
               ? (m_next_to_home[node] & bit_of(t)) != 0
               : m_points.is_leaf(node) && m_far.count({m_points.leaf(node), t}) != 0;
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

  // The patches of a side that are in the shadow of a box, until visit() returns false, as this then does,
  // too; what lies beside the side has the patches at its edges.
  template <class Visit>
  bool visit_patches(std::size_t axis, const Bounds& b, const Visit& visit) const
  {
    const std::size_t s = (axis + 1) % 3, t = (axis + 2) % 3;
    const auto patch = [&](std::size_t a, double x) {
      const double at =
          (x - home().low[a]) * double(m_patches) / (home().high[a] - home().low[a] + 1);
      return std::size_t((std::max)(0., (std::min)(at, double(m_patches - 1))));
    };
    for (std::size_t i = patch(s, b.low[s]), i_end = patch(s, b.high[s]); i <= i_end; ++i)
      for (std::size_t j = patch(t, b.low[t]), j_end = patch(t, b.high[t]); j <= j_end; ++j)
        if (!visit(i * m_patches + j))
          return false;
    return true;
  }

  // Lets the depths end before a copy, on the side from which it is farthest.
  void limit_depths(const Bounds& b, const Shift& t)
  {
    std::size_t axis = 3;
    double farthest = 0;
    Bounds moved;
    for (std::size_t a = 0; a < 3; ++a) {
      moved.low[a] = b.low[a] + t[a] * m_box.period(a) - slack();
      moved.high[a] = b.high[a] + t[a] * m_box.period(a) + slack();
      if (t[a] != 0 && (axis == 3 || gap(b, a, t[a]) > farthest)) {
        axis = a;
        farthest = gap(b, a, t[a]);
      }
    }
    visit_patches(axis, moved, [&](std::size_t patch) {
      double& depth = m_depths[axis][t[axis] > 0][patch];
      depth = (std::min)(depth, farthest - slack());
      return true;
    });
  }

  // Finds a copy of a point that is not inserted with the least power of a ball, or if that is not known
  // the least squared distance from a place. Copies are looked at by halves of shifts or of points,
  // whichever are much longer, those first that may have less.
  struct Search
  {
    // Copies of the points of a node, or of one point of a leaf, by shifts from `first` to `last`.
    struct Part
    {
      Shift first, last;
      std::size_t node;
      Bounds_of_points bounds;
      bool is_point = false;
    };

    const Leaves_of_box& leaves;
    const Empty_ball& ball;
    const double* place;
    double least = std::numeric_limits<double>::infinity();
    Copy copy = {};

    void operator()(const Part& part)
    {
      const Points_by_space& points = leaves.m_points;
      const std::size_t axis = longest_axis(part);
      const double shifts = length(part, axis);
      if (shifts == 0 && (part.first == Shift{0, 0, 0} || leaves.has_all(part.node, part.first)))
        return;
      if (part.is_point && shifts == 0) {
        least = value(part);
        copy.leaf = points.leaf(part.node);
        copy.shift = part.first;
      } else if (part.is_point || part.bounds.size() < 2 * shifts) {
        Part lower = part, upper = part;
        lower.last[axis] = part.first[axis] + (part.last[axis] - part.first[axis]) / 2;
        upper.first[axis] = lower.last[axis] + 1;
        descend(lower, upper);
      } else if (points.is_leaf(part.node)) {
        leaves.visit_points(points.leaf(part.node), [&](std::size_t i) {
          Part point = {part.first, part.last, part.node, {}, true};
          const Box& box = leaves.m_box;
          point.bounds.add(box.position(i, box.home(i)).data(), leaves.weight(i));
          if (value(point) < least)
            (*this)(point);
        });
      } else {
        Part lower = part, upper = part;
        lower.node = 2 * part.node;
        upper.node = lower.node + 1;
        lower.bounds = points.bounds(lower.node);
        upper.bounds = points.bounds(upper.node);
        descend(lower, upper);
      }
    }

    double length(const Part& part, std::size_t axis) const
    {
      return (part.last[axis] - part.first[axis]) * leaves.m_box.period(axis);
    }

    std::size_t longest_axis(const Part& part) const
    {
      std::size_t axis = 0;
      for (std::size_t a = 1; a < 3; ++a)
        if (length(part, a) > length(part, axis))
          axis = a;
      return axis;
    }

    // No more than that of any copy.
    double value(const Part& part) const
    {
      if (part.bounds.is_empty())
        return std::numeric_limits<double>::infinity();
      const auto from = leaves.m_box.moved_by(part.first), to = leaves.m_box.moved_by(part.last);
      Bounds_of_points b = part.bounds;
      for (std::size_t a = 0; a < 3; ++a) {
        b.low[a] += from[a];
        b.high[a] += to[a];
      }
      if (ball.is_known())
        return ball.least_power(b, b.weight);
      double square = 0;
      for (std::size_t a = 0; a < 3; ++a)
        square += std::pow((std::max)({0., b.low[a] - place[a], place[a] - b.high[a]}), 2);
      return square;
    }

    void descend(const Part& a, const Part& b)
    {
      const double of_a = value(a), of_b = value(b);
      if (of_b < of_a && of_b < least)
        (*this)(b);
      if (of_a < least)
        (*this)(a);
      if (!(of_b < of_a) && of_b < least)
        (*this)(b);
    }
  };

  double weight(std::size_t i) const { return Box::has_weight ? m_box.weight(i) : 0; }

  const Box& m_box;
  const Points_by_space m_points;
  std::vector<std::uint32_t> m_next_to_home; // for each node, a bit for each of 27 shifts
  std::set<std::pair<std::size_t, Shift>> m_far;
  std::vector<Copy> m_requested;
  const std::size_t m_patches;        // along an edge of home
  std::vector<double> m_depths[3][2]; // by axis, side and patch
  double m_least_depth[3][2] = {};
  std::vector<bool> m_is_left_out; // empty if no point is
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_LEAVES_OF_BOX_H
