// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERTION_INPUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERTION_INPUT_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What a public function hands over: the points, checked; a graph on them; what the caller calls
// them, as a function of their indices; and the infos that came with them.
template <class Point, class Graph, class VertexIndexMap, class NameOf, class Infos>
struct Insertion_input
{
  const std::vector<Point>& points;
  const Graph& graph;
  VertexIndexMap index_map;
  std::optional<std::string> irregularity; // none where points need not be a surface
  NameOf name_of;
  Infos infos;
};

template <class Point, class Graph, class VertexIndexMap, class NameOf, class Infos>
Insertion_input(const std::vector<Point>&, const Graph&, VertexIndexMap, std::optional<std::string>,
                NameOf, Infos) -> Insertion_input<Point, Graph, VertexIndexMap, NameOf, Infos>;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_INSERTION_INPUT_H
