// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_COPY_SIGNS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_COPY_SIGNS_H

// The predicates of copies of points in a periodic box (Copy_vertex.h), and what a ball may touch
// (Empty_ball.h), next to rational numbers.

#include "exact_signs_of_points.h"
#include "fuzz_tally.h"
#include "random_bits.h"

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Box_of_points.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Empty_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

using Rational = CGAL::Exact_rational;
using Exact_record = std::array<Rational, 4>; // with the weight

template <bool W>
class Copies_of_points
{
  using Place = CGAL::Delaunay_from_surface_3::core::Rounded_place<W>;
  using Exact_place = CGAL::Delaunay_from_surface_3::core::Copy_place<W>;
  static constexpr std::size_t number = 9;

public:
  Copies_of_points(Random& r, Tally& tally)
    : m_random(r)
    , m_tally(tally)
  {
    make_points();
  }

  // What is wrong.
  std::string mistake()
  {
    namespace core = CGAL::Delaunay_from_surface_3::core;
    const core::Box_of_points<W> box(core::Point_array(m_points[0].data(), m_points.size()),
                                     W ? m_weights.data() : nullptr, m_box.data());
    m_rounding = box.rounding();
    auto copies = box.copies();
    for (std::size_t k = 0; k < number; ++k)
      copies.copies.push_back({core::Id(k),
                               {std::int16_t(m_shifts[k][0]), std::int16_t(m_shifts[k][1]),
                                std::int16_t(m_shifts[k][2])},
                               false});
    for (std::size_t k = 0; k < number; ++k) {
      const Exact_place e = copies.place(k);
      m_exact[k] = {Rational(e.point[0]), Rational(e.point[1]), Rational(e.point[2]),
                    W ? Rational(e.point[3 * W]) : Rational(0)};
      for (std::size_t a = 0; a < 3; ++a)
        m_exact[k][a] += Rational(double(m_shifts[k][a])) * Rational(e.periods->lengths[a]);
      const auto p = box.position(k, {m_shifts[k][0], m_shifts[k][1], m_shifts[k][2]});
      m_rounded[k] = {p[0], p[1], p[2], W ? box.weight(k) : std::nan("")};
      if (e.periods->are_scaled)
        for (std::size_t a = 0; a < 3; ++a)
          if (abs(m_exact[k][a] - Rational(p[a])) > 16)
            return "a copy is rounded by more than 2^4";
    }
    m_are_scaled = copies.place(0).periods->are_scaled;
    std::string wrong = mistake_in_order(copies);
    if (wrong.empty())
      wrong = mistake_in_signs(copies);
    return wrong;
  }

private:
  // One of few, so that ties are frequent, with noise of any size, or none.
  double coordinate(double period)
  {
    double x = period * m_random.between(0, m_side) / m_side;
    if (m_random.one_in(3))
      x += std::ldexp(m_random.signed_unit() * period, m_noise);
    if (m_random.one_in(6))
      x = std::nextafter(x, m_random.one_in(2) ? 1e300 : -1e300);
    if (m_random.one_in(8))
      x = std::ldexp(m_random.signed_unit() * period,
                     -m_random.between(1, m_random.one_in(3) ? 1070 : 100));
    return x;
  }

