// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_REFINE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_REFINE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>

#include <CGAL/Subdivision_method_3/subdivision_methods_3.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>

namespace surfaces {

namespace internal {

inline void require_triangles(const Mesh& mesh)
{
  require(!is_empty(mesh) && is_triangle_mesh(mesh),
          "the mesh to refine must have triangles and nothing else");
}

// `Surface_mesh` numbers its halfedges, 6 for a vertex, by 32 bits.
inline void require_room(double vertices)
{
  require(6 * vertices < 4294967295., "the refined mesh would be too large");
}

inline void loop_rounds(Mesh& mesh, unsigned rounds)
{
  CGAL::Subdivision_method_3::Loop_subdivision(mesh,
                                               CGAL::parameters::number_of_iterations(rounds));
}

// Puts a vertex on the middle of an edge and cuts the one or two triangles at the edge.
inline Mesh::Vertex_index split_in_the_middle(Mesh& mesh, Mesh::Halfedge_index h)
{
  const Indexed_surface::Point_3 middle =
      CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  const Mesh::Halfedge_index in = CGAL::Euler::split_edge(h, mesh); // its target is the new vertex
  const Mesh::Halfedge_index back = mesh.opposite(mesh.next(in));   // enters it from the other side
  mesh.point(mesh.target(in)) = middle;
  for (const Mesh::Halfedge_index side : {in, back})
    if (!mesh.is_border(side))
      CGAL::Euler::split_face(side, mesh.next(mesh.next(side)), mesh);
  return mesh.target(in);
}

// Splits the longest edge until there are n vertices. O(n log n). An edge in the queue whose length
// is no longer what it was has been split; its halves are in the queue by themselves.
inline void split_longest_edges(Mesh& mesh, std::size_t n)
{
  const auto squared_length = [&mesh](Mesh::Edge_index e) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    return CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  };
  std::priority_queue<std::pair<double, Mesh::Edge_index>> queue;
  for (Mesh::Edge_index e : mesh.edges())
    queue.emplace(squared_length(e), e);
  while (mesh.number_of_vertices() < n && !queue.empty()) {
    const auto [length, e] = queue.top();
    queue.pop();
    if (length != squared_length(e))
      continue;
    const Mesh::Vertex_index v = split_in_the_middle(mesh, mesh.halfedge(e));
    for (Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
      queue.emplace(squared_length(mesh.edge(h)), mesh.edge(h));
  }
}

} // namespace internal

/// A triangle mesh after `rounds` rounds of Loop subdivision, with jitter.
/// \param fraction jitter, as a fraction of the local edge length
inline Indexed_surface loop_subdivided(Mesh mesh, unsigned rounds, double fraction = 0.05,
                                       std::uint64_t seed = 0)
{
  internal::require_triangles(mesh);
  internal::require_room(std::ldexp(static_cast<double>(mesh.number_of_vertices()),
                                    2 * static_cast<int>((std::min)(rounds, 100u))));
  internal::loop_rounds(mesh, rounds);
  Indexed_surface surface = from_mesh(mesh);
  jitter(surface, fraction, seed);
  return surface;
}

/// A triangle mesh with exactly `n` vertices: rounds of Loop subdivision as long as one more round
/// does not make too many, then the longest edges are halved; at last jitter. Throws
/// `std::invalid_argument` when the mesh has more than `n` vertices.
inline Indexed_surface densified(Mesh mesh, std::size_t n, double fraction = 0.05,
                                 std::uint64_t seed = 0)
{
  internal::require_triangles(mesh);
  internal::require_room(static_cast<double>(n));
  require(mesh.number_of_vertices() <= n, "the mesh has more vertices than asked for");
  // A round of Loop subdivision puts a vertex on every edge.
  while (mesh.number_of_vertices() + mesh.number_of_edges() <= n)
    internal::loop_rounds(mesh, 1);
  internal::split_longest_edges(mesh, n);
  Indexed_surface surface = from_mesh(mesh);
  jitter(surface, fraction, seed);
  return surface;
}

/// A closed triangle mesh with about `n` vertices, fewer than it has: edges are collapsed.
inline Indexed_surface simplified(Mesh mesh, std::size_t n)
{
  internal::require_triangles(mesh);
  // Three edges per vertex, which is what is counted.
  const auto stop = [n](const auto&, const auto&, std::size_t, std::size_t edges) {
    return edges <= 3 * n;
  };
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
  return from_mesh(mesh);
}

/// A closed triangle mesh with `n` vertices, exactly if it has no more of them, else about:
/// `simplified()` or `densified()`, with jitter in both cases, so that the surfaces of all sizes
/// are equally rough.
inline Indexed_surface resized(const Mesh& mesh, std::size_t n, double fraction = 0.05,
                               std::uint64_t seed = 0)
{
  if (mesh.number_of_vertices() <= n)
    return densified(mesh, n, fraction, seed);
  Indexed_surface surface = simplified(mesh, n);
  jitter(surface, fraction, seed);
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_REFINE_H
