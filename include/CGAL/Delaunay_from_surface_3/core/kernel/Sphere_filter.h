// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SPHERE_FILTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SPHERE_FILTER_H

// The first stage of the predicates evaluates determinants in double, with a bound on their error.
//
// A determinant of four rows is a sum of 24 products x y z w; each goes through at most 17
// roundings, 3 + 5 of them in its factors. By the inequality of Hadamard type for permanents
// (Carlen, Lieb, Loss 2006) the products that share w sum up to at most 2/√3 m^(3/2) in absolute
// value, where m bounds all w, so the error is at most 4 · 2/√3 · 17 u m^(5/2) < 80 u m^(5/2) with
// u = 2^-53. In the same way, it is less than 16 u m^(3/2) for three rows (x, y, z). Contraction to
// fma only removes roundings. These constants, and the ones of the other filters, are proved by
// machine in test/Delaunay_from_surface_3/bounds. With weights w has another term, so a product goes
// through one rounding more in it, and the constants are larger (Bound_factors).
//
// Coordinates are at most 2^58 in absolute value (the caller scales them by a power of 2), so
// nothing overflows. There are less than 2^7 underflows, of at most 2^-1075 each, which meet at
// most three coordinates as factors. They change a result by less than `tiny` if m is at most 1,
// and otherwise by less than 2^-900 u m^(5/2), or u m^(3/2).

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns 2^(biased_exponent - 1023), for a biased exponent between 1 and 2046.
inline double power_of_2(std::uint64_t biased_exponent)
{
  const std::uint64_t bits = biased_exponent << 52;
  double power;
  std::memcpy(&power, &bits, sizeof(power));
  return power;
}

// Returns the biased exponent e of a number that is not negative. The number is less than 2^(e -
// 1022) and, if e is not 0, at least half of that.
inline std::uint64_t biased_exponent(double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof(number));
  return bits >> 52;
}

// All stages of the predicates evaluate these determinants, over any type of numbers.
//
// Rows are vertices relative to the new point p, lifted to the paraboloid: (x, y, z) = v - p and
// w = x² + y² + z². Where points have weights, a vertex is lifted less by its own and more by that
// of p: w = x² + y² + z² + (weight of p - weight of v), and spheres are those orthogonal to the
// vertices' (Aurenhammer 1987; Edelsbrunner, Shah 1996). Signs mean the same in all stages:
//   sphere   positive: p is inside the sphere of a positively oriented cell;
//   facet    positive: p is on the inner side of a cell's facet;
//   beyond   positive: p is beyond the finite facet of an infinite cell, or in its plane and inside
//            its circle;
//   0        undecided, or, if the stage is exact, p is on it.
// A cell (v0, v1, v2, v3) is positively oriented if (v1 - v0, v2 - v0, v3 - v0) is right-handed; in
// an infinite cell the infinite vertex v3 stands for a point beyond the facet.

// This stands before loops over the few numbers of a test, which the compiler shall unroll.
#if defined(__clang__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL _Pragma("unroll")
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL _Pragma("GCC unroll 16")
#endif

// Turns a finished sum into a number. Only the sums of Fixed_integer.h are not numbers already.
template <class Number>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Number carried(const Number& sum)
{
  return sum;
}

template <class Number>
using Product_of = decltype(carried(Number() * Number()));

template <class Number>
struct Row
{
  Number x, y, z;
  Product_of<Number> w;

  Row() = default;
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Row(const Number& dx, const Number& dy,
                                                 const Number& dz)
    : x(dx)
    , y(dy)
    , z(dz)
    , w(carried(dx * dx + dy * dy + dz * dz))
  {
  }
  // `dw`, not carried, is the weight of p less that of the vertex.
  template <class Sum>
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Row(const Number& dx, const Number& dy,
                                                 const Number& dz, const Sum& dw)
    : x(dx)
    , y(dy)
    , z(dz)
    , w(carried((dx * dx + dy * dy + dz * dz) + dw))
  {
  }
};

// Returns |a b| in the columns x and y.
template <class Number>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Product_of<Number> minor_of(const Row<Number>& a,
                                                                       const Row<Number>& b)
{
  return carried(a.x * b.y - a.y * b.x);
}

// Returns |a b c|, not carried, in the columns x, y, z: positive if the cell (p, a, b, c) is.
template <class Number>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE auto
determinant_of(const Row<Number>& a, const Row<Number>& b, const Row<Number>& c)
{
  return a.z * minor_of(b, c) + b.z * minor_of(c, a) + c.z * minor_of(a, b);
}

