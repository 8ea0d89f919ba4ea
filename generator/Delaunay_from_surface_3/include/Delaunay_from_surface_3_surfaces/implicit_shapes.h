// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IMPLICIT_SHAPES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IMPLICIT_SHAPES_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <boost/functional/hash.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace surfaces {

// An implicit shape is a function object f on points, negative inside, together with `radius()`,
// the radius of a ball about the origin that holds the shape, and `feature()`, a length that a
// lattice has to resolve. f is 1-Lipschitz: |f(p)| bounds the distance from p to the surface from
// below. The polygoniser relies on this to pass over empty space.

/// A chain of `genus` tori in a row, smoothly joined where neighbours touch; an ellipsoid for
/// genus 0. Nothing on it is flat or spherical, so its points are in general position.
class Torus_chain
{
public:
  using Point_3 = Indexed_surface::Point_3;

  explicit Torus_chain(std::size_t genus)
    : genus(static_cast<double>(genus))
  {
  }

  double operator()(const Point_3& p) const { return genus == 0 ? ellipsoid(p) : chain(p); }

  double radius() const { return genus == 0 ? 1.5 : genus + tube; }

  double feature() const { return tube; }

private:
  static constexpr double tube = 0.4;   // the ring itself has radius 1
  static constexpr double blend = 0.25; // rings nearer to each other than this flow together

  // |p / r| - 1 has slope at most 1 / min(r).
  static double ellipsoid(const Point_3& p)
  {
    return 0.75 *
           (std::sqrt(p.x() * p.x() / (1.4 * 1.4) + p.y() * p.y() + p.z() * p.z() / (0.75 * 0.75)) -
            1);
  }

  static double ring(double x, double y, double z)
  {
    const double radial = std::sqrt(x * x + y * y) - 1;
    return std::sqrt(radial * radial + z * z) - tube;
  }

  // The two rings nearest to p are the one whose slab holds p and its neighbour on p's side.
  double chain(const Point_3& p) const
  {
    const double along = p.x() + genus - 1; // ring i has its centre at 2 i
    const double i = (std::min)((std::max)(std::round(along / 2), 0.), genus - 1);
    const double j = along > 2 * i ? i + 1 : i - 1;
    const double d = ring(along - 2 * i, p.y(), p.z());
    if (j < 0 || j >= genus)
      return d;
    return smooth_minimum(d, ring(along - 2 * j, p.y(), p.z()));
  }

  // Its gradient is a convex combination of the two gradients: still 1-Lipschitz.
  static double smooth_minimum(double a, double b)
  {
    const double h = (std::max)(blend - std::abs(a - b), 0.) / blend;
    return (std::min)(a, b) - h * h * blend / 4;
  }

  double genus;
};

/// A plate with rounded rims and `genus` round holes in a row. Its two flat sides are a hard case
/// on purpose: they carry most of the points.
class Holed_plate
{
public:
  using Point_3 = Indexed_surface::Point_3;

  explicit Holed_plate(std::size_t genus)
    : genus(static_cast<double>(genus))
  {
  }

  double operator()(const Point_3& p) const
  {
    const double across = outline(p.x(), p.y()) + rim;
    const double up = std::abs(p.z()) - half_thickness + rim;
    const double a = (std::max)(across, 0.), b = (std::max)(up, 0.);
    return std::sqrt(a * a + b * b) + (std::min)((std::max)(across, up), 0.) - rim;
  }

  double radius() const { return (std::max)(genus, 1.) + 0.5; }

  double feature() const { return 2 * half_thickness; }

private:
  static constexpr double half_thickness = 0.15;
  static constexpr double rim = 0.14;
  static constexpr double hole = 0.5;

  // Signed distance in the plane: a stadium of half width 1, less the nearest of the holes.
  double outline(double x, double y) const
  {
    const double half_length = (std::max)(genus - 1, 0.);
    const double past_end = (std::max)(std::abs(x) - half_length, 0.);
    const double stadium = std::sqrt(past_end * past_end + y * y) - 1;
    if (genus == 0)
      return stadium;
    const double along = x + genus - 1;
    const double i = (std::min)((std::max)(std::round(along / 2), 0.), genus - 1);
    const double from_centre = along - 2 * i;
    return (std::max)(stadium, hole - std::sqrt(from_centre * from_centre + y * y));
  }

  double genus;
};

/// The triangles of marching tetrahedra for each of the 256 ways in which the corners of a lattice
/// cell can lie inside or outside. A cell is cut into six tetrahedra around its diagonal from
/// corner 0 to corner 7 (bit b of a corner's number is its coordinate b). Neighbouring cells cut
/// their common square alike, so the triangles of all cells form a closed 2-manifold.
class Marching_table
{
public:
  /// An edge of the cut cell: its lower corner, and the bits in which the upper corner differs.
  struct Edge
  {
    int corner;
    int direction;
  };
  using Triangle = std::array<Edge, 3>; // counterclockwise, seen from outside

  Marching_table()
  {
    for (int inside = 0; inside < 256; ++inside) {
      std::array<int, 3> axes = {0, 1, 2};
      do {
        const int a = 1 << axes[0], b = a | 1 << axes[1];
        add_tetrahedron(inside, {0, a, b, 7}, is_odd(axes));
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
  }

  /// Bit c of `inside` says whether corner c lies inside.
  const std::vector<Triangle>& triangles(int inside) const { return cases[inside]; }

private:
  using Tetrahedron = std::array<int, 4>;

  template <class Range>
  static bool is_odd(const Range& permutation)
  {
    bool odd = false;
    for (auto i = permutation.begin(); i != permutation.end(); ++i)
      for (auto j = permutation.begin(); j != i; ++j)
        odd ^= *j > *i;
    return odd;
  }

  static Edge edge(int u, int v) { return {u & v, u ^ v}; }

  // Corners in a tetrahedron come in ascending order, so `is_odd` of a reordering is its parity.
  void add_tetrahedron(int inside, Tetrahedron t, bool negative)
  {
    const auto is_inside = [inside](int corner) { return (inside >> corner & 1) != 0; };
    const auto middle = std::stable_partition(t.begin(), t.end(), is_inside);
    const auto count = middle - t.begin();
    // From here on t is positively oriented, inside corners first.
    if (is_odd(t) != negative)
      std::swap(t[count == 1 ? 2 : 0], t[count == 1 ? 3 : 1]);
    std::vector<Triangle>& out = cases[inside];
    if (count == 1)
      out.push_back({edge(t[0], t[1]), edge(t[0], t[2]), edge(t[0], t[3])});
    else if (count == 3)
      out.push_back({edge(t[3], t[0]), edge(t[3], t[1]), edge(t[3], t[2])});
    else if (count == 2) {
      const Edge ac = edge(t[0], t[2]), ad = edge(t[0], t[3]), bd = edge(t[1], t[3]),
                 bc = edge(t[1], t[2]);
      out.push_back({ac, ad, bd});
      out.push_back({ac, bd, bc});
    }
  }

  std::array<std::vector<Triangle>, 256> cases;
};

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
    return blocks[b].first_vertex[row] + std::bitset<64>(before).count();
  }

  Shape shape;
  Sparse_lattice lattice;
  std::vector<Block> blocks;
  std::array<double, nodes * nodes * nodes> values; // of the block at hand
};

} // namespace internal

/// Turns an implicit shape into a closed triangle surface by marching
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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IMPLICIT_SHAPES_H
