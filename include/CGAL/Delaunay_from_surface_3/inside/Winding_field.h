// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H

// Puts the faces of a soup as triangles into a box of size 1, and finds their winding numbers.

#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The tangent of half the solid angle of a triangle is a quotient (van Oosterom, Strackee 1983); it
// is positive where the triangle is seen from behind.

using Vector_3d = std::array<double, 3>;

// Scales a vector so that its largest absolute coordinate is in [1/2, 1); 0 remains 0.
inline Vector_3d over_power_of_2(const Vector_3d& v)
{
  int exponent = 0;
  std::frexp((std::max)((std::max)(std::abs(v[0]), std::abs(v[1])), std::abs(v[2])), &exponent);
  return {std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), std::ldexp(v[2], -exponent)};
}

// Returns half the solid angle of the triangle with these corners, seen from q. On the triangle
// itself it is π or -π, at its corners 0.
inline double half_solid_angle(const Vector_3d* corners, const Vector_3d& q)
{
  Vector_3d a = minus(corners[0], q), b = minus(corners[1], q), c = minus(corners[2], q);
  double aa = std::sqrt(dot(a, a)), bb = std::sqrt(dot(b, b)), cc = std::sqrt(dot(c, c));
  if (aa * bb * cc < 0x1p-400) { // products may underflow; only the directions matter
    a = over_power_of_2(a), b = over_power_of_2(b), c = over_power_of_2(c);
    aa = std::sqrt(dot(a, a)), bb = std::sqrt(dot(b, b)), cc = std::sqrt(dot(c, c));
  }
  const double y = dot(a, cross(b, c));
  const double x = aa * bb * cc + dot(a, b) * cc + dot(b, c) * aa + dot(c, a) * bb;
  const double t = y / x;
  if (x > 0 && t * t < 0.0004) // the series is accurate, and most triangles are far away
    return t * (1 - t * t * (1. / 3 - t * t * (1. / 5 - t * t / 7)));
  return std::atan2(y, x);
}

// Holds a box around points, which is empty at first.
struct Box_3d
{
  Vector_3d low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  Vector_3d high = {-low[0], -low[0], -low[0]};

  void add(const Vector_3d& p)
  {
    for (std::size_t j = 0; j < 3; ++j) {
      low[j] = (std::min)(low[j], p[j]);
      high[j] = (std::max)(high[j], p[j]);
    }
  }
  bool meets(const Box_3d& other) const
  {
    for (std::size_t j = 0; j < 3; ++j)
      if (low[j] > other.high[j] || high[j] < other.low[j])
        return false;
    return true;
  }
  // Returns the axis along which the box is longest.
  std::size_t longest_side() const
  {
    std::size_t longest = 0;
    for (std::size_t j = 1; j < 3; ++j)
      if (high[j] - low[j] > high[longest] - low[longest])
        longest = j;
    return longest;
  }
};

// Multipole represents oriented triangles as seen from far away, by the expansion of their solid
// angle around a centre to the third order (Barill et al. 2018). The field r / |r|³ is a gradient,
// so only the symmetric parts of the moments of area vectors n and places y count: Σ n, Σ n y,
// ½ Σ ∫ n y y.

using Triangle_3d = std::array<Vector_3d, 3>;
using Symmetric_matrix = std::array<double, 6>; // xx, yy, zz, xy, xz, yz

// Returns the symmetric part of v w.
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

  // Adds another expansion, whose centre is at d relative to this one's centre.
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

  // Returns the solid angle of all triangles, seen from the point from which r leads to the centre.
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

  // Adds the symmetric part of v m.
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

inline Vector_3d vector_of(const double* p)
{
  return {p[0], p[1], p[2]};
}

// Moves a box to 0 and scales it to about 1, so that no product of coordinates overflows. The box
// is that of a surface; other points may lie anywhere, so a point extremely far from the box is
// moved nearer, along its direction.
class Unit_frame
{
  static constexpr double farthest = 0x1p200;

public:
  explicit Unit_frame(const Box_3d& box)
  {
    if (box.high[0] < box.low[0])
      return;
    double half = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      m_half_middle[j] = box.low[j] / 4 + box.high[j] / 4; // halves do not overflow
      half = (std::max)(half, box.high[j] / 2 - box.low[j] / 2);
    }
    int exponent = 0;
    std::frexp(half, &exponent);
    m_factors[0] = std::ldexp(1., (1 - exponent) / 2);
    m_factors[1] = std::ldexp(1., 1 - exponent - (1 - exponent) / 2);
  }

  Vector_3d operator()(const Vector_3d& p) const
  {
    Vector_3d q;
    double most = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      q[j] = p[j] / 2 - m_half_middle[j];
      most = (std::max)(most, std::abs(q[j]));
    }
    const bool is_near = most * m_factors[0] * m_factors[1] <= farthest;
    for (double& x : q)
      x = is_near ? x * m_factors[0] * m_factors[1] : x / most * farthest;
    return q;
  }

