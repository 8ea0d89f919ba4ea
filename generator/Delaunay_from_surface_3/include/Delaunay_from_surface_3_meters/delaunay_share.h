// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_DELAUNAY_SHARE_H
#define DELAUNAY_FROM_SURFACE_3_METERS_DELAUNAY_SHARE_H

// The hypothesis of Choi 2002, as a function: "consisting of Delaunay triangles".

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace meters {

// says how much of a surface is in a triangulation. Vertices at the same point count as one; edges and
// triangles that this makes collapse are left out, and others count once.
//
// VertexHandle: a vertex of the triangulation
template <class VertexHandle>
struct Delaunay_share
{
  std::size_t edges = 0;              // edges of the surface.
  std::size_t delaunay_edges = 0;     // those that are edges of the triangulation.
  std::size_t triangles = 0;          // faces with three vertices.
  std::size_t delaunay_triangles = 0; // those that are facets of the triangulation.
  std::size_t polygons = 0;           // faces with more than three vertices.
  double longest_other_edge = 0;      // the length of the longest edge that is not Delaunay, or 0.

  // the ends of that edge; default-constructed if there is none.
  std::pair<VertexHandle, VertexHandle> ends_of_longest_other_edge;
};

namespace internal {

// Edges and triangles between vertices of a triangulation, numbered by their first points.
template <class Triangulation>
class Surface_in_triangulation
{
  using Vertex = typename Triangulation::Vertex_handle;

public:
  explicit Surface_in_triangulation(const std::vector<Vertex>& vertices)
    : m_number(vertices.size())
    , m_vertices(vertices)
  {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i] == Vertex())
        throw CGAL::Surface_input_error("vertex " + std::to_string(i) +
                                        " of the surface has no vertex in the triangulation");
      if (m_number[vertices[i]] == vertices.size())
        m_number[vertices[i]] = i;
    }
  }

  void add_edge(std::size_t i, std::size_t j)
  {
    const std::size_t u = m_number[m_vertices[i]], v = m_number[m_vertices[j]];
    if (u != v)
      m_edges.push_back({(std::min)(u, v), (std::max)(u, v)});
  }

  void add_face(const std::vector<std::size_t>& face)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
      add_edge(face[k], face[(k + 1) % face.size()]);
    m_polygons += face.size() > 3;
    if (face.size() != 3)
      return;
    std::array<std::size_t, 3> t;
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = m_number[m_vertices[face[k]]];
    std::sort(t.begin(), t.end());
    if (t[0] != t[1] && t[1] != t[2])
      m_triangles.push_back(t);
  }

  Delaunay_share<Vertex> share(const Triangulation& tr)
  {
    sort_and_unite(m_edges);
    sort_and_unite(m_triangles);
    std::vector<std::size_t> degree(m_vertices.size(), 0);
    for (const auto& e : m_edges)
      ++degree[e[0]], ++degree[e[1]];
    const auto has_lower_degree = [&](std::size_t u, std::size_t v) {
      return degree[u] < degree[v];
    };

    Delaunay_share<Vertex> result;
    result.edges = m_edges.size();
    result.triangles = m_triangles.size();
    result.polygons = m_polygons;
    typename Triangulation::Cell_handle c;
    int i, j, k;
    // A test looks at all cells around its first vertex. Were that the hub of a wheel, n spokes
    // would take quadratic time; so it is the vertex with the fewest edges.
    for (auto e : m_edges) {
      std::sort(e.begin(), e.end(), has_lower_degree);
      if (tr.dimension() > 0 && tr.is_edge(m_vertices[e[0]], m_vertices[e[1]], c, i, j))
        ++result.delaunay_edges;
      else
        note_other_edge(m_vertices[e[0]], m_vertices[e[1]], result);
    }
    for (auto t : m_triangles) {
      std::sort(t.begin(), t.end(), has_lower_degree);
      result.delaunay_triangles +=
          tr.dimension() > 1 &&
          tr.is_facet(m_vertices[t[0]], m_vertices[t[1]], m_vertices[t[2]], c, i, j, k);
    }
    return result;
  }

