// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SPARSE_LATTICE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SPARSE_LATTICE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/random.h>

#include <boost/functional/hash.hpp>
#include <boost/unordered_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace surfaces {

/// A cubic lattice of a given spacing, in blocks of 8 x 8 x 8 cells, of which only those that an
/// implicit surface may pass through exist. They are found by descending an octree and leaving out
/// every cube whose centre is farther from the surface than its corners: the cost is linear in the
/// number of blocks kept.
class Sparse_lattice
{
public:
  using Point_3 = Indexed_surface::Point_3;
  using Vector_3 = Indexed_surface::Vector_3;
  using Index = std::array<int, 3>;
  static constexpr int block_size = 8;

  template <class Shape>
  Sparse_lattice(const Shape& shape, double spacing, std::uint64_t seed)
    : spacing(spacing)
  {
    int side = block_size;
    while (side * spacing < 2 * shape.radius() + 4 * spacing)
      side *= 2;
    place(side, seed);
    collect(shape, {0, 0, 0}, side);
  }

  /// The lower corners of the blocks, as lattice points.
  const std::vector<Index>& blocks() const { return corners; }

  /// The number of the block with the lower corner `corner`.
  /// \pre the surface passes through that block
  std::size_t block(const Index& corner) const { return numbers.at(corner); }

  Point_3 position(int i, int j, int k) const
  {
    return origin + (i * axes[0] + j * axes[1] + k * axes[2]);
  }

private:
  // The lattice is turned by fixed angles and shifted at random: symmetries of the shape do not
  // fall together with those of the lattice, and no four points become cocircular by design.
  void place(int side, std::uint64_t seed)
  {
    const double c1 = std::cos(0.7), s1 = std::sin(0.7), c2 = std::cos(0.4), s2 = std::sin(0.4);
    axes[0] = spacing * Vector_3(c1, s1, 0);
    axes[1] = spacing * Vector_3(-s1 * c2, c1 * c2, s2);
    axes[2] = spacing * Vector_3(s1 * s2, -c1 * s2, c2);
    Random random(seed);
    origin = CGAL::ORIGIN;
    for (const Vector_3& axis : axes)
      origin = origin + (random.uniform(-0.5, 0.5) - 0.5 * side) * axis;
  }

  template <class Shape>
  void collect(const Shape& shape, const Index& low, int side)
  {
    const int half = side / 2;
    const double to_corner = 0.8661 * side * spacing; // a little more than sqrt(3) / 2
    if (std::abs(shape(position(low[0] + half, low[1] + half, low[2] + half))) > to_corner)
      return;
    if (side == block_size) {
      numbers.emplace(low, corners.size());
      corners.push_back(low);
      return;
    }
    for (int octant = 0; octant < 8; ++octant)
      collect(shape,
              {low[0] + half * (octant & 1), low[1] + half * (octant >> 1 & 1),
               low[2] + half * (octant >> 2)},
              half);
  }

  double spacing;
  std::array<Vector_3, 3> axes;
  Point_3 origin;
  std::vector<Index> corners;
  boost::unordered_map<Index, std::size_t, boost::hash<Index>> numbers;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_SPARSE_LATTICE_H
