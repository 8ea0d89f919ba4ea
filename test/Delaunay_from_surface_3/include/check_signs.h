// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_SIGNS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_SIGNS_H

// The stages of the compact kernel's predicates, each next to the sign that it must have. A stage
// may leave a sign open, and must never say a wrong one.

#include "exact_signs_of_points.h"
#include "fuzz_tally.h"
#include "hostile_numbers.h" // Points

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/balanced_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace fuzz {

using namespace CGAL::Delaunay_from_surface_3;
using namespace CGAL::Delaunay_from_surface_3::internal;

using Record = std::array<double, 4>; // as wide as what the kernel loads
using Pointers = std::array<const double*, 4>;

// A cell, positively oriented; a point; and the vertices of its neighbours opposite to it.
struct Quintuple
{
  std::array<Record, 4> v;
  Record p;
  std::array<Record, 4> opposite;

  static Pointers pointers(const std::array<Record, 4>& r)
  {
    return {r[0].data(), r[1].data(), r[2].data(), r[3].data()};
  }
};

// Of nine points, in this order. The fourth number of a record must not matter.
inline Quintuple quintuple_of(const Points& points)
{
  const auto record = [&](std::size_t k) {
    return Record{points[k][0], points[k][1], points[k][2], std::nan("")};
  };
  return {{record(0), record(1), record(2), record(3)},
          record(4),
          {record(5), record(6), record(7), record(8)}};
}

// Throws at the first wrong sign.
class Checked_signs
{
public:
  explicit Checked_signs(Tally& tally)
    : m_tally(tally)
  {
  }

  // `said` is 0 where the stage leaves the sign open.
  void may_say(const std::string& stage, int said, int truth)
  {
    m_tally.count("stage: " + stage + (said == 0 ? ", open" : ", decided"));
    if (said != 0 && said != truth)
      fail(stage, said, truth);
  }

  void must_say(const std::string& stage, int said, int truth)
  {
    m_tally.count("stage: " + stage + (truth == 0 ? ", zero" : ", decided"));
    if (said != truth)
      fail(stage, said, truth);
  }

private:
  static void fail(const std::string& stage, int said, int truth)
  {
    throw std::runtime_error(stage + " says " + std::to_string(said) + ", the sign is " +
                             std::to_string(truth));
  }

  Tally& m_tally;
};

// --- the stages ----------------------------------------------------------------------------------

template <class Filter>
void check_view(const std::string& name, const Quintuple& q, int sphere, Checked_signs& signs)
{
  const Pointers v = Quintuple::pointers(q.v);
  const Cell_view view = Filter::view(v.data(), q.p.data());
  signs.may_say(name + " view, sphere", view.sphere, sphere);
  for (unsigned k = 0; k < 4; ++k)
    signs.may_say(name + " view, facets", certified_sign(view.facets[k], view.facet_bound),
                  exact_orientation(q.p, q.v[k ^ 1], q.v[k ^ 2], q.v[k ^ 3]));
}

inline std::array<int, 4> signs_of_neighbors(const Quintuple& q)
{
  std::array<int, 4> signs;
  for (unsigned k = 0; k < 4; ++k) // oriented negatively
    signs[k] = -exact_side_of_sphere(q.opposite[k], q.v[k ^ 1], q.v[k ^ 2], q.v[k ^ 3], q.p);
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
CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS inline Sphere_signs wide_signs(const Quintuple& q)
{
  const Pointers v = Quintuple::pointers(q.v), opposite = Quintuple::pointers(q.opposite);
  return Wide_sphere_filter::signs(v.data(), opposite.data(), q.p.data());
}
#endif

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
// Each width of integers that holds the numbers, also where a smaller one would do.
template <class Determinant>
void check_widths(const std::string& name, const double* const* v, const double* p, int truth,
                  int perturbed_truth, Checked_signs& signs)
{
  constexpr int n = Determinant::size;
  const auto check = [&](const std::string& width, const Exact_sign& said) {
    if (said.is_perturbed != (truth == 0))
      throw std::runtime_error(name + width + (truth == 0 ? " misses a zero" : " sees a zero"));
    signs.must_say(name + width, said.sign, perturbed_truth);
  };
  const Exact_differences<n> exact_differences(v, p);
  const Integer_differences<n> differences(exact_differences);
  if (!differences.can_be_scaled())
    return;
  Row<Fixed_integer<1>> half[n];
  Row<Fixed_integer<2>> one[n];
  Row<Fixed_integer<4>> two[n];
  if (differences.has_one_digit() && differences.has_half_a_digit()) {
    differences.set_rows(half);
    check(", 30 bits", Determinant::sign(half, HALF_DIGIT, v, p));
  }
  if (differences.has_one_digit()) {
    differences.set_rows(one);
    check(", 60 bits", Determinant::sign(one, ONE_DIGIT, v, p));
  }
  if (differences.set_rows(two))
    check(", 120 bits", Determinant::sign(two, TWO_DIGITS, v, p));
}
#endif

// Balanced rows, also where nothing is to be gained by them.
template <int N>
void check_balanced(const std::string& name, const double* const* v, const double* p, int truth,
                    Checked_signs& signs)
{
  const Balanced_signs<N> balanced(v, p);
  using Portable = Bounded_double_doubles<Portable_products>;
  signs.may_say(name + ", balanced doubles", balanced.template sign<Bounded_doubles>(), truth);
  signs.may_say(name + ", balanced double doubles", balanced.template sign<Portable>(), truth);
  signs.may_say(name + ", balanced double doubles", balanced.in_double_doubles(), truth);
}

inline void check_exact(const std::string& name, const Exact_sign& said, int truth,
                        int perturbed_truth, Checked_signs& signs)
{
  signs.may_say(name, said.sign, perturbed_truth);
  if (said.sign != 0 && said.is_perturbed != (truth == 0))
    throw std::runtime_error(name + (truth == 0 ? " misses a zero" : " sees a zero"));
}

inline bool is_vertex(const Quintuple& q, std::size_t n)
{
  for (std::size_t k = 0; k < n; ++k)
    if (std::equal(q.p.begin(), q.p.begin() + 3, q.v[k].begin()))
      return true;
  return false;
}

inline void check_cell(Quintuple q, Checked_signs& signs)
{
  const int orientation = exact_orientation(q.v[0], q.v[1], q.v[2], q.v[3]);
  if (orientation == 0)
    return;
  if (orientation < 0)
    std::swap(q.v[0], q.v[1]);
  const int sphere = exact_side_of_sphere(q.v[0], q.v[1], q.v[2], q.v[3], q.p);
  const Pointers v = Quintuple::pointers(q.v), opposite = Quintuple::pointers(q.opposite);
  const double* const p = q.p.data();
  signs.may_say("first filter", sphere_sign(row(v[0], p), row(v[1], p), row(v[2], p), row(v[3], p)),
                sphere);
  check_view<Sphere_filter>("scalar", q, sphere, signs);
  const std::array<int, 4> neighbors = signs_of_neighbors(q);
  check_neighbors("scalar", Sphere_filter::neighbors(v.data(), opposite.data(), p, 15), neighbors,
                  signs);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  if (machine_has_vectors()) {
    check_view<Wide_sphere_filter>("wide", q, sphere, signs);
    check_neighbors("wide", wide_signs(q), neighbors, signs);
    signs.may_say("wide, by columns", wide_sphere_sign_by_columns(v.data(), p), sphere);
  }
#endif
  if (is_vertex(q, 4)) // found before any exact stage is asked
    return;
  const int perturbed = perturbed_side_of_sphere(q.v[0], q.v[1], q.v[2], q.v[3], q.p);
  signs.may_say("by columns", sphere_sign_by_columns(v.data(), p), sphere);
  signs.may_say("portable double doubles", close_sphere_sign_with<Portable_products>({v.data(), p}),
                sphere);
  signs.may_say("double doubles", close_sphere_sign({v.data(), p}), sphere);
  check_balanced<4>("sphere", v.data(), p, sphere, signs);
  check_exact("exact sphere", exact_sign<Exact_sphere>(v.data(), p), sphere, perturbed, signs);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  check_widths<Exact_sphere>("sphere", v.data(), p, sphere, perturbed, signs);
#endif
}

// The first three vertices as a facet of the convex hull.
inline void check_infinite_cell(const Quintuple& q, Checked_signs& signs)
{
  if (is_vertex(q, 3) || are_collinear(q.v[0], q.v[1], q.v[2]))
    return;
  const Pointers v = Quintuple::pointers(q.v);
  const double* const p = q.p.data();
  const int height = exact_orientation(q.v[0], q.v[1], q.v[2], q.p);
  const int circle = height != 0 ? height : exact_side_of_circle(q.v[0], q.v[1], q.v[2], q.p);
  const int perturbed =
      height != 0 ? height : perturbed_side_of_circle(q.v[0], q.v[1], q.v[2], q.p);
  signs.may_say("first filter, beyond", beyond_sign(row(v[0], p), row(v[1], p), row(v[2], p)),
                height);
  signs.may_say("beyond by columns", beyond_sign_by_columns(v.data(), p), height);
  signs.may_say("flat beyond", flat_beyond_sign(v.data(), p), circle);
  check_balanced<3>("height", v.data(), p, -height, signs);
  check_exact("exact beyond", exact_sign<Exact_beyond>(v.data(), p), circle, perturbed, signs);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  check_widths<Exact_beyond>("beyond", v.data(), p, circle, perturbed, signs);
#endif
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_SIGNS_H
