// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_EDIT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_EDIT_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/random.h>
#include <Delaunay_from_surface_3_surfaces/renumber.h>

#include <CGAL/bounding_box.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace surfaces {

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
  if (count == 0)
    throw std::invalid_argument("there must be at least one component");
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
  if (left > 0)
    throw std::invalid_argument("the surface has no room for " + std::to_string(holes) + " holes");
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
