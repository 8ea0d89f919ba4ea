// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_GENUS_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_GENUS_SURFACE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/implicit_shapes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
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

namespace internal {

// The centroid of the triangles around each vertex.
inline std::vector<Indexed_surface::Point_3> star_centroids(const Indexed_surface& surface)
{
  using Vector_3 = Indexed_surface::Vector_3;
  std::vector<Vector_3> sum(surface.points.size(), CGAL::NULL_VECTOR);
  std::vector<double> weight(surface.points.size(), 0.);
  for (const Indexed_surface::Face& face : surface.faces) {
    const Vector_3 a = surface.points[face[0]] - CGAL::ORIGIN;
    const Vector_3 b = surface.points[face[1]] - CGAL::ORIGIN;
    const Vector_3 c = surface.points[face[2]] - CGAL::ORIGIN;
    const double area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
    for (std::size_t v : face) {
      sum[v] += area * (a + b + c);
      weight[v] += 3 * area;
    }
  }
  std::vector<Indexed_surface::Point_3> centroids(surface.points);
  for (std::size_t v = 0; v < centroids.size(); ++v)
    if (weight[v] > 0)
      centroids[v] = CGAL::ORIGIN + sum[v] / weight[v];
  return centroids;
}

// One step of Newton's method towards f = 0 along the gradient, by differences of width `width`.
template <class Shape>
Indexed_surface::Point_3 projected(const Indexed_surface::Point_3& p, const Shape& shape,
                                   double width)
{
  using Vector_3 = Indexed_surface::Vector_3;
  const double f = shape(p);
  const Vector_3 gradient((shape(p + Vector_3(width, 0, 0)) - f) / width,
                          (shape(p + Vector_3(0, width, 0)) - f) / width,
                          (shape(p + Vector_3(0, 0, width)) - f) / width);
  const double length = gradient.squared_length();
  return length > 1e-3 ? p - f / length * gradient : p;
}

} // namespace internal

/// Evens out the triangles of a surface that approximates the zero set of an implicit shape: in
/// each round every vertex moves to the centroid of its star and from there back to the surface.
template <class Shape>
void smooth(Indexed_surface& surface, const Shape& shape, int rounds)
{
  const double width = 1e-5 * shape.feature();
  for (int round = 0; round < rounds; ++round) {
    std::vector<Indexed_surface::Point_3> points = internal::star_centroids(surface);
    for (Indexed_surface::Point_3& p : points)
      p = internal::projected(p, shape, width);
    surface.points.swap(points);
  }
}

namespace internal {

// The number of vertices goes with spacing^-2, so a coarse polygonisation tells the spacing to
// take.
template <class Shape>
double spacing_for(const Shape& shape, std::size_t n, std::uint64_t seed)
{
  const double wanted = static_cast<double>(n);
  const double pilot = (std::min)(wanted, (std::max)(4000., wanted / 64));
  double spacing = shape.feature() / 3;
  for (int step = 0; step < 3; ++step) {
    const std::size_t found = polygonised(shape, spacing, seed).points.size();
    spacing *= std::sqrt((std::max)(static_cast<double>(found), 1.) / pilot);
  }
  return spacing * std::sqrt(pilot / wanted);
}

// The polygonisation whose number of vertices is nearest to n among a few tries.
template <class Shape>
Indexed_surface polygonised_to_size(const Shape& shape, std::size_t n, std::uint64_t seed)
{
  const double wanted = static_cast<double>(n);
  double spacing = spacing_for(shape, n, seed), best_error = wanted;
  Indexed_surface best;
  for (int step = 0; step < 6 && best_error > 0.01 * wanted; ++step) {
    Indexed_surface surface = polygonised(shape, spacing, seed);
    const double found = static_cast<double>(surface.points.size()),
                 error = std::abs(found - wanted);
    spacing *= std::sqrt((std::max)(found, 1.) / wanted);
    if (error < best_error) {
      best_error = error;
      best = std::move(surface);
    }
  }
  return best;
}

inline void require_genus(const Indexed_surface& surface, std::size_t genus)
{
  // In a closed triangle surface 2 E = 3 F.
  const std::size_t n = surface.points.size(), f = surface.faces.size();
  require(n > 0 && n + 2 * genus == 2 + f / 2 && number_of_components(surface) == 1,
          "too few vertices to show genus " + std::to_string(genus) + ": ask for more");
}

template <class Shape>
Indexed_surface surface_of_shape(const Shape& shape, std::size_t genus, std::size_t n,
                                 double fraction, std::uint64_t seed)
{
  Indexed_surface surface = polygonised_to_size(shape, n, seed);
  require_genus(surface, genus);
  smooth(surface, shape, 3);
  flip_to_delaunay(surface);
  smooth(surface, shape, 2);
  jitter(surface, fraction, seed);
  flip_to_delaunay(surface);
  return surface;
}

} // namespace internal

/// A smooth closed connected surface of the given genus with about `n` vertices (within 2 % once n
/// is some thousands): an ellipsoid or a chain of tori.
/// \param fraction jitter, as a fraction of the local edge length
/// \param seed     shifts the lattice and drives the jitter
/// Throws `std::invalid_argument` when `n` vertices are too few for the genus; 200 per handle do.
inline Indexed_surface genus_surface(std::size_t genus, std::size_t n, double fraction = 0,
                                     std::uint64_t seed = 0)
{
  return internal::surface_of_shape(Torus_chain(genus), genus, n, fraction, seed);
}

/// As `genus_surface()`, but a plate with rounded rims and `genus` round holes: without jitter most
/// of its points lie in two planes, up to rounding.
inline Indexed_surface plate_surface(std::size_t genus, std::size_t n, double fraction = 0,
                                     std::uint64_t seed = 0)
{
  return internal::surface_of_shape(Holed_plate(genus), genus, n, fraction, seed);
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_GENUS_SURFACE_H
