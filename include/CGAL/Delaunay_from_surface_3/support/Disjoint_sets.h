// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_DISJOINT_SETS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_DISJOINT_SETS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_DISJOINT_SETS_H
