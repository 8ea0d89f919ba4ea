// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DETERMINANTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DETERMINANTS_H

// The determinants of the predicates, over any type of numbers; all stages evaluate these.
//
// Rows are vertices relative to the new point p, lifted to the paraboloid: (x, y, z) = v - p and
// w = x² + y² + z². Signs mean the same in all stages:
//   sphere   positive: p is inside the sphere of a positively oriented cell;
//   facet    positive: p is on the inner side of a cell's facet;
//   beyond   positive: p is beyond the finite facet of an infinite cell, or in its plane and inside
//            its circle;
//   0        not decided, or on it where the stage is exact.
// A cell (v0, v1, v2, v3) is positively oriented if (v1 - v0, v2 - v0, v3 - v0) is right-handed; in
// an infinite cell the infinite vertex v3 stands for a point beyond the facet.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/inlining.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Before loops over the few numbers of a test, which the compiler is to unroll.
#if defined(__clang__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL _Pragma("unroll")
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNROLL _Pragma("GCC unroll 16")
#endif

// Makes an ordinary number of a finished sum. Most are; those of Fixed_integer.h are not.
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
};

// |a b| in the columns x and y.
template <class Number>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Product_of<Number> minor_of(const Row<Number>& a,
                                                                       const Row<Number>& b)
{
  return carried(a.x * b.y - a.y * b.x);
}

// |a b c| in the columns x, y, z: positive if the cell (p, a, b, c) is. Not carried.
template <class Number>
CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE auto
determinant_of(const Row<Number>& a, const Row<Number>& b, const Row<Number>& c)
{
  return a.z * minor_of(b, c) + b.z * minor_of(c, a) + c.z * minor_of(a, b);
}

// The determinant of four rows, positive if p is inside the sphere of the cell, as the sum of each
// w times these. That of a vertex is the orientation of the cell with p in the vertex's place:
// positive if p is on the inner side of the facet opposite to it.
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

// The same for three rows in one plane with p. There w is an affine function of any two coordinates
// in which the triangle has an area; the sum of each w times these has the sign of that area if p
// is inside the circle. They add up to the area.
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_DETERMINANTS_H
