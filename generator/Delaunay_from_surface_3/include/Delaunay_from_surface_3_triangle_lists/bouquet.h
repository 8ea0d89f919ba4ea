// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_BOUQUET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_BOUQUET_H

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace triangle_lists {

/// A polygon with rings about its middle, vertex 0, whose sides are glued so that all its corners
/// become one, vertex 1: a surface on which one vertex is as often in the cut as can be.
struct Bouquet
{
  /// The sides in order: letter k runs forwards, -k backwards. A letter is there twice.
  std::vector<int> word;
  /// How many boundary loops there are at the ends of paths from vertex 1.
  int loops_elsewhere = 0;
  /// Whether one more boundary loop runs through vertex 1.
  bool has_loop_at_corner = false;
  /// Whether each corner is cut off by an edge, with a vertex behind it that only vertex 1 leads
  /// to.
  bool has_pockets = false;
};

/// The closed surface of genus g: a b a^-1 b^-1 for each handle. A sphere has no word.
inline Bouquet orientable_bouquet(int genus)
{
  Bouquet result;
  for (int k = 0; k < genus; ++k)
    for (const int side : {2 * k + 1, 2 * k + 2, -2 * k - 1, -2 * k - 2})
      result.word.push_back(side);
  return result;
}

/// The closed surface of k cross-caps: a a for each.
inline Bouquet non_orientable_bouquet(int cross_caps)
{
  Bouquet result;
  for (int k = 1; k <= cross_caps; ++k)
    result.word.insert(result.word.end(), {k, k});
  return result;
}

namespace internal {

// The vertices of the polygon in order. Between two corners a side has three more, which makes the
// surface simple.
inline std::vector<int> polygon_of(const Bouquet& bouquet, int& n)
{
  std::vector<int> polygon;
  const auto append = [&](int first, bool forwards) {
    for (int j = 0; j < 3; ++j)
      polygon.push_back(first + (forwards ? j : 2 - j));
  };
  int letters = 0;
  for (const int side : bouquet.word) {
    polygon.push_back(1);
    append(n + 3 * (std::abs(side) - 1), side > 0);
    letters = std::max(letters, std::abs(side));
  }
  n += 3 * letters;
  for (int k = 0; k < bouquet.loops_elsewhere; ++k, n += 7) {
    polygon.push_back(1);
    append(n, true);
    polygon.push_back(n + 3);
    append(n + 4, true);
    polygon.push_back(n + 3);
    append(n, false);
  }
  if (bouquet.has_loop_at_corner) {
    polygon.push_back(1);
    append(n, true);
    n += 3;
  }
  return polygon;
}

} // namespace internal

inline Triangle_list triangulated(const Bouquet& bouquet)
{
  Triangle_list s{2, {}};
  std::vector<int> outer = internal::polygon_of(bouquet, s.n);
  const int size = int(outer.size());
  const auto is_cut_off = [&](int i) {
    return bouquet.has_pockets && outer[std::size_t(i % size)] == 1;
  };
  for (int ring = 0; ring < 3; ++ring) {
    const auto p = [&](int i) { return outer[std::size_t(i % size)]; };
    const auto q = [&](int i) { return s.n + i % size; };
    for (int i = 0; i < size; ++i) {
      const int next = i + 1;
      if (ring == 0 && is_cut_off(i))
        continue; // with the corner before
      if (ring == 0 && is_cut_off(next)) {
        const int pocket = s.n + size + i;
        s.triangles.push_back({p(i), p(next), pocket});
        s.triangles.push_back({p(next), p(i + 2), pocket});
        s.triangles.push_back({p(i), pocket, p(i + 2)});
        s.triangles.push_back({p(i), p(i + 2), q(next)});
        s.triangles.push_back({p(i), q(next), q(i)});
        s.triangles.push_back({p(i + 2), q(i + 2), q(next)});
        continue;
      }
      s.triangles.push_back({p(i), p(next), q(i)});
      s.triangles.push_back({p(next), q(next), q(i)});
    }
    for (int i = 0; i < size; ++i)
      outer[std::size_t(i)] = s.n + i;
    s.n += size + (ring == 0 && bouquet.has_pockets ? size : 0);
  }
  for (int i = 0; i < size; ++i)
    s.triangles.push_back({outer[std::size_t(i)], outer[std::size_t((i + 1) % size)], 0});
  return s;
}

/// The same surface with its vertices in another order, but for vertex 0. `corner`, the number of
/// the vertex at the corners, goes with it.
template <class Random>
Triangle_list renumbered(Triangle_list s, int& corner, Random& random)
{
  std::vector<int> number(std::size_t(s.n));
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin() + 1, number.end(), random);
  for (Triangle& t : s.triangles)
    for (int& v : t)
      v = number[std::size_t(v)];
  std::shuffle(s.triangles.begin(), s.triangles.end(), random);
  corner = number[std::size_t(corner)];
  return s;
}

} // namespace triangle_lists

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_BOUQUET_H
