// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_SIGNS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_SIGNS_H

// The stages of the compact kernel's predicates, each next to the sign that it must have. A stage
// may leave a sign open, and must never say a wrong one. A Place is that of a point with a weight,
// or of one without.

#include "exact_signs_of_points.h"
#include "fuzz_tally.h"
#include "hostile_weights.h" // Points, Weights

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/balanced_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

using namespace CGAL::Delaunay_from_surface_3;
using namespace CGAL::Delaunay_from_surface_3::internal;

using Record = std::array<double, 4>; // as wide as what the kernel loads
template <class Place>
using Places = std::array<Place, 4>;

// A cell, positively oriented; a point; and the vertices of its neighbours opposite to it.
struct Quintuple
{
  std::array<Record, 4> v;
  Record p;
  std::array<Record, 4> opposite;

  template <class Place>
  static Places<Place> places(const std::array<Record, 4>& r)
  {
    return {Place(r[0].data()), Place(r[1].data()), Place(r[2].data()), Place(r[3].data())};
  }
};

// Of nine points, in this order. Without weights the fourth number of a record must not matter.
inline Quintuple quintuple_of(const Points& points, const Weights& weights = {})
{
  const auto record = [&](std::size_t k) {
    return Record{points[k][0], points[k][1], points[k][2],
                  weights.empty() ? std::nan("") : weights[k]};
  };
  return {{record(0), record(1), record(2), record(3)},
          record(4),
          {record(5), record(6), record(7), record(8)}};
}

// Throws at the first wrong sign.
class Checked_signs
{
public:
  // `prefix` stands before the names of stages.
  explicit Checked_signs(Tally& tally, std::string prefix = "")
    : m_tally(tally)
    , m_prefix(std::move(prefix))
  {
  }

  // `said` is 0 where the stage leaves the sign open.
  void may_say(const std::string& stage, int said, int truth)
  {
    m_tally.count("stage: " + m_prefix + stage + (said == 0 ? ", open" : ", decided"));
    if (said != 0 && said != truth)
      fail(m_prefix + stage, said, truth);
  }

  void must_say(const std::string& stage, int said, int truth)
  {
    m_tally.count("stage: " + m_prefix + stage + (truth == 0 ? ", zero" : ", decided"));
    if (said != truth)
      fail(m_prefix + stage, said, truth);
  }

  void must_see(const std::string& stage, bool zero, int truth)
  {
    if (zero != (truth == 0))
      throw std::runtime_error(m_prefix + stage + (zero ? " sees a zero" : " misses a zero"));
  }

private:
  static void fail(const std::string& stage, int said, int truth)
  {
    throw std::runtime_error(stage + " says " + std::to_string(said) + ", the sign is " +
                             std::to_string(truth));
  }

  Tally& m_tally;
  std::string m_prefix;
};

// --- what they must say --------------------------------------------------------------------------

template <class Place>
int side_of_sphere(const Record& a, const Record& b, const Record& c, const Record& d,
                   const Record& p, bool is_perturbed)
{
  if constexpr (is_weighted<Place>)
    return side_of_power_sphere(a, b, c, d, p, is_perturbed);
  else
    return is_perturbed ? perturbed_side_of_sphere(a, b, c, d, p)
                        : exact_side_of_sphere(a, b, c, d, p);
}

template <class Place>
int side_of_circle(const Record& a, const Record& b, const Record& c, const Record& p,
                   bool is_perturbed)
{
  if constexpr (is_weighted<Place>)
    return side_of_power_circle(a, b, c, p, is_perturbed);
  else
    return is_perturbed ? perturbed_side_of_circle(a, b, c, p) : exact_side_of_circle(a, b, c, p);
}

inline std::string perturbed_or_not(int truth)
{
  return truth == 0 ? ", perturbed" : "";
}

// --- the stages ----------------------------------------------------------------------------------

template <class Filter, class Place>
void check_view(const std::string& name, const Quintuple& q, const Quintuple& own, int sphere,
                Checked_signs& signs)
{
  const Places<Place> v = Quintuple::places<Place>(q.v);
  const Cell_view view = Filter::view(v.data(), Place(q.p.data()));
  signs.may_say(name + " view, sphere", view.sphere, sphere);
  for (unsigned k = 0; k < 4; ++k)
    signs.may_say(name + " view, facets", certified_sign(view.facets[k], view.facet_bound),
                  exact_orientation(own.p, own.v[k ^ 1], own.v[k ^ 2], own.v[k ^ 3]));
}

template <class Place>
std::array<int, 4> signs_of_neighbors(const Quintuple& q)
{
  std::array<int, 4> signs;
  for (unsigned k = 0; k < 4; ++k) // oriented negatively
    signs[k] =
        -side_of_sphere<Place>(q.opposite[k], q.v[k ^ 1], q.v[k ^ 2], q.v[k ^ 3], q.p, false);
  return signs;
}

