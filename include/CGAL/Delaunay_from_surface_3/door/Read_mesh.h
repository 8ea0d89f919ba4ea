// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_MESH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_MESH_H

#include <CGAL/Delaunay_from_surface_3/door/Insertion_input.h>
#include <CGAL/Delaunay_from_surface_3/door/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/door/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class FaceGraph>
std::optional<std::string> irregularity_of_mesh(const FaceGraph& mesh)
{
  std::size_t non_triangles = 0;
  for (const auto f : faces(mesh))
    non_triangles += !is_triangle(halfedge(f, mesh), mesh);
  if (non_triangles == 0)
    return std::nullopt;
  return "faces that are not triangles: " + std::to_string(non_triangles);
}

// CGAL's helper is used only where no map is given: it asserts that a map has no gaps.
template <class FaceGraph, class NamedParameters>
auto vertex_index_map_of_mesh(const FaceGraph& mesh, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::vertex_index_t>::value)
    return get_initialized_vertex_index_map(mesh);
  else
    return parameters::get_parameter(np, internal_np::vertex_index);
}

// The vertices of a mesh, read and checked.
template <class Triangulation, class FaceGraph, class NamedParameters>
class Read_mesh
{
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Sparse_map = std::decay_t<decltype(vertex_index_map_of_mesh(
      std::declval<const FaceGraph&>(), std::declval<const NamedParameters&>()))>;

public:
  // Keeps a reference to the mesh.
  Read_mesh(const FaceGraph& mesh, const NamedParameters& np)
    : m_mesh(mesh)
    , m_sparse_map(vertex_index_map_of_mesh(mesh, np))
    , m_vertices(vertices(mesh).begin(), vertices(mesh).end())
    , m_dense(dense_indices(m_vertices, m_sparse_map, std::vector<std::size_t>().max_size()))
    , m_points(read_points<typename Triangulation::Point>(
          m_vertices,
          parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, mesh))))
  {
  }

  // Refers to this object.
  auto input() const
  {
    return Insertion_input{m_points,
                           m_mesh,
                           Dense_index_map<Sparse_map>(m_sparse_map, m_dense),
                           irregularity_of_mesh(m_mesh),
                           [this](std::size_t i) { return m_vertices[i]; },
                           No_infos()};
  }

private:
  const FaceGraph& m_mesh;
  const Sparse_map m_sparse_map;
  const std::vector<Vertex> m_vertices;
  const std::vector<std::size_t> m_dense;
  const std::vector<typename Triangulation::Point> m_points;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_MESH_H
