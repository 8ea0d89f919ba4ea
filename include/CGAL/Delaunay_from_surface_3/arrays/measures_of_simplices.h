// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MEASURES_OF_SIMPLICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MEASURES_OF_SIMPLICES_H

// Volumes, centres of spheres and cells of the Voronoi diagram, in floating point: nearly flat
// tetrahedra are computed with more digits where the machine has them.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vector_products.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A tetrahedron (a, b, c, d) by its edges from a, times a power of 2 that keeps products in range.
template <class Number>
class Scaled_tetrahedron
{
  using Vector = std::array<Number, 3>;

public:
  Scaled_tetrahedron(const std::array<double, 3>* corners)
  {
    double largest = 0;
    for (std::size_t k = 1; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::fabs(corners[k][i] / 2 - corners[0][i] / 2));
    std::frexp(largest, &m_exponent);
    ++m_exponent;
    const double half = std::ldexp(1., -m_exponent / 2);
    const double rest = std::ldexp(1., -m_exponent - -m_exponent / 2);
    for (std::size_t k = 1; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        m_edges[k - 1][i] =
            Number(corners[k][i]) * half * rest - Number(corners[0][i]) * half * rest;
    m_determinant = dot(m_edges[0], cross(m_edges[1], m_edges[2]));
  }

  // Whether the determinant has lost most of its digits.
  bool is_flat() const
  {
    Number product = 1;
    for (const Vector& e : m_edges)
      product *= dot(e, e);
    return !(m_determinant * m_determinant > Number(1e-16) * product);
  }

  double volume() const { return std::ldexp(double(m_determinant / 6), 3 * m_exponent); }

  // The centre of the sphere through the corners, relative to a.
  std::array<double, 3> center() const
  {
    const Vector c = scaled_center();
    return {std::ldexp(double(c[0]), m_exponent), std::ldexp(double(c[1]), m_exponent),
            std::ldexp(double(c[2]), m_exponent)};
  }
  double radius() const
  {
    const Vector c = scaled_center();
    return std::ldexp(double(std::sqrt(dot(c, c))), m_exponent);
  }

  // What the corners have of the tetrahedron by Voronoi's rule, with signs: the sum over the tetrahedra
  // of a vertex is the volume of its cell. Corner, middle of an edge, centre of a triangle and centre
  // of the sphere are a tetrahedron with three right angles at each of the six flags of a corner.
  std::array<double, 4> shares() const
  {
    const Vector center = scaled_center();
    const Vector corners[4] = {{0, 0, 0}, m_edges[0], m_edges[1], m_edges[2]};
    std::array<double, 4> shares = {0, 0, 0, 0};
    for (unsigned v = 0; v < 4; ++v)
      for (unsigned e = 0; e < 4; ++e)
        for (unsigned f = 0; f < 4; ++f)
          if (v != e && v != f && e != f) {
            const unsigned last = 6 - v - e - f;
            const Vector u = minus(corners[e], corners[v]), w = minus(corners[f], corners[v]);
            const Vector n = cross(u, w), o = minus(center, corners[v]);
            const Number uu = dot(u, u);
            const Number share = uu * (dot(w, w) - dot(u, w)) * dot(n, o) / (24 * dot(n, n));
            const bool is_turned = dot(n, minus(corners[last], corners[v])) < 0;
            shares[v] += std::ldexp(double(is_turned ? -share : share), 3 * m_exponent);
          }
    return shares;
  }

private:
  Vector scaled_center() const
  {
    const Vector &b = m_edges[0], &c = m_edges[1], &d = m_edges[2];
    const Vector p = cross(c, d), q = cross(d, b), r = cross(b, c);
    const Number bb = dot(b, b), cc = dot(c, c), dd = dot(d, d);
    Vector center;
    for (std::size_t i = 0; i < 3; ++i)
      center[i] = (bb * p[i] + cc * q[i] + dd * r[i]) / (2 * m_determinant);
    return center;
  }

  int m_exponent;
  Vector m_edges[3];
  Number m_determinant;
};

// Calls f with the tetrahedron, in numbers of sufficient precision.
template <class F>
auto with_scaled_tetrahedron(const std::array<double, 3>* corners, const F& f)
{
  const Scaled_tetrahedron<double> tetrahedron(corners);
  return tetrahedron.is_flat() ? f(Scaled_tetrahedron<long double>(corners)) : f(tetrahedron);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_MEASURES_OF_SIMPLICES_H