// Holds the cofactors of w in the determinant of four rows, which is the sum of each w times its
// cofactor, and is positive if p is inside the sphere of the cell. The cofactor of a vertex is the
// orientation of the cell with p in the vertex's place: it is positive if p is on the inner side of
// the opposite facet.
template <class Number>
struct Sphere_cofactors
{
  using Minor = decltype(carried(Number() * Product_of<Number>()));
  Minor of[4];

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE
  Sphere_cofactors(const Row<Number>& a, const Row<Number>& b, const Row<Number>& c,
                   const Row<Number>& d)
  {
    const auto ab = minor_of(a, b), ac = minor_of(a, c), ad = minor_of(a, d), bc = minor_of(b, c),
               bd = minor_of(b, d), cd = minor_of(c, d);
    of[0] = carried(b.z * cd - c.z * bd + d.z * bc);
    of[1] = carried(c.z * ad - a.z * cd - d.z * ac);
    of[2] = carried(a.z * bd - b.z * ad + d.z * ab);
    of[3] = carried(b.z * ac - a.z * bc - c.z * ab);
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE auto lifted(const Row<Number>& a, const Row<Number>& b,
                                                         const Row<Number>& c,
                                                         const Row<Number>& d) const
  {
    return (a.w * of[0] + b.w * of[1]) + (c.w * of[2] + d.w * of[3]);
  }
};

// Does the same for three rows in one plane with p, by two coordinates s and t in which the
// triangle has an area. The sum of each w times its cofactor has the sign of that area if p is
// inside the circle; if p is on it, w is a linear function of s and t, and the sum is 0. The
// cofactors add up to the area.
template <class Number> // clang-tidy sees the counters of copied arrays: NOLINTNEXTLINE
struct Circle_cofactors
{
  Product_of<Number> of[3];
  Product_of<Number> area;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE
  Circle_cofactors(const Row<Number>* r, Number Row<Number>::*s, Number Row<Number>::*t)
  {
    const auto bc = r[1].*s * r[2].*t - r[1].*t * r[2].*s;
    const auto ca = r[2].*s * r[0].*t - r[2].*t * r[0].*s;
    const auto ab = r[0].*s * r[1].*t - r[0].*t * r[1].*s;
    of[0] = carried(bc);
    of[1] = carried(ca);
    of[2] = carried(ab);
    area = carried(bc + ca + ab);
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE auto lifted(const Row<Number>* r) const
  {
    return r[0].w * of[0] + r[1].w * of[1] + r[2].w * of[2];
  }
};

// There is another bound on the error of the determinants, by columns. It is the smaller one if a
// coordinate varies much less than another, as in sheets that are nearly flat and parallel to two
// axes, and in wires along one.
//
// A determinant of 4 rows is a sum of 24 products x y z w of at most 17 roundings each (see above).
// Let X, Y, Z, W be the largest numbers of the columns in absolute value, as computed, with 3 + 5
// roundings. Then the error is at most 24 ((1 + u)^17 - 1) (1 - u)^-8 X Y Z W < 409 u X Y Z W. The
// bound has 4 roundings of its own, so 450 u X Y Z W is on the safe side, and 480 u X Y Z W with
// weights, where W is the largest size (Power_row). A determinant of 3 rows has 6 products of at
// most 8 roundings, and an error of less than 55 u X Y Z.
//
// Coordinates are at most 2^58 in absolute value, so differences are at most 2^59 and w at most 3
// 2^118. There are less than 2^7 underflows, of at most 2^-1075 each, which meet factors of less
// than 2^181: they amount to less than `tiny`. If coordinates themselves were rounded, by at most
// 2^-1075 (Compact_complex.h), that is negligible beside columns of at least `least`.

constexpr double unit_of_double = 1. / 9007199254740992.; // 2^-53

struct Column_sizes
{
  static constexpr double tiny = 1e-264; // more than 2^-880
  static constexpr double least = 0x1p-1000;
  static constexpr double three = 55;

  double x = least, y = least, z = least;

  template <class... Rows>
  explicit Column_sizes(const Rows&... rows)
  {
    (add(rows), ...);
  }

  // Returns true if the box with these edges is so flat that these bounds decide much more.
  bool are_flat() const
  {
    const double m = (std::max)((std::max)(x, y), z);
    return x * y * z < 0x1p-20 * (m * m * m);
  }

