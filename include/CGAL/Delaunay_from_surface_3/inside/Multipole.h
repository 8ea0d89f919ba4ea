// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_MULTIPOLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_MULTIPOLE_H

// What oriented triangles look like from far away: the expansion of their solid angle around a
// centre, to the third order (Barill et al. 2018). The field r / |r|³ is a gradient, so only the
// symmetric parts of the moments of area vectors n and places y count: Σ n, Σ n y, ½ Σ ∫ n y y.

#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Triangle_3d = std::array<Vector_3d, 3>;
using Symmetric_matrix = std::array<double, 6>; // xx, yy, zz, xy, xz, yz

// v w, symmetric.
inline Symmetric_matrix product(const Vector_3d& v, const Vector_3d& w)
{
  return {v[0] * w[0],
          v[1] * w[1],
          v[2] * w[2],
          (v[0] * w[1] + v[1] * w[0]) / 2,
          (v[0] * w[2] + v[2] * w[0]) / 2,
          (v[1] * w[2] + v[2] * w[1]) / 2};
}

inline Vector_3d area_vector(const Triangle_3d& t)
{
  const Vector_3d n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  return {n[0] / 2, n[1] / 2, n[2] / 2};
}

class Multipole
{
public:
  // Adds a triangle with area vector n, given by its corners relative to the centre.
  void add(const Triangle_3d& corners, const Vector_3d& n)
  {
    Vector_3d sum = {0, 0, 0}, third;
    Symmetric_matrix squares = {0, 0, 0, 0, 0, 0};
    for (const Vector_3d& y : corners) {
      add_to(squares, product(y, y), 1. / 24);
      for (std::size_t j = 0; j < 3; ++j)
        sum[j] += y[j];
    }
    add_to(squares, product(sum, sum), 1. / 24);
    for (std::size_t j = 0; j < 3; ++j) {
      third[j] = sum[j] / 3;
      m_dipole[j] += n[j];
    }
    add_to(m_quadrupole, product(n, third), 1);
    add_third(n, squares);
  }

  // Adds another expansion, whose centre is at d relative to that of this one.
  void add(const Multipole& other, const Vector_3d& d)
  {
    for (std::size_t j = 0; j < 3; ++j)
      m_dipole[j] += other.m_dipole[j];
    add_to(m_quadrupole, other.m_quadrupole, 1);
    add_to(m_quadrupole, product(other.m_dipole, d), 1);
    for (std::size_t k = 0; k < m_octupole.size(); ++k)
      m_octupole[k] += other.m_octupole[k];
    add_third(d, other.m_quadrupole);
    Symmetric_matrix square = {0, 0, 0, 0, 0, 0};
    add_to(square, product(d, d), 0.5);
    add_third(other.m_dipole, square);
  }

  // The solid angle of all, seen from where r leads to the centre.
  double solid_angle(const Vector_3d& r) const
  {
    const double x = r[0], y = r[1], z = r[2], xx = x * x, yy = y * y, zz = z * z;
    const auto& s = m_quadrupole;
    const auto& t = m_octupole;
    const double inverse = 1 / (xx + yy + zz);
    const double first = m_dipole[0] * x + m_dipole[1] * y + m_dipole[2] * z;
    const double trace = s[0] + s[1] + s[2];
    const double second =
        s[0] * xx + s[1] * yy + s[2] * zz + 2 * (s[3] * x * y + s[4] * x * z + s[5] * y * z);
    const double traces =
        (t[0] + t[5] + t[7]) * x + (t[1] + t[3] + t[8]) * y + (t[2] + t[4] + t[6]) * z;
    const double third = x * (t[0] * xx + 3 * (t[5] * yy + t[7] * zz)) +
                         y * (t[1] * yy + 3 * (t[3] * xx + t[8] * zz)) +
                         z * (t[2] * zz + 3 * (t[4] * xx + t[6] * yy)) + 6 * t[9] * x * y * z;
    return inverse * std::sqrt(inverse) *
           (first + trace + inverse * (-3 * second - 9 * traces + 15 * inverse * third));
  }

private:
  static void add_to(Symmetric_matrix& m, const Symmetric_matrix& other, double factor)
  {
    for (std::size_t k = 0; k < 6; ++k)
      m[k] += factor * other[k];
  }

  // The symmetric part of v m.
  void add_third(const Vector_3d& v, const Symmetric_matrix& m)
  {
    const double terms[10] = {v[0] * m[0],
                              v[1] * m[1],
                              v[2] * m[2],
                              (2 * v[0] * m[3] + v[1] * m[0]) / 3,
                              (2 * v[0] * m[4] + v[2] * m[0]) / 3,
                              (2 * v[1] * m[3] + v[0] * m[1]) / 3,
                              (2 * v[1] * m[5] + v[2] * m[1]) / 3,
                              (2 * v[2] * m[4] + v[0] * m[2]) / 3,
                              (2 * v[2] * m[5] + v[1] * m[2]) / 3,
                              (v[0] * m[5] + v[1] * m[4] + v[2] * m[3]) / 3};
    for (std::size_t k = 0; k < 10; ++k)
      m_octupole[k] += terms[k];
  }

  Vector_3d m_dipole = {0, 0, 0};
  Symmetric_matrix m_quadrupole = {0, 0, 0, 0, 0, 0};
  // xxx, yyy, zzz, xxy, xxz, yyx, yyz, zzx, zzy, xyz
  std::array<double, 10> m_octupole = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_MULTIPOLE_H
