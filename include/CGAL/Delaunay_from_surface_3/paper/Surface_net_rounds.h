// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SURFACE_NET_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SURFACE_NET_ROUNDS_H

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
#include <CGAL/Delaunay_from_surface_3/paper/Lower_neighbor_graph.h>
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
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Surface_net_rounds documents these constants.
constexpr double net_stall = 0.9;
constexpr std::size_t coarsest_net = 64;
constexpr std::size_t large_cluster = 32;

// A net of a graph is a maximal independent set. The cluster of a net vertex consists of the vertex
// and neighbours of it; a vertex beside several net vertices belongs to the nearest, or, if there
// are many vertices, to the first.
//
// The net is the greedy one in a random order of the vertices. In the order of the numbers it would
// be as regular as the numbering, and CAD programs number along profiles and rings: whole rings
// would come one after the other. If there are many vertices, blocks of successive numbers follow
// each other, and the order is random inside each. That keeps memory accesses together, and stays
// near the order of the numbers, which is a good one on scans. Hubs come before all others: it is
// better to insert the middle of a fan before the fan. Chains of vertices, each of which waits for
// the one before, have logarithmic length in random orders (Blelloch, Fineman, Shun 2012; Fischer,
// Noever 2018).
//
// Cost: linear in vertices and edges. Every edge is stored at one of its ends only, which handles
// it for both: a vertex asks the vertices in its list, and tells them when it joins.

// Visits the numbers 0, …, n-1 in random order; if there are many, block by block, in random order
// inside each. The blocks share one permutation, each with a shift and flip of its own. The part of
// a graph that belongs to one of many blocks fits into the cache nearest to the processor.
class Random_blocks
{
public:
  static constexpr std::size_t largest_block = std::size_t(1) << 15;
  static constexpr std::size_t one_of_many = std::size_t(1) << 10;

  // Makes blocks of `block` numbers, rounded up to a power of 2, if there are many numbers.
  Random_blocks(std::size_t n, std::uint64_t seed, std::size_t block = one_of_many)
    : m_n(n)
  {
    std::size_t size = 1;
    while (size < (n <= largest_block ? n : (std::min)(n, block)))
      size *= 2;
    Split_mix random(seed);
    m_inner.resize(size);
    std::iota(m_inner.begin(), m_inner.end(), std::uint32_t(0));
    random.shuffle(m_inner.begin(), m_inner.end());
    for (std::size_t first = 0; first < n; first += size)
      m_blocks.push_back({first, std::size_t(random() % size), std::size_t(random() % size)});
  }

  // Calls visit(v) for every number.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    const std::size_t mask = m_inner.size() - 1;
    for (const Block& block : m_blocks)
      for (std::size_t k = 0; k <= mask; ++k) {
        const std::size_t v = block.first + (m_inner[(k + block.shift) & mask] ^ block.flip);
        if (v < m_n)
          visit(v);
      }
  }

private:
  struct Block
  {
    std::size_t first, shift, flip;
  };

  std::size_t m_n;
  std::vector<Block> m_blocks;
  std::vector<std::uint32_t> m_inner; // a permutation of a block, whose size is a power of 2
};

// Refers to the points at the vertices of a graph.
class Vertex_points
{
public:
  // Vertex v is at the point names[v], or at point v if there are no names.
  explicit Vertex_points(const Point_array& points, const std::uint32_t* names = nullptr)
    : m_points(points)
    , m_names(names)
  {
  }

  double squared_distance(std::size_t v, std::size_t u) const
  {
    return m_names == nullptr
               ? internal::squared_distance(m_points[v], m_points[u])
               : internal::squared_distance(m_points[m_names[v]], m_points[m_names[u]]);
  }

private:
  Point_array m_points;
  const std::uint32_t* m_names;
};

struct Net
{
  Large_vector<std::uint32_t> centers;    // the net vertex of each cluster, in ascending order
  Large_vector<std::uint32_t> cluster_of; // the cluster of each vertex
};

