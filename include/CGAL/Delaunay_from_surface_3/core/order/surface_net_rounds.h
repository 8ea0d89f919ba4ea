// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SURFACE_NET_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SURFACE_NET_ROUNDS_H

// Beyond the paper: rounds, order and starting points from the surface. Good spacing takes the
// place of randomness; that the nets are random keeps the numbering of the mesh out of it.
//
// Invariant: when a round begins, the points inserted are a maximal independent set of the graph
// of the points inserted by its end (contracted level by level), so that each point of the round
// has a neighbour that is already inserted.
// Cost: see Net_hierarchy.h.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Net_hierarchy.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/order/squared_distance.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The median of squared distances from members to net vertices of a level, of about a thousand
// clusters.
inline double median_of_distances(const Point_array& points, const Net_hierarchy& nets,
                                  std::size_t level)
{
  const Lists<std::uint32_t>& clusters = nets.clusters[level];
  std::vector<double> distances;
  for (std::size_t c = 0; c < clusters.size(); c += clusters.size() / 1024 + 1)
    if (const std::uint32_t* center = clusters.begin(c); clusters.end(c) - center > 1)
      distances.push_back(
          squared_distance(points, nets.point(level, *center), nets.point(level, center[1])));
  if (distances.empty())
    return 0;
  const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

// Whether the graph joins points that are near. On a surface the squared distance of a vertex from
// its net vertex grows from level to level as the number of vertices falls, and in a volume as
// its power 2/3; where edges join points at random it stays the same.
inline bool joins_near_points(const Point_array& points, const Net_hierarchy& nets)
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

// Appends one round after the other to an order, from the coarsest net to the finest.
class Rounds_of_nets
{
  // A vertex of a level, and the place of its point in the order.
  struct Placed
  {
    std::uint32_t vertex, place;
  };

  // All vertices of a level, in their order.
  using Sequence = Large_vector<Placed>;

public:
  Rounds_of_nets(const Point_array& points, const Net_hierarchy& nets, const Order_request& request)
    : m_points(points)
    , m_nets(nets)
    , m_request(request)
  {
  }

  Insertion_order order()
  {
    m_result = Insertion_order();
    m_result.order.reserve(m_points.size());
    m_result.starting_places.reserve(m_points.size());
    Sequence sequence = append_coarsest();
    for (std::size_t level = m_nets.clusters.size(); level-- > 0;)
      sequence = append_round(level, sequence);
    return std::move(m_result);
  }

private:
  // The vertex of a level as the next of the order. Returns its place.
  std::uint32_t append(std::size_t level, std::size_t vertex, std::size_t starting_place)
  {
    const std::size_t place = m_result.order.size();
    m_result.order.push_back(m_nets.point(level, vertex));
    m_result.starting_places.push_back(starting_place);
    return static_cast<std::uint32_t>(place);
  }

  // The first rounds: the vertices of the coarsest level. Returns them in their order.
  Sequence append_coarsest()
  {
    const std::size_t level = m_nets.number_of_levels() - 1;
    const std::vector<double> coordinates = coordinates_of(
        m_nets.number_of_coarsest, [&](std::size_t v) { return m_nets.point(level, v); });
    Insertion_order coarse =
        random_rounds(Point_array(coordinates.data(), m_nets.number_of_coarsest));
    m_result.round_ends = std::move(coarse.round_ends);
    Sequence sequence;
    sequence.reserve(coarse.order.size());
    for (const std::size_t v : coarse.order) {
      const std::size_t place = m_result.order.size();
      sequence.push_back(
          {static_cast<std::uint32_t>(v), append(level, v, place == 0 ? 0 : place - 1)});
    }
    return sequence;
  }

  // The round of the vertices of a level that are not in its net. `parents` are those in the net,
  // in their order; returns all vertices of the level in theirs.
  Sequence append_round(std::size_t level, const Sequence& parents)
  {
    const Lists<std::uint32_t>& clusters = m_nets.clusters[level];
    Sequence sequence;
    sequence.reserve(clusters.items.size());
    for (const auto& [c, place_of_center] : parents) {
      const std::uint32_t *const first = clusters.begin(c), *const last = clusters.end(c);
      sequence.push_back({*first, place_of_center});
      if (std::size_t(last - first) > large_cluster)
        append_large_cluster(level, first, last, sequence);
      else
        for (const std::uint32_t* member = first + 1; member != last; ++member)
          sequence.push_back({*member, append(level, *member, place_of_center)});
    }
    m_result.round_ends.push_back(m_result.order.size());
    return sequence;
  }

  // The members of one cluster but its net vertex, which was placed last. A walk from there would
  // lead through half of the fan: they come in random rounds, and start at the point before if that
  // is nearer.
  void append_large_cluster(std::size_t level, const std::uint32_t* first,
                            const std::uint32_t* last, Sequence& sequence)
  {
    const std::uint32_t* const members = first + 1;
    const std::size_t size = std::size_t(last - members);
    const std::vector<double> coordinates =
        coordinates_of(size, [&](std::size_t k) { return m_nets.point(level, members[k]); });
    const Point_array fan(coordinates.data(), size);
    const std::size_t center = m_nets.point(level, *first);
    const std::uint32_t place_of_center = sequence.back().place;
    std::size_t previous = center, place_of_previous = place_of_center;
    for (const std::size_t k : random_rounds(fan).order) {
      const std::size_t point = m_nets.point(level, members[k]);
      const bool previous_is_nearer =
          squared_distance(m_points, point, previous) < squared_distance(m_points, point, center);
      const std::uint32_t place =
          append(level, members[k], previous_is_nearer ? place_of_previous : place_of_center);
      sequence.push_back({members[k], place});
      previous = point;
      place_of_previous = place;
    }
  }

  Insertion_order random_rounds(const Point_array& points) const
  {
    return geometric_rounds(points, m_request.seed, m_request.ratio, m_request.first_round);
  }

  // Of the points name(0), …, name(n-1).
  template <class Name>
  std::vector<double> coordinates_of(std::size_t n, const Name& name) const
  {
    std::vector<double> coordinates;
    coordinates.reserve(3 * n);
    for (std::size_t k = 0; k < n; ++k)
      coordinates.insert(coordinates.end(), m_points[name(k)], m_points[name(k)] + 3);
    return coordinates;
  }

  Point_array m_points;
  const Net_hierarchy& m_nets;
  Order_request m_request;
  Insertion_order m_result;
};

// The order of n points whose graph has these lower neighbours; without starting places if the
// graph does not tell which points are near each other.
inline Insertion_order surface_net_rounds(const Point_array& points, Edge_source& edges,
                                          const Order_request& request, const Executor& executor)
{
  const Net_hierarchy nets(edges, points, request.seed, request.block, executor);
  if (!joins_near_points(points, nets))
    return geometric_rounds(points, request.seed, request.ratio, request.first_round);
  return Rounds_of_nets(points, nets, request).order();
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SURFACE_NET_ROUNDS_H
