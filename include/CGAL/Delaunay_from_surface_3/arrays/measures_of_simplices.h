// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MEASURES_OF_SIMPLICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MEASURES_OF_SIMPLICES_H

// Measures tetrahedra: volumes, spheres through the corners and barycentric coordinates. All are
// quotients of polynomials in the differences of coordinates. With exact predicates tetrahedra may
// be so flat that doubles give no correct digit of their volumes. So each measure states which
// polynomials have to be known well. It is computed in doubles, which are enough for most
// tetrahedra; if their error bounds are too large, in sums of two doubles; and otherwise in
// integers.
//
// Corners are arrays (x, y, z) or, with a weight, (x, y, z, weight); or copies of points in a periodic
// box, whose positions are never rounded.

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Big_integer.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/balanced_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Represents value 2^exponent: products of integers may exceed the range of doubles even if their
// quotients do not.
struct Scaled_double
{
  double value;
  int exponent;
};

// Returns n 2^exponent / d.
inline double quotient(const Scaled_double& n, const Scaled_double& d, int exponent = 0)
{
  const int power = n.exponent - d.exponent + exponent;
  return power == 0 ? n.value / d.value : std::ldexp(n.value / d.value, power);
}

// Returns the square root of n 2^exponent.
inline double root(const Scaled_double& n, int exponent)
{
  const int power = n.exponent + exponent, odd = power & 1;
  return power == 0 ? std::sqrt(n.value)
                    : std::ldexp(std::sqrt(std::ldexp(n.value, odd)), (power - odd) / 2);
}

// Compares absolute values.
inline bool is_larger(const Scaled_double& s, const Scaled_double& t)
{
  return s.exponent == t.exponent ? std::abs(s.value) > std::abs(t.value)
                                  : std::abs(quotient(s, t)) > 1;
}

// What the measures need to know of a corner.
inline const double* place_of(const std::array<double, 3>& p)
{
  return p.data();
}
inline Weighted_place place_of(const std::array<double, 4>& p)
{
  return Weighted_place(p.data());
}
template <bool has_weight>
Copy_place<has_weight> place_of(const Copy_place<has_weight>& p)
{
  return p;
}

inline double weight_of(const std::array<double, 4>& p)
{
  return p[3];
}
inline double weight_of(const Copy_place<true>& p)
{
  return p.weight();
}

template <class Place>
double rounded_difference(const Place& p, const Place& q, int axis)
{
  if constexpr (is_copy<Place>)
    return Periodic_difference(p, q, std::size_t(axis)).high;
  else
    return p[axis] - q[axis];
}

template <class Corner>
std::array<double, 3> rounded_difference(const Corner& p, const Corner& q)
{
  const auto a = place_of(p), b = place_of(q);
  return {rounded_difference(a, b, 0), rounded_difference(a, b, 1), rounded_difference(a, b, 2)};
}

template <class Place>
bool is_finite_place(const Place& p)
{
  const double* coordinates;
  if constexpr (is_copy<Place>)
    coordinates = p.point;
  else
    coordinates = &p[0];
  return std::all_of(coordinates, coordinates + (is_weighted<Place> ? 4 : 3),
                     [](double x) { return std::isfinite(x); });
}

// Holds the differences of N points and an origin, divided by 2^unit, and those of their weights, if
// any, by its square, with error bounds (balanced_signs.h). The differences are at most 4, and 16, so
// that underflow adds an error of less than 2^-1000 to a polynomial of degree 4.
template <class Numbers, int N, class Place>
struct Bounded_rows
{
  using Number = Bounded_number<typename Numbers::Number>;
  Row<Number> rows[N];
  int unit;