// Returns the vertices with more than three times as many edges as the average, in random order.
inline std::vector<std::uint32_t> hubs_of(const Lists_view<std::uint32_t>& lower,
                                          std::uint64_t seed)
{
  using Index = std::uint32_t;
  const std::size_t n = lower.size();
  Large_vector<Index> degree(n);
  for (std::size_t v = 0; v < n; ++v)
    degree[v] = Index(lower.end(v) - lower.begin(v));
  for (std::size_t k = 0; k < lower.number_of_items; ++k)
    ++degree[lower.items[k]];
  const Index most = Index(3 * 2 * lower.number_of_items / n);
  std::vector<Index> result;
  for (std::size_t v = 0; v < n; ++v)
    if (degree[v] > most)
      result.push_back(Index(v));
  Split_mix(seed).shuffle(result.begin(), result.end());
  return result;
}

// Returns for each vertex itself if it is in the greedy net of the graph with these lower
// neighbours, otherwise a neighbour that is. `hubs` come first.
inline Large_vector<std::uint32_t> random_net(const Lists_view<std::uint32_t>& lower,
                                              const std::vector<std::uint32_t>& hubs,
                                              std::uint64_t seed, std::size_t block)
{
  using Index = std::uint32_t;
  enum State : char { UNSEEN, IN_NET, BESIDE };
  std::vector<char> state(lower.size(), UNSEEN);
  Large_vector<Index> center(lower.size());
  const auto decide = [&](std::size_t v) {
    if (state[v] != UNSEEN)
      return;
    const Index *const first = lower.begin(v), *const last = lower.end(v);
    const Index* const in_net =
        std::find_if(first, last, [&](Index u) { return state[u] == IN_NET; });
    center[v] = in_net == last ? Index(v) : *in_net;
    state[v] = in_net == last ? IN_NET : BESIDE;
    if (in_net == last)
      for (const Index* u = first; u != last; ++u)
        if (state[*u] == UNSEEN) {
          state[*u] = BESIDE;
          center[*u] = Index(v);
        }
  };
  for (const Index v : hubs)
    decide(v);
  Random_blocks(lower.size(), seed, block).for_each(decide);
  return center;
}

// Makes the nearest net vertex beside a vertex its centre, for each vertex with is_wanted(v).
template <class Is_wanted>
void choose_nearest_centers(const Lists_view<std::uint32_t>& lower, const Is_wanted& is_wanted,
                            const Vertex_points& points, Large_vector<std::uint32_t>& center)
{
  using Index = std::uint32_t;
  const double largest = (std::numeric_limits<float>::max)();
  Large_vector<float> nearest(lower.size(), (std::numeric_limits<float>::infinity)());
  const auto offer = [&](std::size_t v, std::size_t c) {
    if (!is_wanted(v))
      return;
    const float d = float((std::min)(points.squared_distance(v, c), largest));
    if (d < nearest[v]) {
      nearest[v] = d;
      center[v] = Index(c);
    }
  };
  for (std::size_t v = 0; v < lower.size(); ++v)
    for (const Index *u = lower.begin(v), *end = lower.end(v); u != end; ++u)
      if (center[v] == v) {
        if (*u != v)
          offer(*u, v);
      } else if (center[*u] == *u)
        offer(v, *u);
}

// Does the same for the vertices in the clusters of hubs. A hub would keep all vertices beside it,
// however far away, and its cluster the adjacent clusters on the next level, until one cluster has
// half of all vertices.
inline void choose_nearest_instead_of_hubs(const Lists_view<std::uint32_t>& lower,
                                           const std::vector<std::uint32_t>& hubs,
                                           const Vertex_points& points,
                                           Large_vector<std::uint32_t>& center)
{
  if (hubs.empty())
    return;
  std::vector<char> is_hub(lower.size()), is_beside_hub(lower.size());
  for (const std::uint32_t v : hubs)
    is_hub[v] = 1;
  for (std::size_t v = 0; v < lower.size(); ++v)
    is_beside_hub[v] = is_hub[center[v]];
  choose_nearest_centers(
      lower, [&](std::size_t v) { return is_beside_hub[v] != 0; }, points, center);
}

