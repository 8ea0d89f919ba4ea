// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_SURFACE_NET_ROUNDS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_SURFACE_NET_ROUNDS_H

// A plan that the benchmark and the tests compare with the package's own.
// Goes beyond the paper: takes rounds, order and starting points from the surface. Good spacing
// replaces randomness; the nets are random so that the numbering of the mesh has no influence.
// Rounds of well-spaced points (Spaced_rounds) do as well without a surface.
//
// Invariant: when a round begins, the points inserted are a maximal independent set of the graph
// of the points inserted by its end (contracted level by level), so that each point of the round
// has a neighbour that is already inserted.
// Cost: see Net_hierarchy.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A graph is given by the neighbours of each vertex that have smaller numbers: every edge is stored
// at one of its ends only, which handles it for both. A level is made in linear time.
using Net_index = std::uint32_t;
using Net_graph = Lists_view<Net_index>;

constexpr double net_stall = 0.9;
constexpr std::size_t coarsest_net = 64;
constexpr std::size_t large_cluster = 32;
constexpr std::size_t largest_net_block = std::size_t(1) << 15;

// Calls visit(v) for 0, …, n-1 in random order; if there are many, blocks of `block` numbers,
// rounded up to a power of 2, follow each other, and the order is random inside each. The blocks
// share one permutation, each with a shift and flip of its own. The part of a graph that belongs to
// one of many blocks fits into the cache nearest to the processor.
template <class Visit>
void for_each_in_random_blocks(std::size_t n, std::uint64_t seed, std::size_t block,
                               const Visit& visit)
{
  std::size_t size = 1;
  while (size < (n <= largest_net_block ? n : (std::min)(n, block)))
    size *= 2;
  Split_mix random(seed);
  std::vector<Net_index> inner(size);
  std::iota(inner.begin(), inner.end(), Net_index(0));
  random.shuffle(inner.begin(), inner.end());
  for (std::size_t first = 0; first < n; first += size) {
    const std::size_t shift = random() % size, flip = random() % size;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t v = first + (inner[(k + shift) & (size - 1)] ^ flip);
      if (v < n)
        visit(v);
    }
  }
}

// A net of a graph is a maximal independent set. The cluster of a net vertex consists of the vertex
// and neighbours of it; a vertex beside several net vertices belongs to the nearest, or, if there
// are many vertices, to the first.
//
// The net is the greedy one in a random order of the vertices. In the order of the numbers it would
// be as regular as the numbering, and CAD programs number along profiles and rings: whole rings
// would come one after the other. If there are many vertices, blocks of successive numbers follow
// each other. That keeps memory accesses together, and stays near the order of the numbers, which
// is a good one on scans. Hubs come before all others: it is better to insert the middle of a fan
// before the fan. Chains of vertices, each of which waits for the one before, have logarithmic
// length in random orders (Blelloch, Fineman, Shun 2012; Fischer, Noever 2018).
struct Net
{
  Large_vector<Net_index> centers;    // the net vertex of each cluster, in ascending order
  Large_vector<Net_index> cluster_of; // the cluster of each vertex
};

// Returns the vertices with more than three times as many edges as the average, in random order.
inline std::vector<Net_index> hubs_of(const Net_graph& lower, std::uint64_t seed)
{
  const std::size_t n = lower.size();
  Large_vector<Net_index> degree(n);
  for (std::size_t v = 0; v < n; ++v)
    degree[v] = Net_index(lower.end(v) - lower.begin(v));
  for (std::size_t k = 0; k < lower.number_of_items; ++k)
    ++degree[lower.items[k]];
  const auto most = Net_index(3 * 2 * lower.number_of_items / n);
  std::vector<Net_index> result;
  for (std::size_t v = 0; v < n; ++v)
    if (degree[v] > most)
      result.push_back(Net_index(v));
  Split_mix(seed).shuffle(result.begin(), result.end());
  return result;
}

