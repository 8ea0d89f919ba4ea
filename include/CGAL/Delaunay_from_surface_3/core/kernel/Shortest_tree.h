// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SHORTEST_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SHORTEST_TREE_H

// The points of a test joined by their shortest tree. Seen from a point that is far from the others
// these lie in one direction, and nothing can be decided; the edges of the tree differ as much as
// they can. Its root is the point where the product of the distances to the others is least.

#include <CGAL/Delaunay_from_surface_3/core/kernel/determinants.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The tree depends on rounded distances; the sign that is found by it must not.
template <int N>
class Shortest_tree
{
public:
  // Of N vertices and p. Keeps pointers to the coordinates.
  Shortest_tree(const double* const* vertices, const double* p)
  {
    std::copy(vertices, vertices + N, m_points);
    m_points[N] = p;
    for (int i = 1; i <= N; ++i)
      for (int j = 0; j < i; ++j)
        m_squares[i][j] = m_squares[j][i] = square(i, j);
    grow();
  }

  // Of the k-th vertex, and of what it hangs on: the root or another vertex. The points of the
  // vertices are those of the constructor, but that p has the place of the root.
  const double* point(int k) const { return m_points[m_places[k]]; }
  const double* parent(int k) const { return m_points[m_parents[k]]; }
  const double* root() const { return m_points[m_root]; }
  // Whether two points have changed places for it.
  bool is_odd() const { return m_root != N; }

private:
  double square(int i, int j) const
  {
    const double *a = m_points[i], *b = m_points[j];
    return Row<double>(a[0] - b[0], a[1] - b[1], a[2] - b[2]).w;
  }

  void grow()
  {
    double products[N + 1];
    for (int i = 0; i <= N; ++i) {
      products[i] = 1;
      for (int j = 0; j <= N; ++j)
        products[i] *= i == j ? 1 : m_squares[i][j];
    }
    const int root = int(std::min_element(products, products + N + 1) - products);
    double distances[N]; // to the tree
    for (int k = 0; k < N; ++k) {
      m_places[k] = k == root ? N : k;
      m_parents[k] = root;
      distances[k] = m_squares[m_places[k]][root];
    }
    m_root = root;
    bool is_in_tree[N] = {};
    for (int joined = 0; joined < N; ++joined) {
      int next = -1;
      for (int k = 0; k < N; ++k)
        if (!is_in_tree[k] && (next < 0 || distances[k] < distances[next]))
          next = k;
      is_in_tree[next] = true;
      for (int k = 0; k < N; ++k)
        if (!is_in_tree[k] && m_squares[m_places[k]][m_places[next]] < distances[k]) {
          distances[k] = m_squares[m_places[k]][m_places[next]];
          m_parents[k] = m_places[next];
        }
    }
  }

  const double* m_points[N + 1];
  double m_squares[N + 1][N + 1];
  int m_places[N], m_parents[N], m_root;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_SHORTEST_TREE_H
