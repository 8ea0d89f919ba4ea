// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_NEARBY_DELAUNAY_TEST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_NEARBY_DELAUNAY_TEST_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace surfaces {

/// Says whether a triangle between points of a cube is in the 3D Delaunay triangulation of all
/// points of the lattice, from the points nearby only.
///
/// The spheres through the corners of a triangle are ordered by their centres, which lie on a
/// line. A point on one side of the triangle's plane is inside all spheres from some centre on, a
/// point on the other side inside all up to one. So the last sphere that is empty on one side is
/// found by going through the points there, and the triangle is Delaunay if the points on the other
/// side are not in it. Where points lie on a common sphere, CGAL's symbolic perturbation decides,
/// which depends on these points only: the answer is that of `is_facet()` of
/// `Delaunay_triangulation_3`.
///
/// A triangle that fails among the points of some cubes fails among all. One that passes is in the
/// triangulation of all if the smallest of its empty balls lies within these cubes; otherwise more
/// cubes are looked at. Rounded numbers say how far to look, and which points are too far from
/// being decisive to be asked for; the signs of the others are exact.
///
/// O(m) for m points in the cubes around; mostly these are 27.
class Nearby_delaunay_test
{
public:
  using Kernel = Indexed_surface::Kernel;
  using Point_3 = Indexed_surface::Point_3;
  using Vector_3 = Indexed_surface::Vector_3;
  using Triangle = Indexed_surface::Face;

  explicit Nearby_delaunay_test(const Crossed_lattice& lattice)
    : m_lattice(lattice)
  {
  }

  bool operator()(std::size_t cube, const Triangle& t)
  {
    if (cube != m_cube) {
      m_cube = cube;
      m_close = points_near(cube, 1);
    }
    Pencil pencil(*this, t, m_close);
    for (std::size_t reach = 1;; reach *= 2) {
      if (!is_facet(t, pencil.decisive))
        return false;
      if (reach >= m_lattice.size() || is_within(pencil, cube, reach))
        return true;
      pencil = Pencil(*this, t, points_near(cube, 2 * reach));
    }
  }

private:
  // Perturbed predicates, which are protected. They use nothing of the triangulation.
  struct Predicates : CGAL::Delaunay_triangulation_3<Kernel>
  {
    using Base = CGAL::Delaunay_triangulation_3<Kernel>;
    using Base::coplanar_side_of_bounded_circle;
    using Base::side_of_oriented_sphere;
  };

  const Point_3& point(std::size_t number) const { return m_lattice.points()[number]; }

  // The first and last number of lattice points along an axis, of the cubes within `reach`.
  std::array<std::size_t, 2> range(std::size_t cube, std::size_t reach, std::size_t axis) const
  {
    const std::size_t i = m_lattice.coordinate(cube, axis);
    return {i - (std::min)(i, reach), (std::min)(i + 1 + reach, m_lattice.size() - 1)};
  }