  void add(const Row<double>& r) { add(std::abs(r.x), std::abs(r.y), std::abs(r.z)); }
  void add(double dx, double dy, double dz) // each at least 0
  {
    x = (std::max)(x, dx);
    y = (std::max)(y, dy);
    z = (std::max)(z, dz);
  }

  // `w` must be at least the largest number in that column; for `factor` see Bound_factors.
  double bound_of_four(double w, double factor) const
  {
    return factor * unit_of_double * ((x * y) * (z * w)) + tiny;
  }
  double bound_of_three() const { return three * unit_of_double * (x * y * z) + tiny; }
};

// Points to the coordinates of a point that has a weight, and to the weight behind them. Predicates
// take the `Place` of a vertex: this, or const double*.
struct Weighted_place
{
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE explicit Weighted_place(const double* place)
    : coordinates(place)
  {
  }
  Weighted_place() = default;
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE const double& operator[](std::size_t k) const
  {
    return coordinates[k];
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE double weight() const { return coordinates[3]; }

  const double* coordinates;
};

// Points to coordinates that are rounded, each by at most 2^4: those of a copy of a point in a periodic
// box (Copy_vertex.h).
template <bool has_weight>
struct Rounded_place
{
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE explicit Rounded_place(const double* place)
    : coordinates(place)
  {
  }
  Rounded_place() = default;
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE const double& operator[](std::size_t k) const
  {
    return coordinates[k];
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE double weight() const { return coordinates[3]; }

  const double* coordinates;
};

inline const double* coordinates_of(const double* v)
{
  return v;
}
inline const double* coordinates_of(Weighted_place v)
{
  return v.coordinates;
}
template <bool has_weight>
const double* coordinates_of(Rounded_place<has_weight> v)
{
  return v.coordinates;
}

template <class Place>
inline constexpr bool is_weighted = false;
template <>
inline constexpr bool is_weighted<Weighted_place> = true;
template <>
inline constexpr bool is_weighted<Rounded_place<true>> = true;

// Whether places are rounded, or know what was rounded (Copy_vertex.h).
template <class Place>
inline constexpr bool is_rounded = false;
template <class Place>
inline constexpr bool is_copy = false;
template <bool has_weight>
inline constexpr bool is_rounded<Rounded_place<has_weight>> = true;

// A row in doubles with a weight in w, and what bounds the error of that: the squared length of
// (x, y, z), and this plus the absolute value of the difference of weights.
struct Power_row : Row<double>
{
  double square, size;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Power_row(double dx, double dy, double dz, double dw)
    : Row<double>(dx, dy, dz)
    , square(w)
    , size(w + std::abs(dw))
  {
    w += dw;
  }
};

// A row of places that are rounded: each of its coordinates is off by at most 2^5.
template <class R>
struct Rounded_row : R
{
  using R::R;
};

inline double square_of(const Row<double>& r)
{
  return r.w;
}
inline double square_of(const Power_row& r)
{
  return r.square;
}
inline double size_of(const Row<double>& r)
{
  return r.w;
}
inline double size_of(const Power_row& r)
{
  return r.size;
}

inline Row<double> row(const double* v, const double* p)
{
  return {v[0] - p[0], v[1] - p[1], v[2] - p[2]};
}
inline Power_row row(Weighted_place v, Weighted_place p)
{
  return {v[0] - p[0], v[1] - p[1], v[2] - p[2], p.weight() - v.weight()};
}

inline Rounded_row<Row<double>> row(Rounded_place<false> v, Rounded_place<false> p)
{
  return {v[0] - p[0], v[1] - p[1], v[2] - p[2]};
}
inline Rounded_row<Power_row> row(Rounded_place<true> v, Rounded_place<true> p)
{
  return {v[0] - p[0], v[1] - p[1], v[2] - p[2], p.weight() - v.weight()};
}

template <class Place>
using Row_of = decltype(row(Place(), Place()));

// The factors of u in the bounds on the error of lifted determinants: of four rows by lengths and by
// columns, and of three in a plane.
template <class R>
struct Bound_factors
{
  static constexpr double four = 80, columns = 450, circle = 40;
  static constexpr double off = 0; // by how much coordinates are
};
template <>
struct Bound_factors<Power_row>
{
  static constexpr double four = 88, columns = 480, circle = 44;
  static constexpr double off = 0;
};

// Let coordinates be off by at most d, and let m bound all w. Then a determinant of four rows is off by
// less than 72 d m^2, unless it is smaller than that itself. For a row (x, y, z, w / √m) has a length of
// at most √(2 m), and is moved by at most √15 d and a bit, as w is by 2 √3 d √m. By Hadamard's
// inequality the four rows together move the determinant by 4 √m (2 m)^(3/2) √15 d < 44 d m^2, to first
// order; the other terms add less than a half of that if √m > 12 d, and else the determinant is at most
// 4 m^(5/2) < 48 d m^2. In the same way a determinant of three rows is off by less than 8 d m: by
// 3 √3 d m and a bit.
template <class R>
struct Bound_factors<Rounded_row<R>> : Bound_factors<R>
{
  static constexpr double off = 0x1p5;
};

struct Filter_bounds
{
  static constexpr double unit = unit_of_double;
  static constexpr double tiny = 1e-300;
  template <class R>
  static double four_rows(double m)
  {
    if constexpr (Bound_factors<R>::off > 0)
      return m * m * (Bound_factors<R>::four * unit * std::sqrt(m) + 72 * Bound_factors<R>::off) +
             tiny;
    else
      return Bound_factors<R>::four * unit * (m * m * std::sqrt(m)) + tiny;
  }
  template <class R = Row<double>>
  static double three_rows(double m)
  {
    if constexpr (Bound_factors<R>::off > 0)
      return m * (16 * unit * std::sqrt(m) + 8 * Bound_factors<R>::off) + tiny;
    else
      return 16 * unit * (m * std::sqrt(m)) + tiny;
  }
};

// Returns the sign of a number whose error is at most `bound`, or 0 if that leaves it undecided.
inline int certified_sign(double value, double bound)
{
  return (value > bound) - (value < -bound);
}

template <class R>
double largest_square(const R& a, const R& b, const R& c)
{
  return (std::max)((std::max)(square_of(a), square_of(b)), square_of(c));
}

template <class R>
double largest_size(const R& a, const R& b, const R& c)
{
  return (std::max)((std::max)(size_of(a), size_of(b)), size_of(c));
}

// Tests p against an infinite cell (a, b, c, infinite).
template <class R>
int beyond_sign(const R& a, const R& b, const R& c)
{
  return -certified_sign(determinant_of<double>(a, b, c),
                         Filter_bounds::three_rows<R>(largest_square(a, b, c)));
}

// Tests p against a positively oriented cell (a, b, c, d).
template <class R>
int sphere_sign(const R& a, const R& b, const R& c, const R& d)
{
  const double m = (std::max)(largest_size(a, b, c), size_of(d));
  return certified_sign(Sphere_cofactors<double>(a, b, c, d).lifted(a, b, c, d),
                        Filter_bounds::four_rows<R>(m));
}

// These make the same tests with the bound by columns (Column_sizes). `value` is the determinant.
template <class R>
CGAL_DELAUNAY_FROM_SURFACE_3_APART int sign_by_columns(double value, double w, const R& a,
                                                       const R& b, const R& c, const R& d)
{
  return certified_sign(value,
                        Column_sizes(a, b, c, d).bound_of_four(w, Bound_factors<R>::columns));
}

template <class Place>
CGAL_DELAUNAY_FROM_SURFACE_3_APART int sphere_sign_by_columns(const Place* vertices, Place p)
{
  const auto a = row(vertices[0], p), b = row(vertices[1], p), c = row(vertices[2], p),
             d = row(vertices[3], p);
  const double m = (std::max)(largest_size(a, b, c), size_of(d));
  return sign_by_columns(Sphere_cofactors<double>(a, b, c, d).lifted(a, b, c, d), m, a, b, c, d);
}

template <class Place>
CGAL_DELAUNAY_FROM_SURFACE_3_APART int beyond_sign_by_columns(const Place* vertices, Place p)
{
  const Row<double> a = row(vertices[0], p), b = row(vertices[1], p), c = row(vertices[2], p);
  return -certified_sign(determinant_of(a, b, c), Column_sizes(a, b, c).bound_of_three());
}

// Tries both bounds, one after the other.
template <class R>
int sphere_sign_by_either(const R& a, const R& b, const R& c, const R& d)
{
  const double value = Sphere_cofactors<double>(a, b, c, d).lifted(a, b, c, d);
  const double m = (std::max)(largest_size(a, b, c), size_of(d));
  const int sign = certified_sign(value, Filter_bounds::four_rows<R>(m));
  return sign != 0 || value == 0 || Bound_factors<R>::off > 0
             ? sign
             : sign_by_columns(value, m, a, b, c, d);
}

// Holds the results of four sphere tests, with the neighbours of a cell. Bit i of `inside` says
// that p is inside the sphere of the neighbour beyond facet i, and bit i of `outside` that p is
// outside.
struct Sphere_signs
{
  unsigned inside, outside;
};

// Says where p is, seen from a cell: inside the sphere or outside, and beyond which facets.
struct Cell_view
{
  int sphere;       // 1 inside, -1 outside, 0 undecided
  double facets[4]; // > facet_bound if p is on the inner side, < -facet_bound if beyond
  double facet_bound;
  double pushes[4]; // `facets` times the fourth powers of the distances from the vertices to p
};

// Makes the tests in scalar code, for any machine. Wide_sphere_filter makes them in vectors, with
// the first bound only: there the other one costs too much for what it decides.
struct Sphere_filter
{
  // `vertices` are the cell's, positively oriented. `opposite` has of each neighbour the vertex
  // that is not the cell's. Only neighbours in `wanted` are tested.
  template <class Place>
  static Sphere_signs neighbors(const Place* vertices, const Place* opposite, Place p,
                                unsigned wanted)
  {
    const Row_of<Place> rows[4] = {row(vertices[0], p), row(vertices[1], p), row(vertices[2], p),
                                   row(vertices[3], p)};
    Sphere_signs signs = {0, 0};
    for (unsigned i = 0; i < 4; ++i) {
      if (!(wanted >> i & 1))
        continue;
      // the cell itself has vertex i in the place of the opposite one, and the other orientation
      const int sign =
          sphere_sign_by_either(row(opposite[i], p), rows[i ^ 1], rows[i ^ 3], rows[i ^ 2]);
      signs.inside |= unsigned(sign > 0) << i;
      signs.outside |= unsigned(sign < 0) << i;
    }
    return signs;
  }

