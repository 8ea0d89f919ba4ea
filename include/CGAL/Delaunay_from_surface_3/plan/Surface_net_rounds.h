// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_SURFACE_NET_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_SURFACE_NET_ROUNDS_H

// Beyond the paper: rounds, order and starting points from the surface. Good spacing takes the
// place of randomness; that the nets are random keeps the numbering of the mesh out of it.
//
// Invariant: when a round begins, the points inserted are a maximal independent set of the graph
// of the points inserted by its end (contracted level by level), so that each point of the round
// has a neighbour that is already inserted.
// Cost: see Net_hierarchy.h.

#include <CGAL/Delaunay_from_surface_3/internal/plan/Net_hierarchy.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/order_of_indices.h>
#include <CGAL/Delaunay_from_surface_3/plan/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>

#include <CGAL/number_utils.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds and order from the surface graph. A net of the graph is a maximal independent set;
every other vertex joins the cluster of a net vertex beside it: of the nearest if there are no more
than 32768 vertices, or if the first one has many edges; else of the one that was chosen first. The
clusters are contracted, and so on until a few dozen vertices are left. Rounds go from the coarsest
net to the finest and grow four- to fivefold. Inside a round the points follow the clusters,
children in the order of their parents: that is local on the surface, and so in space. Each point
starts at the net vertex of its cluster, inserted in an earlier round
(`Insertion_order::starting_places`).

A net is chosen greedily in a random order of the vertices, which the seed decides (of more than
32768 vertices block by block of `block` successive ones, 1024, in random order inside each). In the
order of the indices it would be as regular as the numbering: CAD numbers vertices along profiles
and rings, and such nets destroyed 2.5 times as many cells as random rounds did on an airfoil of
200,000 points. Vertices with
more than three times as many edges as the average come first: it is better to insert the middle of
a fan before the fan. The members of a cluster of more than `large_cluster` come in the order of
`spatial_sort()`, and start at the point before if that is nearer than the net vertex.

Where there are no edges or more than \f$2^{32}\f$, or they join points that are not near each
other, as a look at a thousand of them on two levels tells, `Geometric_rounds` orders the points,
and no starting places are named.

A level that keeps more than 90 % of its vertices (isolated vertices, graphs with few edges) ends
the hierarchy; what is left then, and the last few dozen vertices, are ordered by
`Geometric_rounds`.

Expected \f$O((n + m) \log n)\f$ for n vertices and m edges. \f$O(n)\f$ where vertices and edges
become fewer by a constant factor from level to level, as they do on the surfaces measured, and no
cluster is large. Distances are asked for along the edges of net vertices only, and up to rounding.

\cgalModels{InsertionPlan}
*/
class Surface_net_rounds
{
public:
  /// the share of its vertices that a level may keep.
  static constexpr double stall = 0.9;

  /// the number of vertices at which nets end.
  static constexpr std::size_t coarsest = 64;

  /// the budget (`InsertionPlan::cells_per_point`): on most surfaces nets destroy 12 to 33 cells for
  /// each point, on smooth tori without noise more, and 3 to 4 more for each doubling of the points;
  /// on adversarial ones any number.
  static constexpr std::size_t cells_per_point = 64;

  /// the size from which the inside of a cluster is sorted in space.
  static constexpr std::size_t large_cluster = 32;

  /*!
  makes the plan.

  \param seed draws the nets, and is handed to `Geometric_rounds`
  \param block of more than 32768 vertices, so many successive ones, rounded up to a power of 2, are
  a block; 1 is the order of the indices
  */
  explicit Surface_net_rounds(unsigned int seed = 0, std::size_t block = 1024)
    : m_seed(seed)
    , m_block(block)
  {
  }

  /*!
  returns order, rounds and starting places.

  \tparam Graph a model of `boost::EdgeListGraph`; loops and multiple edges do no harm
  \tparam VertexIndexMap a readable map from the vertices of `graph` onto 0, …, n-1
  */
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                             const Graph& graph, VertexIndexMap index_map,
                             const internal::Executor& executor = internal::Alone()) const
  {
    using Index = std::uint32_t; // one type: another would double what a user's file compiles
    const std::size_t m = std::size_t(num_edges(graph));
    if (m == 0 || (std::max)(points.size(), m) >= (std::numeric_limits<Index>::max)())
      return fallback_plan()(points, gt, graph, index_map);
    return order<Index>(points, gt, graph, index_map, executor);
  }

  /// returns the plan that serves when the budget is exceeded: the bound of \cgalCite{acr-icbr-03}
  /// on the cells created and destroyed holds for it, whatever the surface.
  Geometric_rounds fallback_plan() const { return Geometric_rounds(m_seed); }