  void make_points()
  {
    m_side = m_random.between(1, 5);
    m_noise = m_random.one_in(2) ? -m_random.between(40, 60) : -m_random.between(1, 200);
    const double size = m_random.one_in(6) ? std::ldexp(1., m_random.between(-1000, 980)) : 1;
    const double first = m_random.one_in(2) ? 1 : .5 + m_random.unit();
    for (double& L : m_box)
      L = size * (m_random.one_in(2)   ? first
                  : m_random.one_in(2) ? .5 + m_random.unit()
                                       : 3 * first);
    if (m_random.one_in(20))
      m_box[m_random.below(3)] *= 1000;
    const int most = m_random.one_in(3) ? 1 : m_random.one_in(2) ? 3 : 10000;
    m_points.resize(number);
    m_shifts.resize(number);
    const bool is_lifted = m_random.one_in(2);
    for (std::size_t k = 0; k < number; ++k) {
      for (std::size_t a = 0; a < 3; ++a) {
        m_points[k][a] = coordinate(m_box[a]);
        const double diagonal = std::hypot(std::hypot(m_box[0], m_box[1]), m_box[2]);
        const int reach = (std::min)(most, int(diagonal / m_box[a]) + 2);
        m_shifts[k][a] = m_random.between(-reach, reach);
      }
      if (k > 0 && m_random.one_in(6))
        m_points[k] = m_points[m_random.below(k)];
      if (k > 0 && m_random.one_in(4))
        m_shifts[k] = m_shifts[m_random.below(k)];
      if (W) {
        const double L = m_box[0];
        const bool is_usual = std::abs(std::log2(size)) < 400;
        m_weights.push_back(!is_usual   ? 0
                            : is_lifted ? L * L * m_random.between(0, 3) / 4
                            : m_random.one_in(2)
                                ? L * L * m_random.unit()
                                : L * L * std::ldexp(m_random.unit(), m_random.between(-80, 4)));
      }
    }
  }

  static int sign(const Rational& x) { return (x > 0) - (x < 0); }

  std::string
  mistake_in_order(const CGAL::Delaunay_from_surface_3::core::Periodic_copies<W>& copies)
  {
    namespace core = CGAL::Delaunay_from_surface_3::core;
    for (std::size_t j = 0; j < number; ++j)
      for (std::size_t k = 0; k < number; ++k) {
        const Exact_place v = copies.place(j), p = copies.place(k);
        for (std::size_t a = 0; a < 3; ++a) {
          const Rational truth = m_exact[j][a] - m_exact[k][a];
          if (core::sign_of_difference(v, p, a) != sign(truth))
            return "a wrong sign of a difference";
          const core::Periodic_difference d(v, p, a);
          m_tally.count(d.is_exact ? "differences: two doubles" : "differences: more");
          if (!m_are_scaled)
            continue;
          const Rational said = Rational(d.high) + Rational(d.low);
          if (d.is_exact ? said != truth
                         : abs(said - truth) * Rational(0x1p104) > abs(Rational(d.high)))
            return d.is_exact ? "a difference is not exact" : "a difference is too wrong";
        }
        const bool is_less = std::lexicographical_compare(
            m_exact[j].begin(), m_exact[j].begin() + 3, m_exact[k].begin(), m_exact[k].begin() + 3);
        if (core::is_lexicographically_less(v, p) != is_less)
          return "a wrong order";
        if (core::are_equal(v, p) != (m_exact[j] == m_exact[k]))
          return "wrong about equal copies";
      }
    return "";
  }

  int sphere(std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t p,
             bool is_perturbed) const
  {
    const Exact_record &u = m_exact[a], &v = m_exact[b], &w = m_exact[c], &x = m_exact[d],
                       &y = m_exact[p];
    if (W)
      return side_of_power_sphere(u, v, w, x, y, is_perturbed);
    return is_perturbed ? perturbed_side_of_sphere(u, v, w, x, y)
                        : exact_side_of_sphere(u, v, w, x, y);
  }
  int circle(std::size_t a, std::size_t b, std::size_t c, std::size_t p, bool is_perturbed) const
  {
    const Exact_record &u = m_exact[a], &v = m_exact[b], &w = m_exact[c], &y = m_exact[p];
    if (W)
      return side_of_power_circle(u, v, w, y, is_perturbed);
    return is_perturbed ? perturbed_side_of_circle(u, v, w, y) : exact_side_of_circle(u, v, w, y);
  }