  Bounded_rows(const Place* points, Place origin)
  {
    double largest = 0;
    for (int k = 0; k < 3 * N; ++k)
      largest = (std::max)(largest, std::abs(rounded_difference(points[k / 3], origin, k % 3)));
    if constexpr (is_weighted<Place>)
      for (int k = 0; k < N; ++k)
        largest = (std::max)(largest, std::sqrt(std::abs(origin.weight() - points[k].weight())));
    const auto exponent =
        (std::max)(std::uint64_t(1), (std::min)(biased_exponent(largest), std::uint64_t(2044)));
    unit = int(exponent) - 1022;
    const double scale = power_of_2(2045 - exponent);
    const auto bounded = [](const auto& d) { return Number{d, std::abs(Numbers::high(d))}; };
    const auto difference = [&](int k, int i) {
      if constexpr (is_copy<Place>) {
        const Periodic_difference d(points[k], origin, std::size_t(i));
        Number number = bounded(Numbers::scaled(d.high, d.low, scale));
        if (!d.is_exact)
          number.size = std::numeric_limits<double>::infinity(); // nothing is known
        return number;
      } else {
        return bounded(Numbers::difference(points[k][i], origin[i], scale));
      }
    };
    for (int k = 0; k < N; ++k)
      if constexpr (is_weighted<Place>) // the square of the scale may be too large for a double
        rows[k] = {difference(k, 0), difference(k, 1), difference(k, 2),
                   bounded(Numbers::difference(origin.weight(), points[k].weight(), scale) *
                           Numbers::difference(scale, 0, 1))};
      else
        rows[k] = {difference(k, 0), difference(k, 1), difference(k, 2)};
  }

  // Returns whether the error of n is less than this share of d; false if a number is not finite.
  static bool is_known(const Number& n, const Number& d, double share = 0x1p-44)
  {
    return Numbers::error * n.size + 0x1p-1000 < share * std::abs(Numbers::high(d.value));
  }
  static Scaled_double rounded(const Number& n) { return {Numbers::high(n.value), 0}; }
};

// Holds the same differences in integers.
template <int N, class Place>
struct Integer_rows : Big_differences<N, Place>
{
  using Number = Big_integer;
  using Big_differences<N, Place>::Big_differences;

  static bool is_known(const Number&, const Number&, double = 0) { return true; }
  static Scaled_double rounded(const Number& n)
  {
    Scaled_double result;
    result.value = n.scaled_double(result.exponent);
    return result;
  }
};

// Calls measure(rows), with the differences in the numbers of one stage after the other, until it
// returns true. Points that are not finite have no measure.
template <int N, class Place, class Measure>
void measure_in_stages(const Place* points, Place origin, const Measure& measure)
{
  if (measure(Bounded_rows<Bounded_doubles, N, Place>(points, origin)) ||
      measure(Bounded_rows<Bounded_double_doubles<Portable_products>, N, Place>(points, origin)))
    return;
  if (is_finite_place(origin) && std::all_of(points, points + N, is_finite_place<Place>))
    measure(Integer_rows<N, Place>(points, origin));
}

constexpr double no_measure = std::numeric_limits<double>::quiet_NaN();

// Measures a tetrahedron in the frame of one of its corners.
template <class Corner, class Measure>
void measure_at_corner(const Corner (&corners)[4], int origin, const Measure& measure)
{
  decltype(place_of(corners[0])) others[3];
  for (int k = 0, n = 0; k < 4; ++k)
    if (k != origin)
      others[n++] = place_of(corners[k]);
  measure_in_stages<3>(others, place_of(corners[origin]), measure);
}

template <class Number>
std::array<Number, 3> vector_of(const Row<Number>& row)
{
  return {row.x, row.y, row.z};
}

// Returns the place of the largest coordinate, in absolute value.
template <class Rows, class Number>
std::size_t largest_of(const std::array<Number, 3>& v)
{
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (is_larger(Rows::rounded(v[i]), Rows::rounded(v[largest])))
      largest = i;
  return largest;
}

// Returns whether the errors of a vector are negligible beside its length.
template <class Rows, class Number>
bool is_known(const std::array<Number, 3>& v)
{
  const Number& length = v[largest_of<Rows>(v)];
  return Rows::is_known(v[0], length) && Rows::is_known(v[1], length) &&
         Rows::is_known(v[2], length);
}

// Returns the volume of a tetrahedron abcd, positive if (b - a, c - a, d - a) is right-handed.
template <class Corner>
double volume_of(const Corner (&corners)[4])
{
  double volume = no_measure;
  measure_at_corner(corners, 0, [&](const auto& in) {
    const auto six = carried(determinant_of(in.rows[0], in.rows[1], in.rows[2]));
    if (!in.is_known(six, six))
      return false;
    volume = quotient(in.rounded(six), {6, 0}, 3 * in.unit);
    return true;
  });
  return volume;
}

// Represents the sphere through the corners of a tetrahedron.
struct Circumsphere
{
  std::array<double, 3> center = {no_measure, no_measure, no_measure}; // relative to the origin