// Returns whether center[v], the centre of each vertex v, defines a net: every centre is its own,
// every other vertex is beside its centre, and no centre is beside another. Linear.
inline bool is_net(const Lists_view<std::uint32_t>& lower,
                   const Large_vector<std::uint32_t>& center)
{
  std::vector<char> is_beside_center(lower.size());
  for (std::size_t v = 0; v < lower.size(); ++v)
    for (const std::uint32_t *u = lower.begin(v), *end = lower.end(v); u != end; ++u) {
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

// Makes the net and its clusters. Distances are computed between neighbours, one of which is in the
// net; if there are many vertices, only in clusters of hubs: a pass over all points would then cost
// much, for a small gain.
inline Net net_of(const Lists_view<std::uint32_t>& lower, std::uint64_t seed,
                  const Vertex_points& points, std::size_t block = Random_blocks::one_of_many)
{
  using Index = std::uint32_t;
  const std::size_t n = lower.size();
  const std::vector<Index> hubs = hubs_of(lower, seed);
  Net net;
  net.cluster_of = random_net(lower, hubs, seed, block);
  Large_vector<Index>& center = net.cluster_of;
  if (n <= Random_blocks::largest_block)
    choose_nearest_centers(
        lower, [](std::size_t) { return true; }, points, center);
  else
    choose_nearest_instead_of_hubs(lower, hubs, points, center);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(is_net(lower, center));
  Large_vector<Index> number(n); // the cluster of a net vertex
  for (std::size_t v = 0; v < n; ++v)
    if (center[v] == v) {
      number[v] = Index(net.centers.size());
      net.centers.push_back(Index(v));
    }
  for (std::size_t v = 0; v < n; ++v)
    net.cluster_of[v] = number[center[v]];
  return net;
}

// Net_hierarchy makes nets of a graph, each a maximal independent set in the contracted graph of
// the one before, with the clusters of their vertices.
//
// A graph is given by the neighbours of each vertex that have smaller numbers: each edge is stored
// once, at the end that is visited last.
//
// Invariant: the vertices of a level are numbered in the order of the level below, so that a mesh
// that is coherent in memory gives coherent levels. There is no search through the graph: if the
// mesh is not coherent, it would miss the cache at every vertex.
// Cost: every level is linear in its vertices and edges. On the surfaces measured the levels shrink
// by a constant factor (4 to 5) and their edges with them: linear altogether. In other graphs a
// level may keep nearly all its vertices; such a level ends the hierarchy.

// Lists the members of every cluster, its net vertex first, the others in ascending order.
inline Lists<std::uint32_t> members(const Net& net)
{
  using Index = std::uint32_t;
  Lists<Index> lists = in_lists<Index>(
      net.centers.size(),
      Listed_items(
          net.cluster_of.size(), [&](std::size_t v) { return std::size_t(net.cluster_of[v]); },
          [](std::size_t v) { return Index(v); }));
  for (std::size_t c = 0; c < lists.size(); ++c) {
    Index* const first = lists.items.data() + lists.first[c];
    Index* k = first;
    while (*k != net.centers[c])
      ++k;
    std::copy_backward(first, k, k + 1);
    *first = net.centers[c];
  }
  return lists;
}

// Returns the graph of the clusters: two are neighbours if members of them are. An edge is found
// from each of its clusters at most once, so that it is there at most twice.
inline Lists<std::uint32_t> contracted(const Lists_view<std::uint32_t>& lower,
                                       const Large_vector<std::uint32_t>& cluster_of,
                                       const Lists<std::uint32_t>& clusters)
{
  using Index = std::uint32_t;
  Large_vector<Numbered_edge> edges;
  edges.reserve(4 * clusters.size()); // enough on a surface
  Large_vector<Index> last_met_by(clusters.size(), Index(clusters.size()));
  const std::size_t last_item = clusters.items.size() - 1;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    last_met_by[c] = Index(c);
    for (std::size_t k = clusters.first[c]; k < clusters.first[c + 1]; ++k) {
      prefetch(&lower.first[clusters.items[(std::min)(k + prefetch_distance, last_item)]]);
      prefetch(lower.begin(clusters.items[(std::min)(k + near_prefetch_distance, last_item)]));
      const Index v = clusters.items[k];
      for (const Index *u = lower.begin(v), *end = lower.end(v); u != end; ++u) {
        const Index d = cluster_of[*u];
        if (last_met_by[d] == Index(c))
          continue;
        last_met_by[d] = Index(c);
        edges.emplace_back(Index(c), d);
      }
    }
  }
  return lower_neighbors(edges, clusters.size());
}

// Holds the levels, finest first. clusters[l] lists the clusters of the vertices of level l; they
// are the vertices of level l + 1. names[l] has the point of each vertex of level l; at level 0 the
// vertices are the points themselves, and nothing is stored.
struct Net_hierarchy
{
  std::vector<Lists<std::uint32_t>> clusters;
  std::vector<Large_vector<std::uint32_t>> names;
  std::size_t number_of_coarsest;

  // Makes nets of the graph with these edges (at least one) until at most `coarsest_net` vertices
  // are left, or a net keeps more than the share `net_stall` of them. `block` is for Random_blocks.
  Net_hierarchy(Lists_view<std::uint32_t> lower, const Point_array& points, unsigned int seed,
                std::size_t block = Random_blocks::one_of_many)
    : names(1)
    , number_of_coarsest(points.size())
  {
    Split_mix random(seed);
    Lists<std::uint32_t> contracted_edges;
    while (number_of_coarsest > coarsest_net) {
      const std::size_t level = names.size() - 1;
      const Vertex_points vertices(points, level == 0 ? nullptr : names[level].data());
      Net net = net_of(lower, random(), vertices, block);
      if (double(net.centers.size()) > net_stall * double(number_of_coarsest))
        break;
      clusters.push_back(members(net));
      contracted_edges = contracted(lower, net.cluster_of, clusters.back());
      lower = contracted_edges;
      number_of_coarsest = lower.size();
      for (std::uint32_t& c : net.centers)
        c = std::uint32_t(point(level, c));
      names.push_back(std::move(net.centers));
    }
  }

  std::size_t number_of_levels() const { return names.size(); }

  std::size_t point(std::size_t level, std::size_t v) const
  {
    return level == 0 ? v : names[level][v];
  }
};

// Returns the median squared distance from a member to the net vertex, over about a thousand
// clusters of a level.
inline double median_of_distances(const Point_array& points, const Net_hierarchy& nets,
                                  std::size_t level)
{
  const Lists<std::uint32_t>& clusters = nets.clusters[level];
  std::vector<double> distances;
  for (std::size_t c = 0; c < clusters.size(); c += clusters.size() / 1024 + 1)
    if (const std::uint32_t* center = clusters.begin(c); clusters.end(c) - center > 1)
      distances.push_back(squared_distance(points[nets.point(level, *center)],
                                           points[nets.point(level, center[1])]));
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

inline Insertion_order rounds_behind_nets(const Point_array& points, unsigned int seed)
{
  const Build_options options;
  return geometric_rounds(points, seed, options.ratio, options.first_round);
}

// Appends one round after the other to an order, from the coarsest net to the finest.
class Rounds_of_nets
{
  // Holds a vertex of a level, and the place of its point in the order.
  struct Placed
  {
    std::uint32_t vertex, place;
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
    m_result = Insertion_order();
    m_result.order.reserve(m_points.size());
    m_result.starting_places.reserve(m_points.size());
    Sequence sequence = append_coarsest();
    for (std::size_t level = m_nets.clusters.size(); level-- > 0;)
      sequence = append_round(level, sequence);
    return std::move(m_result);
  }

private:
  // Appends a vertex of a level to the order. Returns its place.
  std::uint32_t append(std::size_t level, std::size_t vertex, std::size_t starting_place)
  {
    const std::size_t place = m_result.order.size();
    m_result.order.push_back(m_nets.point(level, vertex));
    m_result.starting_places.push_back(starting_place);
    return static_cast<std::uint32_t>(place);
  }

  // Appends the first rounds: the vertices of the coarsest level. Returns them in their order.
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

  // Appends the round of the vertices of a level that are not in its net. `parents` are the
  // vertices in the net, in their order; returns all vertices of the level in their order.
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

  // Appends the members of one cluster except its net vertex, the last of `sequence`. A walk from
  // there would lead through half of the fan: so the members come in random rounds, and start at
  // the previous point if that is nearer.
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
      const bool previous_is_nearer = squared_distance(m_points[point], m_points[previous]) <
                                      squared_distance(m_points[point], m_points[center]);
      const std::uint32_t place =
          append(level, members[k], previous_is_nearer ? place_of_previous : place_of_center);
      sequence.push_back({members[k], place});
      previous = point;
      place_of_previous = place;
    }
  }

  Insertion_order random_rounds(const Point_array& points) const
  {
    return rounds_behind_nets(points, m_seed);
  }

  // Returns the coordinates of the points name(0), …, name(n-1).
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
  unsigned int m_seed;
  Insertion_order m_result;
};

