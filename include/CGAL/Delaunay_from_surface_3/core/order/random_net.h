// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_RANDOM_NET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_RANDOM_NET_H

// A net of a graph, that is a maximal independent set, with the cluster of every net vertex: itself
// and neighbours of it; of several net vertices beside it a vertex belongs to the nearest, or,
// where there are many vertices, to the first.
//
// The net is the greedy one in a random order of the vertices. In the order of the numbers it would
// be as regular as the numbering, and CAD numbers along profiles and rings: whole rings would come
// one after the other. Where there are many vertices, blocks of successive numbers come one after
// the other, and the order is random inside each. That keeps memory together, and stays near the
// order of the numbers, which is a good one on scans. Hubs come before all others: the middle of a
// fan is better there before the fan than after it. Chains of vertices of which each waits for the
// one before have logarithmic length in random orders (Blelloch, Fineman, Shun 2012; Fischer,
// Noever 2018).
//
// Cost: linear in vertices and edges. Every edge is stored at one of its ends only, at which it is
// seen from both: a vertex asks those in its list, and tells them when it joins.

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/core/order/squared_distance.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists_view.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The numbers 0, …, n-1 in random order; where they are many, block by block, in random order
// inside each. The blocks share one permutation, each with a twist of its own. What belongs to one
// of many blocks of a graph fits into the cache nearest to the processor.
class Random_blocks
{
public:
  static constexpr std::size_t largest_block = std::size_t(1) << 15;
  static constexpr std::size_t one_of_many = std::size_t(1) << 10;

  // `block`: the size of one of many, rounded up to a power of 2.
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
  std::vector<std::uint32_t> m_inner; // as many as a block has, a power of 2
};

// The points at the vertices of a graph.
class Vertex_points
{
public:
  // Vertex v is at the point names[v]; or at v, if there are no names.
  explicit Vertex_points(const Point_array& points, const std::uint32_t* names = nullptr)
    : m_points(points)
    , m_names(names)
  {
  }

  double squared_distance(std::size_t v, std::size_t u) const
  {
    return m_names == nullptr ? internal::squared_distance(m_points, v, u)
                              : internal::squared_distance(m_points, m_names[v], m_names[u]);
  }

private:
  Point_array m_points;
  const std::uint32_t* m_names;
};

struct Net
{
  Large_vector<std::uint32_t> centers;    // by cluster: its net vertex, in ascending order
  Large_vector<std::uint32_t> cluster_of; // by vertex: the number of its cluster
};

// The vertices with more than three times as many edges as the others have on average, in random
// order.
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

// By vertex: itself if it is in the greedy net of the graph with these lower neighbours, else a
// neighbour that is. `hubs` come first.
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

// Of several net vertices beside a vertex that is_wanted, makes the nearest one its centre.
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

// The same for the vertices in the clusters of hubs. A hub would keep all that are beside it,
// however far away, and its cluster those of the next level, until one cluster has half of all
// vertices.
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

// Whether every centre is its own, every other vertex is beside its own centre, and no centre
// beside another. By vertex: the centre. Linear.
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

// The net and its clusters. Distances are those of neighbours, one of which is in the net; where
// there are many vertices, of those beside hubs only: a pass over all points is dear there, for a
// small gain.
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
  Large_vector<Index> number(n); // of the cluster of a net vertex
  for (std::size_t v = 0; v < n; ++v)
    if (center[v] == v) {
      number[v] = Index(net.centers.size());
      net.centers.push_back(Index(v));
    }
  for (std::size_t v = 0; v < n; ++v)
    net.cluster_of[v] = number[center[v]];
  return net;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_RANDOM_NET_H