  double radius() const { return std::hypot(std::hypot(center[0], center[1]), center[2]); }

  // Finds the sphere, and returns whether these rows were accurate enough.
  template <class Rows>
  bool find(const Rows& in)
  {
    const auto b = vector_of(in.rows[0]), c = vector_of(in.rows[1]), d = vector_of(in.rows[2]);
    const auto p = cross(c, d), q = cross(d, b), r = cross(b, c);
    const auto six = dot(b, p);
    auto n = p;
    for (std::size_t i = 0; i < 3; ++i)
      n[i] = in.rows[0].w * p[i] + in.rows[1].w * q[i] + in.rows[2].w * r[i];
    if (!in.is_known(six, six) || !is_known<Rows>(n))
      return false;
    for (std::size_t i = 0; i < 3; ++i)
      center[i] = quotient(in.rounded(n[i]), in.rounded(six), in.unit - 1);
    return true;
  }
};

template <class Corner>
Circumsphere circumsphere_of(const Corner (&corners)[4])
{
  Circumsphere sphere;
  measure_at_corner(corners, 0, [&](const auto& in) { return sphere.find(in); });
  return sphere;
}

// Represents the sphere that is orthogonal to those of four points whose squared radii are weights.
struct Power_sphere
{
  std::array<double, 3> center; // relative to the first point
  double squared_radius;        // negative if the sphere is imaginary
};

// Returns the power sphere of points with weights. Its centre is as accurate as that of a
// circumsphere; the squared radius is its squared distance from a point less the weight there, which
// may have most digits in common.
template <class Corner>
Power_sphere power_sphere_of(const Corner (&corners)[4])
{
  const std::array<double, 3> center = circumsphere_of(corners).center;
  return {center, dot(center, center) - weight_of(corners[0])};
}

// Returns the barycentric coordinates of a point. They add up to 1, and are exact at a corner. If zeros
// are decided, which takes longer near facets, those that are 0 are exactly that, and no others.
template <class Corner>
std::array<double, 4> barycentric_of(const Corner (&corners)[4], const Corner& point,
                                     bool are_zeros_decided = false)
{
  std::array<double, 4> weights = {no_measure, no_measure, no_measure, no_measure};
  const decltype(place_of(point)) points[4] = {place_of(corners[0]), place_of(corners[1]),
                                               place_of(corners[2]), place_of(corners[3])};
  measure_in_stages<4>(points, place_of(point), [&](const auto& in) {
    const Sphere_cofactors<typename std::decay_t<decltype(in)>::Number> parts(
        in.rows[0], in.rows[1], in.rows[2], in.rows[3]);
    const auto sum = (parts.of[0] + parts.of[1]) + (parts.of[2] + parts.of[3]);
    for (const auto& part : parts.of)
      if (!in.is_known(part, sum) || (are_zeros_decided && !in.is_known(part, part, .5)))
        return false;
    for (std::size_t k = 0; k < 4; ++k) {
      weights[k] = quotient(in.rounded(parts.of[k]), in.rounded(sum));
      if (are_zeros_decided && weights[k] == 0 && in.rounded(parts.of[k]).value != 0)
        weights[k] = (std::numeric_limits<double>::denorm_min)();
    }
    return true;
  });
  return weights;
}

// Returns the gradients of the first three barycentric coordinates.
template <class Corner>
std::array<std::array<double, 3>, 3> gradients_of(const Corner (&corners)[4])
{
  constexpr std::array<double, 3> none = {no_measure, no_measure, no_measure};
  std::array<std::array<double, 3>, 3> gradients = {none, none, none};
  measure_at_corner(corners, 3, [&](const auto& in) {
    using Rows = std::decay_t<decltype(in)>;
    const auto a = vector_of(in.rows[0]), b = vector_of(in.rows[1]), c = vector_of(in.rows[2]);
    const std::array<decltype(cross(a, b)), 3> normals = {cross(b, c), cross(c, a), cross(a, b)};
    const auto six = dot(a, normals[0]);
    if (!in.is_known(six, six))
      return false;
    for (const auto& n : normals)
      if (!is_known<Rows>(n))
        return false;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        gradients[k][i] = quotient(in.rounded(normals[k][i]), in.rounded(six), -in.unit);
    return true;
  });
  return gradients;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MEASURES_OF_SIMPLICES_H