  // The points on the edges of the cubes within `reach`, and some more.
  std::vector<std::size_t> points_near(std::size_t cube, std::size_t reach) const
  {
    std::vector<std::size_t> result;
    const auto x = range(cube, reach, 0), y = range(cube, reach, 1), z = range(cube, reach, 2);
    for (std::size_t k = z[0]; k <= z[1]; ++k)
      for (std::size_t j = y[0]; j <= y[1]; ++j)
        for (std::size_t i = x[0]; i <= x[1]; ++i)
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t found = m_lattice.point_along(
                i * m_lattice.step(0) + j * m_lattice.step(1) + k * m_lattice.step(2), axis);
            if (found != Crossed_lattice::none)
              result.push_back(found);
          }
    return result;
  }

  // The spheres through the corners of a triangle: their centres are c + l n with the centre c of
  // its circle and its unit normal n, and they are empty for low <= l <= high, but for rounding.
  struct Pencil
  {
    Point_3 c;
    Vector_3 n;
    double squared_radius; // of the circle
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    bool is_known = true; // or low and high may be anything
    std::vector<std::size_t> decisive;

    Pencil(const Nearby_delaunay_test& test, const Triangle& t,
           const std::vector<std::size_t>& near)
    {
      const Point_3 &p = test.point(t[0]), &q = test.point(t[1]), &r = test.point(t[2]);
      const Vector_3 u = q - p, v = r - p, uv = CGAL::cross_product(u, v);
      const Vector_3 to_c =
          CGAL::cross_product(u.squared_length() * v - v.squared_length() * u, uv) /
          (2 * uv.squared_length());
      c = p + to_c;
      n = uv / std::sqrt(uv.squared_length());
      squared_radius = to_c.squared_length();

      struct Bound
      {
        std::size_t point;
        bool is_high;
        double l;
      };
      std::vector<Bound> bounds;
      for (const std::size_t number : near) {
        const Vector_3 d = test.point(number) - c;
        const double side = n * d, power = d.squared_length() - squared_radius;
        if (number == t[0] || number == t[1] || number == t[2])
          continue;
        if (std::abs(side) > 1e-8) {
          const double l = power / (2 * side);
          bounds.push_back({number, side > 0, l});
          if (side > 0)
            high = (std::min)(high, l);
          else
            low = (std::max)(low, l);
        } else { // in the plane, or nearly; outside the circle it bounds nothing but huge balls
          decisive.push_back(number);
          is_known &=
              power > 1e-3 || CGAL::orientation(p, q, r, test.point(number)) == CGAL::COPLANAR;
        }
      }
      for (const Bound& b : bounds) {
        const double tolerance = 0.01 * (1 + std::abs(b.l));
        if (b.is_high ? b.l <= high + tolerance : b.l >= low - tolerance)
          decisive.push_back(b.point);
      }
    }
  };

  // Among points nearby. A triangle in their common plane is a facet if its circle is empty.
  bool is_facet(const Triangle& t, const std::vector<std::size_t>& near) const
  {
    const Point_3 &p = point(t[0]), &q = point(t[1]), &r = point(t[2]);
    for (const bool is_swapped : {false, true}) {
      const Point_3 &a = is_swapped ? q : p, &b = is_swapped ? p : q;
      const auto is_inside = [&](const Point_3& s, const Point_3& x) {
        return m_predicates.side_of_oriented_sphere(a, b, r, s, x, true) == CGAL::ON_POSITIVE_SIDE;
      };
      const Point_3* last = nullptr; // on the last sphere that is empty on the positive side
      for (const std::size_t n : near)
        if (CGAL::orientation(a, b, r, point(n)) == CGAL::POSITIVE &&
            (last == nullptr || is_inside(*last, point(n))))
          last = &point(n);
      if (last != nullptr)
        return std::none_of(near.begin(), near.end(), [&](std::size_t n) {
          return n != t[0] && n != t[1] && n != t[2] && &point(n) != last &&
                 is_inside(*last, point(n));
        });
    }
    return std::none_of(near.begin(), near.end(), [&](std::size_t n) {
      return n != t[0] && n != t[1] && n != t[2] &&
             m_predicates.coplanar_side_of_bounded_circle(p, q, r, point(n), true) ==
                 CGAL::ON_BOUNDED_SIDE;
    });
  }

  // Whether the smallest empty ball is; no points are beyond the rim of the lattice.
  bool is_within(const Pencil& pencil, std::size_t cube, std::size_t reach) const
  {
    const double l = (std::max)((std::min)(0., pencil.high), pencil.low);
    const Point_3 center = pencil.c + l * pencil.n;
    const double radius = std::sqrt(pencil.squared_radius + l * l);
    const double margin = 0.01;    // makes up for rounding
    bool result = pencil.is_known; // and false if something is not a number
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto lines = range(cube, reach, axis);
      const double x = center[int(axis)];
      result = result && (lines[0] == 0 || x - radius > double(lines[0]) + margin) &&
               (lines[1] + 1 == m_lattice.size() || x + radius < double(lines[1]) - margin);
    }
    return result;
  }

  const Crossed_lattice& m_lattice;
  Predicates m_predicates;
  std::size_t m_cube = Crossed_lattice::none; // the last one
  std::vector<std::size_t> m_close;           // the points near it
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_NEARBY_DELAUNAY_TEST_H