  template <class Place>
  static Cell_view view(const Place* vertices, Place p)
  {
    using R = Row_of<Place>;
    const R a = row(vertices[0], p), b = row(vertices[1], p), c = row(vertices[2], p),
            d = row(vertices[3], p);
    const Sphere_cofactors<double> cofactors(a, b, c, d);
    const double m = (std::max)(largest_size(a, b, c), size_of(d));
    Cell_view view;
    std::copy(cofactors.of, cofactors.of + 4, view.facets);
    view.sphere = certified_sign(cofactors.lifted(a, b, c, d), Filter_bounds::four_rows<R>(m));
    view.facet_bound = Filter_bounds::three_rows<R>(m);
    const double w[4] = {square_of(a), square_of(b), square_of(c), square_of(d)};
    for (unsigned k = 0; k < 4; ++k)
      view.pushes[k] = view.facets[k] * w[k] * w[k];
    return view;
  }
};

// The following does the same in vectors of four doubles, with one lane per facet of the cell. The
// other three vertices of lane i are i^1, i^2 and i^3, an even permutation that takes three cheap
// shuffles.
//
// Only code marked with its target uses vector instructions, so that users need not compile for
// them. The caller asks first whether the machine has them.

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

// Holds a coordinate of the four rows, and its three permutations.
struct Wide_column
{
  Four_doubles v, a, b, c;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS explicit Wide_column(Four_doubles value)
    : v(value)
    , a(lanes_of<1, 0, 3, 2>(value))
    , b(lanes_of<2, 3, 0, 1>(value))
    , c(lanes_of<1, 0, 3, 2>(b))
  {
  }
};

// Returns the largest absolute value of the lanes.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS double largest_of(Four_doubles v)
{
  const Four_doubles size = max_of(v, -v), two = max_of(size, lanes_of<2, 3, 0, 1>(size));
  return (std::max)(two[0], two[1]);
}

// Holds (x, y, z) - p of four points, by coordinate, the squared lengths, and w and sizes, which
// are the same without weights.
template <class Place>
struct Wide_rows
{
  Four_doubles x, y, z, w, square, size;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Wide_rows(const Place* points, Place p)
  {
    const Four_doubles r0 = load_four(coordinates_of(points[0])),
                       r1 = load_four(coordinates_of(points[1]));
    const Four_doubles r2 = load_four(coordinates_of(points[2])),
                       r3 = load_four(coordinates_of(points[3]));
    const Four_doubles xz01 = lanes_of<0, 4, 2, 6>(r0, r1), xz23 = lanes_of<0, 4, 2, 6>(r2, r3);
    const Four_doubles y01 = lanes_of<1, 5, 3, 7>(r0, r1), y23 = lanes_of<1, 5, 3, 7>(r2, r3);
    x = lanes_of<0, 1, 4, 5>(xz01, xz23) - p[0];
    y = lanes_of<0, 1, 4, 5>(y01, y23) - p[1];
    z = lanes_of<2, 3, 6, 7>(xz01, xz23) - p[2];
    w = square = size = x * x + y * y + z * z;
    if constexpr (is_weighted<Place>) {
      const Four_doubles dw = p.weight() - lanes_of<2, 3, 6, 7>(y01, y23);
      w = square + dw;
      size = square + max_of(dw, -dw);
    }
  }
};

// Holds the minors of two columns, which times() expands by a third column.
struct Wide_minors
{
  Four_doubles bc, ca, ab;
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Wide_minors(const Wide_column& r,
                                                             const Wide_column& s)
    : bc(r.b * s.c - s.b * r.c)
    , ca(r.c * s.a - s.c * r.a)
    , ab(r.a * s.b - s.a * r.b)
  {
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Four_doubles times(const Wide_column& t) const
  {
    return t.a * bc + t.b * ca + t.c * ab;
  }
};

struct Wide_sphere_filter
{
  template <class Place>
  CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS static Sphere_signs
  signs(const Place* vertices, const Place* opposite, Place p)
  {
    const Wide_rows<Place> rows(vertices, p), e(opposite, p);
    const Wide_column x(rows.x), y(rows.y), z(rows.z), w(rows.w);
    const Wide_minors xy(x, y), zw(z, w);
    const Four_doubles value =
        (e.x * zw.times(y) - e.y * zw.times(x)) + (e.z * xy.times(w) - e.w * xy.times(z));
    Four_doubles m = max_of(max_of(e.w, w.a), max_of(w.b, w.c));
    if constexpr (is_weighted<Place>) { // of all vertices: that is one too many, but cheaper
      const Four_doubles two = max_of(rows.size, lanes_of<1, 0, 3, 2>(rows.size));
      m = max_of(e.size, max_of(two, lanes_of<2, 3, 0, 1>(two)));
    }
    using Factors = Bound_factors<Row_of<Place>>;
    Four_doubles bound;
    if constexpr (Factors::off > 0)
      bound = m * m * (sqrt_of(m) * (Factors::four * Filter_bounds::unit) + 72 * Factors::off) +
              Filter_bounds::tiny;
    else
      bound = m * m * sqrt_of(m) * (Factors::four * Filter_bounds::unit) + Filter_bounds::tiny;
    return {bits_of(value > bound), bits_of(value < -bound)};
  }

