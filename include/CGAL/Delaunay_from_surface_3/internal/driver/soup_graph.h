// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_SOUP_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_SOUP_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

struct Soup_graph
{
  Index_graph graph; // every edge once, from the smaller index to the larger
  // None if all faces are triangles and no edge has more than two.
  std::optional<std::string> irregularity;
};

template <class IndexRange>
void check_face(const IndexRange& face, std::size_t f, std::size_t number_of_points)
{
  for (const auto& index : face)
    if (index < decltype(index + 0)(0) || std::size_t(index) >= number_of_points)
      throw Surface_input_error("face " + std::to_string(f) + ": the index " +
                                std::to_string(index) + " is not one of the " +
                                std::to_string(number_of_points) + " points");
}

// The edges of the faces as a graph on the points: O(m log m) for m edges.
template <class FaceRange>
Soup_graph soup_graph(const FaceRange& faces, std::size_t number_of_points)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::size_t f = 0, non_triangles = 0, non_manifold_edges = 0;
  for (const auto& face : faces) {
    check_face(face, f++, number_of_points);
    const std::size_t k = std::size_t(std::distance(std::begin(face), std::end(face)));
    non_triangles += k != 3;
    if (k == 0)
      continue;
    std::size_t s = std::size_t(*std::next(std::begin(face), std::ptrdiff_t(k - 1)));
    for (const auto& index : face) {
      const std::size_t t = std::size_t(index);
      if (s != t)
        edges.emplace_back(std::minmax(s, t));
      s = t;
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 2; i < edges.size(); ++i)
    non_manifold_edges += edges[i] == edges[i - 2] && (i < 3 || edges[i] != edges[i - 3]);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  Soup_graph soup = {
      Index_graph(boost::edges_are_sorted, edges.begin(), edges.end(), number_of_points),
      std::nullopt};
  if (non_triangles + non_manifold_edges > 0)
    soup.irregularity = "faces that are not triangles: " + std::to_string(non_triangles) +
                        ", edges with more than two faces: " + std::to_string(non_manifold_edges);
  return soup;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_SOUP_GRAPH_H
