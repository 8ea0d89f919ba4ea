// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_STACKED_COMPLETE_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_STACKED_COMPLETE_GRAPH_H

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

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

} // namespace triangle_lists

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_STACKED_COMPLETE_GRAPH_H
