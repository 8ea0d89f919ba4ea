// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_DISJOINT_SETS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_DISJOINT_SETS_H

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Disjoint sets of 0, …, n-1, united by rank, with path halving. Boost's are not used, because the
// Python module is built without Boost.
template <class Index>
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n)
    : m_rank(n)
    , m_parent(n)
  {
    std::iota(m_parent.begin(), m_parent.end(), Index(0));
  }

  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  // Unites the sets of a and b; returns false if they were one already.
  bool unite(Index a, Index b)
  {
    Index s = root(a), t = root(b);
    if (s == t)
      return false;
    if (m_rank[s] < m_rank[t])
      std::swap(s, t);
    m_rank[s] = static_cast<unsigned char>(m_rank[s] + (m_rank[s] == m_rank[t]));
    m_parent[t] = s;
    return true;
  }

  // Returns one element of the set of i, the same for all of its elements.
  Index root(Index i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

private:
  std::vector<unsigned char> m_rank; // at most log2 n
  std::vector<Index> m_parent;
};

// Edges with the same ends have different places.
template <class Index>
struct Measured_edge
{
  std::array<Index, 2> ends;
  Index place;
  double squared_length; // rounded
};

// Tells of squared lengths that were computed whether the lengths differ: they are off by at most six
// roundings, and by what underflows. One that overflows is never clearly more.
inline bool is_clearly_less(double x, double y)
{
  return y - x > 1e-14 * y + 1e-300;
}

// Keeps the edges of a minimum spanning forest of n vertices, from the shortest to the longest, each with
// the end first that is before the other. Of edges of the same length, those with the lexicographically
// smaller ends come first, of edges with the same ends those with smaller places. The sign of the
// difference of two lengths is lengths.compare(a, b), exactly. Cost: O(m log m).
template <class Index, class Lengths, class IsBefore = std::less<Index>>
void keep_minimum_spanning_forest(std::vector<Measured_edge<Index>>& edges, std::size_t n,
                                  const Lengths& lengths, const Executor& executor = Alone(),
                                  const IsBefore& is_before = IsBefore())
{
  using Edge = Measured_edge<Index>;
  Steps step(executor);
  for (Edge& e : edges) {
    if (is_before(e.ends[1], e.ends[0]))
      std::swap(e.ends[0], e.ends[1]);
    e.squared_length = lengths.squared_length(e.ends[0], e.ends[1]);
  }
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    step();
    return a.squared_length < b.squared_length;
  });
  const auto are_clear = [](const Edge& a, const Edge& b) {
    return is_clearly_less(a.squared_length, b.squared_length);
  };
  for (auto first = edges.begin(), last = first; first != edges.end(); first = last) {
    last = std::adjacent_find(first, edges.end(), are_clear);
    last += last != edges.end();
    const bool are_equal = std::all_of(std::next(first), last, [&](const Edge& e) {
      step();
      return lengths.compare(*first, e) == 0;
    });
    std::sort(first, last, [&](const Edge& a, const Edge& b) {
      step();
      if (const int sign = are_equal ? 0 : lengths.compare(a, b))
        return sign < 0;
      if (a.ends != b.ends)
        return std::lexicographical_compare(a.ends.begin(), a.ends.end(), b.ends.begin(),
                                            b.ends.end(), is_before);
      return a.place < b.place;
    });
  }
  Disjoint_sets<Index> trees(n);
  const auto is_superfluous = [&](const Edge& e) {
    step();
    return !trees.unite(e.ends[0], e.ends[1]);
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_superfluous), edges.end());
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_DISJOINT_SETS_H
