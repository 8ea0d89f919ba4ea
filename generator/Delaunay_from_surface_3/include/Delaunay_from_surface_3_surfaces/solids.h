// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SOLIDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SOLIDS_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Profile.h>

#include <cstddef>

namespace surfaces {

/// A closed solid with `layers` copies of a profile, the walls of quadrangles cut in two, and
/// planar faces at both ends. `position(k, layer)` is where the k-th point of the profile is; a map
/// that keeps its orientation when looked at against the direction of the layers. The points are
/// numbered layer by layer. \pre `layers >= 2`
template <class Position>
Indexed_surface swept(const Profile& profile, std::size_t layers, const Position& position)
{
  const std::size_t n = profile.points.size(), top = (layers - 1) * n;
  Indexed_surface surface;
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (std::size_t k = 0; k < n; ++k)
      surface.points.push_back(position(k, layer));
  for (const Indexed_surface::Face& f : planar_face(profile)) {
    surface.faces.push_back({f[0], f[2], f[1]});
    surface.faces.push_back({top + f[0], top + f[1], top + f[2]});
  }
  const auto edges = profile.edges();
  for (std::size_t first = 0; first < top; first += n)
    for (const auto& [s, t] : edges) {
      surface.faces.push_back({first + s, first + t, first + n + t});
      surface.faces.push_back({first + s, first + n + t, first + n + s});
    }
  return surface;
}

/// A closed solid with `rings` rings of `segments` points and a hub at each end that a fan of
/// triangles joins to the last ring. `position(segment, ring)`; the points are numbered ring by
/// ring, then the two hubs. \pre `segments >= 3`, `rings >= 1`
template <class Position>
Indexed_surface turned(std::size_t segments, std::size_t rings, const Position& position,
                       const Indexed_surface::Point_3& first_hub,
                       const Indexed_surface::Point_3& last_hub)
{
  const std::size_t n = segments * rings;
  Indexed_surface surface;
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t s = 0; s < segments; ++s)
      surface.points.push_back(position(s, r));
  surface.points.push_back(first_hub);
  surface.points.push_back(last_hub);
  for (std::size_t s = 0; s < segments; ++s) {
    const std::size_t t = (s + 1) % segments;
    surface.faces.push_back({n, t, s});
    for (std::size_t first = 0; first + segments < n; first += segments) {
      surface.faces.push_back({first + s, first + t, first + segments + t});
      surface.faces.push_back({first + s, first + segments + t, first + segments + s});
    }
    surface.faces.push_back({n + 1, n - segments + s, n - segments + t});
  }
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SOLIDS_H