  template <class Place>
  CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS static Cell_view view(const Place* vertices, Place p)
  {
    const Wide_rows<Place> rows(vertices, p);
    const Wide_column x(rows.x), y(rows.y), z(rows.z);
    const Four_doubles facets = Wide_minors(x, y).times(z);
    Cell_view view;
    double value[4], w[4];
    store_four(view.facets, facets);
    store_four(value, facets * rows.w);
    store_four(view.pushes, facets * rows.square * rows.square);
    store_four(w, rows.size);
    const double m = (std::max)((std::max)(w[0], w[1]), (std::max)(w[2], w[3]));
    view.sphere = certified_sign((value[0] + value[1]) + (value[2] + value[3]),
                                 Filter_bounds::four_rows<Row_of<Place>>(m));
    view.facet_bound = Filter_bounds::three_rows<Row_of<Place>>(m);
    return view;
  }
};

// Does the same as sphere_sign_by_columns(), in vectors.
template <class Place>
CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS int wide_sphere_sign_by_columns(const Place* vertices,
                                                                        Place p)
{
  const Wide_rows<Place> rows(vertices, p);
  const Wide_column x(rows.x), y(rows.y), z(rows.z);
  const Four_doubles value = Wide_minors(x, y).times(z) * rows.w;
  Column_sizes sizes;
  sizes.add(largest_of(rows.x), largest_of(rows.y), largest_of(rows.z));
  return certified_sign(
      (value[0] + value[1]) + (value[2] + value[3]),
      sizes.bound_of_four(largest_of(rows.size), Bound_factors<Row_of<Place>>::columns));
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SPHERE_FILTER_H