private:
  template <class Simplices>
  static void sort_and_unite(Simplices& simplices)
  {
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  }

  static void note_other_edge(Vertex v, Vertex w, Delaunay_share<Vertex>& share)
  {
    const auto difference = v->point() - w->point();
    const double length = std::sqrt(CGAL::to_double(difference.squared_length()));
    if (length > share.longest_other_edge) {
      share.longest_other_edge = length;
      share.ends_of_longest_other_edge = {v, w};
    }
  }

  CGAL::Unique_hash_map<Vertex, std::size_t> m_number;
  const std::vector<Vertex>& m_vertices;
  std::vector<std::array<std::size_t, 2>> m_edges;
  std::vector<std::array<std::size_t, 3>> m_triangles;
  std::size_t m_polygons = 0;
};

} // namespace internal

// counts the edges and triangles of a polygon soup that are in a Delaunay triangulation of its points:
// how far the hypothesis of {choi-dtsm-02} holds, that the surface consists of Delaunay
// triangles.
//
// Where the triangulation has no edges or facets, in dimensions below 1 and 2, none are Delaunay.
//
// O(m \log m) for m edges, and the sum of the numbers of cells around one end of each edge.
//
// Triangulation: a `CGAL::Delaunay_triangulation_3`
// FaceRange: a range of ranges of integers
//
// tr: the triangulation
// vertices: the vertices of `tr` at the points of the soup, as
// `vertex_to_vertex_output_iterator` gives them
// faces: the faces: for each the indices of its points in order
//
// \throws Surface_input_error if a vertex is default-constructed or an index out of range
template <class Triangulation, class FaceRange>
Delaunay_share<typename Triangulation::Vertex_handle>
delaunay_share(const Triangulation& tr,
               const std::vector<typename Triangulation::Vertex_handle>& vertices,
               const FaceRange& faces)
{
  internal::Surface_in_triangulation<Triangulation> surface(vertices);
  std::vector<std::size_t> indices;
  for (const auto& face : faces) {
    indices.assign(std::begin(face), std::end(face));
    for (const std::size_t i : indices)
      if (i >= vertices.size())
        throw CGAL::Surface_input_error("the index " + std::to_string(i) +
                                        " of a face is not one of the " +
                                        std::to_string(vertices.size()) + " points");
    surface.add_face(indices);
  }
  return surface.share(tr);
}

// does the same for a mesh.
//
// FaceGraph: a model of `FaceListGraph` and `HalfedgeGraph`
// VertexToVertexMap: a model of `boost::ReadablePropertyMap` from the vertices of `mesh` to those of
// `tr`
//
// tr: the triangulation
// mesh: the surface
// vertex_to_vertex: the vertex of `tr` at each vertex of `mesh`
//
// \throws Surface_input_error if a vertex is default-constructed
template <class Triangulation, class FaceGraph, class VertexToVertexMap,
          class = std::enable_if_t<
              !std::is_same<FaceGraph, std::vector<typename Triangulation::Vertex_handle>>::value>>
Delaunay_share<typename Triangulation::Vertex_handle>
delaunay_share(const Triangulation& tr, const FaceGraph& mesh, VertexToVertexMap vertex_to_vertex)
{
  using Vertex = typename Triangulation::Vertex_handle;
  std::vector<Vertex> handles;
  CGAL::Unique_hash_map<Vertex, std::size_t> number;
  const auto number_of = [&](auto v) {
    const Vertex w = get(vertex_to_vertex, v);
    if (w != Vertex() && !number.is_defined(w)) {
      number[w] = handles.size();
      handles.push_back(w);
    }
    if (w == Vertex())
      throw CGAL::Surface_input_error("a vertex of the surface has no vertex in the triangulation");
    return number[w];
  };
  std::vector<std::array<std::size_t, 2>> all_edges;
  for (const auto e : edges(mesh))
    all_edges.push_back({number_of(source(e, mesh)), number_of(target(e, mesh))});
  std::vector<std::vector<std::size_t>> all_faces;
  for (const auto f : faces(mesh)) {
    all_faces.emplace_back();
    const auto first = halfedge(f, mesh);
    auto h = first;
    do {
      all_faces.back().push_back(number_of(target(h, mesh)));
      h = next(h, mesh);
    } while (h != first);
  }
  internal::Surface_in_triangulation<Triangulation> surface(handles);
  for (const auto& e : all_edges)
    surface.add_edge(e[0], e[1]);
  for (const auto& face : all_faces)
    surface.add_face(face);
  return surface.share(tr);
}

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_DELAUNAY_SHARE_H
