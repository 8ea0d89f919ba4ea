// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_SURFACE_NET_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_SURFACE_NET_ROUNDS_H

// Beyond the paper: rounds, order and starting points from the connectivity of the surface alone.
// Good spacing takes the place of randomness.
//
// Invariant: when a round begins, the points inserted are a maximal independent set of the graph
// of the points inserted by its end (contracted level by level), so that each point of the round
// has a neighbour that is already inserted.
// Cost: see Net_hierarchy.h.

#include <CGAL/Delaunay_from_surface_3/internal/plan/Net_hierarchy.h>
#include <CGAL/Delaunay_from_surface_3/plan/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds and order from the surface graph. A net of the graph is a maximal independent set,
chosen greedily in the order of the indices; every other vertex joins the cluster of a net vertex beside
it. The clusters are contracted, and so on until a few dozen vertices are left. Rounds go from the
coarsest net to the finest and grow four- to fivefold. Inside a round the points follow the clusters,
children in the order of their parents: that is local on the surface, and so in space. Each point
starts at the net vertex of its cluster (`Insertion_order::starting_places`).

A level that keeps more than 90 % of its vertices (isolated vertices, stars, random graphs) ends the
hierarchy; what is left then, and the last few dozen vertices, are ordered by `Geometric_rounds`.

O(n) for surfaces of fixed genus; O((n + m) log n + n log n) for n vertices and m edges otherwise.
Coordinates are looked at for the coarsest level only.

\cgalModels{InsertionPlan}
*/
class Surface_net_rounds
{
public:
  /// the share of its vertices that a level may keep.
  static constexpr double stall = 0.9;

  /// the number of vertices at which nets end.
  static constexpr std::size_t coarsest = 64;

  /// the budget: on surfaces nets destroy 9 to 24 cells for each point, and on adversarial ones any
  /// number. What is more than this can only be paid twice by plain CGAL's insertion.
  static constexpr std::size_t cells_per_point = 32;

  /// hands `seed` to `Geometric_rounds`; the nets do not depend on it.
  explicit Surface_net_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  /*!
  returns order, rounds and starting places.

  \tparam Graph a model of `boost::EdgeListGraph`; loops and multiple edges do no harm
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  */
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                             const Graph& graph, VertexIndexMap index_map) const
  {
    const std::size_t larger = (std::max)(points.size(), std::size_t(num_edges(graph)));
    if (larger < (std::numeric_limits<std::uint32_t>::max)())
      return order<std::uint32_t>(points, gt, graph, index_map);
    return order<std::size_t>(points, gt, graph, index_map);
  }

  /// returns the plan that serves when the budget is exceeded: the bound of \cgalCite{acr-icbr-03} on
  /// the cells created and destroyed holds for it, whatever the surface.
  Geometric_rounds fallback_plan() const { return Geometric_rounds(m_seed); }

private:
  template <class Index, class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order order(const std::vector<Point>& points, const GeomTraits& gt, const Graph& graph,
                        VertexIndexMap index_map) const
  {
    using namespace Delaunay_from_surface_3::internal;
    const Net_hierarchy<Index> nets(lower_neighbors<Index>(graph, index_map, points.size()),
                                    coarsest, stall);
    Insertion_order plan;
    plan.order.reserve(points.size());
    plan.starting_places.reserve(points.size());
    Sequence<Index> sequence = order_coarsest<Index>(points, gt, nets, plan);
    for (std::size_t l = nets.clusters.size(); l-- > 0;)
      sequence = append_round(nets, l, sequence, plan);
    return plan;
  }

  // A vertex of a level, and the place of its point in the order.
  template <class Index>
  struct Placed
  {
    Index vertex;
    Index place;
  };

  // All vertices of a level, in their order.
  template <class Index>
  using Sequence = internal::Large_vector<Placed<Index>>;

  // The first rounds: the vertices of the coarsest level. Returns them in their order.
  template <class Index, class Point, class GeomTraits, class Nets>
  Sequence<Index> order_coarsest(const std::vector<Point>& points, const GeomTraits& gt,
                                 const Nets& nets, Insertion_order& plan) const
  {
    const std::size_t level = nets.number_of_levels() - 1;
    std::vector<Point> coarse_points;
    coarse_points.reserve(nets.number_of_coarsest);
    for (std::size_t c = 0; c < nets.number_of_coarsest; ++c)
      coarse_points.push_back(points[nets.point(level, c)]);

    Insertion_order coarse = Geometric_rounds(m_seed)(coarse_points, gt, 0, 0);
    plan.round_ends = std::move(coarse.round_ends);
    Sequence<Index> sequence;
    sequence.reserve(coarse.order.size());
    for (const std::size_t c : coarse.order) {
      const std::size_t place = plan.order.size();
      sequence.push_back({static_cast<Index>(c), static_cast<Index>(place)});
      plan.order.push_back(nets.point(level, c));
      plan.starting_places.push_back(place == 0 ? 0 : place - 1);
    }
    return sequence;
  }

  // The round of the vertices of level l that are not in its net. `parents` are those in the net,
  // in their order; returns all vertices of the level in theirs.
  template <class Nets, class Index>
  static Sequence<Index> append_round(const Nets& nets, std::size_t l,
                                      const Sequence<Index>& parents, Insertion_order& plan)
  {
    Sequence<Index> sequence;
    sequence.reserve(nets.clusters[l].items.size());
    for (const auto& [c, place_of_center] : parents) {
      const Index* member = nets.clusters[l].begin(c);
      sequence.push_back({*member, place_of_center});
      for (++member; member != nets.clusters[l].end(c); ++member) {
        sequence.push_back({*member, static_cast<Index>(plan.order.size())});
        plan.order.push_back(nets.point(l, *member));
        plan.starting_places.push_back(place_of_center);
      }
    }
    plan.round_ends.push_back(plan.order.size());
    return sequence;
  }

  unsigned int m_seed;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_SURFACE_NET_ROUNDS_H
