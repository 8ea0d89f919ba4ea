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
#include <numeric>
#include <tuple>
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

// The smaller number first. Edges of the same length are taken in lexicographical order, those with the
// same ends by their places.
struct Measured_edge
{
  std::array<std::size_t, 2> ends;
  std::size_t place;
  double squared_length; // rounded
};

inline Measured_edge measured_edge(std::size_t s, std::size_t t, std::size_t place)
{
  return {{(std::min)(s, t), (std::max)(s, t)}, place, 0};
}

// Tells of squared lengths that were computed whether the lengths differ: if nothing underflows, they are
// off by at most six roundings.
inline bool is_clearly_less(double x, double y)
{
  return x > 1e-280 && y < 1e280 && y - x > 1e-14 * y;
}

// Keeps the edges of a minimum spanning forest of n vertices, from the shortest to the longest.
// lengths.compare(a, b) is the sign of the difference of two lengths, exactly. Cost: O(m log m).
template <class Lengths>
void keep_minimum_spanning_forest(std::vector<Measured_edge>& edges, std::size_t n,
                                  const Lengths& lengths, const Executor& executor = Alone())
{
  Steps step(executor);
  for (Measured_edge& e : edges)
    e.squared_length = lengths.squared_length(e.ends[0], e.ends[1]);
  std::sort(edges.begin(), edges.end(), [&](const Measured_edge& a, const Measured_edge& b) {
    step();
    if (is_clearly_less(a.squared_length, b.squared_length))
      return true;
    if (is_clearly_less(b.squared_length, a.squared_length))
      return false;
    const int sign = lengths.compare(a, b);
    return sign != 0 ? sign < 0 : std::tie(a.ends, a.place) < std::tie(b.ends, b.place);
  });
  Disjoint_sets<std::size_t> trees(n);
  const auto is_superfluous = [&](const Measured_edge& e) {
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
