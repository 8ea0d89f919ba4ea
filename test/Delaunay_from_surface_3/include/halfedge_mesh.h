// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An orientable triangle list as a CGAL halfedge graph.

#ifndef CGAL_TEST_DELAUNAY_FROM_SURFACE_3_HALFEDGE_MESH_H
#define CGAL_TEST_DELAUNAY_FROM_SURFACE_3_HALFEDGE_MESH_H

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// Turns triangles so that neighbours agree.
inline void orient(triangle_lists::Triangle_list& s)
{
  std::map<std::pair<int, int>, std::vector<std::size_t>> at_edge;
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      at_edge[triangle_lists::ends(s.triangles[i][k], s.triangles[i][(k + 1) % 3])].push_back(i);
  const auto runs = [&](std::size_t i, int a, int b) {
    const triangle_lists::Triangle& t = s.triangles[i];
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  };
  std::vector<bool> is_done(s.triangles.size(), false);
  for (std::size_t root = 0; root < s.triangles.size(); ++root) {
    if (is_done[root])
      continue;
    is_done[root] = true;
    std::vector<std::size_t> stack(1, root);
    while (!stack.empty()) {
      const std::size_t i = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int a = s.triangles[i][k], b = s.triangles[i][(k + 1) % 3];
        for (std::size_t j : at_edge[triangle_lists::ends(a, b)]) {
          if (j == i)
            continue;
          if (!is_done[j]) {
            if (runs(j, a, b))
              std::swap(s.triangles[j][0], s.triangles[j][1]);
            is_done[j] = true;
            stack.push_back(j);
          }
          if (runs(j, a, b))
            throw std::invalid_argument("the surface is not orientable");
        }
      }
    }
  }
}

template <class Mesh>
Mesh to_halfedge_mesh(triangle_lists::Triangle_list s)
{
  orient(s);
  Mesh mesh;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertex;
  for (int v = 0; v < s.n; ++v)
    vertex.push_back(add_vertex(mesh));
  for (const triangle_lists::Triangle& t : s.triangles) {
    const std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> corners{
        vertex[t[0]], vertex[t[1]], vertex[t[2]]};
    if (CGAL::Euler::add_face(corners, mesh) == boost::graph_traits<Mesh>::null_face())
      throw std::invalid_argument("the triangles do not form a mesh");
  }
  return mesh;
}

#endif // CGAL_TEST_DELAUNAY_FROM_SURFACE_3_HALFEDGE_MESH_H