  std::string
  mistake_in_signs(const CGAL::Delaunay_from_surface_3::core::Periodic_copies<W>& copies)
  {
    namespace core = CGAL::Delaunay_from_surface_3::core;
    std::array<std::size_t, 4> v = {0, 1, 2, 3};
    const std::size_t p = 4;
    const auto at = [&](std::size_t k) { return copies.place(k); };
    const auto position = [&](std::size_t k) { return core::position_of(copies.place(k)); };
    const auto rounded = [&](std::size_t k) { return Place(m_rounded[k].data()); };
    const int orientation = exact_orientation(m_exact[0], m_exact[1], m_exact[2], m_exact[3]);
    if (core::orientation(position(0), position(1), position(2), position(3)) != orientation)
      return "a wrong orientation";
    if (core::are_collinear(position(0), position(1), position(2)) !=
        are_collinear(m_exact[0], m_exact[1], m_exact[2]))
      return "wrong about three on a line";
    const std::string wrong = mistake_beyond(copies);
    if (!wrong.empty() || orientation == 0)
      return wrong;
    if (orientation < 0)
      std::swap(v[0], v[1]);
    const Place places[4] = {rounded(v[0]), rounded(v[1]), rounded(v[2]), rounded(v[3])};
    const Exact_place exact[4] = {at(v[0]), at(v[1]), at(v[2]), at(v[3])};
    const int truth = sphere(v[0], v[1], v[2], v[3], p, false);
    const auto may_be = [](int said, int truth) { return said == 0 || said == truth; };
    const int first = core::sphere_sign(row(places[0], rounded(p)), row(places[1], rounded(p)),
                                        row(places[2], rounded(p)), row(places[3], rounded(p)));
    m_tally.count(first == 0 ? "first filter: open" : "first filter: decided");
    if (!may_be(first, truth))
      return "the first filter is wrong";
    if (!is_view_right(core::Sphere_filter::view(places, rounded(p)), v, p, truth))
      return "a view is wrong";
    const Place opposite[4] = {rounded(5), rounded(6), rounded(7), rounded(8)};
    if (!are_neighbors_right(core::Sphere_filter::neighbors(places, opposite, rounded(p), 15), v,
                             p))
      return "the filter of neighbours is wrong";
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (core::machine_has_vectors()) {
      if (!is_view_right(core::Wide_sphere_filter::view(places, rounded(p)), v, p, truth))
        return "a wide view is wrong";
      if (!are_neighbors_right(wide_signs(places, opposite, rounded(p)), v, p))
        return "the wide filter of neighbours is wrong";
    }
#endif
    bool is_vertex = false;
    for (std::size_t k = 0; k < 4; ++k)
      is_vertex = is_vertex || m_exact[k] == m_exact[p];
    if (!is_vertex) {
      const core::Exact_sign said = core::exact_sign<core::Exact_sphere>(exact, at(p));
      m_tally.count("sphere: stage " + std::to_string(said.stage) +
                    (said.is_perturbed ? ", perturbed" : ""));
      if (said.is_perturbed != (truth == 0) || said.sign != sphere(v[0], v[1], v[2], v[3], p, true))
        return "an exact sphere is wrong";
    }
    return mistake_in_ball(places, exact, v);
  }

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static CGAL::Delaunay_from_surface_3::core::Sphere_signs
  wide_signs(const Place* places, const Place* opposite, Place p)
  {
    return CGAL::Delaunay_from_surface_3::core::Wide_sphere_filter::signs(places, opposite, p);
  }
#endif

  bool is_view_right(const CGAL::Delaunay_from_surface_3::core::Cell_view& view,
                     const std::array<std::size_t, 4>& v, std::size_t p, int truth) const
  {
    bool is_right = view.sphere == 0 || view.sphere == truth;
    for (unsigned k = 0; k < 4; ++k) {
      const int said =
          CGAL::Delaunay_from_surface_3::core::certified_sign(view.facets[k], view.facet_bound);
      is_right = is_right &&
                 (said == 0 || said == exact_orientation(m_exact[p], m_exact[v[k ^ 1]],
                                                         m_exact[v[k ^ 2]], m_exact[v[k ^ 3]]));
    }
    return is_right;
  }

  bool are_neighbors_right(const CGAL::Delaunay_from_surface_3::core::Sphere_signs& said,
                           const std::array<std::size_t, 4>& v, std::size_t p) const
  {
    for (unsigned k = 0; k < 4; ++k) {
      const int sign = int(said.inside >> k & 1) - int(said.outside >> k & 1);
      if (sign != 0 && sign != -sphere(5 + k, v[k ^ 1], v[k ^ 2], v[k ^ 3], p, false))
        return false;
    }
    return true;
  }

