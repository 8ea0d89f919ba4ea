// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_BOX_OF_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_BOX_OF_POINTS_H

// Points in a periodic box, and copies of them, as the kernel sees them (Copy_vertex.h).

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Shift = std::array<int, 3>; // by how many periods

inline Shift sum(const Shift& s, const Shift& t)
{
  return {s[0] + t[0], s[1] + t[1], s[2] + t[2]};
}

// The points at home, in the box. Where they fit into one period as they are, not far from the origin,
// home is where they are; else they are wrapped: their coordinates become what is left of a division,
// which is exact, and home is one period further for those that are negative.
template <bool has_weight_>
class Box_of_points
{
public:
  static constexpr bool has_weight = has_weight_;
  static constexpr std::size_t size = has_weight ? 4 : 3; // of a point
  using Copies = Periodic_copies<has_weight>;

  // For the arguments see build_in_box().
  Box_of_points(const Point_array& points, const double* weights, const double* box)
    : m_number_of_points(points.size())
  {
    m_points.reserve(size * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_points.insert(m_points.end(), points[i], points[i] + 3);
      if (has_weight)
        m_points.push_back(weights[i]);
    }
    double diagonal = 0, shortest = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < 3; ++a) {
      if (!(box[a] > 0))
        refuse(a, "is not positive");
      if (!is_finite_number(box[a]))
        continue; // none
      m_periods.lengths[a] = box[a];
      shortest = (std::min)(shortest, box[a]);
      diagonal = std::hypot(diagonal, box[a]);
    }
    for (std::size_t a = 0; a < 3; ++a)
      if (has_period(a)) {
        wrap(a, shortest);
        if (!(diagonal / box[a] < 10000))
          refuse(a, "is less than 1/10000 of the diagonal of the box");
        m_reach[a] = int(std::ceil(diagonal / box[a])) + 1;
      }
    for (std::size_t i = 0; i < m_number_of_points; ++i)
      for (std::size_t a = 0; a < 3; ++a)
        if (!has_period(a) && !(std::abs(m_points[size * i + a]) / too_many_periods < shortest))
          refuse_far(a, i);
    scale(weights, diagonal);
  }

  std::size_t number_of_points() const { return m_number_of_points; }
  bool has_period(std::size_t axis) const { return m_periods.lengths[axis] > 0; }
  double period(std::size_t axis) const { return m_scaled_periods[axis]; } // scaled, or 0

  // A power of 2; differences of scaled and rounded coordinates are off by no more.
  double rounding() const { return m_rounding; }

  double shortest_period() const
  {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < 3; ++a)
      if (has_period(a))
        shortest = (std::min)(shortest, period(a));
    return shortest;
  }

  // How many periods copies are away from home, at most, that matter: see Periodic_triangulation.h.
  int reach(std::size_t axis) const { return m_reach[axis]; }

  // How far home is from the coordinates, and from the user's point.
  Shift home(std::size_t i) const
  {
    return m_is_moved.empty()
               ? Shift{0, 0, 0}
               : Shift{m_is_moved[i] & 1, m_is_moved[i] >> 1 & 1, m_is_moved[i] >> 2};
  }
  std::vector<std::array<std::int32_t, 3>> home_from_user() const
  {
    std::vector<std::array<std::int32_t, 3>> home;
    if (m_wraps.empty())
      return home;
    home.reserve(m_number_of_points);
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      const Shift moved = this->home(i);
      home.push_back(
          {moved[0] - m_wraps[i][0], moved[1] - m_wraps[i][1], moved[2] - m_wraps[i][2]});
    }
    return home;
  }

  // A copy of a point, scaled and rounded.
  std::array<double, 3> position(std::size_t i, const Shift& shift) const
  {
    std::array<double, 3> p;
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = m_points[size * i + a];
      p[a] = shift[a] == 0 ? x : std::fma(double(shift[a]), m_periods.lengths[a], x);
    }
    return m_periods.are_scaled ? p : m_scaled(p.data());
  }
  double weight(std::size_t i) const // scaled
  {
    const double w = m_points[size * i + size - 1];
    return m_periods.are_scaled ? w : m_scaled.weight(w);
  }
  std::array<double, 3> moved_by(const Shift& t) const
  {
    return {t[0] * m_scaled_periods[0], t[1] * m_scaled_periods[1], t[2] * m_scaled_periods[2]};
  }

  // The copy of a point by a shift from home.
  Periodic_copy copy(std::size_t i, const Shift& shift) const
  {
    const Shift by = sum(home(i), shift);
    return {Id(i),
            {std::int16_t(by[0]), std::int16_t(by[1]), std::int16_t(by[2])},
            shift == Shift{0, 0, 0}};
  }
  std::array<double, 3> position(const Periodic_copy& c) const
  {
    return position(c.point, {c.shift[0], c.shift[1], c.shift[2]});
  }

  // No copies, yet.
  Copies copies() const { return {m_points.data(), &m_periods, {}}; }