private:
  Vector_3d m_half_middle = {0, 0, 0};
  double m_factors[2] = {1, 1}; // powers of 2; their product may overflow
};

// Computes generalised winding numbers (Jacobson, Kavan, Sorkine-Hornung 2013): the sum of the
// solid angles of oriented triangles over 4π. It is an integer if the triangles are closed, and
// nearly one if they are nearly closed. Triangles far away are taken together (Barill et al. 2018).
//
// Invariant: the clusters stand in preorder, each before its two halves; `next` leads past these.
// Cost: O(n log n) for n triangles; a query visits O(log n) clusters if these are spread evenly.

class Winding_tree
{
  static constexpr double four_pi = 12.566370614359172954;
  // The distance, in radii, beyond which a cluster is taken as a whole.
  static constexpr double far = 2;

  struct Cluster
  {
    Vector_3d center = {0, 0, 0};
    double reach = 0; // the distance beyond which it is far
    double area = 0;
    Multipole field;
    std::uint32_t first = 0, last = 0; // its triangles
    std::uint32_t next = 0;            // the cluster after all its parts
  };

public:
  // Keeps the triangles. A query ignores clusters so far away that all triangles together, at that
  // distance, would change its number by less than `least`.
  explicit Winding_tree(std::vector<Triangle_3d>&& triangles, double least = 0)
    : m_triangles(std::move(triangles))
    , m_leaf(least > 0 ? 2 : 8)
  {
    if (m_triangles.empty())
      return;
    m_clusters.reserve(4 * m_triangles.size() / m_leaf + 1);
    build(0, m_triangles.size());
    // Changes below `faint` are lost to rounding; powers of much larger distances would overflow.
    constexpr double faint = 1e-30;
    m_horizon = std::sqrt(m_clusters.front().area / (four_pi * (std::max)(least, faint)));
  }

  static constexpr std::size_t most = 16; // the largest number of queries at a time

  // Answers n ≤ most queries that are near each other, and treat the same clusters as far.
  void operator()(const Vector_3d* q, std::size_t n, double* numbers) const
  {
    double angles[most] = {0}, half_angles[most] = {0};
    const Ball ball = ball_around(q, n);
    for (std::size_t k = 0; k < m_clusters.size();) {
      const Cluster& cluster = m_clusters[k];
      const Vector_3d r = minus(cluster.center, ball.center);
      const double reach = cluster.reach + ball.radius;
      if (dot(r, r) > reach * reach) {
        const double horizon = m_horizon + reach;
        for (std::size_t i = 0; i < n && dot(r, r) < horizon * horizon; ++i)
          angles[i] += cluster.field.solid_angle(minus(cluster.center, q[i]));
        k = cluster.next;
        continue;
      }
      if (cluster.next == ++k)
        for (std::size_t t = cluster.first; t < cluster.last; ++t)
          for (std::size_t i = 0; i < n; ++i)
            half_angles[i] += half_solid_angle(m_triangles[t].data(), q[i]);
    }
    for (std::size_t i = 0; i < n; ++i)
      numbers[i] = (2 * half_angles[i] + angles[i]) / four_pi;
  }

  double operator()(const Vector_3d& q) const
  {
    double number;
    (*this)(&q, 1, &number);
    return number;
  }

private:
  struct Ball
  {
    Vector_3d center = {0, 0, 0};
    double radius = 0;
  };

