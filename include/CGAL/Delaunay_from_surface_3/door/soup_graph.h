// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_SOUP_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_SOUP_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/core/order/soup_edges.h>
#include <CGAL/Delaunay_from_surface_3/paper/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Soup_graph
{
  Lower_neighbor_graph graph;
  // None if all faces are triangles and no edge has more than two.
  std::optional<std::string> irregularity;
};

// No edges, where nobody is told what the faces are like and no order is made of them. Linear.
template <class FaceRange>
Soup_graph soup_graph_without_edges(const FaceRange& faces, std::size_t number_of_points)
{
  std::size_t f = 0;
  for (const auto& face : faces)
    check_face(face, f++, number_of_points);
  return {Lower_neighbor_graph(number_of_points), std::nullopt};
}

// The edges of the faces as a graph on the points; without edges if there are more sides than
// numbers of 32 bits. Linear.
template <class FaceRange>
Soup_graph soup_graph(const FaceRange& faces, std::size_t number_of_points,
                      const Executor& executor = Alone())
{
  Soup_edges soup = soup_edges(faces, number_of_points, executor);
  if (!soup.has_lists)
    return {Lower_neighbor_graph(number_of_points), std::nullopt};
  return {Lower_neighbor_graph(std::move(soup.lower)), std::move(soup.irregularity)};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_SOUP_GRAPH_H
