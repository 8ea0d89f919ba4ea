// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_GENUS_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_GENUS_SURFACE_H

#include <Delaunay_from_surface_3_surfaces/flip.h>
#include <Delaunay_from_surface_3_surfaces/implicit_shapes.h>
#include <Delaunay_from_surface_3_surfaces/jitter.h>
#include <Delaunay_from_surface_3_surfaces/polygonise.h>
#include <Delaunay_from_surface_3_surfaces/smooth.h>
#include <Delaunay_from_surface_3_surfaces/topology.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace surfaces {
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
  if (n == 0 || n + 2 * genus != 2 + f / 2 || number_of_components(surface) != 1)
    throw std::invalid_argument("too few vertices to show genus " + std::to_string(genus) +
                                ": ask for more");
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
