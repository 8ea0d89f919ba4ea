// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_STATISTICS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_STATISTICS_H

// How much of the surface is in the triangulation.

#include "Report.h"
#include "Surface.h"

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Edges and triangles of the surface, each once, between vertices that are numbered by their first
// point: points that coincide count as one, and edges and triangles that this makes collapse are
// left out.
struct Surface_simplices
{
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::size_t number_of_polygons = 0; // faces with more than three vertices, triangles left out
};

template <class Simplices>
void sort_and_unite(Simplices& simplices)
{
  for (auto& simplex : simplices)
    std::sort(simplex.begin(), simplex.end());
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

inline Surface_simplices
surface_simplices(const Surface& surface, const std::vector<Triangulation::Vertex_handle>& vertices)
{
  boost::unordered_map<Triangulation::Vertex_handle, std::size_t> first_point;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    first_point.emplace(vertices[i], i);

  Surface_simplices result;
  std::vector<std::size_t> face;
  for (const auto& indices : surface.faces) {
    face.clear();
    for (const std::size_t i : indices)
      face.push_back(first_point.at(vertices[i]));
    for (std::size_t i = 0; i < face.size(); ++i)
      if (face[i] != face[(i + 1) % face.size()])
        result.edges.push_back({face[i], face[(i + 1) % face.size()]});
    if (face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
      result.triangles.push_back({face[0], face[1], face[2]});
    result.number_of_polygons += face.size() > 3;
  }
  sort_and_unite(result.edges);
  sort_and_unite(result.triangles);
  return result;
}

struct Delaunay_counts
{
  std::size_t edges = 0, triangles = 0;
};

// How many of them are edges and facets of the triangulation.
// A test looks at all cells around its first vertex. Were that the hub of a wheel, n spokes would
// take quadratic time; so it is the vertex with the fewest edges.
inline Delaunay_counts count_delaunay(const Triangulation& tr,
                                      const std::vector<Triangulation::Vertex_handle>& vertices,
                                      const Surface_simplices& simplices)
{
  std::vector<std::size_t> degree(vertices.size());
  for (const auto& edge : simplices.edges)
    ++degree[edge[0]], ++degree[edge[1]];
  const auto has_lower_degree = [&](std::size_t u, std::size_t v) { return degree[u] < degree[v]; };

  Delaunay_counts counts;
  Triangulation::Cell_handle c;
  int i, j, k;
  for (auto edge : simplices.edges) {
    std::sort(edge.begin(), edge.end(), has_lower_degree);
    counts.edges += tr.is_edge(vertices[edge[0]], vertices[edge[1]], c, i, j);
  }
  for (auto triangle : simplices.triangles) {
    std::sort(triangle.begin(), triangle.end(), has_lower_degree);
    counts.triangles += tr.is_facet(vertices[triangle[0]], vertices[triangle[1]],
                                    vertices[triangle[2]], c, i, j, k);
  }
  return counts;
}

inline void report_surface(const Surface& surface, const Triangulation& tr,
                           const std::vector<Triangulation::Vertex_handle>& vertices,
                           Report& report)
{
  report.title("The surface in the triangulation");
  if (tr.dimension() < 2) {
    report("Delaunay edges", "not counted in dimension " + std::to_string(tr.dimension()));
    return;
  }
  const Surface_simplices simplices = surface_simplices(surface, vertices);
  const Delaunay_counts counts = count_delaunay(tr, vertices, simplices);
  const std::size_t edges = simplices.edges.size(), triangles = simplices.triangles.size();
  report("Delaunay edges", fraction(counts.edges, edges));
  report("other edges", fraction(edges - counts.edges, edges));
  report("Delaunay triangles", fraction(counts.triangles, triangles));
  report("other triangles", fraction(triangles - counts.triangles, triangles));
  if (simplices.number_of_polygons > 0)
    report("polygons",
           std::to_string(simplices.number_of_polygons) + " (not counted as triangles)");
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_STATISTICS_H
