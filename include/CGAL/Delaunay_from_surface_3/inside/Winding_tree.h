// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_TREE_H

// Generalised winding numbers (Jacobson, Kavan, Sorkine-Hornung 2013): the sum of the solid angles
// of oriented triangles over 4π. It is a whole number where they are closed, and nearly one where
// they nearly are. Triangles far away are taken together (Barill et al. 2018).
//
// Invariant: the clusters stand in preorder, each before its two halves; `next` leads past these.
// Cost: O(n log n) for n triangles; a query O(log n) clusters where these are spread evenly.

#include <CGAL/Delaunay_from_surface_3/inside/Box_3d.h>
#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Winding_tree
{
  static constexpr double four_pi = 12.566370614359172954;
  // The distance, in radii, from which on a cluster is taken as a whole.
  static constexpr double far = 2;

  struct Cluster
  {
    Vector_3d center = {0, 0, 0};
    double reach = 0; // the distance from which on it is far
    double area = 0;
    Multipole field;
    std::uint32_t first = 0, last = 0; // its triangles
    std::uint32_t next = 0;            // the cluster after all its parts
  };

public:
  // Keeps the triangles. What is so far away that all together would not change a number by `least`
  // is left out.
  explicit Winding_tree(std::vector<Triangle_3d>&& triangles, double least = 0)
    : m_triangles(std::move(triangles))
    , m_leaf(least > 0 ? 2 : 8)
  {
    if (m_triangles.empty())
      return;
    m_clusters.reserve(4 * m_triangles.size() / m_leaf + 1);
    build(0, m_triangles.size());
    // No number shows less than `faint`; much farther away powers of the distance would overflow.
    constexpr double faint = 1e-30;
    m_horizon = std::sqrt(m_clusters.front().area / (four_pi * (std::max)(least, faint)));
  }

  static constexpr std::size_t most = 16; // queries at a time

  // Answers n ≤ most queries near each other, which see the same clusters as far.
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

  // Of what is still nearer powers of the distance would vanish.
  static constexpr double nearest = 0x1p-100;

  static double sum(const Triangle_3d& t, std::size_t j) { return t[0][j] + t[1][j] + t[2][j]; }

  // By the longest side of the box of the centres.
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

  // Of few triangles: the middle by area, and the moments from there.
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
        cluster.center[j] += share * sum(m_triangles[t], j) / 3; // what is left if all are flat
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

  // The union of two clusters.
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
  std::size_t m_leaf; // triangles, at most
  double m_horizon = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_WINDING_TREE_H