  static Ball ball_around(const Vector_3d* q, std::size_t n)
  {
    Ball ball;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        ball.center[j] += q[i][j] / double(n);
    double squared = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector_3d r = minus(q[i], ball.center);
      squared = (std::max)(squared, dot(r, r));
    }
    ball.radius = std::sqrt(squared);
    return ball;
  }

  void build(std::size_t first, std::size_t last)
  {
    const std::size_t k = m_clusters.size();
    m_clusters.emplace_back();
    if (last - first <= m_leaf) {
      m_clusters[k] = cluster_of(first, last);
    } else {
      const std::size_t middle = first + (last - first) / 2;
      split(first, middle, last);
      build(first, middle);
      const std::size_t second = m_clusters.size();
      build(middle, last);
      m_clusters[k] = joined(m_clusters[k + 1], m_clusters[second]);
    }
    Cluster& cluster = m_clusters[k];
    cluster.first = std::uint32_t(first);
    cluster.last = std::uint32_t(last);
    cluster.next = std::uint32_t(m_clusters.size());
    cluster.reach = (std::max)(far * radius_of(cluster.center, first, last), nearest);
  }

  // The least reach of a cluster: powers of shorter distances would underflow.
  static constexpr double nearest = 0x1p-100;

  static double sum(const Triangle_3d& t, std::size_t j) { return t[0][j] + t[1][j] + t[2][j]; }

  // Splits triangles along the longest side of the box of their centres.
  void split(std::size_t first, std::size_t middle, std::size_t last)
  {
    Box_3d sums;
    for (std::size_t t = first; t < last; ++t)
      sums.add({sum(m_triangles[t], 0), sum(m_triangles[t], 1), sum(m_triangles[t], 2)});
    const std::size_t longest = sums.longest_side();
    const auto at = [&](std::size_t t) { return m_triangles.begin() + std::ptrdiff_t(t); };
    std::nth_element(at(first), at(middle), at(last), [&](const auto& s, const auto& t) {
      return sum(s, longest) < sum(t, longest);
    });
  }

  // Makes a cluster of few triangles, with the centroid of their areas as its centre.
  Cluster cluster_of(std::size_t first, std::size_t last) const
  {
    Cluster cluster;
    const double share = 1 / double(last - first);
    Vector_3d weighted = {0, 0, 0};
    for (std::size_t t = first; t < last; ++t) {
      const Vector_3d n = area_vector(m_triangles[t]);
      const double area = std::sqrt(dot(n, n));
      cluster.area += area;
      for (std::size_t j = 0; j < 3; ++j) {
        weighted[j] += area * sum(m_triangles[t], j) / 3;
        cluster.center[j] += share * sum(m_triangles[t], j) / 3; // used if all areas are 0
      }
    }
    for (std::size_t j = 0; cluster.area > 0 && j < 3; ++j)
      cluster.center[j] = weighted[j] / cluster.area;
    for (std::size_t t = first; t < last; ++t) {
      const Triangle_3d& triangle = m_triangles[t];
      const Vector_3d& center = cluster.center;
      cluster.field.add(
          {minus(triangle[0], center), minus(triangle[1], center), minus(triangle[2], center)},
          area_vector(triangle));
    }
    return cluster;
  }

  // Returns the union of two clusters.
  static Cluster joined(const Cluster& a, const Cluster& b)
  {
    Cluster cluster;
    cluster.area = a.area + b.area;
    const double share = cluster.area > 0 ? a.area / cluster.area : 0.5;
    for (std::size_t j = 0; j < 3; ++j)
      cluster.center[j] = share * a.center[j] + (1 - share) * b.center[j];
    for (const Cluster* const part : {&a, &b})
      cluster.field.add(part->field, minus(part->center, cluster.center));
    return cluster;
  }

  double radius_of(const Vector_3d& center, std::size_t first, std::size_t last) const
  {
    double squared = 0;
    for (std::size_t t = first; t < last; ++t)
      for (const Vector_3d& p : m_triangles[t]) {
        const Vector_3d r = minus(p, center);
        squared = (std::max)(squared, dot(r, r));
      }
    return std::sqrt(squared);
  }

  std::vector<Triangle_3d> m_triangles;
  std::vector<Cluster> m_clusters;
  std::size_t m_leaf; // the largest number of triangles in a leaf
  double m_horizon = 0;
};

struct Winding_field
{
  Unit_frame frame;
  Winding_tree tree;
};

// Calls visit(i, j, k, f) with the points of the triangles of face f = 0, 1, …, which cut every other
// corner off a polygon until none is left: in a fan of many triangles the boxes of all would meet.
// Throws Surface_input_error if an index is not one of 0, …, n-1.
template <class FaceRange, class Visit>
void for_each_triangle(const FaceRange& faces, std::size_t n, const Visit& visit)
{
  std::size_t f = 0;
  std::vector<std::size_t> corners;
  for (const auto& face : faces) {
    check_face(face, f, n);
    corners.clear();
    for (const auto& index : face)
      corners.push_back(std::size_t(index));
    for (std::size_t step = 1; step < corners.size(); step *= 2)
      for (std::size_t i = 0; i + step < corners.size(); i += 2 * step)
        if (i + 2 * step < corners.size())
          visit(corners[i], corners[i + step], corners[i + 2 * step], f);
        else if (i > 0)
          visit(corners[0], corners[i], corners[i + step], f);
    ++f;
  }
}

// Returns the frame of the points of all triangles: other points must not make these small. A
// triangle that has a point twice is ignored, and so are its points.
template <class FaceRange>
Unit_frame frame_of(const FaceRange& faces, const Point_array& points)
{
  Box_3d box;
  for_each_triangle(
      faces, points.size(), [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
        const Triangle_3d t = {vector_of(points[i]), vector_of(points[j]), vector_of(points[k])};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
          for (const Vector_3d& p : t)
            box.add(p);
      });
  return Unit_frame(box);
}

// Makes the field of faces. Throws Surface_input_error if a face has an index out of range.
template <class FaceRange>
Winding_field winding_field(const Point_array& points, const FaceRange& faces)
{
  const Unit_frame frame = frame_of(faces, points);
  std::vector<Triangle_3d> triangles;
  const auto at = [&](std::size_t i) { return frame(vector_of(points[i])); };
  for_each_triangle(faces, points.size(),
                    [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
                      triangles.push_back({at(i), at(j), at(k)});
                    });
  return {frame, Winding_tree(std::move(triangles))};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_FIELD_H
