// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SPHERE_FILTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SPHERE_FILTER_H

// The first stage of the predicates: the determinants in double, with one bound on their error.
//
// A determinant of four rows is a sum of 24 products x y z w; each goes through at most 17
// roundings, 3 + 5 of them in its factors. By the inequality of Hadamard type for permanents
// (Carlen, Lieb, Loss 2006) the products that share w sum up to at most 2/√3 m^(3/2) in absolute
// value where m bounds all w; so the error is at most 4 · 2/√3 · 17 u m^(5/2) < 80 u m^(5/2) with u
// = 2^-53. In the same way it is less than 16 u m^(3/2) for three rows (x, y, z). Contraction to
// fma only removes roundings. These constants, and those of the other filters, are proved by machine
// in test/Delaunay_from_surface_3/bounds.
//
// Coordinates are at most 2^58 in absolute value (the caller scales them by a power of 2). Hence
// nothing overflows. What underflows, 2^-1075 each time and less than 2^7 times, meets at most
// three coordinates as factors: it changes a result by less than `tiny` where m is at most 1, and
// by less than 2^-900 u m^(5/2), or u m^(3/2), where it is not.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Column_sizes.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Filter_bounds
{
  static constexpr double unit = unit_of_double;
  static constexpr double tiny = 1e-300;
  static double four_rows(double m) { return 80 * unit * (m * m * std::sqrt(m)) + tiny; }
  static double three_rows(double m) { return 16 * unit * (m * std::sqrt(m)) + tiny; }
};

inline Row<double> row(const double* v, const double* p)
{
  return {v[0] - p[0], v[1] - p[1], v[2] - p[2]};
}

// -1, 0 or 1; 0: not decided.
inline int certified_sign(double value, double bound)
{
  return (value > bound) - (value < -bound);
}

inline double largest_square(const Row<double>& a, const Row<double>& b, const Row<double>& c)
{
  return (std::max)((std::max)(a.w, b.w), c.w);
}

// The test against an infinite cell (a, b, c, infinite).
inline int beyond_sign(const Row<double>& a, const Row<double>& b, const Row<double>& c)
{
  return -certified_sign(determinant_of(a, b, c),
                         Filter_bounds::three_rows(largest_square(a, b, c)));
}

// The test against a positively oriented cell (a, b, c, d).
inline int sphere_sign(const Row<double>& a, const Row<double>& b, const Row<double>& c,
                       const Row<double>& d)
{
  return certified_sign(Sphere_cofactors<double>(a, b, c, d).lifted(a, b, c, d),
                        Filter_bounds::four_rows((std::max)(largest_square(a, b, c), d.w)));
}

// The same by the bound by columns (Column_sizes.h).
CGAL_DELAUNAY_FROM_SURFACE_3_APART int sphere_sign_by_columns(const double* const* vertices,
                                                              const double* p)
{
  const Row<double> a = row(vertices[0], p), b = row(vertices[1], p), c = row(vertices[2], p),
                    d = row(vertices[3], p);
  const double m = (std::max)(largest_square(a, b, c), d.w);
  return certified_sign(Sphere_cofactors<double>(a, b, c, d).lifted(a, b, c, d),
                        Column_sizes(a, b, c, d).bound_of_four(m));
}

CGAL_DELAUNAY_FROM_SURFACE_3_APART int beyond_sign_by_columns(const double* const* vertices,
                                                              const double* p)
{
  const Row<double> a = row(vertices[0], p), b = row(vertices[1], p), c = row(vertices[2], p);
  return -certified_sign(determinant_of(a, b, c), Column_sizes(a, b, c).bound_of_three());
}

CGAL_DELAUNAY_FROM_SURFACE_3_APART int sign_by_columns(double value, double w, const Row<double>& a,
                                                       const Row<double>& b, const Row<double>& c,
                                                       const Row<double>& d)
{
  return certified_sign(value, Column_sizes(a, b, c, d).bound_of_four(w));
}

// By both bounds, one after the other.
inline int sphere_sign_by_either(const Row<double>& a, const Row<double>& b, const Row<double>& c,
                                 const Row<double>& d)
{
  const double value = Sphere_cofactors<double>(a, b, c, d).lifted(a, b, c, d);
  const double m = (std::max)(largest_square(a, b, c), d.w);
  const int sign = certified_sign(value, Filter_bounds::four_rows(m));
  return sign != 0 || value == 0 ? sign : sign_by_columns(value, m, a, b, c, d);
}

// Four sphere tests at once: those of the neighbours of a cell. Bit i of `inside` says that p is
// inside the sphere of the neighbour beyond facet i, of `outside` that it is outside.
struct Sphere_signs
{
  unsigned inside, outside;
};

// Where p is from a cell: in the sphere (sign), and beyond which facet.
struct Cell_view
{
  int sphere;       // 1: inside, -1: outside, 0: not decided
  double facets[4]; // > facet_bound: p is on the inner side; < -facet_bound: beyond
  double facet_bound;
  double pushes[4]; // the facets, times the fourth powers of the distances from the vertices to p
};

// Scalar code for any machine. Wide_sphere_filter.h has the same for vectors, by the first bound
// alone: there the other one costs too much for what it decides.
struct Sphere_filter
{
  // `vertices` of the cell, positively oriented; `opposite`: of each neighbour the vertex that the
  // cell has not. The tests of the facets in `wanted` are made.
  static Sphere_signs neighbors(const double* const* vertices, const double* const* opposite,
                                const double* p, unsigned wanted)
  {
    const Row<double> rows[4] = {row(vertices[0], p), row(vertices[1], p), row(vertices[2], p),
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

  static Cell_view view(const double* const* vertices, const double* p)
  {
    const Row<double> a = row(vertices[0], p), b = row(vertices[1], p), c = row(vertices[2], p),
                      d = row(vertices[3], p);
    const Sphere_cofactors<double> cofactors(a, b, c, d);
    const double m = (std::max)(largest_square(a, b, c), d.w);
    Cell_view view;
    std::copy(cofactors.of, cofactors.of + 4, view.facets);
    view.sphere = certified_sign(cofactors.lifted(a, b, c, d), Filter_bounds::four_rows(m));
    view.facet_bound = Filter_bounds::three_rows(m);
    const double w[4] = {a.w, b.w, c.w, d.w};
    for (unsigned k = 0; k < 4; ++k)
      view.pushes[k] = view.facets[k] * w[k] * w[k];
    return view;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SPHERE_FILTER_H
