// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_POLYGONISE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_POLYGONISE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/Marching_table.h>
#include <Delaunay_from_surface_3_surfaces/Sparse_lattice.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace surfaces {
namespace internal {

// Marching tetrahedra over the blocks of a sparse lattice, in two passes: the first puts a vertex
// on every lattice edge that crosses the surface, the second joins the vertices by triangles.
// Invariant: an edge belongs to the block that holds its lower end, so a vertex on the border of
// two blocks is made once. A block numbers its vertices by the rank of their edges in a bitmap,
// which makes the lookup of a vertex a bit count and takes 850 bytes for some 300 vertices.
template <class Shape>
class Polygoniser
{
  static constexpr int size = Sparse_lattice::block_size;
  static constexpr int nodes = size + 1; // a block knows the lattice points on its upper faces too
  using Index = Sparse_lattice::Index;
  using Point_3 = Indexed_surface::Point_3;

  struct Block
  {
    std::array<std::uint16_t, nodes * nodes>
        inside{}; // bit i of entry (j, k): lattice point (i, j, k)
    std::array<std::uint64_t, size * size> crossed{};    // bit 8 i + direction of entry (j, k)
    std::array<std::size_t, size * size> first_vertex{}; // of the row (j, k)

    bool is_inside(int i, int j, int k) const { return (inside[j + nodes * k] >> i & 1) != 0; }
  };

public:
  Polygoniser(const Shape& shape, double spacing, std::uint64_t seed)
    : shape(shape)
    , lattice(shape, spacing, seed)
    , blocks(lattice.blocks().size())
  {
  }

  /// Makes the vertices.
  void make_vertices(std::vector<Point_3>& points)
  {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      evaluate(b);
      for (int k = 0; k < size; ++k)
        for (int j = 0; j < size; ++j) {
          blocks[b].first_vertex[j + size * k] = points.size();
          for (int i = 0; i < size; ++i)
            cut_edges(b, i, j, k, points);
        }
    }
  }

  /// Makes the triangles. \pre the vertices are made
  void make_faces(std::vector<Indexed_surface::Face>& faces) const
  {
    const Marching_table table;
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (int k = 0; k < size; ++k)
        for (int j = 0; j < size; ++j)
          for (int i = 0; i < size; ++i)
            for (const Marching_table::Triangle& t :
                 table.triangles(corners_inside(blocks[b], i, j, k)))
              faces.push_back(
                  {vertex(b, i, j, k, t[0]), vertex(b, i, j, k, t[1]), vertex(b, i, j, k, t[2])});
  }

private:
  void evaluate(std::size_t b)
  {
    const Index low = lattice.blocks()[b];
    double* value = values.data();
    for (int k = 0; k < nodes; ++k)
      for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i, ++value) {
          *value = shape(lattice.position(low[0] + i, low[1] + j, low[2] + k));
          blocks[b].inside[j + nodes * k] |= static_cast<std::uint16_t>((*value < 0) << i);
        }
  }

  void cut_edges(std::size_t b, int i, int j, int k, std::vector<Point_3>& points)
  {
    Block& block = blocks[b];
    const Index low = lattice.blocks()[b];
    const bool here = block.is_inside(i, j, k);
    for (int direction = 1; direction < 8; ++direction) {
      const int x = i + (direction & 1), y = j + (direction >> 1 & 1), z = k + (direction >> 2);
      if (block.is_inside(x, y, z) == here)
        continue;
      block.crossed[j + size * k] |= std::uint64_t(1) << (8 * i + direction);
      const double f = value_at(i, j, k), g = value_at(x, y, z);
      // Kept away from the ends, the vertices around a lattice point stay apart.
      const double t = (std::min)((std::max)(f / (f - g), 0.1), 0.9);
      const Point_3 p = lattice.position(low[0] + i, low[1] + j, low[2] + k);
      const Point_3 q = lattice.position(low[0] + x, low[1] + y, low[2] + z);
      points.push_back(p + t * (q - p));
    }
  }

  double value_at(int i, int j, int k) const { return values[i + nodes * (j + nodes * k)]; }

  static int corners_inside(const Block& block, int i, int j, int k)
  {
    int result = 0;
    for (int row = 0; row < 4; ++row)
      result |= (block.inside[j + (row & 1) + nodes * (k + (row >> 1))] >> i & 3) << (2 * row);
    return result;
  }

  // The vertex on an edge of the cell (i, j, k) of block b.
  std::size_t vertex(std::size_t b, int i, int j, int k, const Marching_table::Edge& edge) const
  {
    i += edge.corner & 1;
    j += edge.corner >> 1 & 1;
    k += edge.corner >> 2;
    if (i == size || j == size || k == size) {
      Index low = lattice.blocks()[b];
      low[0] += i / size * size;
      low[1] += j / size * size;
      low[2] += k / size * size;
      b = lattice.block(low);
    }
    const int row = j % size + size * (k % size), bit = 8 * (i % size) + edge.direction;
    const std::uint64_t before = blocks[b].crossed[row] & ((std::uint64_t(1) << bit) - 1);
    return blocks[b].first_vertex[row] + count_bits(before);
  }

  static std::size_t count_bits(std::uint64_t word)
  {
    std::size_t count = 0;
    for (; word != 0; word &= word - 1)
      ++count;
    return count;
  }

  Shape shape;
  Sparse_lattice lattice;
  std::vector<Block> blocks;
  std::array<double, nodes * nodes * nodes> values; // of the block at hand
};

} // namespace internal

/// Turns an implicit shape (implicit_shapes.h) into a closed triangle surface by marching
/// tetrahedra on a lattice of the given spacing. The result is an oriented 2-manifold without
/// boundary whatever the shape; its topology is the shape's once the spacing resolves it.
/// Linear in the size of the result, in time and memory.
template <class Shape>
Indexed_surface polygonised(const Shape& shape, double spacing, std::uint64_t seed = 0)
{
  internal::Polygoniser<Shape> polygoniser(shape, spacing, seed);
  Indexed_surface surface;
  polygoniser.make_vertices(surface.points);
  surface.faces.reserve(2 * surface.points.size() + 4);
  polygoniser.make_faces(surface.faces);
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_POLYGONISE_H
