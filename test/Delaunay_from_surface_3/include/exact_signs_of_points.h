// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_EXACT_SIGNS_OF_POINTS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_EXACT_SIGNS_OF_POINTS_H

// The signs that the compact kernel's predicates must have, from rational numbers and plain CGAL. A
// point is anything whose first three items are its coordinates, and whose fourth is its weight.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Simple_cartesian.h>

namespace fuzz {

using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

template <class P>
Rational_kernel::Point_3 exact(const P& p)
{
  return {p[0], p[1], p[2]};
}

template <class P>
int exact_orientation(const P& a, const P& b, const P& c, const P& d)
{
  return int(CGAL::orientation(exact(a), exact(b), exact(c), exact(d)));
}

template <class P>
bool are_collinear(const P& a, const P& b, const P& c)
{
  return CGAL::collinear(exact(a), exact(b), exact(c));
}

template <class P>
int exact_side_of_sphere(const P& a, const P& b, const P& c, const P& d, const P& p)
{
  return int(CGAL::side_of_oriented_sphere(exact(a), exact(b), exact(c), exact(d), exact(p)));
}

// Positive: inside.
template <class P>
int exact_side_of_circle(const P& a, const P& b, const P& c, const P& p)
{
  return int(CGAL::coplanar_side_of_bounded_circle(exact(a), exact(b), exact(c), exact(p)));
}

// The perturbed predicates of CGAL are protected.
struct Perturbing_triangulation : CGAL::Delaunay_triangulation_3<Rational_kernel>
{
  using Base = CGAL::Delaunay_triangulation_3<Rational_kernel>;
  using Base::coplanar_side_of_bounded_circle;
  using Base::side_of_oriented_sphere;
};

inline const Perturbing_triangulation& perturbing()
{
  static const Perturbing_triangulation triangulation;
  return triangulation;
}

struct Perturbing_regular_triangulation : CGAL::Regular_triangulation_3<Rational_kernel>
{
  using Base = CGAL::Regular_triangulation_3<Rational_kernel>;
  using Base::side_of_bounded_power_circle;
  using Base::side_of_oriented_power_sphere;
};

inline const Perturbing_regular_triangulation& perturbing_with_weights()
{
  static const Perturbing_regular_triangulation triangulation;
  return triangulation;
}

template <class P>
Rational_kernel::Weighted_point_3 exact_with_weight(const P& p)
{
  return {exact(p), p[3]};
}

template <class P>
int side_of_power_sphere(const P& a, const P& b, const P& c, const P& d, const P& p,
                         bool is_perturbed)
{
  const auto u = exact_with_weight(a), v = exact_with_weight(b), w = exact_with_weight(c),
             x = exact_with_weight(d), y = exact_with_weight(p);
  return int(is_perturbed // then the cell must be positively oriented
                 ? perturbing_with_weights().side_of_oriented_power_sphere(u, v, w, x, y, true)
                 : CGAL::power_side_of_oriented_power_sphere(u, v, w, x, y));
}

template <class P>
int side_of_power_circle(const P& a, const P& b, const P& c, const P& p, bool is_perturbed)
{
  return int(perturbing_with_weights().side_of_bounded_power_circle(
      exact_with_weight(a), exact_with_weight(b), exact_with_weight(c), exact_with_weight(p),
      is_perturbed));
}

template <class P>
int perturbed_side_of_sphere(const P& a, const P& b, const P& c, const P& d, const P& p)
{
  return int(
      perturbing().side_of_oriented_sphere(exact(a), exact(b), exact(c), exact(d), exact(p), true));
}

template <class P>
int perturbed_side_of_circle(const P& a, const P& b, const P& c, const P& p)
{
  return int(
      perturbing().coplanar_side_of_bounded_circle(exact(a), exact(b), exact(c), exact(p), true));
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_EXACT_SIGNS_OF_POINTS_H
