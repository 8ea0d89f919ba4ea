// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SPHERE_FILTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SPHERE_FILTER_H

// The first stage of the predicates: determinants in double, relative to the new point p, with one
// bound on their error.
//
// Rows are (x, y, z, w) with (x, y, z) = v - p and w = x² + y² + z². A determinant of four rows is
// a sum of 24 products x y z w; each goes through at most 17 roundings, 3 + 5 of them in its
// factors. By the inequality of Hadamard type for permanents (Carlen, Lieb, Loss 2006) the products
// that share w sum up to at most 2/√3 m^(3/2) in absolute value where m bounds all w; so the error
// is at most 4 · 2/√3 · 17 u m^(5/2) < 80 u m^(5/2) with u = 2^-53. In the same way it is less than
// 16 u m^(3/2) for three rows (x, y, z). Contraction to fma only removes roundings.
//
// Coordinates are at most 1 in absolute value (the caller scales them by a power of 2). Hence
// nothing overflows, and what underflows changes a result by less than `tiny`.

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

struct Filter_bounds
{
  static constexpr double unit = 1. / 9007199254740992.; // 2^-53
  static constexpr double tiny = 1e-300;
  static double four_rows(double m) { return 80 * unit * (m * m * std::sqrt(m)) + tiny; }
  static double three_rows(double m) { return 16 * unit * (m * std::sqrt(m)) + tiny; }
};

// v - p and its squared length.
struct Row
{
  double x, y, z, w;
  Row(const double* v, const double* p)
    : x(v[0] - p[0])
    , y(v[1] - p[1])
    , z(v[2] - p[2])
    , w(x * x + y * y + z * z)
  {
  }
};

// -1, 0 or 1; 0: not decided.
inline int certified_sign(double value, double bound)
{
  return (value > bound) - (value < -bound);
}

// |a b c| in columns x, y, z: positive if the cell (p, a, b, c) is.
inline double determinant(const Row& a, const Row& b, const Row& c)
{
  return a.z * (b.x * c.y - b.y * c.x) + b.z * (c.x * a.y - c.y * a.x) +
         c.z * (a.x * b.y - a.y * b.x);
}

inline int orientation_sign(const Row& a, const Row& b, const Row& c)
{
  const double m = (std::max)((std::max)(a.w, b.w), c.w);
  return certified_sign(determinant(a, b, c), Filter_bounds::three_rows(m));
}

// Positive if p is inside the sphere through e, a, b, c, where the cell (e, a, b, c) is negatively
// oriented: e lies beyond the facet (a, b, c) of a cell.
inline int sphere_sign(const Row& e, const Row& a, const Row& b, const Row& c)
{
  const double xy_bc = b.x * c.y - b.y * c.x, xy_ca = c.x * a.y - c.y * a.x,
               xy_ab = a.x * b.y - a.y * b.x;
  const double zw_bc = b.z * c.w - b.w * c.z, zw_ca = c.z * a.w - c.w * a.z,
               zw_ab = a.z * b.w - a.w * b.z;
  const double value = e.x * (a.y * zw_bc + b.y * zw_ca + c.y * zw_ab) -
                       e.y * (a.x * zw_bc + b.x * zw_ca + c.x * zw_ab) +
                       e.z * (a.w * xy_bc + b.w * xy_ca + c.w * xy_ab) -
                       e.w * (a.z * xy_bc + b.z * xy_ca + c.z * xy_ab);
  const double m = (std::max)((std::max)(e.w, a.w), (std::max)(b.w, c.w));
  return certified_sign(value, Filter_bounds::four_rows(m));
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
};

// Scalar code for any machine. Wide_sphere_filter.h has the same for vectors.
struct Sphere_filter
{
  // `vertices` of the cell, positively oriented; `opposite`: of each neighbour the vertex that the
  // cell has not. The tests of the facets in `wanted` are made.
  static Sphere_signs neighbors(const double* const* vertices, const double* const* opposite,
                                const double* p, unsigned wanted)
  {
    const Row rows[4] = {{vertices[0], p}, {vertices[1], p}, {vertices[2], p}, {vertices[3], p}};
    Sphere_signs signs = {0, 0};
    for (unsigned i = 0; i < 4; ++i) {
      if (!(wanted >> i & 1))
        continue;
      const int sign = sphere_sign(Row(opposite[i], p), rows[i ^ 1], rows[i ^ 2], rows[i ^ 3]);
      signs.inside |= unsigned(sign > 0) << i;
      signs.outside |= unsigned(sign < 0) << i;
    }
    return signs;
  }

  static Cell_view view(const double* const* vertices, const double* p)
  {
    const Row rows[4] = {{vertices[0], p}, {vertices[1], p}, {vertices[2], p}, {vertices[3], p}};
    Cell_view view;
    double m = 0, value = 0;
    for (unsigned i = 0; i < 4; ++i) {
      view.facets[i] = determinant(rows[i ^ 1], rows[i ^ 2], rows[i ^ 3]);
      value += rows[i].w * view.facets[i];
      m = (std::max)(m, rows[i].w);
    }
    view.sphere = certified_sign(value, Filter_bounds::four_rows(m));
    view.facet_bound = Filter_bounds::three_rows(m);
    return view;
  }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_SPHERE_FILTER_H