private:
  [[noreturn]] static void refuse(std::size_t axis, const std::string& reason)
  {
    throw Surface_input_error(std::string("box: the period along ") + "xyz"[axis] + " " + reason);
  }

  [[noreturn]] static void refuse_far(std::size_t axis, std::size_t i)
  {
    throw Surface_input_error(std::string("box: the ") + "xyz"[axis] + " coordinate of point " +
                              std::to_string(i) +
                              ", along an axis without a period, is 2^29 times " +
                              "the shortest period; remedy: move the points towards 0");
  }

  void wrap(std::size_t axis, double shortest_period)
  {
    const double period = m_periods.lengths[axis];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      low = (std::min)(low, m_points[size * i + axis]);
      high = (std::max)(high, m_points[size * i + axis]);
    }
    const double farthest = (std::max)(std::abs(low), std::abs(high));
    if (!(high - low >= period) && !(farthest >= 0x1p20 * shortest_period))
      return;
    m_wraps.resize(m_number_of_points);
    m_is_moved.resize(m_number_of_points);
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      double& x = m_points[size * i + axis];
      const double by = core::wrap(x, period);
      if (!(std::abs(by) < too_many_periods))
        refuse(axis, "is so small that point " + std::to_string(i) + " is 2^29 of them away");
      m_wraps[i][axis] = std::int32_t(by);
      m_is_moved[i] = std::uint8_t(m_is_moved[i] | unsigned(x < 0) << axis);
    }
  }

  // Scales all by a power of 2, so that copies within reach are at most 2^58 away; if that rounds any,
  // the points stay as they are.
  void scale(const double* weights, double diagonal)
  {
    double longest = 0, farthest = 0, least = (std::numeric_limits<double>::max)();
    const auto look_at = [&least](double x) { least = x > 0 ? (std::min)(least, x) : least; };
    for (const double length : m_periods.lengths) {
      longest = (std::max)(longest, length);
      look_at(length);
    }
    for (std::size_t i = 0; i < m_number_of_points; ++i)
      for (std::size_t a = 0; a < 3; ++a) {
        const double x = std::abs(m_points[size * i + a]);
        farthest = (std::max)(farthest, x);
        look_at(x);
      }
    const double largest = farthest + diagonal + 4 * longest;
    if (!is_finite_number(largest))
      throw Surface_input_error("box: copies of the points would have infinite coordinates");
    m_scaled = Power_of_scale(largest, least, weights, has_weight ? m_number_of_points : 0);
    m_periods.are_scaled = m_scaled.is_exact();
    const double farthest_place[3] = {largest, 0, 0};
    int exponent = 0;
    std::frexp(m_scaled(farthest_place)[0], &exponent);
    m_rounding = std::ldexp(1, exponent - 52);
    const auto scaled = m_scaled(m_periods.lengths);
    std::copy(scaled.begin(), scaled.end(), m_scaled_periods);
    if (!m_periods.are_scaled)
      return;
    std::copy(scaled.begin(), scaled.end(), m_periods.lengths);
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      const auto p = m_scaled(&m_points[size * i]);
      std::copy(p.begin(), p.end(), &m_points[size * i]);
      if (has_weight)
        m_points[size * i + 3] = m_scaled.weight(m_points[size * i + 3]);
    }
  }

  std::size_t m_number_of_points;
  std::vector<double> m_points; // wrapped, and scaled if that is exact
  Periods m_periods = {};
  double m_scaled_periods[3] = {};
  Power_of_scale m_scaled{0, 1};
  double m_rounding = 0;
  int m_reach[3] = {};
  std::vector<std::array<std::int32_t, 3>> m_wraps; // by how many periods; empty if by none
  std::vector<std::uint8_t> m_is_moved; // a bit for each axis along which home is 1 further
};

// Copies of the points as a source of points: those to begin with.
template <class Box>
class Source_of_copies final : public Point_source
{
public:
  explicit Source_of_copies(const Box& box)
    : m_box(box)
    , m_copies(box.copies())
  {
    m_copies.copies.reserve(box.number_of_points() + box.number_of_points() / 2);
  }

  // Adds the copy of a point by a shift from home.
  void add(std::size_t i, const Shift& shift) { m_copies.copies.push_back(m_box.copy(i, shift)); }

  Point_array points() override
  {
    const auto& copies = m_copies.copies;
    if (m_positions.empty()) {
      m_positions.reserve(3 * copies.size());
      for (const Periodic_copy& c : copies) {
        const auto p = m_box.position(c);
        m_positions.insert(m_positions.end(), p.begin(), p.end());
      }
    }
    return Point_array(m_positions.data(), copies.size());
  }
  void give_up() override { std::vector<double>().swap(m_positions); }
  double weight(std::size_t k) const { return m_box.weight(m_copies.copies[k].point); }
  const typename Box::Copies& copies() const { return m_copies; }

private:
  const Box& m_box;
  typename Box::Copies m_copies;
  std::vector<double> m_positions;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_BOX_OF_POINTS_H
