// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_BOUQUET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_BOUQUET_H

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace triangle_lists {

/// A triangulation of the closed orientable surface of genus (n - 3) (n - 4) / 12 in which any two
/// of the n vertices are neighbours, for n = 7, 19 and 31. Such are known for every n that leaves a
/// remainder of 0, 3, 4 or 7 by 12 (Ringel 1974).
///
/// Vertices are numbers modulo n. Each triple (a, b, c), with a + b + c = 0, makes the n triangles
/// i, i + a, i + a + b; every number but 0 is in one triple, so that there is one triangle on either
/// side of each edge, and the triangles at vertex 0, hence at any, follow each other in one cycle.
inline Triangle_list complete_graph(int n)
{
  std::vector<Triangle> triples;
  if (n == 7)
    triples = {{1, 4, 2}, {3, 5, 6}};
  else if (n == 19)
    triples = {{1, 4, 14}, {2, 7, 10}, {3, 17, 18}, {5, 6, 8}, {9, 16, 13}, {11, 15, 12}};
  else if (n == 31)
    triples = {{1, 28, 2},  {3, 8, 20},   {4, 18, 9},   {5, 12, 14},  {6, 10, 15},
               {7, 30, 25}, {11, 29, 22}, {13, 26, 23}, {16, 27, 19}, {17, 21, 24}};
  else
    throw std::invalid_argument("complete_graph: n has to be 7, 19 or 31");
  Triangle_list result{n, {}};
  for (const Triangle& t : triples)
    for (int i = 0; i < n; ++i)
      result.triangles.push_back({i, (i + t[0]) % n, (i + t[0] + t[1]) % n});
  return result;
}

/// Puts a vertex into every triangle.
inline Triangle_list stacked(const Triangle_list& s)
{
  Triangle_list result{s.n, {}};
  for (const Triangle& t : s.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      result.triangles.push_back({t[k], t[(k + 1) % 3], result.n});
    ++result.n;
  }
  return result;
}

/// The stacked complete graph on n vertices: without these n a vertex in each of n (n - 1) / 3
/// triangles is left alone, so every spanning tree has a vertex of degree about n / 3.
inline Triangle_list stacked_complete_graph(int n)
{
  return stacked(complete_graph(n));
}

/// The complete graph on 13 vertices with a vertex in each of the 39 quadrangles of an embedding, of
/// genus 14. Each vertex of the graph is a neighbour of all others, and each vertex put in has four
/// neighbours: the triangulation is 4-connected, but no more.
///
/// Vertices are numbers modulo 13. Each quadruple (a, b, c, d), of sum 0, makes the 13 quadrangles
/// i, i + a, i + a + b, i + a + b + c, as the triples above make triangles.
inline Triangle_list stacked_quadrangles()
{
  const int n = 13;
  const std::vector<std::array<int, 4>> quadruples = {{1, 6, 9, 10}, {2, 4, 12, 8}, {3, 7, 5, 11}};
  Triangle_list result{n, {}};
  for (const auto& q : quadruples)
    for (int i = 0; i < n; ++i, ++result.n)
      for (int k = 0, v = i; k < 4; ++k) {
        const int next = (v + q[std::size_t(k)]) % n;
        result.triangles.push_back({v, next, result.n});
        v = next;
      }
  return result;
}

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