// Returns for each vertex itself if it is in the greedy net, otherwise a neighbour that is. `hubs`
// come first. A vertex asks the vertices in its list, and tells them when it joins.
inline Large_vector<Net_index> random_net(const Net_graph& lower,
                                          const std::vector<Net_index>& hubs, std::uint64_t seed,
                                          std::size_t block)
{
  enum State : char { UNSEEN, IN_NET, BESIDE };
  std::vector<char> state(lower.size(), UNSEEN);
  Large_vector<Net_index> center(lower.size());
  const auto decide = [&](std::size_t v) {
    if (state[v] != UNSEEN)
      return;
    const Net_index *const first = lower.begin(v), *const last = lower.end(v);
    const Net_index* const in_net =
        std::find_if(first, last, [&](Net_index u) { return state[u] == IN_NET; });
    center[v] = in_net == last ? Net_index(v) : *in_net;
    state[v] = in_net == last ? IN_NET : BESIDE;
    if (in_net == last)
      for (const Net_index* u = first; u != last; ++u)
        if (state[*u] == UNSEEN) {
          state[*u] = BESIDE;
          center[*u] = Net_index(v);
        }
  };
  for (const Net_index v : hubs)
    decide(v);
  for_each_in_random_blocks(lower.size(), seed, block, decide);
  return center;
}

// Makes the nearest net vertex beside a vertex its centre. If there are many vertices, this is done
// for those in the clusters of hubs alone: a pass over all points would cost much, for a small
// gain. But a hub would keep all vertices beside it, however far away, and its cluster the adjacent
// clusters on the next level, until one cluster has half of all vertices. Vertex v is at the point
// names[v].
inline void choose_nearest_centers(const Net_graph& lower, const std::vector<Net_index>& hubs,
                                   const Point_array& points, const Net_index* names,
                                   Large_vector<Net_index>& center)
{
  const std::size_t n = lower.size();
  const bool are_few = n <= largest_net_block;
  if (!are_few && hubs.empty())
    return;
  std::vector<char> is_hub(n), chooses(n);
  for (const Net_index v : hubs)
    is_hub[v] = 1;
  for (std::size_t v = 0; v < n; ++v)
    chooses[v] = are_few || is_hub[center[v]];
  const double largest = (std::numeric_limits<float>::max)();
  Large_vector<float> nearest(n, (std::numeric_limits<float>::infinity)());
  const auto offer = [&](std::size_t v, std::size_t c) {
    if (!chooses[v])
      return;
    const float d =
        float((std::min)(squared_distance(points[names[v]], points[names[c]]), largest));
    if (d < nearest[v]) {
      nearest[v] = d;
      center[v] = Net_index(c);
    }
  };
  for (std::size_t v = 0; v < n; ++v)
    for (const Net_index *u = lower.begin(v), *end = lower.end(v); u != end; ++u)
      if (center[v] == v) {
        if (*u != v)
          offer(*u, v);
      } else if (center[*u] == *u)
        offer(v, *u);
}

// Returns whether center[v], the centre of each vertex v, defines a net: every centre is its own,
// every other vertex is beside its centre, and no centre is beside another. Linear.
inline bool is_net(const Net_graph& lower, const Large_vector<Net_index>& center)
{
  std::vector<char> is_beside_center(lower.size());
  for (std::size_t v = 0; v < lower.size(); ++v)
    for (const Net_index *u = lower.begin(v), *end = lower.end(v); u != end; ++u) {
      if (*u != v && center[v] == v && center[*u] == *u)
        return false;
      if (center[v] == *u)
        is_beside_center[v] = 1;
      if (center[*u] == v)
        is_beside_center[*u] = 1;
    }
  for (std::size_t v = 0; v < lower.size(); ++v)
    if (center[center[v]] != center[v] || (center[v] != v && !is_beside_center[v]))
      return false;
  return true;
}

// Makes the net and its clusters. Vertex v is at the point names[v].
inline Net net_of(const Net_graph& lower, std::uint64_t seed, const Point_array& points,
                  const Net_index* names, std::size_t block)
{
  const std::size_t n = lower.size();
  const std::vector<Net_index> hubs = hubs_of(lower, seed);
  Large_vector<Net_index> center = random_net(lower, hubs, seed, block);
  choose_nearest_centers(lower, hubs, points, names, center);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(is_net(lower, center));
  Net net;
  Large_vector<Net_index> number(n); // the cluster of a net vertex
  for (std::size_t v = 0; v < n; ++v)
    if (center[v] == v) {
      number[v] = Net_index(net.centers.size());
      net.centers.push_back(Net_index(v));
    }
  for (Net_index& c : center)
    c = number[c];
  net.cluster_of = std::move(center);
  return net;
}

// Lists the members of every cluster, its net vertex first, the others in ascending order.
inline Lists<Net_index> members(const Net& net)
{
  Lists<Net_index> lists = in_lists<Net_index>(
      net.centers.size(),
      Listed_items(
          net.cluster_of.size(), [&](std::size_t v) { return std::size_t(net.cluster_of[v]); },
          [](std::size_t v) { return Net_index(v); }));
  for (std::size_t c = 0; c < lists.size(); ++c) {
    Net_index* const first = lists.items.data() + lists.first[c];
    Net_index* const center =
        std::find(first, first + (lists.end(c) - lists.begin(c)), net.centers[c]);
    std::rotate(first, center, center + 1);
  }
  return lists;
}

