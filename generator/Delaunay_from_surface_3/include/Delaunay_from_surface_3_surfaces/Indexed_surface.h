// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_INDEXED_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_INDEXED_SURFACE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

/// Makers of test and benchmark surfaces. Every maker is deterministic: the same arguments give the
/// same points in the same order. Arguments that make no sense are refused by
/// `std::invalid_argument` with a message for the user.
namespace surfaces {

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

/// Builds a `Surface_mesh` or `Polyhedron_3` over the kernel `Indexed_surface::Kernel`.
/// The vertices keep their order where every point is on a face.
/// \pre the faces form an oriented manifold, with or without boundary
template <class Mesh>
Mesh to_mesh(const Indexed_surface& surface)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (!PMP::is_polygon_soup_a_polygon_mesh(surface.faces))
    throw std::invalid_argument("the surface is not an oriented manifold");
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

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_INDEXED_SURFACE_H