  std::string mistake_beyond(const CGAL::Delaunay_from_surface_3::core::Periodic_copies<W>& copies)
  {
    namespace core = CGAL::Delaunay_from_surface_3::core;
    if (are_collinear(m_exact[0], m_exact[1], m_exact[2]))
      return "";
    const std::size_t p = 4;
    const int height = exact_orientation(m_exact[0], m_exact[1], m_exact[2], m_exact[p]);
    const auto rounded = [&](std::size_t k) { return Place(m_rounded[k].data()); };
    const int first = core::beyond_sign(row(rounded(0), rounded(p)), row(rounded(1), rounded(p)),
                                        row(rounded(2), rounded(p)));
    if (first != 0 && first != height)
      return "the first filter of facets is wrong";
    for (std::size_t k = 0; k < 3; ++k)
      if (m_exact[k] == m_exact[p])
        return "";
    const int truth = height != 0 ? height : circle(0, 1, 2, p, false);
    const int perturbed = height != 0 ? height : circle(0, 1, 2, p, true);
    const Exact_place v[3] = {copies.place(0), copies.place(1), copies.place(2)};
    const core::Exact_sign said = core::exact_sign<core::Exact_beyond>(v, copies.place(p));
    if (said.sign != perturbed || said.is_perturbed != (truth == 0))
      return "an exact test beyond is wrong";
    return "";
  }

  // Boxes around the copies, and that of the ball, must not leave out one that is in it.
  std::string mistake_in_ball(const Place* places, const Exact_place* exact,
                              const std::array<std::size_t, 4>& v)
  {
    namespace core = CGAL::Delaunay_from_surface_3::core;
    const core::Empty_ball ball(places, exact, m_rounding);
    m_tally.count(ball.is_known() ? "balls: known" : "balls: unknown");
    if (!ball.is_known())
      return "";
    for (std::size_t p = 0; p < number; ++p) {
      if (sphere(v[0], v[1], v[2], v[3], p, false) < 0)
        continue; // outside
      double weight = W ? m_rounded[p][3] : 0;
      for (const bool is_alone : {true, false}) {
        core::Bounds bounds;
        bounds.add(m_rounded[p].data());
        if (!is_alone) { // with another
          const std::size_t other = m_random.below(number);
          bounds.add(m_rounded[other].data());
          if (W)
            weight = (std::max)(weight, m_rounded[other][3]);
        }
        if (!(ball.least_power(bounds, weight) < 1e308))
          return "a ball leaves out a point in it";
        const core::Bounds of_ball = ball.bounds(weight);
        for (std::size_t a = 0; a < 3; ++a)
          if (of_ball.low[a] > m_rounded[p][a] || of_ball.high[a] < m_rounded[p][a])
            return "the bounds of a ball leave out a point in it";
      }
    }
    if (!m_are_scaled)
      return "";
    const double radius = ball.radius();
    if (radius < 1e200) { // an edge is no longer than two radii
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          Rational square = 0;
          for (std::size_t a = 0; a < 3; ++a)
            square += (m_exact[v[j]][a] - m_exact[v[k]][a]) * (m_exact[v[j]][a] - m_exact[v[k]][a]);
          if (square > 4 * Rational(radius) * Rational(radius))
            return "an edge is longer than two radii";
        }
    }
    return "";
  }

  Random& m_random;
  Tally& m_tally;
  int m_side = 1, m_noise = 0;
  bool m_are_scaled = true;
  std::array<double, 3> m_box;
  double m_rounding = 0;
  std::vector<std::array<double, 3>> m_points;
  std::vector<double> m_weights;
  std::vector<std::array<int, 3>> m_shifts;
  std::array<Exact_record, number> m_exact;
  std::array<std::array<double, 4>, number> m_rounded;
};

inline std::string mistake_in_copies(std::uint64_t seed, Tally& tally)
{
  Random r(seed);
  return r.one_in(2) ? Copies_of_points<false>(r, tally).mistake()
                     : Copies_of_points<true>(r, tally).mistake();
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_COPY_SIGNS_H
