// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_SPANNING_FOREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_SPANNING_FOREST_H

// A spanning subgraph T for surfaces without usable faces. Choi 2002, §3 asks for bounded degree;
// this one has no bound, so the trace is right but its cost is not proved.

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

writes the edges of a spanning forest, one tree per connected component: every edge that joins two
components of those before it. It works for every graph and bounds no degree.

O(n + m α(n)) for n vertices and m edges. Memory: two integers per vertex.

\cgalModels{SurfaceSubgraph}
*/
class Spanning_forest
{
public:
  /*!
  writes edges of `graph` that span it without a cycle.

  \tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  \tparam EdgeOutputIterator accepts edge descriptors of `Graph`

  \param graph the surface
  \param index_map the indices of its vertices
  \param out receives the edges

  \return the output iterator past the last edge written
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const
  {
    std::vector<std::size_t> ranks(number_of_vertices(graph)), parents(ranks.size());
    const auto rank_map = boost::make_iterator_property_map(
        ranks.begin(), boost::typed_identity_property_map<std::size_t>());
    const auto parent_map = boost::make_iterator_property_map(
        parents.begin(), boost::typed_identity_property_map<std::size_t>());
    boost::disjoint_sets<decltype(rank_map), decltype(parent_map)> trees(rank_map, parent_map);
    for (std::size_t i = 0; i < parents.size(); ++i)
      trees.make_set(i);
    for (auto [e, end] = edges(graph); e != end; ++e) {
      const std::size_t s = trees.find_set(std::size_t(get(index_map, source(*e, graph))));
      const std::size_t t = trees.find_set(std::size_t(get(index_map, target(*e, graph))));
      if (s == t)
        continue;
      trees.link(s, t);
      *out++ = *e;
    }
    return out;
  }

private:
  // Not num_vertices(): on a mesh with removed elements that is only an upper bound of n.
  template <class Graph>
  static std::size_t number_of_vertices(const Graph& graph)
  {
    const auto range = vertices(graph);
    return std::size_t(std::distance(range.first, range.second));
  }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPH_SPANNING_FOREST_H
