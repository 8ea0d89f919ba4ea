// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/paper/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Spanning_forest.h>

#include <CGAL/iterator.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// T, made by the functor of the traits. If the functor needs more than the graph has, such as
// faces, or refuses the surface by a Surface_input_error, a spanning forest is used, and the
// visitor is told why.
template <class SurfaceSubgraph, class Graph, class VertexIndexMap, class Visitor>
Index_graph spanning_subgraph(const SurfaceSubgraph& subgraph, const Graph& graph,
                              VertexIndexMap index_map, const std::vector<std::size_t>& numbers,
                              Visitor& visitor)
{
  if constexpr (std::is_invocable<const SurfaceSubgraph&, const Graph&, VertexIndexMap,
                                  Emptyset_iterator>::value) {
    try {
      return index_graph(subgraph, graph, index_map, numbers);
    } catch (const Surface_input_error& refusal) {
      visitor.subgraph_is_replaced(refusal.what());
    }
  } else {
    visitor.subgraph_is_replaced(
        "the subgraph needs a surface with faces, which a plain graph is not");
  }
  return index_graph(Spanning_forest(), graph, index_map, numbers);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPANNING_SUBGRAPH_H
