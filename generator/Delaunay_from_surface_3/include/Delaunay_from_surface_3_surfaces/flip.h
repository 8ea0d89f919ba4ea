// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_FLIP_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_FLIP_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace surfaces {
namespace internal {

// Flips edges of a closed oriented manifold. Halfedge 3 f + k leads from corner k of face f to the
// next corner; `opposite` is an involution on the halfedges at all times.
class Edge_flipper
{
  using Point_3 = Indexed_surface::Point_3;
  using Vector_3 = Indexed_surface::Vector_3;

public:
  explicit Edge_flipper(Indexed_surface& surface)
    : surface(surface)
    , opposite(3 * surface.faces.size())
  {
    std::vector<std::size_t> first(surface.points.size() + 1, 0), out(opposite.size());
    for (std::size_t h = 0; h < out.size(); ++h)
      ++first[source(h) + 1];
    for (std::size_t v = 1; v < first.size(); ++v)
      first[v] += first[v - 1];
    std::vector<std::size_t> end(first.begin(), first.end() - 1);
    for (std::size_t h = 0; h < out.size(); ++h)
      out[end[source(h)]++] = h;
    for (std::size_t h = 0; h < out.size(); ++h) {
      std::size_t i = first[target(h)];
      while (target(out[i]) != source(h))
        ++i;
      opposite[h] = out[i];
    }
  }

  /// Flips every edge that gains by it, once. Returns the number of flips.
  std::size_t pass()
  {
    std::size_t flips = 0;
    for (std::size_t h = 0; h < opposite.size(); ++h)
      if (h < opposite[h] && gains(h)) {
        flip(h);
        ++flips;
      }
    return flips;
  }

private:
  static std::size_t next(std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  std::size_t& source(std::size_t h) { return surface.faces[h / 3][h % 3]; }
  std::size_t target(std::size_t h) { return source(next(h)); }
  std::size_t apex(std::size_t h) { return source(next(next(h))); }
  const Point_3& point(std::size_t v) const { return surface.points[v]; }

  double cotangent_of_apex(std::size_t h)
  {
    const Vector_3 a = point(source(h)) - point(apex(h)), b = point(target(h)) - point(apex(h));
    return a * b / std::sqrt(CGAL::cross_product(a, b).squared_length());
  }

  Vector_3 normal(std::size_t a, std::size_t b, std::size_t c) const
  {
    return CGAL::cross_product(point(b) - point(a), point(c) - point(a));
  }

  // The two angles opposite to the edge add up to more than pi, the surface does not fold, and the
  // new edge is not there yet.
  bool gains(std::size_t h)
  {
    const std::size_t g = opposite[h];
    if (!(cotangent_of_apex(h) + cotangent_of_apex(g) < -1e-9))
      return false;
    const std::size_t a = source(h), b = target(h), c = apex(h), d = apex(g);
    const Vector_3 before = normal(a, b, c) + normal(b, a, d);
    return normal(a, d, c) * before > 0 && normal(d, b, c) * before > 0 && !is_edge(h, d);
  }

  // Is there an edge from the apex of h to the vertex v?
  bool is_edge(std::size_t h, std::size_t v)
  {
    const std::size_t start = next(next(h));
    std::size_t out = start;
    do {
      if (target(out) == v)
        return true;
      out = next(opposite[out]);
    } while (out != start);
    return false;
  }

  void join(std::size_t h, std::size_t g)
  {
    opposite[h] = g;
    opposite[g] = h;
  }

  // Faces (a, b, c) and (b, a, d) become (a, d, c) and (d, b, c).
  void flip(std::size_t h)
  {
    const std::size_t g = opposite[h];
    const std::size_t bc = opposite[next(h)], ad = opposite[next(g)];
    const std::size_t c = apex(h), d = apex(g);
    source(next(h)) = d; // h: a -> d, then d -> c, then c -> a as before
    source(next(g)) = c; // g: b -> c, then c -> d, then d -> b as before
    join(h, ad);
    join(g, bc);
    join(next(h), next(g));
  }

  Indexed_surface& surface;
  std::vector<std::size_t> opposite;
};

} // namespace internal

/// Flips the edges whose two opposite angles add up to more than pi, in passes over all edges until
/// none is left or `passes` are done. Where the points are dense on a smooth surface, all its
/// triangles belong to the points' 3D Delaunay triangulation afterwards, as on a good scan. Linear.
/// \pre the surface is a closed oriented manifold
inline void flip_to_delaunay(Indexed_surface& surface, int passes = 4)
{
  internal::Edge_flipper flipper(surface);
  while (passes-- > 0 && flipper.pass() > 0)
    ;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_FLIP_H