inline void check_neighbors(const std::string& name, const Sphere_signs& said,
                            const std::array<int, 4>& truth, Checked_signs& signs)
{
  if ((said.inside & said.outside) != 0)
    throw std::runtime_error(name + " says inside and outside");
  for (unsigned k = 0; k < 4; ++k)
    signs.may_say(name + " neighbours", int(said.inside >> k & 1) - int(said.outside >> k & 1),
                  truth[k]);
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
template <class Place>
CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS Sphere_signs wide_signs(const Quintuple& q)
{
  const Places<Place> v = Quintuple::places<Place>(q.v),
                      opposite = Quintuple::places<Place>(q.opposite);
  return Wide_sphere_filter::signs(v.data(), opposite.data(), Place(q.p.data()));
}
#endif

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
// Each width of integers that holds the numbers, also where a smaller one would do.
template <class Determinant, class Place>
void check_widths(const std::string& name, const Place* v, Place p, int truth, int perturbed_truth,
                  Checked_signs& signs)
{
  constexpr int n = Determinant::size;
  const auto check = [&](const std::string& width, const Exact_sign& said) {
    signs.must_see(name + width, said.is_perturbed, truth);
    signs.must_say(name + width + perturbed_or_not(truth), said.sign, perturbed_truth);
  };
  const Exact_differences<n, Place> exact_differences(v, p);
  const Integer_differences<n, Place> differences(exact_differences);
  if (!differences.can_be_scaled())
    return;
  Row<Fixed_integer<1>> half[n];
  Row<Fixed_integer<2>> one[n];
  Row<Fixed_integer<4>> two[n];
  if (differences.has_one_digit() && differences.has_half_a_digit() && differences.set_rows(half))
    check(", 30 bits", Determinant::sign(half, HALF_DIGIT, v, p));
  if (differences.has_one_digit() && differences.set_rows(one))
    check(", 60 bits", Determinant::sign(one, ONE_DIGIT, v, p));
  if (differences.set_rows(two))
    check(", 120 bits", Determinant::sign(two, TWO_DIGITS, v, p));
}
#endif

inline void check_exact(const std::string& name, const Exact_sign& said, int truth,
                        int perturbed_truth, Checked_signs& signs)
{
  signs.may_say(name + ", stage " + std::to_string(said.stage) + perturbed_or_not(truth), said.sign,
                perturbed_truth);
  if (said.sign != 0)
    signs.must_see(name, said.is_perturbed, truth);
}

// Doubles that round nothing, where the points are near each other on a lattice.
template <class Determinant, class Place>
void check_lattice(const std::string& name, const Quintuple& q, int truth, int perturbed_truth,
                   Checked_signs& signs)
{
  std::vector<double> coordinates, weights;
  for (const Record& r : {q.v[0], q.v[1], q.v[2], q.v[3], q.p}) {
    coordinates.insert(coordinates.end(), r.begin(), r.begin() + 3);
    weights.push_back(r[3]);
  }
  const Power_of_scale scaled(Point_array(coordinates.data(), 5), nullptr,
                              is_weighted<Place> ? weights.data() : nullptr);
  const auto scale = [&scaled](Record& r) {
    const auto p = scaled(r.data());
    r = {p[0], p[1], p[2], is_weighted<Place> ? scaled.weight(r[3]) : r[3]};
  };
  Quintuple on_lattice = q;
  for (Record& r : on_lattice.v)
    scale(r);
  scale(on_lattice.p);
  const Places<Place> v = Quintuple::places<Place>(on_lattice.v);
  const Exact_sign said =
      lattice_sign<Determinant>(v.data(), Place(on_lattice.p.data()), scaled.exact_size());
  check_exact(name + ", lattice", said, truth, perturbed_truth, signs);
}

// Balanced rows, also where nothing is to be gained by them.
template <int N, class Place>
void check_balanced(const std::string& name, const Place* v, Place p, int truth,
                    Checked_signs& signs)
{
  const Balanced_signs<N, Place> balanced(v, p);
  using Portable = Bounded_double_doubles<Portable_products>;
  signs.may_say(name + ", balanced doubles", balanced.template sign<Bounded_doubles>(), truth);
  signs.may_say(name + ", balanced double doubles", balanced.template sign<Portable>(), truth);
  signs.may_say(name + ", balanced double doubles", balanced.in_double_doubles(), truth);
}

template <class Place>
bool is_vertex(const Quintuple& q, std::size_t n)
{
  for (std::size_t k = 0; k < n; ++k)
    if (std::equal(q.p.begin(), q.p.begin() + 3 + is_weighted<Place>, q.v[k].begin()))
      return true;
  return false;
}

// The first filters of a cell that is positively oriented. `own` are the points and weights before
// they were scaled, which may have rounded some.
template <class Place>
void check_first_filters(const Quintuple& q, const Quintuple& own, Checked_signs& signs)
{
  const int sphere = side_of_sphere<Place>(own.v[0], own.v[1], own.v[2], own.v[3], own.p, false);
  const Places<Place> v = Quintuple::places<Place>(q.v),
                      opposite = Quintuple::places<Place>(q.opposite);
  const Place p(q.p.data());
  signs.may_say("first filter", sphere_sign(row(v[0], p), row(v[1], p), row(v[2], p), row(v[3], p)),
                sphere);
  signs.may_say("by columns", sphere_sign_by_columns(v.data(), p), sphere);
  signs.may_say("first filter, beyond", beyond_sign(row(v[0], p), row(v[1], p), row(v[2], p)),
                exact_orientation(own.v[0], own.v[1], own.v[2], own.p));
  check_view<Sphere_filter, Place>("scalar", q, own, sphere, signs);
  const std::array<int, 4> neighbors = signs_of_neighbors<Place>(own);
  check_neighbors("scalar", Sphere_filter::neighbors(v.data(), opposite.data(), p, 15), neighbors,
                  signs);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  if (machine_has_vectors()) {
    check_view<Wide_sphere_filter, Place>("wide", q, own, sphere, signs);
    check_neighbors("wide", wide_signs<Place>(q), neighbors, signs);
    signs.may_say("wide, by columns", wide_sphere_sign_by_columns(v.data(), p), sphere);
  }
#endif
}

template <class Place>
void check_rounded_cell(Quintuple q, Quintuple own, Checked_signs& signs)
{
  const int orientation = exact_orientation(own.v[0], own.v[1], own.v[2], own.v[3]);
  if (orientation < 0) {
    std::swap(q.v[0], q.v[1]);
    std::swap(own.v[0], own.v[1]);
  }
  if (orientation != 0)
    check_first_filters<Place>(q, own, signs);
}

template <class Place = const double*>
void check_cell(Quintuple q, Checked_signs& signs)
{
  const int orientation = exact_orientation(q.v[0], q.v[1], q.v[2], q.v[3]);
  if (orientation == 0)
    return;
  if (orientation < 0)
    std::swap(q.v[0], q.v[1]);
  check_first_filters<Place>(q, q, signs);
  if (is_vertex<Place>(q, 4)) // found before any exact stage is asked
    return;
  const int sphere = side_of_sphere<Place>(q.v[0], q.v[1], q.v[2], q.v[3], q.p, false),
            perturbed = side_of_sphere<Place>(q.v[0], q.v[1], q.v[2], q.v[3], q.p, true);
  const Places<Place> v = Quintuple::places<Place>(q.v);
  const Place p(q.p.data());
  const Exact_differences<4, Place> differences(v.data(), p);
  signs.may_say("portable double doubles", close_sphere_sign_with<Portable_products>(differences),
                sphere);
  signs.may_say("double doubles", close_sphere_sign(differences), sphere);
  check_balanced<4>("sphere", v.data(), p, sphere, signs);
  check_exact("exact sphere", exact_sign<Exact_sphere>(v.data(), p), sphere, perturbed, signs);
  check_exact("any width, sphere", wide_sign<Exact_sphere>(v.data(), p), sphere, perturbed, signs);
  check_lattice<Exact_sphere, Place>("sphere", q, sphere, perturbed, signs);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  check_widths<Exact_sphere>("sphere", v.data(), p, sphere, perturbed, signs);
#endif
}

// The first three vertices as a facet of the convex hull.
template <class Place = const double*>
void check_infinite_cell(const Quintuple& q, Checked_signs& signs)
{
  if (is_vertex<Place>(q, 3) || are_collinear(q.v[0], q.v[1], q.v[2]))
    return;
  const Places<Place> v = Quintuple::places<Place>(q.v);
  const Place p(q.p.data());
  const int height = exact_orientation(q.v[0], q.v[1], q.v[2], q.p);
  const auto circle_or_height = [&](bool is_perturbed) {
    return height != 0 ? height : side_of_circle<Place>(q.v[0], q.v[1], q.v[2], q.p, is_perturbed);
  };
  const int circle = circle_or_height(false), perturbed = circle_or_height(true);
  signs.may_say("first filter, beyond", beyond_sign(row(v[0], p), row(v[1], p), row(v[2], p)),
                height);
  signs.may_say("beyond by columns", beyond_sign_by_columns(v.data(), p), height);
  signs.may_say("flat beyond", flat_beyond_sign(v.data(), p), circle);
  check_balanced<3>("height", v.data(), p, -height, signs);
  check_exact("exact beyond", exact_sign<Exact_beyond>(v.data(), p), circle, perturbed, signs);
  check_exact("any width, beyond", wide_sign<Exact_beyond>(v.data(), p), circle, perturbed, signs);
  check_lattice<Exact_beyond, Place>("beyond", q, circle, perturbed, signs);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  check_widths<Exact_beyond>("beyond", v.data(), p, circle, perturbed, signs);
#endif
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_SIGNS_H
