// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_JITTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_JITTER_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
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
  if (!(fraction >= 0 && fraction < 0.5))
    throw std::invalid_argument("the jitter must be at least 0 and below 0.5");
  if (fraction == 0)
    return;
  const std::vector<double> length = local_edge_lengths(surface);
  Random random(seed);
  for (std::size_t v = 0; v < length.size(); ++v)
    surface.points[v] = surface.points[v] + fraction * length[v] * random.in_ball();
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_JITTER_H
