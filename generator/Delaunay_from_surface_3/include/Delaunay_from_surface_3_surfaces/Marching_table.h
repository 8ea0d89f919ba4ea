// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_TABLE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_TABLE_H

#include <algorithm>
#include <array>
#include <vector>

namespace surfaces {

/// The triangles of marching tetrahedra for each of the 256 ways in which the corners of a lattice
/// cell can lie inside or outside. A cell is cut into six tetrahedra around its diagonal from
/// corner 0 to corner 7 (bit b of a corner's number is its coordinate b). Neighbouring cells cut
/// their common square alike, so the triangles of all cells form a closed 2-manifold.
class Marching_table
{
public:
  /// An edge of the cut cell: its lower corner, and the bits in which the upper corner differs.
  struct Edge
  {
    int corner;
    int direction;
  };
  using Triangle = std::array<Edge, 3>; // counterclockwise, seen from outside

  Marching_table()
  {
    for (int inside = 0; inside < 256; ++inside) {
      std::array<int, 3> axes = {0, 1, 2};
      do {
        const int a = 1 << axes[0], b = a | 1 << axes[1];
        add_tetrahedron(inside, {0, a, b, 7}, is_odd(axes));
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
  }

  /// Bit c of `inside` says whether corner c lies inside.
  const std::vector<Triangle>& triangles(int inside) const { return cases[inside]; }

private:
  using Tetrahedron = std::array<int, 4>;

  template <class Range>
  static bool is_odd(const Range& permutation)
  {
    bool odd = false;
    for (auto i = permutation.begin(); i != permutation.end(); ++i)
      for (auto j = permutation.begin(); j != i; ++j)
        odd ^= *j > *i;
    return odd;
  }

  static Edge edge(int u, int v) { return {u & v, u ^ v}; }

  // Corners in a tetrahedron come in ascending order, so `is_odd` of a reordering is its parity.
  void add_tetrahedron(int inside, Tetrahedron t, bool negative)
  {
    const auto is_inside = [inside](int corner) { return (inside >> corner & 1) != 0; };
    const auto middle = std::stable_partition(t.begin(), t.end(), is_inside);
    const auto count = middle - t.begin();
    // From here on t is positively oriented, inside corners first.
    if (is_odd(t) != negative)
      std::swap(t[count == 1 ? 2 : 0], t[count == 1 ? 3 : 1]);
    std::vector<Triangle>& out = cases[inside];
    if (count == 1)
      out.push_back({edge(t[0], t[1]), edge(t[0], t[2]), edge(t[0], t[3])});
    else if (count == 3)
      out.push_back({edge(t[3], t[0]), edge(t[3], t[1]), edge(t[3], t[2])});
    else if (count == 2) {
      const Edge ac = edge(t[0], t[2]), ad = edge(t[0], t[3]), bd = edge(t[1], t[3]),
                 bc = edge(t[1], t[2]);
      out.push_back({ac, ad, bd});
      out.push_back({ac, bd, bc});
    }
  }

  std::array<std::vector<Triangle>, 256> cases;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_MARCHING_TABLE_H
