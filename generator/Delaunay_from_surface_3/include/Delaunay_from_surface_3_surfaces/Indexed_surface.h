// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_INDEXED_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_INDEXED_SURFACE_H

#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Makers of test and benchmark surfaces. Every maker is deterministic: the same arguments give the
/// same points in the same order. Arguments that make no sense are refused by
/// `std::invalid_argument` with a message for the user.
namespace surfaces {
namespace internal {
constexpr double pi = 3.14159265358979323846;
}

/// Refuses arguments that make no sense.
inline void require(bool makes_sense, const std::string& message)
{
  if (!makes_sense)
    throw std::invalid_argument(message);
}

/// A triangle surface as a soup: points, and faces that index them.
struct Indexed_surface
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  using Face = std::array<std::size_t, 3>;

  std::vector<Point_3> points;
  std::vector<Face> faces;
};

/// The mesh type in which surfaces are read and refined.
using Mesh = CGAL::Surface_mesh<Indexed_surface::Point_3>;

/// Builds a `Surface_mesh` or `Polyhedron_3` over the kernel `Indexed_surface::Kernel`.
/// The vertices keep their order where every point is on a face.
/// \pre the faces form an oriented manifold, with or without boundary
template <class Mesh>
Mesh to_mesh(const Indexed_surface& surface)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  require(PMP::is_polygon_soup_a_polygon_mesh(surface.faces),
          "the surface is not an oriented manifold");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.faces, mesh);
  return mesh;
}

/// Takes the vertices and triangles of a mesh, in their order.
/// \pre all faces are triangles
template <class Mesh>
Indexed_surface from_mesh(const Mesh& mesh)
{
  Indexed_surface surface;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, surface.points, surface.faces);
  return surface;
}

/// The edges of the faces, each once, as sorted pairs of indices in ascending order. O(n log n).
inline std::vector<std::pair<std::size_t, std::size_t>> edges(const Indexed_surface& surface)
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  result.reserve(3 * surface.faces.size());
  for (const Indexed_surface::Face& face : surface.faces)
    for (int i = 0; i < 3; ++i)
      result.push_back(std::minmax<std::size_t>(face[i], face[(i + 1) % 3]));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Vertices - edges + faces.
inline std::ptrdiff_t euler_characteristic(const Indexed_surface& surface)
{
  return static_cast<std::ptrdiff_t>(surface.points.size() + surface.faces.size()) -
         static_cast<std::ptrdiff_t>(edges(surface).size());
}

/// The number of pieces that hang together through faces; a point on no face is a piece.
inline std::size_t number_of_components(const Indexed_surface& surface)
{
  std::size_t count = surface.points.size();
  CGAL::Delaunay_from_surface_3::internal::Disjoint_sets<std::size_t> pieces(count);
  for (const Indexed_surface::Face& face : surface.faces)
    for (int i = 1; i < 3; ++i)
      count -= pieces.unite(face[0], face[i]);
  return count;
}

/// Random numbers that depend on the seed alone. The distributions are Boost's, because those of
/// the standard library differ from one library to the next.
class Random
{
public:
  using Vector_3 = Indexed_surface::Vector_3;

  explicit Random(std::uint64_t seed)
    : engine(seed)
  {
  }

  double uniform(double low, double high)
  {
    return low + (high - low) * boost::random::uniform_01<double>()(engine);
  }

  double normal() { return boost::random::normal_distribution<double>()(engine); }

  /// A number in `0 .. count - 1`.
  std::size_t below(std::size_t count)
  {
    return boost::random::uniform_int_distribution<std::size_t>(0, count - 1)(engine);
  }

  /// A vector in the unit ball.
  Vector_3 in_ball()
  {
    Vector_3 v;
    do {
      const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      v = Vector_3(x, y, z);
    } while (v.squared_length() > 1);
    return v;
  }

  /// The numbers `0 .. count - 1` in random order.
  std::vector<std::size_t> permutation(std::size_t count)
  {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = below(i + 1);
      order[i] = order[j];
      order[j] = i;
    }
    return order;
  }

private:
  boost::random::mt19937_64 engine;
};

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_INDEXED_SURFACE_H