// Returns the order of points whose graph has these lower neighbours. Without edges it depends on
// the points alone. It has no starting places if edges join points that are not near each other.
inline Insertion_order surface_net_rounds(const Point_array& points,
                                          const Lists_view<std::uint32_t>& lower, unsigned int seed,
                                          std::size_t block)
{
  if (lower.number_of_items == 0)
    return spaced_rounds(points, Alone());
  const Net_hierarchy nets(lower, points, seed, block);
  return joins_near_points(points, nets) ? Rounds_of_nets(points, nets, seed).order()
                                         : rounds_behind_nets(points, seed);
}

// Lists, for each of the n vertices of a graph, its neighbours with smaller numbers; returns no
// lists if there are no edges, or too many vertices or edges for 32-bit numbers.
template <class Graph, class VertexIndexMap>
Lists<std::uint32_t> lower_neighbors(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  using Index = std::uint32_t;
  const std::size_t m = std::size_t(num_edges(graph));
  if (m == 0 || (std::max)(n, m) >= (std::numeric_limits<Index>::max)())
    return {};
  Large_vector<Numbered_edge> numbered;
  numbered.reserve(m);
  const auto range = edges(graph);
  for (auto e = range.first; e != range.second; ++e)
    numbered.emplace_back(Index(get(index_map, source(*e, graph))),
                          Index(get(index_map, target(*e, graph))));
  return lower_neighbors(numbered, n);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds and order from the surface graph. A net of the graph is a maximal independent set.
Every other vertex joins the cluster of an adjacent net vertex: the nearest if there are at most
32768 vertices, or if the first that was chosen has many edges; otherwise the first.
Contracting the clusters gives a smaller graph, and so on, until at most `coarsest` vertices are
left. Rounds go from the coarsest net to the finest and grow four- to fivefold. Inside a round the
points follow the clusters, children in the order of their parents. This order is local on the
surface, and so in space. Each point starts at the net vertex of its cluster, which is inserted in
an earlier round (`Insertion_order::starting_places`).

A net is chosen greedily in a random order of the vertices, which the seed determines. With more
than 32768 vertices, blocks of `block` successive vertices (1024 by default) follow each other, and
only the order inside each block is random. In the order of the indices a net would be as regular as
the numbering. CAD programs number vertices along profiles and rings, and such nets destroyed 3.6
times as many cells as random ones on an airfoil of 200,000 points (`nets_200k.json`). Vertices
with more than three times as many edges as the average come first: it is better to insert the
middle of a fan before the fan. The members of a cluster of more than `large_cluster` vertices come
in the order of `Geometric_rounds`, and start at the previous point if that is nearer than the net
vertex.

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
  /// the fraction of its vertices that a level may keep.
  static constexpr double stall = internal::net_stall;

  /// the number of vertices at which nets end.
  static constexpr std::size_t coarsest = internal::coarsest_net;

  /// the budget (`InsertionPlan::cells_per_point`). On most surfaces nets destroy 12 to 33 cells
  /// per point. On smooth tori without noise they destroy more, and 3 to 4 more for each doubling
  /// of the points; on adversarial surfaces any number.
  static constexpr std::size_t cells_per_point = internal::Build_options::usual_number;

  /// the largest size of a cluster whose members are not ordered by `Geometric_rounds`.
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
                             const Graph& graph, VertexIndexMap index_map) const
  {
    using namespace internal;
    const auto coordinates = rounded_coordinates(points);
    const Point_array array(coordinates.data(), points.size());
    if constexpr (std::is_base_of<Lower_neighbor_graph, Graph>::value)
      return surface_net_rounds(array, graph.lists(), m_seed, m_block);
    else
      return surface_net_rounds(array, lower_neighbors(graph, index_map, points.size()), m_seed,
                                m_block);
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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SURFACE_NET_ROUNDS_H