// Returns the graph of the clusters: two are neighbours if members of them are. An edge is found
// from each of its clusters at most once, so that it is there at most twice.
inline Lists<Net_index> contracted(const Net_graph& lower,
                                   const Large_vector<Net_index>& cluster_of,
                                   const Lists<Net_index>& clusters)
{
  Large_vector<Numbered_edge> edges;
  edges.reserve(4 * clusters.size()); // enough on a surface
  Large_vector<Net_index> last_met_by(clusters.size(), Net_index(clusters.size()));
  const std::size_t last_item = clusters.items.size() - 1;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    last_met_by[c] = Net_index(c);
    for (std::size_t k = clusters.first[c]; k < clusters.first[c + 1]; ++k) {
      prefetch(&lower.first[clusters.items[(std::min)(k + prefetch_distance, last_item)]]);
      prefetch(lower.begin(clusters.items[(std::min)(k + prefetch_distance / 2, last_item)]));
      const Net_index v = clusters.items[k];
      for (const Net_index *u = lower.begin(v), *end = lower.end(v); u != end; ++u) {
        const Net_index d = cluster_of[*u];
        if (last_met_by[d] == Net_index(c))
          continue;
        last_met_by[d] = Net_index(c);
        edges.emplace_back(Net_index(c), d);
      }
    }
  }
  return lower_neighbors(edges, clusters.size());
}

// Holds nets of a graph, finest first, each a maximal independent set in the contracted graph of
// the one before. clusters[l] lists the clusters of the vertices of level l; they are the vertices
// of level l + 1. names[l] has the point of each vertex of level l.
//
// Invariant: the vertices of a level are numbered in the order of the level below, so that a mesh
// that is coherent in memory gives coherent levels. There is no search through the graph: if the
// mesh is not coherent, it would miss the cache at every vertex.
// Cost: on the surfaces measured the levels shrink by a constant factor (4 to 5) and their edges
// with them: linear altogether. In other graphs a level may keep nearly all its vertices; such a
// level ends the hierarchy.
struct Net_hierarchy
{
  std::vector<Lists<Net_index>> clusters;
  std::vector<Large_vector<Net_index>> names;

  // Makes nets of the graph with these edges (at least one) until at most `coarsest_net` vertices
  // are left, or a net keeps more than the share `net_stall` of them.
  Net_hierarchy(Net_graph lower, const Point_array& points, unsigned int seed, std::size_t block)
    : names(1, Large_vector<Net_index>(points.size()))
  {
    std::iota(names[0].begin(), names[0].end(), Net_index(0));
    Split_mix random(seed);
    Lists<Net_index> contracted_edges;
    while (lower.size() > coarsest_net) {
      const Large_vector<Net_index>& names_here = names.back();
      Net net = net_of(lower, random(), points, names_here.data(), block);
      if (double(net.centers.size()) > net_stall * double(lower.size()))
        break;
      clusters.push_back(members(net));
      contracted_edges = contracted(lower, net.cluster_of, clusters.back());
      lower = contracted_edges;
      for (Net_index& c : net.centers)
        c = names_here[c];
      names.push_back(std::move(net.centers));
    }
  }
};

