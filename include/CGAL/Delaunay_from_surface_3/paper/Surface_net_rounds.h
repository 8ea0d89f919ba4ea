// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SURFACE_NET_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SURFACE_NET_ROUNDS_H

// The public face of core/order/surface_net_rounds.h.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds and order from the surface graph. A net of the graph is a maximal independent set.
Every other vertex joins the cluster of an adjacent net vertex: of the nearest if there are no more
than 32768 vertices, or if the first of these has many edges; otherwise of the one chosen first.
Contracting the clusters gives a smaller graph, and so on, until at most `coarsest` vertices are
left. Rounds go from the coarsest net to the finest and grow four- to fivefold. Inside a round the
points follow the clusters, children in the order of their parents. This order is local on the
surface, and so in space. Each point starts at the net vertex of its cluster, which is inserted in
an earlier round (`Insertion_order::starting_places`).

A net is chosen greedily in a random order of the vertices, which the seed determines. With more
than 32768 vertices, blocks of `block` successive vertices (1024 by default) follow each other, and
only the order inside each block is random. In the order of the indices a net would be as regular as
the numbering. CAD programs number vertices along profiles and rings, and such nets destroyed 2.5
times as many cells as random rounds on an airfoil of 200,000 points (`nets_200k.json`). Vertices
with more than three times as many edges as the average come first: it is better to insert the
middle of a fan before the fan. The members of a cluster of more than `large_cluster` vertices come
in the order of `Geometric_rounds`, and start at the previous point if that is nearer than the net
vertex.

If there are no edges or more than \f$2^{32}\f$, the order is that of `Spaced_rounds`. If they join
points that are not near each other (a thousand of them are examined on two levels),
`Geometric_rounds` orders the points. Then there are no starting places.

A level that keeps more than 90 % of its vertices (isolated vertices, graphs with few edges) ends
the hierarchy. `Geometric_rounds` orders the vertices left at the end.

<b>Complexity</b>: expected \f$O((n + m) \log n)\f$ for n vertices and m edges; \f$O(n)\f$ if
vertices and edges decrease by a constant factor from level to level, as they do on the surfaces
measured, and no cluster is large. Distances are computed only along the edges of net vertices, and
up to rounding.

\cgalModels{InsertionPlan}
*/
class Surface_net_rounds
{
public:
  /// the fraction of its vertices that a level may keep.
  static constexpr double stall = internal::net_stall;

  /// the number of vertices at which nets end.
  static constexpr std::size_t coarsest = internal::coarsest_net;

  /// the budget (`InsertionPlan::cells_per_point`). On most surfaces nets destroy 12 to 33 cells
  /// per point. On smooth tori without noise they destroy more, and 3 to 4 more for each doubling
  /// of the points; on adversarial surfaces any number.
  static constexpr std::size_t cells_per_point = internal::cells_per_point_of_nets;

  /// the size from which the inside of a cluster is ordered by `Geometric_rounds`.
  static constexpr std::size_t large_cluster = internal::large_cluster;

  /*!
  makes the plan.

  \param seed determines the random nets, and is passed to `Geometric_rounds`
  \param block the number of successive vertices in a block, rounded up to a power of 2, with more
  than 32768 vertices; 1 gives the order of the indices
  */
  explicit Surface_net_rounds(unsigned int seed = 0, std::size_t block = 1024)
    : m_seed(seed)
    , m_block(block)
  {
  }

  /*!
  returns order, rounds and starting places.

  \tparam Graph a model of `boost::EdgeListGraph`; loops and multiple edges are harmless
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  */
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&,
                             const Graph& graph, VertexIndexMap index_map,
                             const internal::Executor& executor = internal::Alone()) const
  {
    internal::Edges_of_graph<Graph, VertexIndexMap> edges(graph, index_map, points.size());
    return internal::order_by_core(points, order_request(), edges, executor);
  }

  /// returns the plan that is used when the budget is exceeded; the bound of \cgalCite{acr-icbr-03}
  /// on the cells created and destroyed holds for it, whatever the surface.
  Geometric_rounds fallback_plan() const { return Geometric_rounds(m_seed); }

  /// \cond
  using Plan_of_core = Surface_net_rounds;

  internal::Order_request order_request() const
  {
    internal::Order_request request;
    request.seed = m_seed;
    request.block = m_block;
    return request;
  }
  /// \endcond

private:
  unsigned int m_seed;
  std::size_t m_block;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SURFACE_NET_ROUNDS_H
