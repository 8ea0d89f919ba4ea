// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_EDIT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_EDIT_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace surfaces {

/// The mean length of the edges at each vertex, 0 for a vertex on no face.
inline std::vector<double> local_edge_lengths(const Indexed_surface& surface)
{
  std::vector<double> length(surface.points.size(), 0.);
  std::vector<std::size_t> count(surface.points.size(), 0);
  for (const Indexed_surface::Face& face : surface.faces)
    for (int i = 0; i < 3; ++i) {
      const std::size_t u = face[i], v = face[(i + 1) % 3];
      const double d = std::sqrt(CGAL::squared_distance(surface.points[u], surface.points[v]));
      length[u] += d;
      length[v] += d;
      ++count[u];
      ++count[v];
    }
  for (std::size_t v = 0; v < length.size(); ++v)
    if (count[v] > 0)
      length[v] /= static_cast<double>(count[v]);
  return length;
}

/// Moves every point in a random direction by up to `fraction` of the mean length of its edges.
/// \pre `0 <= fraction < 0.5`
inline void jitter(Indexed_surface& surface, double fraction, std::uint64_t seed)
{
  require(fraction >= 0 && fraction < 0.5, "the jitter must be at least 0 and below 0.5");
  if (fraction == 0)
    return;
  const std::vector<double> length = local_edge_lengths(surface);
  Random random(seed);
  for (std::size_t v = 0; v < length.size(); ++v)
    surface.points[v] = surface.points[v] + fraction * length[v] * random.in_ball();
}

/// Point `order[i]` becomes point i. The faces stay in their order.
inline void renumber(Indexed_surface& surface, const std::vector<std::size_t>& order)
{
  std::vector<std::size_t> new_number(order.size());
  std::vector<Indexed_surface::Point_3> points;
  points.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    new_number[order[i]] = i;
    points.push_back(surface.points[order[i]]);
  }
  surface.points.swap(points);
  for (Indexed_surface::Face& face : surface.faces)
    for (std::size_t& v : face)
      v = new_number[v];
}

/// The points come as the rows of a table, `width` in each, and perhaps more; they are numbered
/// column by column instead, then the others.
inline void number_by_columns(Indexed_surface& surface, std::size_t width)
{
  const std::size_t rows = surface.points.size() / width;
  std::vector<std::size_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t k = 0; k < rows * width; ++k)
    order[k] = k % rows * width + k / rows;
  renumber(surface, order);
}

/// Every coordinate as the nearest number of single precision.
inline void round_to_float(Indexed_surface& surface)
{
  for (Indexed_surface::Point_3& p : surface.points)
    p = Indexed_surface::Point_3(double(float(p.x())), double(float(p.y())), double(float(p.z())));
}

/// Every coordinate as a text file with so many decimals has it.
inline void round_to_decimals(Indexed_surface& surface, unsigned decimals)
{
  const double unit = std::pow(10., decimals);
  const auto round = [unit](double x) { return std::round(x * unit) / unit; };
  for (Indexed_surface::Point_3& p : surface.points)
    p = Indexed_surface::Point_3(round(p.x()), round(p.y()), round(p.z()));
}

/// Adds the points and faces of `other`, moved by `offset`.
inline void append(Indexed_surface& surface, const Indexed_surface& other,
                   const Indexed_surface::Vector_3& offset = CGAL::NULL_VECTOR)
{
  const std::size_t first = surface.points.size();
  for (const Indexed_surface::Point_3& p : other.points)
    surface.points.push_back(p + offset);
  for (const Indexed_surface::Face& face : other.faces)
    surface.faces.push_back({first + face[0], first + face[1], first + face[2]});
}

/// `count` copies of a surface in a row along the x axis, a tenth of its length apart.
/// \pre `count >= 1`
inline Indexed_surface copies(const Indexed_surface& surface, std::size_t count)
{
  require(count > 0, "there must be at least one component");
  double step = 0;
  if (!surface.points.empty()) {
    const auto box = CGAL::bounding_box(surface.points.begin(), surface.points.end());
    step = 1.1 * (box.xmax() - box.xmin());
  }
  Indexed_surface result;
  for (std::size_t i = 0; i < count; ++i)
    append(result, surface, Indexed_surface::Vector_3(static_cast<double>(i) * step, 0, 0));
  return result;
}

/// Opens a closed surface by taking out `holes` faces at random, no two of which share a vertex:
/// every one leaves a boundary loop of three edges, and the surface stays a manifold.
inline void puncture(Indexed_surface& surface, std::size_t holes, std::uint64_t seed)
{
  Random random(seed);
  std::vector<bool> touched(surface.points.size(), false), removed(surface.faces.size(), false);
  std::size_t left = holes;
  for (std::size_t f : random.permutation(surface.faces.size())) {
    if (left == 0)
      break;
    const Indexed_surface::Face& face = surface.faces[f];
    if (touched[face[0]] || touched[face[1]] || touched[face[2]])
      continue;
    for (std::size_t v : face)
      touched[v] = true;
    removed[f] = true;
    --left;
  }
  require(left == 0, "the surface has no room for " + std::to_string(holes) + " holes");
  std::vector<Indexed_surface::Face> kept;
  kept.reserve(surface.faces.size() - holes);
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    if (!removed[f])
      kept.push_back(surface.faces[f]);
  surface.faces.swap(kept);
}

/// Puts the points into random order, the faces likewise.
inline void shuffle(Indexed_surface& surface, std::uint64_t seed)
{
  Random random(seed);
  renumber(surface, random.permutation(surface.points.size()));
  std::vector<Indexed_surface::Face> faces;
  faces.reserve(surface.faces.size());
  for (const std::size_t f : random.permutation(surface.faces.size()))
    faces.push_back(surface.faces[f]);
  surface.faces.swap(faces);
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_EDIT_H