// Returns the median squared distance from a member to the net vertex, over about a thousand
// clusters of a level.
inline double median_of_distances(const Point_array& points, const Net_hierarchy& nets,
                                  std::size_t level)
{
  const Lists<Net_index>& clusters = nets.clusters[level];
  const Large_vector<Net_index>& names = nets.names[level];
  std::vector<double> distances;
  for (std::size_t c = 0; c < clusters.size(); c += clusters.size() / 1024 + 1)
    if (const Net_index* center = clusters.begin(c); clusters.end(c) - center > 1)
      distances.push_back(squared_distance(points[names[*center]], points[names[center[1]]]));
  if (distances.empty())
    return 0;
  const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

// Returns whether the graph joins points that are near each other. From level to level, the squared
// distance of a vertex from its net vertex grows on a surface as the number of vertices falls, and
// in a volume as the power 2/3 of that; if edges join points at random, it stays the same.
inline bool joins_near_points(const Point_array& points, const Net_hierarchy& nets)
{
  std::size_t level = nets.clusters.size(); // becomes 1 + the coarsest level that is large enough
  while (level > 0 && nets.clusters[level - 1].items.size() < 128)
    --level;
  if (level < 2)
    return true;
  --level;
  const double falls = double(points.size()) / double(nets.clusters[level].items.size());
  return median_of_distances(points, nets, level) >=
         std::sqrt(falls) * median_of_distances(points, nets, 0);
}

// Returns the order of Geometric_rounds for the points named.
inline Insertion_order geometric_rounds_of(const Point_array& points, const Net_index* first,
                                           const Net_index* last, unsigned int seed)
{
  std::vector<double> coordinates;
  coordinates.reserve(3 * std::size_t(last - first));
  for (; first != last; ++first)
    coordinates.insert(coordinates.end(), points[*first], points[*first] + 3);
  const Build_options options;
  return geometric_rounds(Point_array(coordinates.data(), coordinates.size() / 3), seed,
                          options.ratio, options.first_round);
}

// Appends one round after the other to an order, from the coarsest net to the finest.
class Rounds_of_nets
{
  // Holds a vertex of a level, and the place of its point in the order.
  struct Placed
  {
    Net_index vertex, place;
  };

  // Lists all vertices of a level in their order.
  using Sequence = Large_vector<Placed>;

public:
  Rounds_of_nets(const Point_array& points, const Net_hierarchy& nets, unsigned int seed)
    : m_points(points)
    , m_nets(nets)
    , m_seed(seed)
  {
  }

  Insertion_order order()
  {
    m_result.order.reserve(m_points.size());
    m_result.starting_places.reserve(m_points.size());
    Sequence sequence = append_coarsest();
    for (std::size_t level = m_nets.clusters.size(); level-- > 0;)
      sequence = append_round(level, sequence);
    return std::move(m_result);
  }

private:
  // Appends a point to the order. Returns its place.
  Net_index append(std::size_t point, std::size_t starting_place)
  {
    m_result.order.push_back(point);
    m_result.starting_places.push_back(starting_place);
    return Net_index(m_result.order.size() - 1);
  }

  // Appends the first rounds: the vertices of the coarsest level. Returns them in their order.
  Sequence append_coarsest()
  {
    const Large_vector<Net_index>& names = m_nets.names.back();
    Insertion_order coarse =
        geometric_rounds_of(m_points, names.data(), names.data() + names.size(), m_seed);
    m_result.round_ends = std::move(coarse.round_ends);
    Sequence sequence;
    sequence.reserve(names.size());
    for (const std::size_t v : coarse.order)
      sequence.push_back(
          {Net_index(v), append(names[v], (std::max)(sequence.size(), std::size_t(1)) - 1)});
    return sequence;
  }

  // Appends the round of the vertices of a level that are not in its net. `parents` are the
  // vertices in the net, in their order; returns all vertices of the level in their order.
  Sequence append_round(std::size_t level, const Sequence& parents)
  {
    const Lists<Net_index>& clusters = m_nets.clusters[level];
    const Large_vector<Net_index>& names = m_nets.names[level];
    Sequence sequence;
    sequence.reserve(clusters.items.size());
    for (const auto& [c, place_of_center] : parents) {
      const Net_index *const first = clusters.begin(c), *const last = clusters.end(c);
      sequence.push_back({*first, place_of_center});
      if (std::size_t(last - first) > large_cluster)
        append_large_cluster(names, first, last, sequence);
      else
        for (const Net_index* member = first + 1; member != last; ++member)
          sequence.push_back({*member, append(names[*member], place_of_center)});
    }
    m_result.round_ends.push_back(m_result.order.size());
    return sequence;
  }

  // Appends the members of one cluster except its net vertex, the last of `sequence`. A walk from
  // there would lead through half of the fan: so the members come in random rounds, and start at
  // the previous point if that is nearer.
  void append_large_cluster(const Large_vector<Net_index>& names, const Net_index* first,
                            const Net_index* last, Sequence& sequence)
  {
    std::vector<Net_index> fan;
    for (const Net_index* member = first + 1; member != last; ++member)
      fan.push_back(names[*member]);
    const Placed center = sequence.back();
    const double* previous = m_points[names[*first]];
    const double* const middle = previous;
    for (const std::size_t k :
         geometric_rounds_of(m_points, fan.data(), fan.data() + fan.size(), m_seed).order) {
      const double* const point = m_points[fan[k]];
      const bool previous_is_nearer =
          squared_distance(point, previous) < squared_distance(point, middle);
      sequence.push_back({first[1 + k], append(fan[k], previous_is_nearer ? sequence.back().place
                                                                          : center.place)});
      previous = point;
    }
  }

  Point_array m_points;
  const Net_hierarchy& m_nets;
  unsigned int m_seed;
  Insertion_order m_result;
};

// Lists, for each of the n vertices of a graph, its neighbours with smaller numbers; returns no
// lists if there are no edges, or too many vertices or edges for 32-bit numbers.
template <class Graph, class VertexIndexMap>
Lists<Net_index> lower_neighbors(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  const std::size_t m = std::size_t(num_edges(graph));
  if (m == 0 || (std::max)(n, m) >= (std::numeric_limits<Net_index>::max)())
    return {};
  Large_vector<Numbered_edge> numbered;
  numbered.reserve(m);
  for (auto [e, end] = edges(graph); e != end; ++e)
    numbered.emplace_back(Net_index(get(index_map, source(*e, graph))),
                          Net_index(get(index_map, target(*e, graph))));
  return lower_neighbors(numbered, n);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds and order from the surface graph. A net of the graph is a maximal independent set.
Every other vertex joins the cluster of an adjacent net vertex: the nearest if there are at most
32768 vertices, or if the first that was chosen has many edges; otherwise the first.
Contracting the clusters gives a smaller graph, and so on, until at most 64 vertices are left.
Rounds go from the coarsest net to the finest and grow four- to fivefold. Inside a round the points
follow the clusters, children in the order of their parents. This order is local on the surface, and
so in space. Each point starts at the net vertex of its cluster, which is inserted in an earlier
round (`Insertion_order::starting_places`).

A net is chosen greedily in a random order of the vertices, which the seed determines. With more
than 32768 vertices, blocks of `block` successive vertices (1024 by default) follow each other, and
only the order inside each block is random. In the order of the indices a net would be as regular as
the numbering. CAD programs number vertices along profiles and rings, and such nets destroyed 3.6
times as many cells as random ones on an airfoil of 200,000 points (`nets_200k.json`). Vertices
with more than three times as many edges as the average come first: it is better to insert the
middle of a fan before the fan. The members of a cluster of more than 32 vertices come in the order
of `Geometric_rounds`, and start at the previous point if that is nearer than the net vertex.

If there are no edges or more than \f$2^{32}\f$, the order is that of `Spaced_rounds`, within the
budget of this plan, which a quadratic number of cells exceeds. If the edges join points that are
not near each other (a thousand are examined on two levels), `Geometric_rounds` orders the points.
Then there are no starting places.

A level that keeps more than 90 % of its vertices (isolated vertices, graphs with few edges) ends
the hierarchy. `Geometric_rounds` orders the vertices left at the end.

One thread makes the order, also with `Parallel_tag`.

<b>Complexity</b>: expected \f$O((n + m) \log n)\f$ for n vertices and m edges; \f$O(n)\f$ if
vertices and edges decrease by a constant factor from level to level, as they do on the surfaces
measured, and no cluster is large. Distances are computed only along the edges of net vertices, and
up to rounding.

\cgalModels{InsertionPlan}
*/
class Surface_net_rounds
{
public:
  /// the budget (`InsertionPlan::cells_per_point`). On most surfaces nets destroy 12 to 33 cells
  /// per point. On smooth tori without noise they destroy more, and 3 to 4 more for each doubling
  /// of the points; on adversarial surfaces any number.
  static constexpr std::size_t cells_per_point = internal::Build_options::usual_number;

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
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                             const Graph& graph, VertexIndexMap index_map) const
  {
    using namespace internal;
    const auto coordinates = rounded_coordinates(points);
    const Point_array array(coordinates.data(), points.size());
    const auto lower = lower_neighbors(graph, index_map, points.size());
    if (lower.items.empty() && points.size() < (std::numeric_limits<std::uint32_t>::max)())
      return spaced_rounds(array, Alone());
    if (lower.items.empty())
      return fallback_plan()(points, gt, graph, index_map);
    const Net_hierarchy nets(lower, array, m_seed, m_block);
    return joins_near_points(array, nets) ? Rounds_of_nets(array, nets, m_seed).order()
                                          : fallback_plan()(points, gt, graph, index_map);
  }

  /// returns the plan that is used when the budget is exceeded; the bound of \cgalCite{acr-icbr-03}
  /// on the cells created and destroyed holds for it, whatever the surface.
  Geometric_rounds fallback_plan() const { return Geometric_rounds(m_seed); }

private:
  unsigned int m_seed;
  std::size_t m_block;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // DELAUNAY_FROM_SURFACE_3_METERS_SURFACE_NET_ROUNDS_H