private:
  template <class Index, class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order order(const std::vector<Point>& points, const GeomTraits& gt, const Graph& graph,
                        VertexIndexMap index_map, const internal::Executor& executor) const
  {
    using namespace Delaunay_from_surface_3::internal;
    const Net_hierarchy<Index> nets(
        lower_neighbors<Index>(graph, index_map, points.size()), coarsest, stall, m_seed,
        [&](std::size_t i, std::size_t j) { return squared_distance(points[i], points[j]); },
        m_block, executor);
    if (!joins_near_points(points, nets))
      return fallback_plan()(points, gt, graph, index_map);
    Insertion_order plan;
    plan.order.reserve(points.size());
    plan.starting_places.reserve(points.size());
    Sequence<Index> sequence = order_coarsest<Index>(points, gt, nets, plan);
    for (std::size_t l = nets.clusters.size(); l-- > 0;)
      sequence = append_round(points, gt, nets, l, sequence, plan);
    return plan;
  }

  // Up to rounding, and infinite where it overflows.
  template <class Point>
  static double squared_distance(const Point& p, const Point& q)
  {
    const double x = to_double(p.x()) - to_double(q.x());
    const double y = to_double(p.y()) - to_double(q.y());
    const double z = to_double(p.z()) - to_double(q.z());
    return x * x + y * y + z * z;
  }

  // Does the graph join points that are near? On a surface the squared distance of a vertex from
  // its net vertex grows from level to level as the number of vertices falls, and in a volume as
  // its power 2/3; where edges join points at random it stays the same.
  template <class Point, class Nets>
  static bool joins_near_points(const std::vector<Point>& points, const Nets& nets)
  {
    std::size_t level = nets.clusters.size(); // the coarsest that is large enough, and 1
    while (level > 0 && nets.clusters[level - 1].items.size() < 128)
      --level;
    if (level < 2)
      return true;
    --level;
    const double falls = double(points.size()) / double(nets.clusters[level].items.size());
    return median_of_distances(points, nets, level) >=
           std::sqrt(falls) * median_of_distances(points, nets, 0);
  }

  // The median of squared distances from members to net vertices, of about a thousand clusters.
  template <class Point, class Nets>
  static double median_of_distances(const std::vector<Point>& points, const Nets& nets,
                                    std::size_t l)
  {
    const auto& clusters = nets.clusters[l];
    std::vector<double> distances;
    for (std::size_t c = 0; c < clusters.size(); c += clusters.size() / 1024 + 1)
      if (const auto* center = clusters.begin(c); clusters.end(c) - center > 1)
        distances.push_back(
            squared_distance(points[nets.point(l, *center)], points[nets.point(l, center[1])]));
    if (distances.empty())
      return 0;
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
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
  template <class Point, class GeomTraits, class Nets, class Index>
  static Sequence<Index> append_round(const std::vector<Point>& points, const GeomTraits& gt,
                                      const Nets& nets, std::size_t l,
                                      const Sequence<Index>& parents, Insertion_order& plan)
  {
    Sequence<Index> sequence;
    sequence.reserve(nets.clusters[l].items.size());
    for (const auto& [c, place_of_center] : parents) {
      const Index* const first = nets.clusters[l].begin(c);
      const Index* const last = nets.clusters[l].end(c);
      sequence.push_back({*first, place_of_center});
      if (std::size_t(last - first) > large_cluster) {
        append_large_cluster(points, gt, nets, l, first, last, sequence, plan);
        continue;
      }
      for (const Index* member = first + 1; member != last; ++member) {
        sequence.push_back({*member, static_cast<Index>(plan.order.size())});
        plan.order.push_back(nets.point(l, *member));
        plan.starting_places.push_back(place_of_center);
      }
    }
    plan.round_ends.push_back(plan.order.size());
    return sequence;
  }

  // The members of one cluster but its net vertex, which was placed last. A walk from there would
  // lead through half of the fan: they come in the order that spatial_sort() gives them, and start
  // at the point before if that is nearer.
  template <class Point, class GeomTraits, class Nets, class Index>
  static void append_large_cluster(const std::vector<Point>& points, const GeomTraits& gt,
                                   const Nets& nets, std::size_t l, const Index* first,
                                   const Index* last, Sequence<Index>& sequence,
                                   Insertion_order& plan)
  {
    using namespace Delaunay_from_surface_3::internal;
    std::vector<Point> fan;
    for (const Index* member = first + 1; member != last; ++member)
      fan.push_back(points[nets.point(l, *member)]);
    std::vector<std::size_t> order = identity_order(fan.size());
    sort_indices(fan, gt, order.begin(), order.end(),
                 [](auto b, auto e, const auto& traits) { spatial_sort(b, e, traits); });

    const std::size_t place_of_center = sequence.back().place;
    const Point& center = points[nets.point(l, *first)];
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::size_t place = plan.order.size();
      const Point& p = fan[order[k]];
      const bool previous_is_nearer =
          k > 0 && squared_distance(p, fan[order[k - 1]]) < squared_distance(p, center);
      sequence.push_back({first[1 + order[k]], static_cast<Index>(place)});
      plan.order.push_back(nets.point(l, first[1 + order[k]]));
      plan.starting_places.push_back(previous_is_nearer ? place - 1 : place_of_center);
    }
  }

  unsigned int m_seed;
  std::size_t m_block;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_SURFACE_NET_ROUNDS_H
